/* SPDX-License-Identifier: Apache-2.0
 *
 * Numbers that are none: whatever stands in the inputs, every answer is
 * finite, and what the header says is read in its place is.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "batch.h"

static plugin p;
static const sozai_texture_info *info;
static full_batch b, other;

static const float nasty[] = {NAN,           -NAN,         INFINITY, -INFINITY, 1e30f,  -1e30f,
                              3.4028235e38f, 1e-45f,       -1e-45f,  1e-38f,    0.0f,   -0.0f,
                              1e6f,          -1e6f,        1e10f,    1e19f,     1e-19f, 1e-30f,
                              1e20f,         2.1474836e9f, 1.0f};
#define NASTY (sizeof nasty / sizeof *nasty)

/* A wood of every preset; a stone of every other, under all finishes; a fibre of every third. */
static sozai_texture *make(uint32_t k) {
  const char *preset = k ? info->presets[k - 1]->id : NULL;
  if (strcmp(info->id, "wood") == 0) return plugin_wood(&p, preset, "compound");
  static const char *const finishes[] = {"split", "flamed", "bush_hammered",
                                         "sawn",  "honed",  "polished"};
  if (strcmp(info->id, "fiber") == 0) {
    sozai_texture *t = NULL;
    assert_int_equal(p.textures->create(NULL, "fiber", preset, NULL, 0, &t), SOZAI_OK);
    return t;
  }
  const sozai_value values[] = {
      {.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = finishes[k / 2 % 6u]},
      {.id = "colour_mode", .kind = SOZAI_KIND_CHOICE, .text = k ? "fabric" : "paper_rgb"}};
  sozai_texture *t = NULL;
  if (p.textures->create(NULL, info->id, preset, values, 2, &t)) {
    print_error("create %s: %s", info->id, p.textures->last_error());
  }
  return t;
}

static void finite_in(const char *id, const char *set) {
  setenv("SOZAI_CPU", set, 1);
  info = p.textures->find(id);
  assert_non_null(info);
  sozai_texture *t = NULL;
  if (p.textures->create(NULL, id, NULL, NULL, 0, &t) == SOZAI_ERROR_UNSUPPORTED) return;
  p.textures->destroy(t);
  uint64_t r = 1, points = 0;
  uint32_t step = strcmp(id, "wood") == 0 ? 1 : strcmp(id, "fiber") == 0 ? 3 : 2;
  for (uint32_t k = 0; k <= info->preset_count; k += step) {
    t = make(k);
    assert_non_null(t);
    for (uint32_t round = 0; round < 44; round++) {
      batch_make(&b, info, BATCH_MAX);
      /* all of an input, here and there among ordinary ones, or everything */
      for (uint32_t a = 0; a < 16; a++) {
        r = mix64(r);
        uint32_t often = round < 16 ? (a == round ? 1 : 0) : round < 32 ? 40 : 3;
        for (uint32_t i = 0; often && i < BATCH_MAX; i++) {
          r = mix64(r);
          if (r % often == 0) b.in[a][i] = nasty[(r >> 20) % NASTY];
        }
      }
      if (round % 5 == 4) memset(b.batch.light_colour, 0, sizeof b.batch.light_colour);
      if (round % 7 == 6) b.batch.footprint = NULL;
      assert_int_equal(p.textures->evaluate(t, &b.batch), SOZAI_OK);
      if (batch_unfit(&b, BATCH_MAX)) {
        for (uint32_t o = 0; o < b.components; o++) {
          for (uint32_t i = 0; i < BATCH_MAX; i++) {
            if (isfinite(b.out[o][i])) continue;
            print_error("output %u of %s is %g for", o, k ? info->presets[k - 1]->id : id,
                        (double)b.out[o][i]);
            for (int a = 0; a < 16; a++) print_error(" %g", (double)b.in[a][i]);
            fail_msg("not finite");
          }
        }
      }
      points += BATCH_MAX;
    }
    p.textures->destroy(t);
  }
  print_message("%s, %s: %llu points, all finite\n", id, set, (unsigned long long)points);
}

