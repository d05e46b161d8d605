/* SPDX-License-Identifier: Apache-2.0
 *
 * Settings at both ends of their ranges, many at once, which nobody has looked at: whatever is
 * created answers numbers, no light below black, and normals and fibres of length one.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum { VALUES = 256, POINTS = 512, COMPONENTS = 64 };

/* A few of a texture's parameters: numbers mostly at an end, choices any. */
static uint32_t draw(const sozai_texture_info *info, sozai_value out[VALUES]) {
  uint32_t count = 0;
  double often = 0.05 + 0.4 * uniform();
  for (uint32_t k = 0; k < info->parameter_count && count < VALUES; k++) {
    const sozai_parameter *p = info->parameters[k];
    double at = uniform(), x = p->soft_min + (p->soft_max - p->soft_min) * uniform();
    if (uniform() > often) continue;
    if (p->kind == SOZAI_KIND_FLOAT || p->kind == SOZAI_KIND_INT) {
      if (at < 0.4) x = p->hard_min;
      if (at > 0.6) x = p->hard_max;
      if (p->kind == SOZAI_KIND_INT) x = floor(x);
      out[count++] = (sozai_value){.id = p->id, .kind = p->kind, .number = {x}};
    } else if (p->kind == SOZAI_KIND_CHOICE) {
      const char *choice = p->choices[(uint32_t)(uniform() * p->choice_count)];
      out[count++] = (sozai_value){.id = p->id, .kind = p->kind, .text = choice};
    }
  }
  return count;
}

typedef struct {
  float point[3][POINTS], normal[3][POINTS], light[3][POINTS], view[3][POINTS];
  float footprint[POINTS], out[COMPONENTS][POINTS];
} asked;

static void unit(float *const v[3], unsigned i) {
  double h = 2 * uniform() - 1, t = 6.283185307179586 * uniform(), r = sqrt(1 - h * h);
  v[0][i] = (float)(r * cos(t));
  v[1][i] = (float)(r * sin(t));
  v[2][i] = (float)h;
}

static void ask(asked *a, const sozai_texture_info *info, const sozai_texture *t) {
  static const float footprints[] = {0, 0.01f, 0.1f, 1, 5, 30, 300, 1e30f};
  sozai_batch b = {.size = sizeof b, .count = POINTS, .footprint = a->footprint};
  float *out[COMPONENTS];
  for (int c = 0; c < 3; c++) {
    b.point[c] = a->point[c];
    b.normal[c] = a->normal[c];
    b.light[c] = a->light[c];
    b.view[c] = a->view[c];
  }
  for (unsigned i = 0; i < POINTS; i++) {
    double reach = i & 1 ? 20 : 3000;
    for (int c = 0; c < 3; c++) a->point[c][i] = (float)(reach * (2 * uniform() - 1));
    unit((float *const[]){a->normal[0], a->normal[1], a->normal[2]}, i);
    unit((float *const[]){a->light[0], a->light[1], a->light[2]}, i);
    unit((float *const[]){a->view[0], a->view[1], a->view[2]}, i);
    a->footprint[i] = footprints[i / 2 % 8];
  }
  assert_true(info->component_count <= COMPONENTS);
  for (unsigned c = 0; c < COMPONENTS; c++) out[c] = a->out[c];
  b.out = out;
  b.out_count = info->component_count;
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
}

/* What is wrong at a point, or NULL. */
static const char *wrong(const asked *a, const sozai_texture_info *info, unsigned i) {
  for (uint32_t k = 0; k < info->channel_count; k++) {
    const sozai_channel *c = info->channels[k];
    double square = 0;
    for (uint32_t n = 0; n < c->components; n++) {
      double x = (double)a->out[c->first + n][i];
      if (!isfinite(x)) return c->id;
      if ((strcmp(c->id, "albedo") == 0 || strcmp(c->id, "radiance") == 0) && x < 0) return c->id;
      square += x * x;
    }
    /* a direction, or as long as its share */
    int vector = strcmp(c->suffixes, "xyz") == 0;
    if (vector && !*c->unit && fabs(square - 1) > 1e-4) return c->id;
    if (vector && strcmp(c->unit, "share") == 0 && square > 1 + 1e-4) return c->id;
  }
  return NULL;
}

