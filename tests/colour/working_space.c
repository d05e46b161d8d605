/* SPDX-License-Identifier: Apache-2.0
 *
 * The same wood in any working space: what the plugin gives under configs whose
 * working spaces differ is the same colour, as CIE XYZ adapted to D65. The light
 * is white: what a product of coloured light and colour is, three numbers cannot
 * say the same of in every space.
 */
#define _GNU_SOURCE /* unsetenv */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "colorimetry.h"
#include "sozai.h"

#define CONFIG(name) SOZAI_TEST_DATA "/configs/" name ".ocio"
#define BLENDER "/usr/share/blender/datafiles/colormanagement/config.ocio"

enum { POINTS = 10000, INPUTS = 9 };

static void *library;
static const sozai_entry_v1 *entry;
static const sozai_textures_1 *textures;

/* Points in a block of 0.6 m, normals and lights of every direction. */
static float inputs[INPUTS][POINTS], footprints[POINTS];

static void make_inputs(void) {
  uint32_t x = 12345;
  for (int i = 0; i < POINTS; i++)
    for (int k = 0; k < INPUTS; k++) {
      x = x * 1664525u + 1013904223u;
      inputs[k][i] = (float)(x >> 8) / 8388608.0f - 1.0f;
      if (k < 3) inputs[k][i] *= 300;
    }
}

static int setup(void **state) {
  (void)state;
  unsetenv("OCIO");
  unsetenv("OCIO_OPTIMIZATION_FLAGS");
  library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  if (!library) fail_msg("%s", dlerror());
  entry = dlsym(library, SOZAI_ENTRY_SYMBOL);
  assert_non_null(entry);
  assert_int_equal(entry->init(SOZAI_TEST_PLUGIN), SOZAI_OK);
  textures = entry->get_factory(SOZAI_TEXTURES_1);
  make_inputs();
  return 0;
}

static int teardown(void **state) {
  (void)state;
  entry->deinit();
  return dlclose(library);
}

typedef struct answers {
  float albedo[3][POINTS], radiance[3][POINTS];
} answers;

static uint32_t first_of(const sozai_texture_info *info, const char *channel) {
  for (uint32_t i = 0; i < info->channel_count; i++)
    if (strcmp(info->channels[i]->id, channel) == 0) return info->channels[i]->first;
  fail_msg("no channel %s", channel);
  return 0;
}

static int warned;
static void note(void *user, int32_t severity, const char *text) {
  (void)user;
  if (severity < SOZAI_LOG_WARNING) return;
  print_message("%s\n", text);
  warned++;
}

/* Colours that no display has: negative in linear Rec.709, and nothing may cut them. */
static const sozai_value wide[] = {
    {.id = "earlywood_colour",
     .kind = SOZAI_KIND_COLOUR,
     .number = {0.02, 0.5, 0.03},
     .text = "ACES2065-1"},
    {.id = "latewood_colour",
     .kind = SOZAI_KIND_COLOUR,
     .number = {0.6, 0.05, 0.01},
     .text = "ACES2065-1"},
    {.id = "vessel_colour",
     .kind = SOZAI_KIND_COLOUR,
     .number = {0.02, 0.03, 0.4},
     .text = "ACES2065-1"},
};
enum { WIDE = sizeof wide / sizeof *wide };

static const char *material = "wood";

/* config NULL: the shipped one. The first `given` of wide are used. */
static void evaluate(const char *config, const char *preset, uint32_t given, float footprint,
                     answers *out) {
  sozai_host host = {.size = sizeof host, .log = note, .colour_config = config};
  sozai_texture *t;
  if (textures->create(&host, material, preset, wide, given, &t) != SOZAI_OK)
    fail_msg("%s: %s", preset, textures->last_error());
  const sozai_texture_info *info = textures->info_of(t);
  float *channels[64] = {0};
  assert_true(info->component_count <= 64);
  for (uint32_t c = 0; c < 3; c++) {
    channels[first_of(info, "albedo") + c] = out->albedo[c];
    channels[first_of(info, "radiance") + c] = out->radiance[c];
  }
  for (int i = 0; i < POINTS; i++) footprints[i] = footprint;
  sozai_batch b = {.size = sizeof b,
                   .count = POINTS,
                   .point = {inputs[0], inputs[1], inputs[2]},
                   .normal = {inputs[3], inputs[4], inputs[5]},
                   .light = {inputs[6], inputs[7], inputs[8]},
                   .footprint = footprints,
                   .out = channels,
                   .out_count = info->component_count};
  assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
  textures->destroy(t);
}

/* To XYZ under D65; another white is adapted by Bradford. */
static matrix meaning(primaries p) { return product(rgb_to_xyz(rec709), rgb_to_rgb(p, rec709)); }

