/* SPDX-License-Identifier: Apache-2.0
 * Row 10, of cloth: every woven preset as curves (woven.h), between which rays go to and fro,
 * and as the texture under five footprints: what is covered, what comes back of light from all
 * around, and the radiance under light from seven sides. Prints docs/fiber-texture.md's table. */
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include "woven.h"

enum { SCALES = 5, POINTS = 8192, VIEWS = 3, SIDES = 4, RAYS = 2500, COMPONENTS = 17 };
static const double footprints[SCALES] = {0, 0.03, 0.3, 3, 30};
static const double views[VIEWS] = {90, 50, 25};
enum { ALBEDO = 0, RADIANCE = 3, COVERAGE = 6 };

static const sozai_textures_1 *textures_of(void) {
  geometry(); /* makes the plugin ready */
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  assert_non_null(entry);
  return entry->get_factory(SOZAI_TEXTURES_1);
}

static double encoded(double x) {
  return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055;
}

/* The preset, of even yarns and strands of one thickness and one colour. */
static sozai_texture *texture_of(const cloth *c, const sozai_textures_1 *textures) {
  const double rgb[3] = {encoded((double)colours[0]), encoded((double)colours[1]),
                         encoded((double)colours[2])};
#define NUMBER_(i, x)                                                                              \
  {                                                                                                \
    .id = i, .kind = SOZAI_KIND_FLOAT, .number = { x }                                             \
  }
#define COLOUR_(i)                                                                                 \
  { .id = i, .kind = SOZAI_KIND_COLOUR, .number = {rgb[0], rgb[1], rgb[2]}, .text = "sRGB" }
  const sozai_value values[] = {{.id = "axis", .kind = SOZAI_KIND_CHOICE, .text = "x"},
                                NUMBER_("diameter_spread", 0),
                                NUMBER_("slub", 0),
                                NUMBER_("second_share", 0),
                                NUMBER_("variation", 0),
                                NUMBER_("crimp", 0),
                                COLOUR_("colour"),
                                COLOUR_("weft_colour")};
  sozai_texture *t;
  if (textures->create(NULL, "fiber", c->preset, values, sizeof values / sizeof *values, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

static double random_of(uint32_t *state) {
  *state = *state * 1664525u + 1013904223u;
  return (double)(*state >> 8) / 16777216.0;
}

static eye eye_of(int view, int side) {
  return (eye){views[view], 180.0 * side / SIDES - 90.0 / SIDES, 180.0 / SIDES};
}

/* Means of the texture's albedo, radiance and coverage. */
static void look_at_texture(const sozai_texture *t, const sozai_textures_1 *textures, eye e,
                            const double light[2], double footprint, double got[7]) {
  static float in[10][POINTS], normal[3][POINTS], out[7][POINTS];
  uint32_t r = 9;
  for (int i = 0; i < POINTS; i++) {
    double turn = e.from + e.range * random_of(&r);
    for (int k = 0; k < 2; k++) in[k][i] = (float)(400 * random_of(&r));
    const vec of[2] = {aim(e.elevation, turn), aim(light[0], light[1] + turn)};
    for (int q = 0; q < 2; q++) {
      in[3 + 3 * q][i] = of[q].x;
      in[4 + 3 * q][i] = of[q].y;
      in[5 + 3 * q][i] = of[q].z;
    }
    in[9][i] = (float)footprint;
    normal[2][i] = 1;
  }
  float *outs[COMPONENTS] = {0};
  for (int k = 0; k < 7; k++) outs[k] = out[k];
  sozai_batch q = {.size = sizeof q,
                   .count = POINTS,
                   .point = {in[0], in[1], in[2]},
                   .normal = {normal[0], normal[1], normal[2]},
                   .view = {in[3], in[4], in[5]},
                   .light = {in[6], in[7], in[8]},
                   .footprint = in[9],
                   .out = outs,
                   .out_count = COMPONENTS};
  assert_int_equal(textures->evaluate(t, &q), SOZAI_OK);
  for (int k = 0; k < 7; k++) {
    got[k] = 0;
    for (int i = 0; i < POINTS; i++) got[k] += (double)out[k][i] / POINTS;
  }
}

/* ---- both -------------------------------------------------------------- */

static void compare(const cloth *c, const sozai_textures_1 *textures) {
  static const char *const names[3] = {"white", "wool", "dark"};
  woven b;
  weave_cloth(&b, c);
  sozai_texture *t = texture_of(c, textures);
  const char *dump = getenv("DUMP");
  int rays = getenv("RAYS") ? atoi(getenv("RAYS")) : RAYS;
  print_message("%s: %s, %llu fibres; curves (+- chance) and texture\n", c->preset, c->weave,
                (unsigned long long)b.curves_count);
  double all[3] = {0}, all_seen[SCALES][3] = {{0}}, covered = 0, covered_seen[SCALES] = {0};
  double around[3] = {0}, around_seen[SCALES][3] = {{0}}, chance2[3] = {0};
  for (int v = 0; v < VIEWS; v++) {
    for (int side = 0; side < SIDES; side++) {
      eye e = eye_of(v, side);
      seen s = look_at_curves(&b.t, e, (uint32_t)rays);
      traced black = b.t;
      memcpy(black.colour, (float[]){0.001f, 0.001f, 0.001f}, sizeof black.colour);
      seen glints = look_at_curves(&black, e, (uint32_t)rays / 4);
      for (int k = 0; k < 3; k++) s.around[k] -= glints.around[k];
      covered += s.covered;
      for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (int l = 0; l < LIGHTS; l++) sum += s.sum[l][k];
        chance2[k] += (s.square_of_all[k] - sum * sum) / rays;
        around[k] += s.around[k];
        all[k] += sum;
      }
      if (dump)
        fprintf(stderr, "A %s %g %g %g %g %g %g %g %g %g\n", c->preset, views[v],
                e.from + e.range / 2, s.covered, s.around[0], s.around[1], s.around[2], 0., 0., 0.);
      double mean[LIGHTS][3] = {{0}}, cover[SCALES];
      for (int f = 0; f < SCALES; f++) {
        for (int l = 0; l < LIGHTS; l++) {
          double got[7];
          look_at_texture(t, textures, e, lights[l], footprints[f], got);
          cover[f] = got[COVERAGE];
          for (int k = 0; k < 3; k++) {
            mean[l][k] += got[RADIANCE + k] / SCALES;
            all_seen[f][k] += got[RADIANCE + k];
            if (l == 0) around_seen[f][k] += got[ALBEDO + k];
          }
        }
        covered_seen[f] += cover[f];
      }
      print_message("  view %2.0f %3.0f: covered %.3f %.3f %.3f; albedo %.3f %.3f %.3f\n", views[v],
                    e.from + e.range / 2, s.covered, cover[0], cover[SCALES - 1], s.around[0],
                    s.around[1], s.around[2]);
      for (int l = 0; l < LIGHTS; l++) {
        print_message("    light %2.0f %3.0f:", lights[l][0], lights[l][1]);
        for (int k = 0; k < 3; k++) {
          double square = s.square[l][k] - s.sum[l][k] * s.sum[l][k];
          double chance = sqrt(fmax(square, 0) / rays), off = mean[l][k] / s.sum[l][k] - 1;
          print_message(" %s %.3f (%.3f) %.3f %+3.0f %%", names[k], s.sum[l][k], chance, mean[l][k],
                        100 * off);
          if (dump)
            fprintf(stderr, "D %s %g %g %g %g %d %g %g %g\n", c->preset, views[v],
                    e.from + e.range / 2, lights[l][0], lights[l][1], k, s.sum[l][k], chance,
                    mean[l][k]);
        }
        print_message("\n");
      }
    }
  }
  print_message("  covered: %.3f;", covered / VIEWS / SIDES);
  for (int f = 0; f < SCALES; f++) print_message(" %+.1f", 100 * (covered_seen[f] / covered - 1));
  print_message(" %%\n");
  for (int k = 0; k < 3; k++) {
    print_message("  %s: albedo %.3f;", names[k], around[k] / VIEWS / SIDES);
    for (int f = 0; f < SCALES; f++)
      print_message(" %+.1f", 100 * (around_seen[f][k] / around[k] - 1));
    print_message(" %%; radiance");
    for (int f = 0; f < SCALES; f++) print_message(" %+.1f", 100 * (all_seen[f][k] / all[k] - 1));
    print_message(" %% (chance %.1f)\n", 100 * sqrt(chance2[k]) / all[k]);
  }
  textures->destroy(t);
  free_cloth(&b);
}

static void all_of_them(void **unused) {
  (void)unused;
  const sozai_textures_1 *textures = textures_of();
  const sozai_texture_info *info = textures->find("fiber");
  assert_non_null(info);
  for (uint32_t i = 0; i < info->preset_count; i++) {
    cloth c;
    if (!cloth_of(info, info->presets[i], &c)) continue;
    if (getenv("ONLY") && !strstr(getenv("ONLY"), c.preset)) continue;
    compare(&c, textures);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(all_of_them)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
