/* SPDX-License-Identifier: Apache-2.0
 * Branch lengths on the crown's curve, for every species and age. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tree.h"

/* Section 6.1 as the preset is shipped: equation 2, with a of the slope's two sides. */
static void on_the_curve(void **unused) {
  (void)unused;
  double worst = 0, n = 0;
  for (int age = 3; age <= 27; age += 4) {
    for (int seed = 0; seed < 5; seed++) {
      char text[60];
      snprintf(text, sizeof text, "age=%d orders=1 seed=%d", age, seed);
      sozai_geometry *g = grow("sugi_paper", text, NULL);
      sozai_table t = table_of(g, "turning");
      for (uint64_t i = 0; i < t.rows; i++) {
        double azimuth = cell(&t, i, "azimuth"), a = azimuth > 90 && azimuth < 270 ? 0.26 : 0.25;
        double want = a * sqrt(1 - cell(&t, i, "height"));
        worst = fmax(worst, fabs(cell(&t, i, "length") - want));
        n++;
      }
      geometry()->release(g);
    }
  }
  print_message("the paper's preset: %.0f lengths off equation 2 by %.2g of the height at most\n",
                n, worst);
  assert_true(worst < 5e-6);
}

static int rising(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Kolmogorov's statistic of angles against even ones, times the root of their number. */
static double unevenness(double *angles, size_t n) {
  double worst = 0;
  qsort(angles, n, sizeof *angles, rising);
  for (size_t i = 0; i < n; i++) {
    double share = angles[i] / 360;
    worst = fmax(worst, fmax((double)(i + 1) / (double)n - share, share - (double)i / (double)n));
  }
  return worst * sqrt((double)n);
}

static void statistics_of_azimuths(const char *preset, double *azimuths, double *steps) {
  enum { MOST = 20000 };
  static double at[MOST], step[MOST];
  size_t n = 0, m = 0;
  for (int seed = 0; seed < 200; seed++) {
    char text[60];
    snprintf(text, sizeof text, "age=7 orders=1 seed=%d", seed);
    sozai_geometry *g = grow(preset, text, NULL);
    sozai_table t = table_of(g, "turning");
    for (uint64_t i = 0; i < t.rows && n < MOST; i++) {
      at[n++] = cell(&t, i, "azimuth");
      if (i) step[m++] = cell(&t, i, "divergence");
    }
    geometry()->release(g);
  }
  *azimuths = unevenness(at, n);
  *steps = unevenness(step, m);
  print_message("%-10s %zu azimuths: unevenness %.2f, from branch to branch %.2f\n", preset, n,
                *azimuths, *steps);
}

/* Section 6.1 again: azimuths at random, each whatever the one before. Of even ones one in 100
 * is beyond 1.63; those that turn are, from branch to branch. */
static void azimuths_at_random(void **unused) {
  (void)unused;
  double azimuths, steps;
  statistics_of_azimuths("sugi_paper", &azimuths, &steps);
  assert_true(azimuths < 1.63 && steps < 1.63);
  statistics_of_azimuths("sugi", &azimuths, &steps);
  assert_true(steps > 5);
}

static void scatter_about_it(void **unused) {
  (void)unused;
  double rms = 0;
  for (int seed = 0; seed < 50; seed++) {
    char text[100];
    snprintf(text, sizeof text, "crown_scatter=0.2 orders=1 seed=%d", seed);
    sozai_geometry *g = grow("sugi_paper", text, NULL);
    rms += statistic(g, "crown_rms") / 50;
    geometry()->release(g);
  }
  print_message("scatter 0.2: %.4f measured\n", rms);
  assert_true(fabs(rms / 0.2 - 1) < 0.05);
}

/* Of every species: it only grows, and its live branches stand in the crown. */
static void every_species(void **unused) {
  (void)unused;
  const sozai_generator_info *info = geometry()->find("tree");
  assert_non_null(info);
  assert_true(info->preset_count >= 12);
  for (uint32_t i = 0; i < info->preset_count; i++) {
    assert_true(strlen(info->presets[i]->source) > 20);
    double height = 0, diameter = 0;
    for (int age = 2; age <= 82; age += 20) {
      char text[64];
      snprintf(text, sizeof text, "age=%d orders=1", age);
      sozai_geometry *g = grow(info->presets[i]->id, text, NULL);
      double h = statistic(g, "height"), d = statistic(g, "diameter");
      assert_true(h > height && d > diameter);
      height = h;
      diameter = d;
      sozai_table t = table_of(g, "branches");
      for (uint64_t k = 1; k < t.rows; k++) {
        assert_true(cell(&t, k, "at") < h);
        assert_true(cell(&t, k, "length") > 0 && cell(&t, k, "length") < 1.6 * h);
        if (cell(&t, k, "death") >= 0) assert_true(cell(&t, k, "death") >= cell(&t, k, "birth"));
        if (cell(&t, k, "shed") >= 0) assert_true(cell(&t, k, "shed") >= cell(&t, k, "death"));
      }
      geometry()->release(g);
    }
    print_message("%-14s at 82 years: %5.1f m, %4.0f mm at the ground\n", info->presets[i]->id,
                  height / 1000, diameter);
    assert_true(height > 4000 && height < 70000);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(on_the_curve), cmocka_unit_test(azimuths_at_random),
      cmocka_unit_test(scatter_about_it), cmocka_unit_test(every_species)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
