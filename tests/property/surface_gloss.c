/* SPDX-License-Identifier: Apache-2.0
 *
 * Gloss of surfaces and finishes: radiance under a footprint against the average of 1,024 points
 * of its square, towards the mirror's side and off it along the board and across. A highlight
 * comes from what little of a face lies just so; it is not that of the mean slope.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
/* Degrees: of the light, which plane it is in from the stem's on and how steep, and how far what
 * lies half way to the view leans along the board and across. */
static const double ways[][4] = {{0, 30, 0, 0}, {90, 30, 0, 0}, {0, 30, 5, 0},
                                 {0, 30, 0, 5}, {0, 30, 12, 0}, {0, 65, 0, 0}};
enum { WAYS = sizeof ways / sizeof *ways };

static const struct {
  const char *parameters;
  double low, high; /* what the footprint's radiance is of the points' */
} kinds[] = {{"surface=brushed", 0.95, 1.02},
             {"surface=sanded", 0.97, 1.02},
             {"surface=weathered", 0.95, 1.02},
             {"surface=band_sawn", 0.96, 1.07},
             {"surface=charred", 0.69, 1.09},
             {"surface=brushed;finish=oiled", 0.88, 1.08},
             {"surface=planed;coat=1;coat_roughness=0.2", 0.86, 1.08},
             {"surface=sanded;finish=lacquered;coat_roughness=0.1", 0.65, 1.65},
             {"surface=planed;finish=lacquered;coat_roughness=0.1", 0.90, 1.45},
             {"surface=hand_planed;finish=lacquered;coat_roughness=0.1", 0.94, 1.15}};

/* Directions of light and view; y is along the stem. */
static void directions(const double way[4], double light[3], double view[3]) {
  double turn = way[0] * PI / 180, steep = way[1] * PI / 180;
  double h[3] = {sin(way[3] * PI / 180), sin(way[2] * PI / 180), 1}, dot = 0;
  double size = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
  light[0] = sin(steep) * sin(turn);
  light[1] = sin(steep) * cos(turn);
  light[2] = cos(steep);
  for (int c = 0; c < 3; c++) dot += light[c] * h[c] / size;
  for (int c = 0; c < 3; c++) view[c] = 2 * dot * h[c] / size - light[c];
}

static void as_bright_far_as_near(const char *reflection) {
  static const char *const species[] = {"oak", "sugi"};
  static const double sizes[] = {0.3, 3, 30};
  points p = {0};
  for (unsigned kind = 0; kind < sizeof kinds / sizeof *kinds; kind++) {
    for (int k = 0; k < 2; k++) {
      char text[160];
      snprintf(text, sizeof text, "cut=flat;reflection=%s;%s", reflection, kinds[kind].parameters);
      sozai_texture *t = wood_make(species[k], text);
      double least = 1e9, most = 0;
      for (int f = 0; f < 3; f++) {
        print_message("%4g mm", sizes[f]);
        for (int way = 0; way < WAYS; way++) {
          double light[3], view[3];
          directions(ways[way], light, view);
          double ratio = truth_lit(&p, t, light, view, sizes[f]);
          least = fmin(least, ratio);
          most = fmax(most, ratio);
          print_message(" %.3f", ratio);
        }
        print_message("\n");
      }
      CHECK(least >= kinds[kind].low && most <= kinds[kind].high,
            "%-55s %-4s far over near %.3f to %.3f (%g to %g)\n", kinds[kind].parameters,
            species[k], least, most, kinds[kind].low, kinds[kind].high);
      textures->destroy(t);
    }
  }
  points_free(&p);
}

static void of_kawai(void **state) {
  (void)state;
  as_bright_far_as_near("kawai");
}

static void of_the_cone(void **state) {
  (void)state;
  as_bright_far_as_near("fibre_cone");
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(of_kawai), cmocka_unit_test(of_the_cone)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
