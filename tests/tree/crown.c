/* SPDX-License-Identifier: Apache-2.0
 * Branch lengths on the crown's curve, for every species and age. */
#include <math.h>
#include <stdio.h>

#include "tree.h"

static void on_the_curve(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi_paper", "crown_scatter=0 orders=1 crown_a_down=0", NULL);
  sozai_table t = table_of(g, "turning");
  double a = statistic(g, "crown_a"), worst = 0;
  for (uint64_t i = 0; i < t.rows; i++) {
    double want = a * sqrt(1 - cell(&t, i, "height"));
    worst = fmax(worst, fabs(cell(&t, i, "length") - want));
  }
  print_message("without scatter: off the curve by %.2g of the height, a = %.4f\n", worst, a);
  assert_true(worst < 1e-4);
  assert_true(fabs(a - 0.25) < 0.002);
  geometry()->release(g);
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
  const struct CMUnitTest tests[] = {cmocka_unit_test(on_the_curve),
                                     cmocka_unit_test(scatter_about_it),
                                     cmocka_unit_test(every_species)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
