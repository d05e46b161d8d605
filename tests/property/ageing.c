/* SPDX-License-Identifier: Apache-2.0
 *
 * Ageing: colours go from the fresh to the aged one of their species, all the
 * way and never back, by half of it in the time that an exponential says; and
 * mineral streaks take the share of the wood asked for.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

/* Earlywood alone: what albedo is then. */
static void tissue_after(const char *preset, double years, const char *part, double rgb[3]) {
  char text[512];
  snprintf(text, sizeof text,
           "construction=solid;porosity=none;ray_density=0;streak_share=0;pigment=0;fibre_"
           "brightness=0;drift=0;age_"
           "years=%g;%s",
           years, part);
  sozai_texture *t = wood_make(preset, text);
  points p = {0};
  points_add(&p, 40, 10, 3, 0);
  points_ask(&p, t);
  for (int c = 0; c < 3; c++) rgb[c] = (double)p.out[ALBEDO + c][0];
  points_free(&p);
  textures->destroy(t);
}

#define EARLY                                                                                      \
  "latewood_fraction=0.01;latewood_abruptness=1;ring_width=30;ring_variation=0;heartwood_years="   \
  "1000;parenchyma_band_width=0;paratracheal_parenchyma=0;vessel_band_parenchyma=0;marginal_"      \
  "parenchyma=0"

/* A colour parameter of a preset in linear light. */
static void colour_of(const char *preset, const char *id, double out[3]) {
  const sozai_texture_info *info = textures->find("wood");
  const sozai_preset *found = NULL;
  out[0] = out[1] = out[2] = 0;
  for (uint32_t i = 0; i < info->preset_count; i++) {
    if (strcmp(info->presets[i]->id, preset) == 0) found = info->presets[i];
  }
  assert_non_null(found);
  for (uint32_t i = 0; i < found->value_count; i++) {
    if (strcmp(found->values[i].id, id) != 0) continue;
    for (int c = 0; c < 3; c++) {
      double x = found->values[i].number[c];
      out[c] = x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
    }
    return;
  }
  fail_msg("%s has no %s of its own", preset, id);
}

static double number_of(const char *preset, const char *id) {
  const sozai_texture_info *info = textures->find("wood");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    if (strcmp(info->presets[i]->id, preset) != 0) continue;
    const sozai_preset *p = info->presets[i];
    for (uint32_t k = 0; k < p->value_count; k++) {
      if (strcmp(p->values[k].id, id) == 0) return p->values[k].number[0];
    }
  }
  fail_msg("%s has no %s of its own", preset, id);
  return 0;
}

static void colours_saturate(void **state) {
  (void)state;
  for (unsigned k = 0; k < wood_presets(); k++) {
    const char *id = wood_preset(k);
    double aged[3] = {0}, fresh[3], end[3], before[3], time = number_of(id, "ageing_years");
    colour_of(id, "aged_colour", aged);
    tissue_after(id, 0, EARLY, fresh);
    tissue_after(id, 1000, EARLY, end);
    memcpy(before, fresh, sizeof before);
    int monotone = 1;
    for (int step = 1; step <= 10; step++) {
      double now[3];
      tissue_after(id, 0.5 * step * time, EARLY, now);
      for (int c = 0; c < 3; c++) {
        double way = end[c] - fresh[c];
        if ((now[c] - before[c]) * way < 0) monotone = 0;
        /* half the time constant's exponential, in the logarithm */
        double done = log(now[c] / fresh[c]) / log(end[c] / fresh[c]);
        if (fabs(way) > 0.01 && fabs(done - (1 - exp(-0.5 * step))) > 0.01) monotone = 0;
      }
      memcpy(before, now, sizeof before);
    }
    double off = 0, change = 0;
    for (int c = 0; c < 3; c++) {
      off = fmax(off, fabs(end[c] - aged[c]));
      change = fmax(change, fabs(end[c] - fresh[c]));
    }
    CHECK(monotone && off < 0.003 && change > 0.002 && time >= 0.3 && time <= 12,
          "%-18s time %4.1f years: (%.3f %.3f %.3f) to (%.3f %.3f %.3f), aged_colour off by %.4f\n",
          id, time, fresh[0], fresh[1], fresh[2], end[0], end[1], end[2], off);
  }
}

/* What the literature says of a few: which way they go. */
static void known_woods_go_the_known_way(void **state) {
  (void)state;
  static const struct {
    const char *id;
    int darker;
  } known[] = {{"cherry", 1}, {"black_walnut", 0}, {"walnut", 0},
               {"spruce", 1}, {"padauk", 1},       {"hard_maple", 1},
               {"iroko", 1},  {"wenge", 0},        {"tulipwood", 1}};
  for (unsigned k = 0; k < sizeof known / sizeof *known; k++) {
    double a[3], b[3];
    tissue_after(known[k].id, 0, EARLY, a);
    tissue_after(known[k].id, 20, EARLY, b);
    double grey = 0.21 * (b[0] - a[0]) + 0.72 * (b[1] - a[1]) + 0.07 * (b[2] - a[2]);
    CHECK(known[k].darker ? grey < -0.01 : grey > 0.01, "%-14s luminance by %+.3f in 20 years\n",
          known[k].id, grey);
  }
}

static void streaks_take_their_share(void **state) {
  (void)state;
  static const double shares[] = {0.01, 0.03, 0.06};
  for (int k = 0; k < 3; k++) {
    char text[320];
    snprintf(text, sizeof text,
             "porosity=none;fibre_brightness=0;earlywood_colour=0.8 0.8 0.8 @ lin_rec709;"
             "latewood_colour=0.8 0.8 0.8 @ lin_rec709;heartwood_years=1000;cut=rift;"
             "streak_colour=0 0 0 @ lin_rec709;streak_share=%g",
             shares[k]);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(98);
    for (int i = 0; i < 200000; i++) {
      points_add(&p, 400 * (uniform() - 0.5), 4000 * (uniform() - 0.5), 200 * uniform(), 0);
    }
    points_add(&p, 0, 0, 0, 2000);
    points_ask(&p, t);
    double mean = 0;
    for (unsigned i = 0; i + 1 < p.count; i++) {
      mean += (1 - (double)p.out[ALBEDO][i] / 0.8) / (p.count - 1);
    }
    double wide = 1 - (double)p.out[ALBEDO][p.count - 1] / 0.8;
    CHECK(fabs(mean / shares[k] - 1) < 0.15 && fabs(wide / shares[k] - 1) < 0.01,
          "streak_share %.3f: %.4f of the wood, %.4f under a wide footprint\n", shares[k], mean,
          wide);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(colours_saturate),
      cmocka_unit_test(known_woods_go_the_known_way),
      cmocka_unit_test(streaks_take_their_share),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
