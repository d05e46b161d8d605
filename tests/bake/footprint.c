/* SPDX-License-Identifier: Apache-2.0
 *
 * What a texel that is longer than wide should be given as footprint, which is
 * a square: the root of its area, or its longer side? Measured against the
 * average over the texel itself, of wood along and across the grain; prints the
 * errors, root of the mean square. Wood hardly changes along the grain, so that
 * the texel's side across the grain would be best, whichever side it is: on
 * the average of both ways the two are level, and the root's worst is less. */
#include "plugin.h" /* before cmocka, which has another `fail` */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define TEXELS 400
#define SAMPLES 576 /* of a texel, in a grid as stretched as the texel */

typedef struct wood {
  plugin plugin;
  sozai_texture *texture;
  const sozai_channel *albedo;
} wood;

static void open_wood(wood *w) {
  failure why;
  setenv("SOZAI_PLUGIN", SOZAI_TEST_PLUGIN, 1);
  if (!plugin_open(&w->plugin, &why)) fail_msg("%s", why.text);
  const sozai_textures_1 *t = w->plugin.textures;
  assert_int_equal(t->create(NULL, "wood", "keyaki", NULL, 0, &w->texture), SOZAI_OK);
  const sozai_texture_info *info = t->find("wood");
  for (uint32_t i = 0; i < info->channel_count; i++)
    if (strcmp(info->channels[i]->id, "albedo") == 0) w->albedo = info->channels[i];
  assert_non_null(w->albedo);
}

/* Albedo's green at points of the plane z = 40 mm. */
static void evaluate(const wood *w, uint32_t count, float *x, float *y, float footprint,
                     float *green) {
  static float z[TEXELS * SAMPLES], zero[TEXELS * SAMPLES], one[TEXELS * SAMPLES];
  static float side[TEXELS * SAMPLES];
  float *out[64] = {NULL};
  for (uint32_t i = 0; i < count; i++) z[i] = 40, one[i] = 1, side[i] = footprint;
  out[w->albedo->first + 1] = green;
  sozai_batch b = {.size = sizeof b,
                   .count = count,
                   .point = {x, y, z},
                   .normal = {zero, zero, one},
                   .footprint = side,
                   .out = out,
                   .out_count = 64};
  assert_int_equal(w->plugin.textures->evaluate(w->texture, &b), SOZAI_OK);
}

static double root_mean_square(const float *a, const double *b) {
  double sum = 0;
  for (int i = 0; i < TEXELS; i++) sum += ((double)a[i] - b[i]) * ((double)a[i] - b[i]);
  return sqrt(sum / TEXELS);
}

/* Texels of across x along mm: errors with either footprint. */
static void measure(const wood *w, double across, double along, double errors[2]) {
  static float x[TEXELS * SAMPLES], y[TEXELS * SAMPLES], fine[TEXELS * SAMPLES];
  float cx[TEXELS], cy[TEXELS], got[TEXELS];
  double truth[TEXELS] = {0};
  uint32_t state = 5;
  int columns = (int)fmax(1, fmin(SAMPLES, round(24 * sqrt(across / along))));
  int rows = SAMPLES / columns;
  for (int i = 0; i < TEXELS; i++) {
    state = state * 1664525u + 1013904223u;
    cx[i] = (float)((state >> 8) / 16777216.0 * 200 - 100);
    state = state * 1664525u + 1013904223u;
    cy[i] = (float)((state >> 8) / 16777216.0 * 200 - 100);
    for (int k = 0; k < columns * rows; k++) {
      x[i * columns * rows + k] = cx[i] + (float)(((k % columns + 0.5) / columns - 0.5) * across);
      y[i * columns * rows + k] = cy[i] + (float)(((k / columns + 0.5) / rows - 0.5) * along);
    }
  }
  int each = columns * rows;
  evaluate(w, (uint32_t)(TEXELS * each), x, y, (float)(across / columns), fine);
  for (int i = 0; i < TEXELS; i++)
    for (int k = 0; k < each; k++) truth[i] += (double)fine[i * each + k] / each;
  evaluate(w, TEXELS, cx, cy, (float)sqrt(across * along), got);
  errors[0] = root_mean_square(got, truth);
  evaluate(w, TEXELS, cx, cy, (float)fmax(across, along), got);
  errors[1] = root_mean_square(got, truth);
}

static void the_root_of_the_area_has_the_smaller_worst_error(void **state) {
  (void)state;
  wood w;
  open_wood(&w);
  double sum[2] = {0}, worst[2] = {0};
  printf("%8s %8s %10s %10s\n", "across", "along", "root", "longer");
  for (double side = 0.25; side <= 4; side *= 2)
    for (double stretch = 0.25; stretch <= 4; stretch *= 2) {
      double errors[2], across = side * sqrt(stretch), along = side / sqrt(stretch);
      measure(&w, across, along, errors);
      printf("%8.3f %8.3f %10.5f %10.5f\n", across, along, errors[0], errors[1]);
      if (stretch == 1) continue;
      for (int k = 0; k < 2; k++) {
        sum[k] += errors[k];
        worst[k] = fmax(worst[k], errors[k]);
      }
    }
  printf("%17s %10.5f %10.5f\n", "stretched, mean", sum[0] / 20, sum[1] / 20);
  printf("%17s %10.5f %10.5f\n", "stretched, worst", worst[0], worst[1]);
  assert_true(worst[0] < worst[1]);
  assert_true(sum[0] < 1.1 * sum[1]);
  w.plugin.textures->destroy(w.texture);
  plugin_close(&w.plugin);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_root_of_the_area_has_the_smaller_worst_error)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
