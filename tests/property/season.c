/* SPDX-License-Identifier: Apache-2.0
 *
 * The season profile: earlywood first, latewood last, the fraction and the
 * abruptness as asked.
 */
#include <math.h>

#include "cmocka_all.h"
#include "wood.h"

/* The profile by phase within a ring, from a plain stem. */
enum { STEPS = 1000 };
static void profile(const char *parameters, double *late) {
  char text[512];
  snprintf(
      text, sizeof text,
      "section_wobble=0; pith_wander=0; ring_variation=0; latewood_variation=0; ring_width=10; "
      "porosity=none; %s",
      parameters);
  sozai_texture *t = wood_make(NULL, text);
  points p = {0};
  for (int i = 0; i < STEPS; i++) points_add(&p, 50 + 10 * (i + 0.5) / STEPS, 0, 0, 0);
  points_ask(&p, t);
  for (int i = 0; i < STEPS; i++) late[i] = (double)p.out[LATEWOOD][i];
  points_free(&p);
  textures->destroy(t);
}

static void rises_through_the_ring(void **state) {
  (void)state;
  double late[STEPS];
  profile("latewood_fraction=0.4; latewood_abruptness=0.3", late);
  int falls = 0;
  /* the first and the last samples' averages, 0.02 mm wide, reach into the
   * neighbouring rings */
  for (int i = 3; i < STEPS - 2; i++) falls += late[i] < late[i - 1] - 3e-4;
  CHECK(falls == 0 && late[5] < 1e-3 && late[STEPS - 5] > 0.999,
        "from %.4f at the start to %.4f at the end, falling %d times\n", late[5], late[STEPS - 5],
        falls);
}

static void fraction_and_abruptness(void **state) {
  (void)state;
  double before = 1e9;
  for (int a = 0; a <= 4; a++) {
    for (int f = 1; f <= 7; f += 3) {
      char text[128];
      snprintf(text, sizeof text, "latewood_fraction=%g; latewood_abruptness=%g", 0.1 * f,
               0.25 * a);
      double late[STEPS], share = 0, rise = 0;
      profile(text, late);
      for (int i = 0; i < STEPS; i++) {
        share += (late[i] > 0.5) / (double)STEPS;
        rise += (late[i] > 0.1 && late[i] < 0.9) / (double)STEPS;
      }
      print_message("%s: %.3f of the ring above half, the rise takes %.3f\n", text, share, rise);
      assert_true(fabs(share - 0.1 * f) < 0.005);
      if (f == 4) {
        assert_true(rise < before);
        before = rise;
      }
    }
  }
}

/* From the knee, where the parabola ends, latewood deepens along a line to the ring's end; where
 * it is half way does not move. */
static void deepens_to_the_end(void **state) {
  (void)state;
  for (int k = 0; k <= 2; k++) {
    double deepening = 0.2 * k, late[STEPS], share = 0, worst = 0;
    char text[128];
    snprintf(text, sizeof text,
             "latewood_fraction=0.5; latewood_abruptness=1; latewood_deepening=%g", deepening);
    profile(text, late);
    /* abruptness 1: the knee is 0.08 of the latewood past its middle */
    double knee = 0.5 + 0.08 * 0.5;
    for (int i = 0; i < STEPS; i++) {
      double f = (i + 0.5) / STEPS;
      share += (late[i] > 0.5) / (double)STEPS;
      if (f < knee + 0.002 || f > 0.998) continue;
      worst = fmax(worst, fabs(late[i] - (1 - deepening * (1 - f) / (1 - knee))));
    }
    CHECK(fabs(share - 0.5) < 0.005 && worst < 1e-3,
          "deepening by %.2f: %.3f of the ring above half, at most %.1e off the line\n", deepening,
          share, worst);
  }
}

static void every_species_has_seasons(void **state) {
  (void)state;
  for (unsigned k = 0; k < wood_presets(); k++) {
    sozai_texture *t = wood_make(wood_preset(k), "construction=solid");
    points p = {0};
    for (int i = 0; i < 20000; i++) points_add(&p, 40 + 0.005 * i, 0, 0, 0);
    points_ask(&p, t);
    double least = 1, most = 0;
    for (unsigned i = 0; i < p.count; i++) {
      least = fmin(least, (double)p.out[LATEWOOD][i]);
      most = fmax(most, (double)p.out[LATEWOOD][i]);
    }
    CHECK(least == 0 && most > 0.9, "%s: latewood %.3f to %.3f\n", wood_preset(k), least, most);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(rises_through_the_ring),
      cmocka_unit_test(fraction_and_abruptness),
      cmocka_unit_test(deepens_to_the_end),
      cmocka_unit_test(every_species_has_seasons),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
