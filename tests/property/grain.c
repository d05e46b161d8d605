/* SPDX-License-Identifier: Apache-2.0
 *
 * The grain: slopes as the equations have them, and a walk along the fibre
 * direction that stays on one fibre.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
/* A stem without wobble, taper or wander: slopes are seen as they are. */
#define PLAIN                                                                                      \
  "section_wobble=0; undulation=0; taper=0; pith_wander=0; ring_variation=0; ring_width=2; "

/* Slope of the fibre round the stem, r dtheta/dy, at r and y on the +x side. */
static double slope_of(const points *p, unsigned i) {
  double x = (double)p->point[0][i], z = (double)p->point[2][i], r = hypot(x, z);
  double around = (-z * (double)p->out[FIBER][i] + x * (double)p->out[FIBER + 2][i]) / r;
  return around / (double)p->out[FIBER + 1][i];
}

static void slopes_are_the_equations(void **state) {
  (void)state;
  uniform_seed(11);
  const struct {
    const char *parameters;
    double spiral, a, lambda;
  } cases[] = {
      {PLAIN "grain=straight; slope_noise=0", 0, 0, 1},
      {PLAIN "grain=spiral; spiral_slope=0.12; slope_noise=0", 0.12, 0, 1},
      {PLAIN "grain=spiral; spiral_slope=-0.3; slope_noise=0", -0.3, 0, 1},
      {PLAIN "grain=wavy; wave_slope=0.2; wave_length=40; slope_noise=0", 0, 0.2, 40},
      {PLAIN "grain=wavy; wave_slope=0.15; wave_length=15; slope_noise=0", 0, 0.15, 15},
      {PLAIN "grain=compound; spiral_slope=0.1; wave_slope=0.2; wave_length=33; "
             "interlocked_slope=0; slope_noise=0",
       0.1, 0.2, 33},
  };
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    sozai_texture *t = wood_make(NULL, cases[k].parameters);
    points p = {0};
    for (int i = 0; i < 5000; i++) {
      double r = 20 + 200 * uniform(), theta = 2 * PI * uniform();
      points_add(&p, r * cos(theta), 3000 * (uniform() - 0.5), r * sin(theta), 0);
    }
    points_ask(&p, t);
    double worst = 0;
    for (unsigned i = 0; i < p.count; i++) {
      double y = (double)p.point[1][i];
      double want = cases[k].spiral + cases[k].a * sin(2 * PI * y / cases[k].lambda);
      /* the divisor is sqrt(R^2 + 1 mm^2): 0.13 % at 20 mm */
      worst = fmax(worst, fabs(slope_of(&p, i) - want));
    }
    CHECK(worst < 1e-3, "%s\n  slope off by %.2g at most (1e-3)\n",
          cases[k].parameters + sizeof PLAIN - 1, worst);
    points_free(&p);
    textures->destroy(t);
  }
}

static void variation_is_bounded_and_continuous(void **state) {
  (void)state;
  for (int k = 1; k <= 3; k++) {
    double most = 0.02 * k * k, seen = 0, step = 0, square = 0;
    char text[512];
    snprintf(text, sizeof text, PLAIN "grain=straight; slope_noise=%g", most);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    for (int line = 0; line < 40; line++) {
      for (int i = 0; i < 4000; i++) points_add(&p, 30 + 5 * line, 0.5 * i - 1000, 0, 0);
    }
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) {
      double s = slope_of(&p, i);
      seen = fmax(seen, fabs(s));
      square += s * s / p.count;
      if (i % 4000) step = fmax(step, fabs(s - slope_of(&p, i - 1)));
    }
    CHECK(seen <= most * 1.0001 && seen > 0.5 * most && step < 0.2 * most,
          "slope_noise %.2f: |slope| up to %.4f, rms %.4f, changes by %.4f in 0.5 mm\n", most, seen,
          sqrt(square), step);
    points_free(&p);
    textures->destroy(t);
  }
}

static void interlocked_alternates_with_the_year(void **state) {
  (void)state;
  sozai_texture *t = wood_make(
      NULL, PLAIN "grain=interlocked; interlocked_slope=0.15; interlocked_years=12; slope_noise=0");
  points p = {0};
  for (int i = 0; i < 9000; i++) points_add(&p, 20 + 0.02 * i, 0, 0, 0);
  points_ask(&p, t);
  int changes = 0;
  double most = 0;
  for (unsigned i = 1; i < p.count; i++) {
    changes += (slope_of(&p, i) > 0) != (slope_of(&p, i - 1) > 0);
    most = fmax(most, fabs(slope_of(&p, i)));
  }
  /* 180 mm of radius are 90 years: 7.5 periods, 15 changes of side */
  CHECK(changes == 15 && fabs(most - 0.15) < 1e-3,
        "over 90 years the slope changes sides %d times (15), up to %.4f\n", changes, most);
  points_free(&p);
  textures->destroy(t);
}

