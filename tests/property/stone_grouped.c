/* SPDX-License-Identifier: Apache-2.0
 *
 * How specks lie: flakes show more edge for their area than equant ones, each its
 * own way; and where minerals cluster, small areas differ more, and large ones
 * and all together do not.
 */
#include <math.h>

#include "cmocka_all.h"
#include "wood.h"

enum { SPECK = 12, LINES = 150, STEPS = 2000 };
#define SIZE 2.0  /* mm, of specks */
#define STEP 0.02 /* mm */

static sozai_value number(const char *id, double x) {
  return (sozai_value){.id = id, .kind = SOZAI_KIND_FLOAT, .number = {x}};
}

static sozai_texture *specks(double flatness, double clustering) {
  const sozai_value v[] = {number("black_share", 0.06), number("white_share", 0.02),
                           number("speck_size", SIZE), number("speck_flatness", flatness),
                           number("speck_clustering", clustering)};
  sozai_texture *t = NULL;
  if (textures->create(NULL, "stone", NULL, v, 5, &t)) fail_msg("%s", textures->last_error());
  return t;
}

/* Along lines in a direction of the face: the specks' share of them, and how often
 * their edges are crossed, 1/mm. */
static void along_lines(const sozai_texture *t, double turn, double *share, double *crossed) {
  points p = {0};
  *share = *crossed = 0;
  uniform_seed(95);
  for (int l = 0; l < LINES; l++) {
    double x = 900 * (uniform() - 0.5), y = 900 * (uniform() - 0.5);
    points_clear(&p);
    for (int i = 0; i < STEPS; i++)
      points_add(&p, x + i * STEP * cos(turn), y + i * STEP * sin(turn), 0, 0);
    points_ask(&p, t);
    for (int i = 0; i < STEPS; i++) {
      *share += (double)p.out[SPECK][i] / (LINES * STEPS);
      if (i) *crossed += (p.out[SPECK][i] > 0.5f) != (p.out[SPECK][i - 1] > 0.5f);
    }
  }
  *crossed /= LINES * STEPS * STEP;
  points_free(&p);
}

/* Stereology: of bodies that fill a share of space, the surface to a volume is twice
 * the crossings to a length of line (Underwood, Quantitative Stereology, 1970). Leaves
 * of a seventh of their breadth have at least half as much again as equant bodies. */
static void flakes_are_flat(void **state) {
  (void)state;
  double share[3], crossed[3], other[2];
  static const double flatness[3] = {0, 0.5, 1};
  for (int k = 0; k < 3; k++) {
    sozai_texture *t = specks(flatness[k], 0);
    along_lines(t, 0.4, &share[k], &crossed[k]);
    if (k == 2) along_lines(t, 1.97, &other[0], &other[1]);
    textures->destroy(t);
    CHECK(fabs(share[k] / 0.08 - 1) < 0.08, "flatness %g: specks take %.4f of 0.08\n", flatness[k],
          share[k]);
  }
  CHECK(crossed[1] > 1.04 * crossed[0] && crossed[2] > 1.5 * crossed[0],
        "edges crossed: %.3f a mm by equant specks, %.3f by flat ones, %.3f by flakes\n",
        crossed[0], crossed[1], crossed[2]);
  CHECK(fabs(crossed[2] / other[1] - 1) < 0.08, "across that direction %.3f: they lie all ways\n",
        other[1]);
}

/* Sd of the specks' share over squares of some specks. */
static double unevenness(const sozai_texture *t, double side, double *mean) {
  enum { SQUARES = 600, ROW = 20, SAMPLES = ROW * ROW };
  points p = {0};
  double sum = 0, square = 0;
  uniform_seed(96);
  for (int s = 0; s < SQUARES; s++) {
    double x = 3000 * (uniform() - 0.5), y = 3000 * (uniform() - 0.5), share = 0;
    points_clear(&p);
    for (int i = 0; i < SAMPLES; i++)
      points_add(&p, x + side * (i % ROW + uniform()) / ROW, y + side * (i / ROW + uniform()) / ROW,
                 0, 0);
    points_ask(&p, t);
    for (int i = 0; i < SAMPLES; i++) share += (double)p.out[SPECK][i] / SAMPLES;
    sum += share;
    square += share * share;
  }
  points_free(&p);
  *mean = sum / SQUARES;
  return sqrt(square / SQUARES - *mean * *mean);
}

static void clusters_are_local(void **state) {
  (void)state;
  double near[2], mean[2], far[2];
  for (int k = 0; k < 2; k++) {
    sozai_texture *t = specks(0.8, k);
    near[k] = unevenness(t, 5 * SIZE, &mean[k]);
    far[k] = unevenness(t, 60 * SIZE, &mean[k]);
    textures->destroy(t);
  }
  CHECK(near[1] > 1.25 * near[0], "over 5 sizes the share's sd is %.4f, clustered %.4f\n", near[0],
        near[1]);
  CHECK(fabs(far[1] - far[0]) < 0.1 * near[1],
        "over 60 sizes it is %.4f, which is the samples' chance, clustered %.4f\n", far[0], far[1]);
  CHECK(fabs(mean[1] / mean[0] - 1) < 0.02, "the whole has %.4f, clustered %.4f\n", mean[0],
        mean[1]);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(flakes_are_flat),
                                     cmocka_unit_test(clusters_are_local)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
