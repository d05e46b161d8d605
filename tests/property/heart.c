/* SPDX-License-Identifier: Apache-2.0
 *
 * Heartwood and sapwood: where the boundary runs, that the grain carries it, and
 * that a footprint over it is the average.
 */
#include <math.h>

#include "cmocka_all.h"
#include "truth.h"

/* Heartwood red, sapwood blue, and nothing else: red is the share of heartwood. */
#define BARE                                                                                       \
  "porosity=none; fibre_brightness=0; drift=0; ray_density=0; latewood_colour=1 0 0 @ "            \
  "lin_rec709; "                                                                                   \
  "earlywood_colour=1 0 0 @ lin_rec709; sapwood_earlywood_colour=0 0 1 @ lin_rec709; "             \
  "sapwood_latewood_colour=0 0 1 @ lin_rec709; "

static void boundary(void **state) {
  (void)state;
  sozai_texture *t = wood_make("keyaki", BARE "grain=spiral; heartwood_years=20; "
                                              "heartwood_stray=4; heartwood_edge=0.5");
  points p = {0};
  uniform_seed(71);
  for (int i = 0; i < 40000; i++) {
    double a = 6.2831853 * uniform(), r = 80 * sqrt(uniform());
    points_add(&p, r * cos(a), 1000 * uniform(), r * sin(a), 0);
  }
  points_ask(&p, t);
  double low = 1e9, high = 0, sum = 0;
  int edge = 0;
  for (unsigned i = 0; i < p.count; i++) {
    double heart = (double)p.out[ALBEDO][i], year = (double)p.out[TIME][i];
    sum = fmax(sum, fabs(heart + (double)p.out[ALBEDO + 2][i] - 1));
    if (heart < 0.5) low = fmin(low, year);
    if (heart > 0.5) high = fmax(high, year);
    edge += heart > 0.01 && heart < 0.99;
  }
  CHECK(low > 16 - 1e-3 && high < 24 + 1e-3 && high - low > 2,
        "20 rings of heartwood, straying by 4: the boundary runs from year %.2f to %.2f\n", low,
        high);
  CHECK(edge > 0 && edge < 2000, "%d of 40,000 points are on the edge\n", edge);
  assert_true(sum < 1e-5);
  points_free(&p);
  textures->destroy(t);
}

/* Along a fibre wood stays what it is. */
static void carried(void **state) {
  (void)state;
  sozai_texture *t = wood_make("sugi", BARE "grain=compound; heartwood_years=12; "
                                            "heartwood_stray=5; heartwood_edge=3");
  points a = {0}, b = {0};
  uniform_seed(72);
  points_add_anywhere(&a, 4000, 15, 25, 200);
  points_ask(&a, t);
  double worst = 0;
  int part = 0;
  points_along_fibre(&a, 0.5f, &b);
  points_ask(&b, t);
  for (unsigned i = 0; i < a.count; i++) {
    worst = fmax(worst, fabs((double)(a.out[ALBEDO][i] - b.out[ALBEDO][i])));
    part += a.out[ALBEDO][i] > 0.01f && a.out[ALBEDO][i] < 0.99f;
  }
  CHECK(worst < 2e-3 && part > 200,
        "half a millimetre along the fibre changes heartwood by %.2g (%d points on the edge)\n",
        worst, part);
  points_free(&a);
  points_free(&b);
  textures->destroy(t);
}