static void print(const char *preset, const sozai_value *v, uint32_t count) {
  print_message("  preset %s", preset ? preset : "none");
  for (uint32_t k = 0; k < count; k++) {
    if (v[k].text)
      print_message(", %s=%s", v[k].id, v[k].text);
    else
      print_message(", %s=%g", v[k].id, v[k].number[0]);
  }
  print_message("\n");
}

/* Asks, and prints where an answer is wrong: 1 if any is. */
static int wrong_anywhere(asked *a, const sozai_texture_info *info, const sozai_texture *t) {
  ask(a, info, t);
  for (unsigned i = 0; i < POINTS; i++) {
    const char *what = wrong(a, info, i);
    if (!what) continue;
    print_message("%s: %s under %g mm\n", info->id, what, (double)a->footprint[i]);
    return 1;
  }
  return 0;
}

static void check(const char *id, int trials) {
  const sozai_texture_info *info = textures->find(id);
  asked *a = malloc(sizeof *a);
  assert_non_null(info);
  assert_non_null(a);
  int made = 0, bad = 0;
  uniform_seed(91);
  for (int t = 0; t < trials; t++) {
    sozai_value v[VALUES];
    uint32_t count = draw(info, v), preset = (uint32_t)(uniform() * (info->preset_count + 1));
    const char *name = preset < info->preset_count ? info->presets[preset]->id : NULL;
    sozai_texture *texture;
    if (textures->create(NULL, id, name, v, count, &texture) != SOZAI_OK) {
      assert_true(*textures->last_error()); /* what does not go together is refused in words */
      continue;
    }
    made++;
    if (wrong_anywhere(a, info, texture)) {
      print(name, v, count);
      bad++;
    }
    textures->destroy(texture);
  }
  CHECK(made > trials / 4 && bad == 0, "%-5s %d of %d created, %d of them wrong somewhere\n", id,
        made, trials, bad);
  free(a);
}

/* What the above has met once. */
static void those_met(void **state) {
  (void)state;
  static const struct {
    const char *material, *preset, *parameters;
  } met[] = {
      {"wood", NULL, "canal_density=10; canal_diameter=1000"},
      {"stone", NULL, "vein_width=500; vein_softness=0"},
      {"stone", NULL,
       "colour_mode=paper_rgb; paper_white=1; layout=chevron; tone_spread=0.5; wet=1"},
      {"stone", "araidashi",
       "inclusion_size=0.1; inclusion_gap=0; inclusion_share=0.4; inclusion_blur=50; "
       "inclusion_relief=50; layout=igeta; joint_width=20; crown=-5"},
  };
  asked *a = malloc(sizeof *a);
  assert_non_null(a);
  int bad = 0;
  for (size_t k = 0; k < sizeof met / sizeof met[0]; k++) {
    int is_wood = strcmp(met[k].material, "wood") == 0;
    sozai_texture *t = (is_wood ? wood_make : stone_make)(met[k].preset, met[k].parameters);
    uniform_seed(92);
    for (int times = 0; times < 20; times++) {
      if (!wrong_anywhere(a, textures->find(met[k].material), t)) continue;
      print_message("  %s\n", met[k].parameters);
      bad++;
      break;
    }
    textures->destroy(t);
  }
  CHECK(bad == 0, "%d of those met before are wrong\n", bad);
  free(a);
}

static void wood(void **state) {
  (void)state;
  check("wood", 400);
}

static void stone(void **state) {
  (void)state;
  check("stone", 600);
}

static void fiber(void **state) {
  (void)state;
  check("fiber", 300);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(those_met), cmocka_unit_test(wood),
                                     cmocka_unit_test(stone), cmocka_unit_test(fiber)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