static double difference(matrix ma, float (*a)[POINTS], matrix mb, float (*b)[POINTS]) {
  double worst = 0;
  for (int i = 0; i < POINTS; i++) {
    const double va[3] = {a[0][i], a[1][i], a[2][i]}, vb[3] = {b[0][i], b[1][i], b[2][i]};
    double xa[3], xb[3];
    transform(ma, va, xa);
    transform(mb, vb, xb);
    for (int c = 0; c < 3; c++) worst = fmax(worst, fabs(xa[c] - xb[c]));
  }
  return worst;
}

static const float sizes[] = {0, 0.5f, 20};

typedef struct errors {
  double albedo, radiance;
  double apart; /* of the numbers themselves */
  double least; /* of the shipped config's numbers */
} errors;

static void add(const char *config, const primaries *working, const char *preset, uint32_t given,
                errors *e) {
  static answers want, got;
  for (size_t f = 0; f < sizeof sizes / sizeof *sizes; f++) {
    evaluate(NULL, preset, given, sizes[f], &want);
    evaluate(config, preset, given, sizes[f], &got);
    const matrix a = meaning(rec709), b = meaning(*working);
    e->albedo = fmax(e->albedo, difference(a, want.albedo, b, got.albedo));
    e->radiance = fmax(e->radiance, difference(a, want.radiance, b, got.radiance));
    e->apart = fmax(e->apart, difference(a, want.albedo, a, got.albedo));
    for (int i = 0; i < POINTS * 3; i++)
      e->least = fmin(e->least, (double)want.albedo[i / POINTS][i % POINTS]);
  }
}

static void judge(const char *config, const char *what, const errors *e) {
  print_message("%s, %s, %d points, 3 footprints: XYZ off by %.2g at most in albedo, %.2g in "
                "radiance; the numbers themselves differ by %.2g\n",
                strrchr(config, '/') + 1, what, POINTS, e->albedo, e->radiance, e->apart);
  assert_true(e->albedo < 1e-4);
  assert_true(e->radiance < 1e-4);
  assert_int_equal(warned, 0);
}

static void compare(const char *config, const primaries *working) {
  if (access(config, R_OK) != 0) skip();
  const sozai_texture_info *wood = textures->find("wood");
  assert_non_null(wood);
  assert_true(wood->preset_count >= 9);
  errors e = {0};
  for (uint32_t k = 0; k < wood->preset_count; k++)
    add(config, working, wood->presets[k]->id, 0, &e);
  judge(config, "every preset", &e);
  /* Or it would show nothing. */
  if (working != &rec709) assert_true(e.apart > 0.01);
}

/* Fibres too: their white gloss is white in every space. */
static void compare_fibers(const char *config, const primaries *working) {
  if (access(config, R_OK) != 0) skip();
  const sozai_texture_info *fiber = textures->find("fiber");
  assert_non_null(fiber);
  errors e = {0};
  material = "fiber";
  for (uint32_t k = 0; k < fiber->preset_count; k++)
    add(config, working, fiber->presets[k]->id, 0, &e);
  material = "wood";
  judge(config, "every fibre", &e);
  if (working != &rec709) assert_true(e.apart > 0.01);
}

static void compare_wide(const char *config, const primaries *working) {
  errors e = {0};
  add(config, working, "keyaki", WIDE, &e);
  judge(config, "wide colours", &e);
  assert_true(e.least < -0.1);
}

static void acescg(void **state) {
  (void)state;
  compare(CONFIG("acescg"), &aces_ap1);
  compare_wide(CONFIG("acescg"), &aces_ap1);
  compare_fibers(CONFIG("acescg"), &aces_ap1);
}
static void p3d65(void **state) {
  (void)state;
  compare(CONFIG("p3d65"), &p3_d65);
  compare_wide(CONFIG("p3d65"), &p3_d65);
  compare_fibers(CONFIG("p3d65"), &p3_d65);
}
static void blender(void **state) {
  (void)state;
  compare(BLENDER, &rec709);
}

/* A config that says nothing of colours: linear Rec.709 by formula, and a warning. */
static void raw(void **state) {
  (void)state;
  warned = 0;
  errors e = {0};
  add(CONFIG("created_raw"), &rec709, "keyaki", 0, &e);
  assert_int_equal(warned, 1);
  warned = 0;
  judge(CONFIG("created_raw"), "keyaki", &e);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(acescg), cmocka_unit_test(p3d65),
                                     cmocka_unit_test(blender), cmocka_unit_test(raw)};
  return cmocka_run_group_tests(tests, setup, teardown);
}