static void filtered(void **state) {
  (void)state;
  static const double sizes[] = {0.1, 1, 3, 10, 30};
  static const char *const cuts[] = {"flat", "end"};
  points p = {0};
  uniform_seed(73);
  double worst = 0;
  for (int f = 0; f < 5; f++) {
    truth_errors errors = {0};
    for (int c = 0; c < 2; c++) {
      char text[256];
      snprintf(text, sizeof text, "cut=%s; cut_distance=25; heartwood_years=15", cuts[c]);
      sozai_texture *t = wood_make("onigurumi", text);
      for (int place = 0; place < 400; place++) {
        double x = 80 * (uniform() - 0.5), y = (c ? 80 : 1200) * (uniform() - 0.5);
        truth_ask(&p, t, ONLY3(ALBEDO), x, y, 0, sizes[f]);
        truth_add(&errors, &p);
      }
      textures->destroy(t);
    }
    double rms = truth_rms(&errors), mean = truth_mean(&errors);
    worst = fmax(worst, fmax(rms, 5 * fabs(mean)));
    print_message("footprint %g mm over the boundary: rms %.4f, mean %+.4f\n", sizes[f], rms, mean);
  }
  points_free(&p);
  CHECK(worst <= 0.014, "worst %.4f\n", worst);
}

/* The mean albedo of what the channel tells of, and of the rest. */
static void of_tissue(const char *preset, const char *values, int channel, double mean[2]) {
  sozai_texture *t = wood_make(preset, values);
  points p = {0};
  double sum[2] = {0, 0};
  unsigned count[2] = {0, 0};
  uniform_seed(19);
  for (int i = 0; i < 60000; i++)
    points_add(&p, 60 * (uniform() - 0.5), 300 * (uniform() - 0.5), 0, 0);
  points_ask(&p, t);
  for (unsigned i = 0; i < p.count; i++) {
    double share = points_value(&p, channel, i);
    if (share > 0.05 && share < 0.95) continue;
    for (int c = 0; c < 3; c++) sum[share < 0.5] += points_value(&p, ALBEDO + c, i) / 3;
    count[share < 0.5]++;
  }
  assert_true(count[0] > 50 && count[1] > 50);
  for (int k = 0; k < 2; k++) mean[k] = sum[k] / count[k];
  points_free(&p);
  textures->destroy(t);
}

/* Rays of sapwood are as pale as it is, whatever they are in heartwood. */
static void rays_are_sapwood_too(void **state) {
  (void)state;
  static const char *const species[] = {"oak", "white_oak", "silky_oak", "plane", "beech"};
  double worst = 0;
  for (unsigned k = 0; k < sizeof species / sizeof *species; k++) {
    double heart[2], sap[2];
    of_tissue(species[k], "cut=quarter; heartwood_years=5000", RAY, heart);
    of_tissue(species[k], "cut=quarter; heartwood_years=1; heartwood_edge=0.5", RAY, sap);
    print_message("%s: rays are %+.3f beside heartwood, %+.3f beside sapwood\n", species[k],
                  heart[0] - heart[1], sap[0] - sap[1]);
    worst = fmax(worst, sap[1] - sap[0]);
  }
  CHECK(worst <= 0.03, "rays are darker than sapwood by at most %.3f\n", worst);
}

/* Vessels too: their lumina lie in shade there as in heartwood, and nothing stains them. */
static void vessels_are_sapwood_too(void **state) {
  (void)state;
  static const char *const species[] = {"katsura", "yellow_birch", "buna",
                                        "padauk",  "honoki",       "ash"};
  double least = 1, most = 0;
  for (unsigned k = 0; k < sizeof species / sizeof *species; k++) {
    double heart[2], sap[2];
    of_tissue(species[k], "cut=end; heartwood_years=5000", VESSEL, heart);
    of_tissue(species[k], "cut=end; heartwood_years=1; heartwood_edge=0.5", VESSEL, sap);
    double dark = heart[0] / heart[1], pale = sap[0] / sap[1];
    print_message("%s: vessels have %.3f of the light that heartwood has about them, %.3f of the "
                  "light that sapwood has\n",
                  species[k], dark, pale);
    least = fmin(least, pale / dark);
    most = fmax(most, pale);
  }
  CHECK(least >= 0.9 && most < 1, "at least %.3f of it, at most %.3f\n", least, most);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(rays_are_sapwood_too), cmocka_unit_test(vessels_are_sapwood_too),
      cmocka_unit_test(boundary), cmocka_unit_test(carried), cmocka_unit_test(filtered)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
