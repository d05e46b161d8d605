/* SPDX-License-Identifier: Apache-2.0
 *
 * Footprints across boards: albedo against the average of 1,024 points of the
 * square, anywhere and astride joints, by layout and footprint. The neighbour's
 * wood is not looked up, its shade is where the footprint is wide. Anywhere the
 * goal is wood's own, up to the 100 mm that it is set for; astride of joints, a
 * small part of a floor, errors are held to where they are.
 */
#include <math.h>

#include "cmocka_all.h"
#include "truth.h"

enum { PLACES = 600 };

static void against_1024_samples(void **state) {
  (void)state;
  static const double sizes[] = {0.1, 0.3, 1, 3, 10, 30, 100, 300};
  static const char *const layouts[] = {"layout=strip; joint_width=0.6",
                                        "layout=herringbone; joint_width=0.6",
                                        "layout=versailles; joint_width=0.6",
                                        "layout=chidori; joint_width=6; joint_colour=#808080",
                                        "layout=hexagon; joint_width=6; joint_colour=#808080",
                                        "layout=crazy; joint_width=10; joint_colour=#808080"};
  print_message("RMS / mean error of albedo, by footprint in mm:\n%-22s", "");
  for (unsigned f = 0; f < 8; f++) print_message("%16g", sizes[f]);
  print_message("\n");
  double worst = 0, worst_mean = 0, beyond = 0, astride = 0;
  points p = {0};
  for (unsigned k = 0; k < 12; k++) {
    const char *layout = layouts[k / 2];
    sozai_texture *t = wood_make("mizunara", layout);
    print_message("%-12.12s%-10s", layout + 7, k & 1 ? " astride" : " anywhere");
    for (unsigned f = 0; f < 8; f++) {
      uniform_seed(91);
      truth_errors errors = {0};
      for (int place = 0; place < PLACES; place++) {
        double x = 3000 * (uniform() - 0.5), y = 3000 * (uniform() - 0.5);
        if (k & 1) { /* down the edge's slope, to a joint's middle */
          for (int step = 0; step < 6; step++) {
            points_clear(&p);
            points_add(&p, x, y, 0, 0);
            points_add(&p, x + 0.1, y, 0, 0);
            points_add(&p, x, y + 0.1, 0, 0);
            points_ask(&p, t);
            double e = (double)p.out[BOARD_EDGE][0];
            double gx = (double)p.out[BOARD_EDGE][1] - e, gy = (double)p.out[BOARD_EDGE][2] - e;
            double g = hypot(gx, gy);
            if (g < 0.05 || e < 0.1) break;
            x -= gx / g * e;
            y -= gy / g * e;
          }
          x += sizes[f] * (uniform() - 0.5);
          y += sizes[f] * (uniform() - 0.5);
        }
        truth_ask(&p, t, ONLY3(ALBEDO), x, y, 0, sizes[f]);
        truth_add(&errors, &p);
      }
      double rms = truth_rms(&errors), mean = truth_mean(&errors);
      print_message("  %.4f/%+.4f", rms, mean);
      if (k & 1) {
        astride = fmax(astride, rms);
      } else if (sizes[f] > 100) {
        beyond = fmax(beyond, rms);
      } else {
        worst = fmax(worst, rms);
        worst_mean = fmax(worst_mean, fabs(mean));
      }
    }
    print_message("\n");
    textures->destroy(t);
  }
  points_free(&p);
  CHECK(worst <= 0.01 && worst_mean <= 0.002,
        "anywhere: worst RMS %.4f (goal 0.01), worst mean %.4f (goal 0.002), up to 100 mm\n", worst,
        worst_mean);
  CHECK(beyond <= 0.017 && astride <= 0.02,
        "worst RMS %.4f under 300 mm (0.017), %.4f astride of joints (0.02)\n", beyond, astride);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(against_1024_samples)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