static void reference_is_the_place_at_y_0(void **state) {
  (void)state;
  uniform_seed(12);
  for (unsigned k = 0; k < wood_presets(); k++) {
    /* without knots: for those see knots.c */
    sozai_texture *t =
        wood_make(wood_preset(k), "grain=compound; section_wobble=0.15; tree=; construction=solid");
    points p = {0};
    for (int i = 0; i < 3000; i++) {
      points_add(&p, 400 * (uniform() - 0.5), 0, 400 * (uniform() - 0.5), 0);
    }
    points_ask(&p, t);
    double worst = 0;
    for (unsigned i = 0; i < p.count; i++) {
      worst = fmax(worst, fabs((double)(p.out[REFERENCE][i] - p.point[0][i])));
      worst = fmax(worst, fabs((double)(p.out[REFERENCE + 1][i] - p.point[2][i])));
    }
    CHECK(worst < 3e-4, "%s: reference at y = 0 is (x, z) to %.2g mm\n", wood_preset(k), worst);
    points_free(&p);
    textures->destroy(t);
  }
}

/* One metre by Runge and Kutta's fourth-order rule in double; only the field
 * is the plugin's. */
enum { WALKERS = 96 };
static double walk(const sozai_texture *t, double step) {
  static double at[WALKERS][3], k[4][WALKERS][3];
  double first[WALKERS][2], worst = 0;
  points p = {0};
  for (int w = 0; w < WALKERS; w++) {
    double r = 15 + 165 * uniform(), theta = 2 * PI * uniform();
    at[w][0] = r * cos(theta);
    at[w][1] = 800 * (uniform() - 0.5);
    at[w][2] = r * sin(theta);
  }
  int steps = (int)(1000 / step);
  for (int n = 0; n <= steps; n++) {
    for (int stage = 0; stage < 4; stage++) {
      points_clear(&p);
      for (int w = 0; w < WALKERS; w++) {
        double h = stage == 0 ? 0 : stage == 3 ? step : 0.5 * step;
        double q[3];
        for (int c = 0; c < 3; c++) q[c] = at[w][c] + (stage ? h * k[stage - 1][w][c] : 0);
        points_add(&p, q[0], q[1], q[2], 0);
      }
      points_ask_only(&p, t, ONLY3(FIBER) | ONLY(REFERENCE) | ONLY(REFERENCE + 1));
      for (int w = 0; w < WALKERS; w++) {
        for (int c = 0; c < 3; c++) k[stage][w][c] = (double)p.out[FIBER + c][w];
        if (stage == 0) {
          double x = (double)p.out[REFERENCE][w], z = (double)p.out[REFERENCE + 1][w];
          if (n == 0) {
            first[w][0] = x;
            first[w][1] = z;
          }
          /* the walker's own place is rounded to float before it is asked */
          worst = fmax(worst, hypot(x - first[w][0], z - first[w][1]));
        }
      }
    }
    for (int w = 0; w < WALKERS; w++) {
      for (int c = 0; c < 3; c++) {
        at[w][c] += step / 6 * (k[0][w][c] + 2 * k[1][w][c] + 2 * k[2][w][c] + k[3][w][c]);
      }
    }
  }
  points_free(&p);
  return worst;
}

/* mm: creases take shorter steps, and the smallest eyes, of a millimetre, the shortest. */
static double step_of(unsigned k) {
  const sozai_preset *p = textures->find("wood")->presets[k];
  double step = 0.5;
  for (uint32_t i = 0; i < p->value_count; i++) {
    const char *id = p->values[i].id;
    if (strncmp(id, "quilt_", 6) == 0) step = fmin(step, 0.04);
    if (strncmp(id, "eye_", 4) == 0) step = fmin(step, 0.02);
  }
  return step;
}

static void a_walk_stays_on_its_fibre(void **state) {
  (void)state;
  uniform_seed(13);
  static const char *const grains[] = {"straight", "spiral", "wavy", "interlocked", "compound"};
  for (unsigned g = 0; g < 5; g++) {
    double worst = 0;
    for (unsigned k = 0; k < wood_presets(); k++) {
      char text[64];
      snprintf(text, sizeof text, "grain=%s; tree=; construction=solid", grains[g]);
      sozai_texture *t = wood_make(wood_preset(k), text);
      double one = walk(t, step_of(k));
      if (one >= 1e-3)
        print_message("grain=%s, %s: drifts %.2g mm\n", grains[g], wood_preset(k), one);
      worst = fmax(worst, one);
      textures->destroy(t);
    }
    CHECK(worst < 1e-3,
          "grain=%s: 1 m on %u fibres of %u species: reference drifts %.2g mm (1e-3)\n", grains[g],
          WALKERS * wood_presets(), wood_presets(), worst);
  }
}

static void phase_is_bounded_at_the_pith(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, PLAIN "grain=spiral; spiral_slope=0.12; slope_noise=0");
  points p = {0};
  for (int i = 0; i < 200; i++) points_add(&p, 1e-7 * i * i, 500, 0, 0);
  points_ask(&p, t);
  double most = 0;
  for (unsigned i = 1; i < p.count; i++) most = fmax(most, fabs(slope_of(&p, i)));
  CHECK(most < 0.12, "within 4 um of the pith the slope stays within %.3g\n", most);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(slopes_are_the_equations),
      cmocka_unit_test(variation_is_bounded_and_continuous),
      cmocka_unit_test(interlocked_alternates_with_the_year),
      cmocka_unit_test(reference_is_the_place_at_y_0),
      cmocka_unit_test(a_walk_stays_on_its_fibre),
      cmocka_unit_test(phase_is_bounded_at_the_pith),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