static void always_finite(void **unused) {
  (void)unused;
  static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512", "neon"};
  for (int i = 0; i < 5; i++) finite_in("wood", sets[i]);
  for (int i = 0; i < 5; i++) finite_in("stone", sets[i]);
  for (int i = 0; i < 5; i++) finite_in("fiber", sets[i]);
  unsetenv("SOZAI_CPU");
}

static void evaluate(sozai_texture *t, full_batch *f) {
  assert_int_equal(p.textures->evaluate(t, &f->batch), SOZAI_OK);
}

static void same(const char *what) {
  for (uint32_t o = 0; o < b.components; o++) {
    for (uint32_t i = 0; i < b.batch.count; i++) {
      if (memcmp(&b.out[o][i], &other.out[o][i], sizeof(float)) != 0) {
        fail_msg("%s: output %u of point %u: %.9g and %.9g", what, o, i, (double)b.out[o][i],
                 (double)other.out[o][i]);
      }
    }
  }
}

static void fill(float *a, float x) {
  for (uint32_t i = 0; i < BATCH_MAX; i++) a[i] = x;
}

/* One input as it is and as it is said to be read: the same bits. */
static void read_as(sozai_texture *t, int first, int arrays, float given, float read,
                    const char *what) {
  for (int c = 0; c < arrays; c++) {
    batch_make(&b, info, 64);
    batch_make(&other, info, 64);
    fill(b.in[first + c], given);
    fill(other.in[first + c], read);
    evaluate(t, &b);
    evaluate(t, &other);
    same(what);
  }
}

/* A vector of no use is read as +z, or as no light. */
static void vector_read_as(sozai_texture *t, int first, float given, const float read[3],
                           const char *what) {
  batch_make(&b, info, 64);
  batch_make(&other, info, 64);
  for (int c = 0; c < 3; c++) {
    fill(b.in[first + c], given);
    fill(other.in[first + c], read[c]);
  }
  evaluate(t, &b);
  evaluate(t, &other);
  same(what);
}

static void header_says_of(const char *id, sozai_texture *t) {
  static const float up[3] = {0.0f, 0.0f, 1.0f};
  info = p.textures->find(id);
  assert_non_null(t);
  read_as(t, 0, 3, NAN, 0.0f, "a point's NaN is 0");
  read_as(t, 0, 3, INFINITY, 1e6f, "a point's infinity is a kilometre");
  read_as(t, 0, 3, -1e30f, -1e6f, "a point's -1e30 is minus a kilometre");
  read_as(t, 15, 1, NAN, 0.0f, "a footprint's NaN is 0");
  read_as(t, 15, 1, -5.0f, 0.0f, "a negative footprint is 0");
  read_as(t, 15, 1, INFINITY, 1e4f, "an infinite footprint is 1e4");
  read_as(t, 15, 1, 1e5f, 1e4f, "a footprint of 1e5 is 1e4");
  read_as(t, 9, 3, NAN, 0.0f, "a light colour's NaN is 0");
  read_as(t, 9, 3, INFINITY, 0.0f, "a light colour's infinity is 0");
  for (int first = 3; first <= 6; first += 3) {
    vector_read_as(t, first, 0.0f, up, "a zero vector is +z");
    vector_read_as(t, first, NAN, up, "a vector of NaN is +z");
    vector_read_as(t, first, INFINITY, up, "an infinite vector is +z");
  }
  /* NULL is the footprint 0, and the light 1 */
  batch_make(&b, info, 64);
  batch_make(&other, info, 64);
  b.batch.footprint = NULL;
  memset(b.batch.light_colour, 0, sizeof b.batch.light_colour);
  fill(other.in[15], 0.0f);
  for (int c = 9; c < 12; c++) fill(other.in[c], 1.0f);
  evaluate(t, &b);
  evaluate(t, &other);
  same("without a footprint and a light's colour");
  p.textures->destroy(t);
}

