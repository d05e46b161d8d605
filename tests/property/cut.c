/* SPDX-License-Identifier: Apache-2.0
 *
 * The cut: that a tilted and skewed board is the turn of the log that its angles say,
 * and that boards of a layout lean as far as they are told to.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "wood.h"

#define DEGREE 0.017453292519943295

/* The same wood seen in the log: channels agree, directions turn with the board. */
static void turned(void **state) {
  (void)state;
  static const struct {
    const char *cut;
    double x, z;
  } cuts[] = {{"flat", 0, 60}, {"quarter", 60, 0}, {"rift", 42.426407, 42.426407}};
  const double tilt = 3 * DEGREE, skew = -2 * DEGREE;
  sozai_texture *log = wood_make("keyaki", "cut=log; grain=compound");
  points a = {0}, b = {0};
  uniform_seed(91);
  for (int c = 0; c < 3; c++) {
    char text[128];
    snprintf(text, sizeof text, "cut=%s; cut_tilt=3; cut_skew=-2; grain=compound", cuts[c].cut);
    sozai_texture *t = wood_make("keyaki", text);
    points_clear(&a);
    points_clear(&b);
    for (int i = 0; i < 2000; i++) {
      double x = 60 * (uniform() - 0.5), y = 400 * (uniform() - 0.5), z = 20 * (uniform() - 0.5);
      points_add(&a, x, y, z, 0);
      /* tilted about x first, then askew about the face's normal */
      double ty = y * cos(tilt) - z * sin(tilt), tz = y * sin(tilt) + z * cos(tilt);
      points_add(&b, cuts[c].x + x * cos(skew) + ty * sin(skew),
                 250 + ty * cos(skew) - x * sin(skew), cuts[c].z + tz, 0);
    }
    points_ask(&a, t);
    points_ask(&b, log);
    double year = 0, lean = 0;
    for (unsigned i = 0; i < a.count; i++) {
      year = fmax(year, fabs((double)(a.out[TIME][i] - b.out[TIME][i])));
      /* of the fibre's direction, what lies along the board */
      double along = (double)b.out[FIBER][i] * sin(skew) * cos(tilt) +
                     (double)b.out[FIBER + 1][i] * cos(skew) * cos(tilt) +
                     (double)b.out[FIBER + 2][i] * sin(tilt);
      lean = fmax(lean, fabs((double)a.out[FIBER + 1][i] - along));
    }
    CHECK(year < 2e-3 && lean < 2e-3,
          "%s: years agree to %.2g, the fibre's direction along the board to %.2g\n", cuts[c].cut,
          year, lean);
    textures->destroy(t);
  }
  textures->destroy(log);
  points_free(&a);
  points_free(&b);
}

/* Straight-grained trees without taper: a board's fibres show how it lies. */
static void leaning(void **state) {
  (void)state;
  sozai_texture *t = wood_make(
      "keyaki", "layout=strip; cut_tilt=1.5; cut_skew=0.5; taper=0; pith_wander=0; undulation=0; "
                "slope_noise=0; section_wobble=0; layout_rotation=0");
  points p = {0};
  double tilt = 0, skew = 0, before = -1;
  int boards = 0;
  for (int i = 0; i < 40; i++) {
    for (int j = 0; j < 400; j++) points_add(&p, 90 * j + 45, 1800 * i, 0, 0);
  }
  points_ask(&p, t);
  for (unsigned i = 0; i < p.count; i++) {
    double id = (double)p.out[BOARD_ID][i];
    if (id == before) continue;
    before = id;
    tilt += pow(asin((double)p.out[FIBER + 2][i]), 2);
    skew += pow(asin((double)p.out[FIBER][i]), 2);
    boards++;
  }
  tilt = sqrt(tilt / boards) / DEGREE;
  skew = sqrt(skew / boards) / DEGREE;
  CHECK(boards > 3000, "%d boards\n", boards);
  CHECK(fabs(tilt - 1.5) < 0.06 && fabs(skew - 0.5) < 0.02,
        "told to lean by 1.5 and 0.5 degrees, boards lean by %.3f and %.3f, rms\n", tilt, skew);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(turned), cmocka_unit_test(leaning)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
