/* SPDX-License-Identifier: Apache-2.0
 *
 * Filtering: albedo under a footprint against the average of 1,024 points of
 * the square it stands for, for every species, cut and size of footprint.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
enum { PLACES = 200 };

static void against_1024_samples(void **state) {
  (void)state;
  static const double sizes[] = {0.002, 0.005, 0.01, 0.03, 0.1, 0.3, 0.7, 1, 3, 5, 10, 30, 100};
  enum { SIZES = sizeof sizes / sizeof *sizes };
  static const char *const cuts[] = {"flat", "quarter", "rift", "end"};
  double worst = 0, worst_mean = 0;
  points p = {0};
  print_message("RMS / mean error of albedo, by footprint in mm:\n%-18s", "");
  for (unsigned f = 0; f < SIZES; f++) print_message("%16g", sizes[f]);
  print_message("\n");
  for (unsigned k = 0; k < wood_presets(); k++) {
    if (strncmp(wood_preset(k), "knotty_", 7) == 0) continue; /* see knots.c */
    if (wood_is_panel(wood_preset(k))) continue;              /* see plies.c */
    print_message("%-18s", wood_preset(k));
    uniform_seed(51); /* so that a species' numbers do not depend on the others */
    for (unsigned f = 0; f < SIZES; f++) {
      truth_errors errors = {0};
      for (int c = 0; c < 4; c++) {
        char text[32];
        snprintf(text, sizeof text, "cut=%s", cuts[c]);
        sozai_texture *t = wood_make(wood_preset(k), text);
        for (int place = 0; place < PLACES; place++) {
          double x = 160 * (uniform() - 0.5), y = (c == 3 ? 80 : 1200) * (uniform() - 0.5);
          truth_ask(&p, t, ONLY3(ALBEDO), x, y, 2 * PI * uniform(), sizes[f]);
          truth_add(&errors, &p);
        }
        textures->destroy(t);
      }
      double rms = truth_rms(&errors), mean = truth_mean(&errors);
      worst = fmax(worst, rms);
      worst_mean = fmax(worst_mean, fabs(mean));
      print_message("  %.4f/%+.4f", rms, mean);
    }
    print_message("\n");
  }
  points_free(&p);
  CHECK(worst <= 0.01 && worst_mean <= 0.002,
        "worst RMS %.4f (goal 0.01), worst mean %.4f (goal 0.002)\n", worst, worst_mean);
}

/* What is there without a footprint fades to its mean under a wide one. */
static void detail_fades(void **state) {
  (void)state;
  for (unsigned k = 0; k < wood_presets(); k++) {
    sozai_texture *t = wood_make(wood_preset(k), "cut=quarter");
    double sd[3];
    for (int f = 0; f < 3; f++) {
      points p = {0};
      uniform_seed(52);
      for (int i = 0; i < 4000; i++) {
        points_add(&p, 100 * (uniform() - 0.5), 600 * (uniform() - 0.5), 0,
                   f == 0   ? 0
                   : f == 1 ? 2
                            : 50);
      }
      points_ask(&p, t);
      double mean = 0, square = 0;
      for (unsigned i = 0; i < p.count; i++) {
        mean += (double)p.out[ALBEDO][i] / p.count;
        square += (double)p.out[ALBEDO][i] * (double)p.out[ALBEDO][i] / p.count;
      }
      sd[f] = sqrt(fmax(square - mean * mean, 0));
      points_free(&p);
    }
    /* arches of peeled plies are wider than that */
    double most = wood_is_panel(wood_preset(k)) ? 0.5 : 0.35;
    CHECK(sd[1] < sd[0] && sd[2] < most * sd[0],
          "%s: albedo's sd %.4f at a point, %.4f under 2 mm, %.4f under 50 mm\n", wood_preset(k),
          sd[0], sd[1], sd[2]);
    textures->destroy(t);
  }
}

/* Rings that curve under the footprint: how much of it is latewood, whose contrast is all there
 * can be. */
static void rings_that_curve(void **state) {
  (void)state;
  static const double sizes[] = {20, 40, 100, 300};
  enum { SIZES = sizeof sizes / sizeof *sizes };
  double worst = 0;
  points p = {0};
  for (int c = 0; c < 2; c++) {
    const char *cut = c ? "cut=end" : "cut=flat";
    sozai_texture *t = wood_make("sugi", cut);
    uniform_seed(54);
    for (unsigned f = 0; f < SIZES; f++) {
      double square = 0;
      for (int place = 0; place < PLACES; place++) {
        double x = 160 * (uniform() - 0.5), y = (c ? 80 : 1200) * (uniform() - 0.5);
        truth_ask(&p, t, ONLY(LATEWOOD), x, y, 2 * PI * uniform(), sizes[f]);
        double e = truth_error(&p, LATEWOOD);
        square += e * e / PLACES;
      }
      print_message("%s, %g mm: RMS %.4f of latewood\n", cut, sizes[f], sqrt(square));
      worst = fmax(worst, sqrt(square));
    }
    textures->destroy(t);
  }
  points_free(&p);
  CHECK(worst < 0.018, "worst %.4f (0.018)\n", worst);
}

/* Past the largest colonies a footprint sees what is to be expected of them all. */
static void wide_spalting(void **state) {
  (void)state;
  enum { NEAR = 100000 };
  static const char *const amounts[] = {"0.4", "0.8", "1"};
  double worst = 0;
  for (int k = 0; k < 3; k++) {
    char text[64];
    snprintf(text, sizeof text, "cut=end; heartwood_years=9000; spalt=%s", amounts[k]);
    sozai_texture *t = wood_make("spalted_beech", text);
    points p = {0};
    uniform_seed(53);
    for (int i = 0; i < NEAR + 500; i++) {
      points_add(&p, 8000 * (uniform() - 0.5), 8000 * (uniform() - 0.5), 40 * (uniform() - 0.5),
                 i < NEAR ? 1 : 2000);
    }
    points_ask_only(&p, t, ONLY3(ALBEDO));
    for (int c = 0; c < 3; c++) {
      double near = 0, far = 0;
      for (unsigned i = 0; i < NEAR; i++) near += points_value(&p, ALBEDO + c, i) / NEAR;
      for (unsigned i = NEAR; i < p.count; i++) far += points_value(&p, ALBEDO + c, i) / 500;
      print_message("spalt=%s, channel %d: %.4f near by, %.4f under 2 m\n", amounts[k], c, near,
                    far);
      worst = fmax(worst, fabs(far - near));
    }
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(worst < 0.004, "apart by %.4f at most (0.004)\n", worst);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(against_1024_samples),
      cmocka_unit_test(detail_fades),
      cmocka_unit_test(rings_that_curve),
      cmocka_unit_test(wide_spalting),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
