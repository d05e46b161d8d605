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
enum { PLACES = 24 };

/* Degrees: of the light, which plane it is in from the stem's on and how steep, and how far what
 * lies half way to the view leans along the board and across. */
static const double ways[][4] = {{0, 30, 0, 0}, {90, 30, 0, 0}, {0, 30, 5, 0},
                                 {0, 30, 0, 5}, {0, 30, 12, 0}, {0, 65, 0, 0}};
enum { WAYS = sizeof ways / sizeof *ways };

static const struct {
  const char *parameters;
  double low, high; /* what the footprint's radiance is of the points' */
} kinds[] = {{"surface=brushed", 0.95, 1.09},
             {"surface=sanded", 0.97, 1.05},
             {"surface=weathered", 0.95, 1.10},
             {"surface=band_sawn", 0.96, 1.10},
             {"surface=charred", 0.66, 1.12},
             {"surface=brushed;finish=oiled", 0.88, 1.08},
             {"surface=planed;coat=1;coat_roughness=0.2", 0.86, 1.08},
             {"surface=sanded;finish=lacquered;coat_roughness=0.1", 0.65, 1.65},
             {"surface=planed;finish=lacquered;coat_roughness=0.1", 0.90, 1.45},
             {"surface=hand_planed;finish=lacquered;coat_roughness=0.1", 0.94, 1.15}};

static void set3(float *a[3], unsigned i, const double d[3]) {
  for (int c = 0; c < 3; c++) a[c][i] = (float)d[c];
}

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

/* Mean radiance of footprints over that of the points in them. */
static double near_and_far(points *p, const sozai_texture *t, const double way[4], double size) {
  double light[3], view[3], points_sum = 0, footprints = 0;
  directions(way, light, view);
  uniform_seed(5);
  for (int place = 0; place < PLACES; place++) {
    double x = 160 * (uniform() - 0.5), y = 800 * (uniform() - 0.5), turn = 2 * PI * uniform();
    double co = cos(turn), si = sin(turn);
    points_clear(p);
    for (int i = 0; i <= TRUTH_SAMPLES; i++) {
      double a = ((i % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
      double b = ((i / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size;
      if (i == TRUTH_SAMPLES) a = b = 0;
      unsigned q =
          points_add(p, x + a * co - b * si, y + a * si + b * co, 0, i == TRUTH_SAMPLES ? size : 0);
      set3(p->light, q, light);
      set3(p->view, q, view);
    }
    points_ask_only(p, t, ONLY3(RADIANCE));
    for (int i = 0; i < TRUTH_SAMPLES; i++) {
      points_sum += (double)p->out[RADIANCE + 1][i] / TRUTH_SAMPLES;
    }
    footprints += (double)p->out[RADIANCE + 1][TRUTH_SAMPLES];
  }
  return footprints / points_sum;
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
          double ratio = near_and_far(&p, t, ways[way], sizes[f]);
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
