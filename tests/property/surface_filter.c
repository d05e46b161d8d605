/* SPDX-License-Identifier: Apache-2.0
 *
 * Filtering of surfaces and finishes: albedo under a footprint against the
 * average of 1,024 points of its square, as property.filter does for all
 * species; and height, whose mean a footprint keeps.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
enum { SIDE = 32, SAMPLES = SIDE * SIDE, PLACES = 80, SIZES = 9 };

static const char *const kinds[] = {"surface=brushed",
                                    "surface=charred",
                                    "surface=charred;charring=0.6",
                                    "surface=weathered",
                                    "surface=weathered;checks=20;check_width=0.8",
                                    "end_checks=10;end_check_width=1.5;end_check_length=25",
                                    "surface=planed;finish=oiled",
                                    "finish=lacquered",
                                    "age_years=30;finish=oiled"};
static const char *const species[] = {"oak", "sugi", "itayakaede", "onigurumi"};

static void albedo_and_height(void **state) {
  (void)state;
  static const double sizes[SIZES] = {0.01, 0.03, 0.1, 0.3, 1, 3, 10, 30, 100};
  static const char *const cuts[] = {"flat", "quarter", "rift", "end"};
  points p = {0};
  for (unsigned kind = 0; kind < sizeof kinds / sizeof *kinds; kind++) {
    for (unsigned k = 0; k < sizeof species / sizeof *species; k++) {
      double worst = 0, worst_mean = 0, worst_size = 0;
      uniform_seed(97);
      for (unsigned f = 0; f < SIZES; f++) {
        truth_errors errors = {0};
        double low = 0;
        for (int c = 0; c < 4; c++) {
          char text[120];
          snprintf(text, sizeof text, "cut=%s;%s", cuts[c], kinds[kind]);
          sozai_texture *t = wood_make(species[k], text);
          for (int place = 0; place < PLACES; place++) {
            double x = 160 * (uniform() - 0.5), y = (c == 3 ? 80 : 1200) * (uniform() - 0.5);
            truth_ask(&p, t, ONLY3(ALBEDO) | ONLY(HEIGHT), x, y, 2 * PI * uniform(), sizes[f]);
            truth_add(&errors, &p);
            low -= truth_error(&p, HEIGHT);
          }
          textures->destroy(t);
        }
        double rms = truth_rms(&errors), mean = truth_mean(&errors);
        if (rms > worst) worst_size = sizes[f];
        worst = fmax(worst, rms);
        worst_mean = fmax(worst_mean, fabs(mean));
        print_message("%g mm: %.4f/%+.4f, height %+.4f  ", sizes[f], rms, mean, 3 * low / errors.n);
      }
      print_message("\n");
      CHECK(worst <= 0.01 && worst_mean <= 0.002,
            "%-44s %-11s worst RMS %.4f at %g mm (goal 0.01), worst mean %.4f (goal 0.002)\n",
            kinds[kind], species[k], worst, worst_size, worst_mean);
    }
  }
  points_free(&p);
}

/* Mean albedo of a board, and how far its channels are apart, over it. */
static double mean_of(const char *preset, const char *parameters, double *saturation) {
  char text[120];
  snprintf(text, sizeof text, "cut=quarter;cut_distance=90;%s", parameters);
  sozai_texture *t = wood_make(preset, text);
  points p = {0};
  uniform_seed(99);
  for (int i = 0; i < 20000; i++) points_add(&p, 80 * uniform(), 800 * uniform(), 0, 0);
  points_ask(&p, t);
  double mean[3] = {0};
  for (int c = 0; c < 3; c++) {
    for (unsigned i = 0; i < p.count; i++) mean[c] += (double)p.out[ALBEDO + c][i] / p.count;
  }
  points_free(&p);
  textures->destroy(t);
  double high = fmax(mean[0], fmax(mean[1], mean[2])), low = fmin(mean[0], fmin(mean[1], mean[2]));
  *saturation = (high - low) / high;
  return (mean[0] + mean[1] + mean[2]) / 3;
}

static void finishes_change_the_colour(void **state) {
  (void)state;
  for (unsigned k = 0; k < sizeof species / sizeof *species; k++) {
    double raw_s, oil_s, film_s, black_s, toast_s, grey_s, planed_s;
    double raw = mean_of(species[k], "", &raw_s);
    double planed = mean_of(species[k], "surface=planed", &planed_s);
    double oil = mean_of(species[k], "finish=oiled", &oil_s);
    double film = mean_of(species[k], "finish=lacquered", &film_s);
    double black = mean_of(species[k], "surface=charred", &black_s);
    double toast = mean_of(species[k], "surface=charred;charring=0.4", &toast_s);
    double grey = mean_of(species[k], "surface=weathered", &grey_s);
    CHECK(planed == raw && planed_s == raw_s && oil < 0.92 * raw && oil < film && film < raw &&
              oil_s > film_s && film_s > raw_s && black < 0.05 && black > 0.01 && black_s < 0.35 &&
              toast < 0.75 * raw && toast > 1.5 * black && toast_s > raw_s && grey > 0.2 &&
              grey < 0.4 && grey_s < 0.25,
          "%-11s albedo %.3f, saturation %.2f; oiled %.3f, %.2f; lacquered %.3f, %.2f; charred "
          "%.3f, %.2f; toasted %.3f, %.2f; weathered %.3f, %.2f\n",
          species[k], raw, raw_s, oil, oil_s, film, film_s, black, black_s, toast, toast_s, grey,
          grey_s);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(albedo_and_height),
                                     cmocka_unit_test(finishes_change_the_colour)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
