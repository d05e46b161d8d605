/* SPDX-License-Identifier: Apache-2.0
 *
 * Beds that swell and pinch.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "wood.h"

enum { PATCHES = 24, SIDE = 40 };

/* Of beds far thicker than a patch the shade grows evenly across them, and how much it does from
 * place to place is how thick they are there: sd over the mean, of all patches in which it grows by
 * much, but for an even change across the beds. */
static double uneven(const char *more) {
  const double step = 5, reach = 1;
  char text[400];
  snprintf(text, sizeof text,
           "grain_variation=0; second_share=0; third_share=0; mottle=0; cleavage=0; turbidity=0; "
           "base_colour=0 0 0 @ lin_rec709; bed_colour=1 1 1 @ lin_rec709; bed_contrast=1; "
           "bed_thickness=10000; %s",
           more);
  sozai_texture *t = stone_make(NULL, text);
  double sum = 0;
  int count = 0;
  uniform_seed(75);
  for (int k = 0; k < PATCHES; k++) {
    points p = {0};
    double x = 20000 * uniform(), y = 20000 * uniform(), z = 20000 * uniform();
    for (int i = 0; i < SIDE * SIDE; i++) {
      double u = x + step * (i % SIDE), v = y + step * (i / SIDE);
      points_add(&p, u, v - reach, z, 0);
      points_add(&p, u, v + reach, z, 0);
    }
    points_ask_only(&p, t, ONLY3(ALBEDO));
    double mean = 0, square = 0, rise = 0, rows = 0;
    for (unsigned i = 0; i < p.count; i += 2) {
      double d = (double)p.out[ALBEDO][i + 1] - (double)p.out[ALBEDO][i];
      double row = i / (2 * SIDE) - 0.5 * (SIDE - 1);
      mean += d / (SIDE * SIDE);
      square += d * d / (SIDE * SIDE);
      rise += d * row / (SIDE * SIDE);
      rows += row * row / (SIDE * SIDE);
    }
    square -= rise * rise / rows; /* the thick beds' own, from row to row */
    points_free(&p);
    if (fabs(mean) < 2 * reach * 2e-5) continue; /* floats tell too little, or it turns here */
    sum += square / (mean * mean) - 1;
    count++;
  }
  textures->destroy(t);
  return count > PATCHES / 4 ? sqrt(fmax(sum / count, 0)) : -1;
}

static void beds_pinch(void **state) {
  (void)state;
  static const char *const waves[] = {"bed_wave=18; bed_wavelength=130",
                                      "bed_wave=6; bed_wavelength=90"};
  static const double pinching[] = {0, 0.15, 0.3};
  for (int w = 0; w < 2; w++) {
    for (int k = 0; k < 3; k++) {
      char text[100];
      snprintf(text, sizeof text, "%s; bed_pinching=%g", waves[w], pinching[k]);
      double sd = uneven(text);
      CHECK(sd >= 0 && fabs(sd - pinching[k]) < 0.03 + 0.1 * pinching[k],
            "%s: thickness differs by sd %.3f\n", text, sd);
    }
  }
  double level = uneven("bed_wave=0; bed_pinching=0.3");
  CHECK(level >= 0 && level < 0.03, "no waves: thickness differs by sd %.3f\n", level);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(beds_pinch)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
