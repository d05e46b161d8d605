/* SPDX-License-Identifier: Apache-2.0
 *
 * Slow-grown ring-porous wood, whose rings have less room than its rows of
 * vessels want: the wood's brightness is the same near and far, and no share
 * is above 1.
 */
#include <math.h>

#include "cmocka_all.h"
#include "wood.h"

#define SIDE 160

/* Means over a quarter-sawn face of 20 x 28 mm, a grid of SIDE^2 footprints; the most of `vessel`.
 */
static double mean_over(const sozai_texture *t, double footprint, double *vessel, double *most) {
  points p = {0};
  for (int j = 0; j < SIDE; j++)
    for (int i = 0; i < SIDE; i++)
      points_add(&p, 40 + 20.0 * i / SIDE, 300 + 28.0 * j / SIDE, 0, footprint);
  points_ask(&p, t);
  double sum = 0;
  *vessel = 0;
  for (unsigned k = 0; k < p.count; k++) {
    sum += points_value(&p, ALBEDO, k) / p.count;
    *vessel += points_value(&p, VESSEL, k) / p.count;
    *most = fmax(*most, points_value(&p, VESSEL, k));
  }
  points_free(&p);
  return sum;
}

static void near_is_far(void **state) {
  (void)state;
  static const char *const species[] = {"oak",      "white_oak", "red_oak", "mizunara", "keyaki",
                                        "chestnut", "kuri",      "ash",     "tamo",     "teak"};
  static const char *const widths[] = {"cut=quarter; ring_width=0.3", "cut=quarter; ring_width=0.5",
                                       "cut=quarter; ring_width=0.8", "cut=quarter"};
  static const double far[] = {0.1, 0.3, 1, 3};
  double worst = 0, vessels = 0, most = 0;
  for (unsigned s = 0; s < sizeof species / sizeof *species; s++) {
    for (unsigned k = 0; k < sizeof widths / sizeof *widths; k++) {
      sozai_texture *t = wood_make(species[s], widths[k]);
      double at_points, v, albedo = mean_over(t, 0, &at_points, &most);
      for (unsigned f = 0; f < sizeof far / sizeof *far; f++) {
        double apart = fabs(mean_over(t, far[f], &v, &most) - albedo);
        if (apart > 0.006)
          print_message("%s, %s: albedo off by %.4f at %g mm\n", species[s], widths[k], apart,
                        far[f]);
        worst = fmax(worst, apart);
        vessels = fmax(vessels, fabs(v - at_points));
      }
      textures->destroy(t);
    }
  }
  CHECK(worst <= 0.012 && vessels <= 0.05 && most <= 1,
        "mean albedo is off by at most %.4f, the share of vessels by %.3f, whose most is %.7f\n",
        worst, vessels, most);
}

/* Bands of vessels leave those as wide as a ring no room. */
static void vessels_as_wide_as_rings(void **state) {
  (void)state;
  static const char *const values[] = {
      "surface=sanded; ring_width=0.2; vessel_diameter=400",
      "surface=sanded; ring_width=0.2; vessel_diameter=400; vessel_arrangement=diagonal",
      "surface=sanded; ring_width=0.2; vessel_diameter=250; vessel_arrangement=radial",
      "surface=sanded; ring_width=0.4; vessel_diameter=500; vessel_arrangement=dendritic"};
  static const char *const species[] = {NULL,  "mizunara", "kuri",    "oak",
                                        "elm", "holly",    "red_oak", "jarrah"};
  unsigned odd = 0, all = 0;
  for (unsigned s = 0; s < sizeof species / sizeof *species; s++) {
    for (unsigned k = 0; k < sizeof values / sizeof *values; k++) {
      sozai_texture *t = wood_make(species[s], values[k]);
      points p = {0};
      uniform_seed(9);
      for (int i = 0; i < 300; i++)
        points_add(&p, 60 * uniform(), 60 * uniform(), 0, i % 3 ? 3 * uniform() : 0);
      points_ask(&p, t);
      for (unsigned i = 0; i < p.count; i++, all++) {
        double v = points_value(&p, VESSEL, i), a = points_value(&p, ALBEDO, i);
        odd += !isfinite(points_value(&p, HEIGHT, i)) || !(v >= 0 && v <= 1) || !(a > 0 && a < 1);
      }
      points_free(&p);
      textures->destroy(t);
    }
  }
  CHECK(!odd, "%u of %u places have a height, a share of vessels or an albedo that cannot be\n",
        odd, all);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(near_is_far),
                                     cmocka_unit_test(vessels_as_wide_as_rings)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
