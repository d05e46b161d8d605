/* SPDX-License-Identifier: Apache-2.0
 *
 * Pigment figure: that it comes in bands as often as it is told to, that the grain
 * carries it, that there is none in sapwood, and that a footprint sees the average.
 */
#include <math.h>

#include "cmocka_all.h"
#include "truth.h"

/* All black but for the bands, whose depth is red. */
#define BARE                                                                                       \
  "porosity=none; fibre_brightness=0; ray_density=0; latewood_colour=0 0 0 @ lin_rec709; "         \
  "earlywood_colour=0 0 0 @ lin_rec709; latewood_fraction=0.02; "                                  \
  "sapwood_earlywood_colour=0 0 1 @ lin_rec709; sapwood_latewood_colour=0 0 1 @ lin_rec709; "      \
  "pigment_colour=1 0 0 @ lin_rec709; parenchyma_band_width=0; "

/* Along a radius, fifty samples to a ring. */
static void ask_radius(points *p, const sozai_texture *t, double turn) {
  points_clear(p);
  for (int i = 0; i < 20000; i++) {
    double r = 0.5 + 0.04 * i;
    points_add(p, r * cos(turn), 0, r * sin(turn), 0);
  }
  points_ask(p, t);
}

/* A band's outer edge takes a quarter of a year. */
static int outer_edges(const points *p, double least, double *last) {
  int edges = 0;
  double top = 0, at = 0;
  for (unsigned i = 0; i < p->count; i++) {
    double depth = (double)p->out[ALBEDO][i], year = (double)p->out[TIME][i];
    if (year - floor(year) > 0.9) continue; /* latewood, where bands are darker */
    if (depth >= top || year - at > 0.5) {
      top = depth;
      at = year;
    } else if (top - depth > least) {
      edges++;
      while (i + 1 < p->count && (double)p->out[TIME][i + 1] < year + 0.3) i++;
      top = (double)p->out[ALBEDO][i];
      at = (double)p->out[TIME][i];
    }
    *last = year;
  }
  return edges;
}

static void spaced(void **state) {
  (void)state;
  static const double spacings[] = {3, 6, 12};
  points p = {0};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text,
             BARE "pigment=1; pigment_width=0.3; pigment_stray=0; pigment_spacing=%g; "
                  "heartwood_years=100000; ring_width=2; ring_variation=0",
             spacings[k]);
    sozai_texture *t = wood_make(NULL, text);
    double years = 0, found = 0;
    for (int a = 0; a < 4; a++) {
      double last = 0;
      ask_radius(&p, t, 0.4 + 1.5 * a);
      found += outer_edges(&p, 0.04, &last);
      years += last;
    }
    /* few are so weak or so near to a deeper one that they are not seen */
    double ratio = found * spacings[k] / years;
    CHECK(ratio > 0.7 && ratio < 1.15, "a band every %g years: %.2f times as many are found\n",
          spacings[k], ratio);
    textures->destroy(t);
  }
  points_free(&p);
}

/* Depth is in proportion to `pigment`, and beyond the heartwood there is none. */
static void within_heartwood(void **state) {
  (void)state;
  points whole = {0}, half = {0};
  sozai_texture *a = wood_make("walnut", BARE "pigment=1; heartwood_years=40; heartwood_stray=0; "
                                              "heartwood_edge=0.8");
  sozai_texture *b = wood_make("walnut", BARE "pigment=0.5; heartwood_years=40; heartwood_stray=0; "
                                              "heartwood_edge=0.8");
  ask_radius(&whole, a, 1);
  ask_radius(&half, b, 1);
  double worst = 0, sap = 0, most = 0;
  for (unsigned i = 0; i < whole.count; i++) {
    double x = (double)whole.out[ALBEDO][i], year = (double)whole.out[TIME][i];
    worst = fmax(worst, fabs(x - 2 * (double)half.out[ALBEDO][i]));
    if (year > 41) sap = fmax(sap, x);
    if (year < 39) most = fmax(most, x);
  }
  CHECK(worst < 2e-3, "half the pigment is half the depth: off by %.2g at most\n", worst);
  CHECK(sap == 0 && most > 0.3, "depth up to %.2f in heartwood, %.2g in sapwood\n", most, sap);
  points_free(&whole);
  points_free(&half);
  textures->destroy(a);
  textures->destroy(b);
}

/* Along a fibre depth is what it was; elsewhere it is not. */
static void carried(void **state) {
  (void)state;
  sozai_texture *t = wood_make("olive", BARE "pigment=1; grain=compound; heartwood_years=100000");
  points a = {0}, b = {0};
  uniform_seed(81);
  points_add_anywhere(&a, 4000, 15, 60, 200);
  points_ask(&a, t);
  points_along_fibre(&a, 0.5f, &b);
  points_ask(&b, t);
  double square = 0, spread = 0, mean = 0;
  for (unsigned i = 0; i < a.count; i++) mean += (double)a.out[ALBEDO][i] / a.count;
  for (unsigned i = 0; i < a.count; i++) {
    square += pow((double)(a.out[ALBEDO][i] - b.out[ALBEDO][i]), 2) / a.count;
    spread += pow((double)a.out[ALBEDO][i] - mean, 2) / a.count;
  }
  CHECK(sqrt(square) < 3e-3 && sqrt(spread) > 0.1,
        "half a millimetre along the fibre changes depth by %.2g, rms, of a spread of %.2f\n",
        sqrt(square), sqrt(spread));
  points_free(&a);
  points_free(&b);
  textures->destroy(t);
}

static void filtered(void **state) {
  (void)state;
  static const double sizes[] = {0.1, 1, 3, 10, 30, 100};
  static const char *const cuts[] = {"flat", "quarter", "end"};
  static const char *const presets[] = {"walnut", "olive", "rosewood", "zebrano"};
  points p = {0};
  uniform_seed(83);
  double worst = 0;
  for (int f = 0; f < 6; f++) {
    truth_errors errors = {0};
    for (int k = 0; k < 12; k++) {
      char text[256];
      /* vessels and latewood have a test of their own */
      snprintf(text, sizeof text, "cut=%s; porosity=none; latewood_fraction=0.02; ray_density=0",
               cuts[k % 3]);
      sozai_texture *t = wood_make(presets[k / 3], text);
      for (int place = 0; place < 60; place++) {
        double x = 80 * (uniform() - 0.5), y = (k % 3 < 2 ? 1200 : 80) * (uniform() - 0.5);
        truth_ask(&p, t, ONLY3(ALBEDO), x, y, 6.2831853 * uniform(), sizes[f]);
        truth_add(&errors, &p);
      }
      textures->destroy(t);
    }
    double rms = truth_rms(&errors), mean = truth_mean(&errors);
    worst = fmax(worst, fmax(rms, 5 * fabs(mean)));
    print_message("footprint %g mm over the bands: rms %.4f, mean %+.4f\n", sizes[f], rms, mean);
  }
  points_free(&p);
  CHECK(worst <= 0.01, "worst %.4f\n", worst);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(spaced), cmocka_unit_test(within_heartwood),
                                     cmocka_unit_test(carried), cmocka_unit_test(filtered)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
