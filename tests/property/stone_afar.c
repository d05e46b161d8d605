/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone from afar: under footprints of some millimetres to a hand's breadth against the points in
 * them, lit.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "truth.h"

enum { S_RADIANCE = 3, S_OCCLUSION = 21 };

static double at(const points *p, int what, unsigned i) { return (double)p->out[what][i]; }

/* A square and its footprint, the last point, under a light. */
static void square(points *p, double x, double y, double size, double turn, double height) {
  double flat = sqrt(1 - height * height);
  points_clear(p);
  for (int i = 0; i <= TRUTH_SAMPLES; i++) {
    double u = ((i % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
    double v = ((i / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
    int far = i == TRUTH_SAMPLES;
    unsigned q = points_add(p, far ? x : x + u, far ? y : y + v, 0, far ? size : 0);
    p->light[0][q] = (float)(flat * cos(turn));
    p->light[1][q] = (float)(flat * sin(turn));
    p->light[2][q] = (float)height;
  }
}

/* Means over squares of a size: of what footprints of that size answer, over what points in them
 * do. Of light from every side at a height, of the radiance upwards; and of the share of the sky.
 */
static void far_over_near(points *p, const sozai_texture *t, int places, double size, double height,
                          double *lit, double *sky) {
  double sum[2][2] = {{0, 0}, {0, 0}};
  uniform_seed(95);
  for (int place = 0; place < places; place++) {
    double x = 1600 * (uniform() - 0.5), y = 1600 * (uniform() - 0.5);
    double turn = 6.2831853 * uniform();
    square(p, x, y, size, turn, height);
    points_ask_only(p, t, ONLY3(S_RADIANCE) | ONLY(S_OCCLUSION));
    for (unsigned i = 0; i <= TRUTH_SAMPLES; i++) {
      double part = i < TRUTH_SAMPLES ? 1.0 / TRUTH_SAMPLES : 1;
      sum[i == TRUTH_SAMPLES][0] += part * at(p, S_RADIANCE + 1, i);
      sum[i == TRUTH_SAMPLES][1] += part * at(p, S_OCCLUSION, i);
    }
  }
  *lit = sum[1][0] / sum[0][0];
  *sky = sum[1][1] / sum[0][1];
}

/* Whatever lies between lights what it leans to and shades the rest: from afar a ground is as
 * bright as it is near by, and sees as much of the sky. */
static void grounds_are_as_bright(void **state) {
  (void)state;
  static const struct {
    const char *preset, *parameters;
    int places;            /* more where the stone itself varies, by some 0.01 a place */
    double low, high, sky; /* of the light; and of the sky, how far off 1 */
  } cases[] = {{"araidashi", "", 48, 0.95, 1.11, 0.02},
               {"exposed_aggregate", "", 48, 0.94, 1.07, 0.02},
               {"inada", "finish=flamed", 192, 0.97, 1.02, 0.01},
               {"inada", "finish=bush_hammered", 192, 0.96, 1.03, 0.02},
               {"inada", "finish=split", 192, 0.97, 1.05, 0.01},
               {"slate", "finish=riven", 48, 0.89, 1.02, 0.02},
               {"granite_fan", "", 48, 0.93, 1.09, 0.06},
               {"porphyry", "", 48, 0.90, 1.10, 0.05},
               {"belgian_block", "", 48, 0.92, 1.07, 0.08}};
  static const double sizes[] = {3, 10, 37, 100}, heights[] = {0.259, 0.5, 0.743, 1};
  points p = {0};
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    sozai_texture *t = stone_make(cases[k].preset, cases[k].parameters);
    double least = 1e9, most = 0, off = 0;
    for (int i = 0; i < 16; i++) {
      double lit, sky;
      far_over_near(&p, t, cases[k].places, sizes[i / 4], heights[i % 4], &lit, &sky);
      least = fmin(least, lit);
      most = fmax(most, lit);
      off = fmax(off, fabs(sky - 1));
    }
    CHECK(least >= cases[k].low && most <= cases[k].high && off <= cases[k].sky,
          "%-17s %-20s far over near %.3f to %.3f (%g to %g); of the sky off %.3f (%g)\n",
          cases[k].preset, cases[k].parameters, least, most, cases[k].low, cases[k].high, off,
          cases[k].sky);
    textures->destroy(t);
  }
  points_free(&p);
}

/* What the error of footprints is of the contrast that their squares have, as a split face is lit
 * aslant: planes are no noise, and one place of them says little about a footprint. */
static void facets_under_footprints(void **state) {
  (void)state;
  enum { PLACES = 300 };
  static const double sizes[] = {1, 3, 10, 20};
  points p = {0};
  sozai_texture *t = stone_make("inada", "finish=split");
  for (int f = 0; f < 4; f++) {
    double off = 0, mean = 0, all = 0;
    uniform_seed(96);
    for (int i = 0; i < PLACES; i++) {
      double x = 1600 * (uniform() - 0.5), y = 1600 * (uniform() - 0.5), near = 0;
      square(&p, x, y, sizes[f], 0.7854, 0.5);
      points_ask_only(&p, t, ONLY3(S_RADIANCE));
      for (unsigned k = 0; k < TRUTH_SAMPLES; k++)
        near += at(&p, S_RADIANCE + 1, k) / TRUTH_SAMPLES;
      double d = at(&p, S_RADIANCE + 1, TRUTH_SAMPLES) - near;
      off += d * d / PLACES;
      mean += near / PLACES;
      all += near * near / PLACES;
    }
    double contrast = sqrt(all - mean * mean), part = sqrt(off) / contrast;
    CHECK(part < 0.4, "split, %g mm: contrast %.3f of the mean, error %.3f of that\n", sizes[f],
          contrast / mean, part);
  }
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(grounds_are_as_bright),
                                     cmocka_unit_test(facets_under_footprints)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
