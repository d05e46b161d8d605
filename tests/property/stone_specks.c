/* SPDX-License-Identifier: Apache-2.0
 *
 * Specks in stone: how ragged their outlines are, and how long gabbro's laths.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "lines.h"
#include "wood.h"

/* Specks alone, in light grey on black. */
#define PLAIN                                                                                      \
  "grain_variation=0; second_share=0; third_share=0; mottle=0; cleavage=0; turbidity=0; "          \
  "base_colour=0 0 0 @ lin_rec709; white_colour=0.5 0.5 0.5 @ lin_rec709; speck_size=3; "

#define SHARE 0.1 /* what specks fill is measured at creation, to some 3 % */

static void cut_by_lines(double grains, double ragged, double *covered, double *begin) {
  char text[400];
  snprintf(text, sizeof text, PLAIN "white_share=%g; grain_size=%g; speck_raggedness=%g", SHARE,
           grains, ragged);
  sozai_texture *t = stone_make(NULL, text);
  uniform_seed(75);
  lines_meet(&(lines){800, 4000, 0.05}, t, covered, begin);
  textures->destroy(t);
}

/* How much larger a surface is, at places moved by noises of a gradient of sd s along each axis
 * for each of their three numbers: E |n + g|, by sampling, were the gradients normal. */
static double larger(double s) {
  double sum = 0;
  enum { SAMPLES = 200000 };
  uniform_seed(76);
  for (int i = 0; i < SAMPLES; i++) {
    double g[4];
    for (int k = 0; k < 4; k += 2) {
      double r = sqrt(-2 * log(1 - uniform())), a = 2 * acos(-1) * uniform();
      g[k] = s * r * cos(a);
      g[k + 1] = s * r * sin(a);
    }
    sum += sqrt((1 + g[0]) * (1 + g[0]) + g[1] * g[1] + g[2] * g[2]);
  }
  return sum / SAMPLES;
}

/* A line meets an outline as often as there is surface. Bends are value noise of sd 0.45 times
 * their height, mixed by 3 t^2 - 2 t^3, whose gradient has 2.4 / (26/35) of its variance along each
 * axis, times the frequency squared: 1.15 to a speck with a height of 0.2 (0.51 + 0.6 r), and 3.5
 * with 0.18 r. Where crystals are as large, the noises are theirs. */
static void frayed_outlines_are_longer(void **state) {
  (void)state;
  static const double grains[] = {20, 3}, ragged[] = {0, 0.5, 1};
  for (int g = 0; g < 2; g++) {
    double smooth[2] = {1, 1};
    for (int k = 0; k < 3; k++) {
      double r = ragged[k], covered, begin;
      double coarse = 1.15 * 0.2 * (0.51 + 0.6 * r), fine = 3.5 * 0.18 * r;
      double surface = larger(0.45 * sqrt(2.4 / (26.0 / 35.0) * (coarse * coarse + fine * fine)));
      cut_by_lines(grains[g], r, &covered, &begin);
      if (k == 0) smooth[0] = begin / covered, smooth[1] = surface;
      double more = begin / covered / smooth[0], expected = surface / smooth[1];
      CHECK(fabs(covered - SHARE) < 0.006,
            "speck_raggedness=%g: specks take %.4f of a line, of %g\n", r, covered, SHARE);
      CHECK(fabs(more / expected - 1) < 0.02,
            "speck_raggedness=%g, crystals of %g mm: a line meets %.3f as many, of %.3f\n", r,
            grains[g], more, expected);
    }
  }
}

enum { SIDE = 800 };

/* Of a speck on a raster: its pixels, and sums of their places and products of these. */
typedef struct {
  double n, x, y, xx, xy, yy;
  int cut; /* by the raster's border */
} speck;

/* Empties the speck that a pixel is of. */
static void take(unsigned char *seen, int *heap, int at, speck *s) {
  static const int way[4] = {1, -1, SIDE, -SIDE};
  int count = 0;
  heap[count++] = at;
  seen[at] = 0;
  while (count) {
    at = heap[--count];
    int i = at % SIDE, j = at / SIDE;
    s->n++;
    s->x += i, s->y += j;
    s->xx += i * i, s->xy += i * j, s->yy += j * j;
    if (i == 0 || j == 0 || i == SIDE - 1 || j == SIDE - 1) {
      s->cut = 1;
      continue;
    }
    for (int k = 0; k < 4; k++) {
      int next = at + way[k];
      if (seen[next]) heap[count++] = next;
      seen[next] = 0;
    }
  }
}

/* How long the specks are over how wide, of those that lie apart: the root of their second moments'
 * ratio, in the mean. */
static double elongation(const char *settings, int *count) {
  static unsigned char seen[SIDE * SIDE];
  static int heap[SIDE * SIDE];
  sozai_texture *t = stone_make("gabbro", settings);
  points p = {0};
  for (int j = 0; j < SIDE; j++)
    for (int i = 0; i < SIDE; i++) points_add(&p, 0.1 * i, 0.1 * j, 0, 0);
  points_ask_only(&p, t, ONLY3(ALBEDO));
  for (int i = 0; i < SIDE * SIDE; i++) seen[i] = p.out[ALBEDO][i] > 0.5f;
  points_free(&p);
  textures->destroy(t);
  double sum = 0;
  *count = 0;
  for (int at = 0; at < SIDE * SIDE; at++) {
    if (!seen[at]) continue;
    speck s = {0};
    take(seen, heap, at, &s);
    if (s.cut || s.n < 40) continue;
    double x = s.x / s.n, y = s.y / s.n, xx = s.xx / s.n - x * x, yy = s.yy / s.n - y * y,
           xy = s.xy / s.n - x * y, half = 0.5 * (xx + yy),
           root = sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
    sum += sqrt((half + root) / (half - root));
    ++*count;
  }
  return sum / *count;
}

/* Of the preset's laths as many as lie apart, in light alone. */
#define LATHS                                                                                      \
  "white_share=0.06; black_share=0; white_colour=1 1 1 @ lin_rec709; base_colour=0 0 0 @ "         \
  "lin_rec709; second_colour=0 0 0 @ lin_rec709; third_colour=0 0 0 @ lin_rec709; "                \
  "grain_variation=0; cleavage=0"

static void gabbro_has_laths(void **state) {
  (void)state;
  int count[2];
  double laths = elongation(LATHS, &count[0]);
  double grains = elongation(LATHS "; speck_flatness=0", &count[1]);
  CHECK(count[0] > 60 && count[1] > 60 && laths > 2.2 && grains < 1.8,
        "%d laths are %.2f times as long as wide, %d grains that are not flat %.2f\n", count[0],
        laths, count[1], grains);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(frayed_outlines_are_longer),
                                     cmocka_unit_test(gabbro_has_laths)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
