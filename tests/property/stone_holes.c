/* SPDX-License-Identifier: Apache-2.0
 *
 * Holes in stone: how many of them are small, and how they differ.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "lines.h"
#include "wood.h"

/* Holes alone, in black. */
#define PLAIN                                                                                      \
  "grain_variation=0; second_share=0; third_share=0; mottle=0; cleavage=0; turbidity=0; "          \
  "base_colour=0 0 0 @ lin_rec709; hole_colour=0.5 0.5 0.5 @ lin_rec709; hole_size=3; "            \
  "hole_raggedness=0; "

#define SHARE 0.1 /* what holes fill is measured at creation, to some 3 % */

static void cut_by_lines(double fines, double *covered, double *begin) {
  char text[400];
  snprintf(text, sizeof text, PLAIN "hole_share=%g; hole_fines=%g", SHARE, fines);
  sozai_texture *t = stone_make(NULL, text);
  uniform_seed(73);
  lines_meet(&(lines){2000, 2000, 0.1}, t, covered, begin);
  textures->destroy(t);
}

/* A line meets balls by the square of their radius, and lies in them by its cube: of radii from
 * 0.32 to 1, evenly spread, it meets E[r^2] / E[r^3] = 1.303 to what it covers; of 0.32 + 0.68 v^2,
 * v evenly spread, 1.440. Some balls are cut by their cells' faces, the large ones more. */
static void fines_are_small(void **state) {
  (void)state;
  double covered[2], begin[2];
  for (int k = 0; k < 2; k++) {
    cut_by_lines(k, &covered[k], &begin[k]);
    CHECK(fabs(covered[k] - SHARE) < 0.006, "hole_fines=%d: holes take %.4f of a line, of %g\n", k,
          covered[k], SHARE);
  }
  double more = begin[1] / begin[0] * covered[0] / covered[1];
  CHECK(fabs(more - 1.440 / 1.303) < 0.04,
        "with hole_fines a line meets %.3f as many holes, %.3f if all were balls\n", more,
        1.440 / 1.303);
}

/* Whether a place is on a hole's edge, which has a width even to a point: a step from it, as small
 * as its coordinates have, there is none. */
static int on_edge(const sozai_texture *t, const points *p, unsigned i) {
  points near = {0};
  for (int k = 0; k < 6; k++) {
    double step[3] = {0, 0, 0};
    step[k / 2] = k % 2 ? 1e-3 : -1e-3;
    points_add(&near, (double)p->point[0][i] + step[0], (double)p->point[1][i] + step[1],
               (double)p->point[2][i] + step[2], 0);
  }
  points_ask_only(&near, t, ONLY3(ALBEDO));
  int none = 0;
  for (unsigned k = 0; k < near.count; k++) none |= (double)near.out[ALBEDO][k] <= 0;
  points_free(&near);
  return none;
}

/* A hole is of one shade, up to `hole_variation` off its colour either way, evenly spread. */
static void holes_differ(void **state) {
  (void)state;
  static const double variation[] = {0, 0.2, 0.5};
  for (int k = 0; k < 3; k++) {
    char text[400];
    snprintf(text, sizeof text, PLAIN "hole_share=%g; hole_variation=%g", SHARE, variation[k]);
    sozai_texture *t = stone_make(NULL, text);
    points p = {0};
    uniform_seed(74);
    for (int i = 0; i < 400000; i++)
      points_add(&p, 8000 * uniform(), 8000 * uniform(), 8000 * uniform(), 0);
    points_ask_only(&p, t, ONLY3(ALBEDO));
    double count = 0, sum = 0, square = 0, most = 0;
    for (unsigned i = 0; i < p.count; i++) {
      double x = (double)p.out[ALBEDO][i] / 0.5;
      if (x <= 0.1) continue;
      count++;
      sum += x;
      square += x * x;
      if (fabs(x - 1) > variation[k] + 1e-5 && on_edge(t, &p, i)) continue;
      most = fmax(most, fabs(x - 1));
    }
    double mean = sum / count, sd = sqrt(fmax(square / count - mean * mean, 0));
    CHECK(count > 30000 && fabs(mean - 1) < 0.01 && most <= variation[k] + 1e-5 &&
              fabs(sd - variation[k] / sqrt(3)) < 0.01,
          "hole_variation=%g: %.0f places in holes are %.4f of the colour, sd %.4f (%.4f), at most "
          "%.4f off\n",
          variation[k], count, mean, sd, variation[k] / sqrt(3), most);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(fines_are_small),
                                     cmocka_unit_test(holes_differ)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
