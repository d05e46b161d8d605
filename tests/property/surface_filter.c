/* SPDX-License-Identifier: Apache-2.0
 *
 * Filtering of surfaces and finishes: albedo under a footprint against the
 * average of 1,024 points of its square, as property.filter does for all
 * species; and height, whose mean a footprint keeps.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
enum { SIDE = 32, SAMPLES = SIDE * SIDE, PLACES = 40, SIZES = 9 };

static const char *const kinds[] = {"surface=brushed",
                                    "surface=charred",
                                    "surface=charred;charring=0.6",
                                    "surface=weathered",
                                    "surface=weathered;checks=20;check_width=0.8",
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
        double square = 0, mean = 0, low = 0;
        unsigned n = 0;
        for (int c = 0; c < 4; c++) {
          char text[120];
          snprintf(text, sizeof text, "cut=%s;%s", cuts[c], kinds[kind]);
          sozai_texture *t = wood_make(species[k], text);
          for (int place = 0; place < PLACES; place++) {
            double x = 160 * (uniform() - 0.5), y = (c == 3 ? 80 : 1200) * (uniform() - 0.5);
            double turn = 2 * PI * uniform(), co = cos(turn), si = sin(turn);
            points_clear(&p);
            for (int i = 0; i < SAMPLES; i++) {
              double u = ((i % SIDE + uniform()) / SIDE - 0.5) * sizes[f];
              double v = ((i / SIDE + uniform()) / SIDE - 0.5) * sizes[f];
              points_add(&p, x + u * co - v * si, y + u * si + v * co, 0, 0);
            }
            points_add(&p, x, y, 0, sizes[f]);
            points_ask(&p, t);
            for (int ch = 0; ch < 3; ch++) {
              double truth = 0;
              for (int i = 0; i < SAMPLES; i++) truth += (double)p.out[ALBEDO + ch][i] / SAMPLES;
              double error = (double)p.out[ALBEDO + ch][SAMPLES] - truth;
              square += error * error;
              mean += error;
              n++;
            }
            for (int i = 0; i < SAMPLES; i++) low += (double)p.out[HEIGHT][i] / SAMPLES;
            low -= (double)p.out[HEIGHT][SAMPLES];
          }
          textures->destroy(t);
        }
        double rms = sqrt(square / n);
        if (rms > worst) worst_size = sizes[f];
        worst = fmax(worst, rms);
        worst_mean = fmax(worst_mean, fabs(mean / n));
        print_message("%g mm: %.4f/%+.4f, height %+.4f  ", sizes[f], rms, mean / n, 3 * low / n);
      }
      print_message("\n");
      CHECK(worst <= 0.01 && worst_mean <= 0.002,
            "%-44s %-11s worst RMS %.4f at %g mm (goal 0.01), worst mean %.4f (goal 0.002)\n",
            kinds[kind], species[k], worst, worst_size, worst_mean);
    }
  }
  points_free(&p);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(albedo_and_height)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