static void as_the_header_says(void **unused) {
  (void)unused;
  sozai_texture *stone = NULL;
  const sozai_value rough = {.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = "flamed"};
  assert_int_equal(p.textures->create(NULL, "stone", "inada", &rough, 1, &stone), SOZAI_OK);
  header_says_of("wood", plugin_wood(&p, "mizunara", "compound"));
  header_says_of("stone", stone);
  static const char *const fibers[] = {"felt", "denim"};
  for (int i = 0; i < 2; i++) {
    sozai_texture *t = NULL;
    assert_int_equal(p.textures->create(NULL, "fiber", fibers[i], NULL, 0, &t), SOZAI_OK);
    header_says_of("fiber", t);
  }
}

/* ring_radius and pith too. */
static void wood_functions(void **unused) {
  (void)unused;
  const sozai_wood_1 *wood = p.entry->get_factory(SOZAI_WOOD_1);
  sozai_texture *t = plugin_wood(&p, "sugi", "compound");
  float in[3][NASTY * NASTY], out[2][NASTY * NASTY];
  const uint32_t n = NASTY * NASTY;
  for (uint32_t i = 0; i < n; i++) {
    in[0][i] = nasty[i % NASTY];
    in[1][i] = nasty[i / NASTY];
    in[2][i] = nasty[(i * 7u + i / NASTY) % NASTY];
  }
  assert_int_equal(wood->ring_radius(t, n, in[0], in[1], in[2], out[0]), SOZAI_OK);
  for (uint32_t i = 0; i < n; i++) {
    if (!isfinite(out[0][i])) {
      fail_msg("ring_radius(%g, %g, %g) = %g", (double)in[0][i], (double)in[1][i], (double)in[2][i],
               (double)out[0][i]);
    }
  }
  assert_int_equal(wood->pith(t, n, in[1], out[0], out[1]), SOZAI_OK);
  for (uint32_t i = 0; i < n; i++) assert_true(isfinite(out[0][i]) && isfinite(out[1][i]));
  p.textures->destroy(t);
}

/* Seen against the light along the surface, as a coat on a relief hardly is: half way between the
 * two there is no direction. */
static void seen_against_the_light(void **unused) {
  (void)unused;
  const sozai_value values[] = {{.id = "finish", .kind = SOZAI_KIND_CHOICE, .text = "lacquered"},
                                {.id = "surface", .kind = SOZAI_KIND_CHOICE, .text = "planed"}};
  sozai_texture *t = NULL;
  assert_int_equal(p.textures->create(NULL, "wood", NULL, values, 2, &t), SOZAI_OK);
  for (uint32_t round = 0; round < 64; round++) {
    batch_make(&b, info, BATCH_MAX);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
      float aside = nasty[i % NASTY], turned = i & 1 ? -1e-30f : 0.0f;
      float off = ldexpf(1.0f, -(int)(i / NASTY % 80u));
      const float normal[3] = {1.0f, off < 1e-3f ? 0.0f : off, turned};
      const float light[3] = {round & 1 ? aside : off, 0.0f, 1.0f};
      for (int c = 0; c < 3; c++) {
        b.in[3 + c][i] = normal[c];
        b.in[6 + c][i] = light[c];
        b.in[12 + c][i] = c == 2 ? -1.0f : 0.0f;
      }
    }
    assert_int_equal(p.textures->evaluate(t, &b.batch), SOZAI_OK);
    assert_int_equal(batch_unfit(&b, BATCH_MAX), 0);
    for (uint32_t i = 0; i < BATCH_MAX; i++) {
      float most = b.out[3][i] / fmaxf(b.in[9][i], 1e-3f); /* radiance under the light's colour */
      if (most > 1e4f) fail_msg("radiance %g at point %u", (double)most, i);
    }
  }
  p.textures->destroy(t);
}

static int start(void **unused) {
  (void)unused;
  if (plugin_start(&p, SOZAI_TEST_PLUGIN)) return -1;
  info = p.textures->find("wood");
  return info ? 0 : -1;
}

static int stop(void **unused) {
  (void)unused;
  plugin_stop(&p);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(always_finite), cmocka_unit_test(as_the_header_says),
      cmocka_unit_test(wood_functions), cmocka_unit_test(seen_against_the_light)};
  return cmocka_run_group_tests(tests, start, stop);
}
