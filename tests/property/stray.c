/* SPDX-License-Identifier: Apache-2.0
 *
 * Latewood that strays with its bundles of fibres: as far as it is told to, about its
 * ring, the same along a fibre; and that it frays the edge of a flat-sawn ring.
 */
#include <math.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "wood.h"

#define ROUND                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; taper=0; porosity=none; ring_width=4; "          \
  "ring_variation=0; latewood_variation=0; latewood_fraction=0.5; cut=log; "

/* Where along the radius the latewood of the ring from 60 mm on ends, less where it ends
 * without stray: its last crossing of a half. */
static double end_of_latewood(points *p, const sozai_texture *t, double turn) {
  enum { STEPS = 1200 };
  points_clear(p);
  for (int i = 0; i < STEPS; i++) {
    double r = 62.5 + i * 0.0025;
    points_add(p, r * cos(turn), 0, r * sin(turn), 0);
  }
  points_ask(p, t);
  double at = NAN;
  for (int i = 1; i < STEPS; i++)
    if (p->out[LATEWOOD][i - 1] >= 0.5f && p->out[LATEWOOD][i] < 0.5f) at = 62.5 + i * 0.0025;
  return at;
}

static void as_far_as_asked(void **state) {
  (void)state;
  static const double strays[] = {0, 0.1, 0.3};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text, ROUND "latewood_stray=%g", strays[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    double sum = 0, square = 0, most = 0;
    int n = 600;
    for (int i = 0; i < n; i++) {
      double off = end_of_latewood(&p, t, 6.2831853 * (i + 0.37) / n) - 64;
      sum += off;
      square += off * off;
      most = fmax(most, fabs(off));
    }
    double mean = sum / n, sd = sqrt(square / n - mean * mean);
    /* octaves of 0.25, 0.4 and 0.35, each of deviation 0.43 of its most; what is left of the
     * finest under 0.02 mm is not counted off */
    double want = 0.43 * 0.587 * strays[k];
    CHECK(most <= strays[k] + 0.006 && fabs(mean) < 0.15 * want + 0.003 &&
              fabs(sd - want) < 0.12 * want + 0.002,
          "stray %g mm: ends of rings off by %+.4f mm, sd %.4f (%.4f wanted), at most %.4f\n",
          strays[k], mean, sd, want, most);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Mean difference of their latewood. */
static double apart(const points *a, const points *b) {
  double sum = 0;
  for (unsigned i = 0; i < a->count; i++)
    sum += fabs((double)a->out[LATEWOOD][i] - (double)b->out[LATEWOOD][i]);
  return sum / a->count;
}

/* With the fibre, and not across it. */
static void carried(void **state) {
  (void)state;
  sozai_texture *t =
      wood_make(NULL, "porosity=none; grain=compound; latewood_stray=0.4; latewood_abruptness=1; "
                      "ring_width=3; cut=log");
  points p = {0}, b = {0};
  uniform_seed(85);
  points_add_anywhere(&p, 30000, 50, 60, 300);
  points_ask(&p, t);
  points_along_fibre(&p, 0.5f, &b);
  points_ask(&b, t);
  double along = apart(&p, &b);
  points_clear(&b);
  points_round_pith(&p, 0.5, &b);
  points_ask(&b, t);
  double across = apart(&p, &b);
  CHECK(along < 0.1 * across, "latewood half a millimetre on differs by %.5f along, %.4f across\n",
        along, across);
  points_free(&p);
  points_free(&b);
  textures->destroy(t);
}

/* How often the edge between late- and earlywood is crossed on level lines across a
 * flat-sawn face, near an arch's tip: twice where it is smooth. */
static double crossings(const char *stray) {
  char text[512];
  snprintf(text, sizeof text,
           "porosity=none; grain=straight; slope_noise=0; pith_wander=0; undulation=0; "
           "section_wobble=0; taper=0; ring_width=4; ring_variation=0; latewood_variation=0; "
           "cut=flat; cut_distance=66; cut_tilt=2; cut_skew=0; latewood_stray=%s",
           stray);
  sozai_texture *t = wood_make(NULL, text);
  points p = {0};
  double found = 0, lines = 0;
  for (int j = 0; j < 200; j++) {
    points_clear(&p);
    for (int i = 0; i < 1000; i++) {
      unsigned n = points_add(&p, 0.02 * (i - 500), 0.5 * j, 0, 0);
      p.normal[2][n] = 1;
    }
    points_ask(&p, t);
    int count = 0;
    for (int i = 1; i < 1000; i++)
      count += (p.out[LATEWOOD][i - 1] >= 0.5f) != (p.out[LATEWOOD][i] >= 0.5f);
    found += count;
    lines += count > 0;
  }
  points_free(&p);
  textures->destroy(t);
  return found / lines;
}

static void frayed(void **state) {
  (void)state;
  double smooth = crossings("0"), ragged = crossings("0.15");
  CHECK(smooth <= 2.3 && ragged > 2.6, "an arch's edge is crossed %.2f times, strayed %.2f times\n",
        smooth, ragged);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_far_as_asked), cmocka_unit_test(carried),
                                     cmocka_unit_test(frayed)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
