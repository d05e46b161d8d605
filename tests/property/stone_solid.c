/* SPDX-License-Identifier: Apache-2.0
 *
 * Solid stone: one fabric through a block, whatever face shows it; shares that
 * are shares of area; albedo linear in the palette; and a point the same whoever is beside it.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum { SPECULAR = 11, SPECK = 12, N = 200000 };

static sozai_texture *make(const char *preset, const sozai_value *values, uint32_t count) {
  sozai_texture *t = NULL;
  if (textures->create(NULL, "stone", preset, values, count, &t)) {
    fail_msg("%s", textures->last_error());
  }
  return t;
}

static sozai_value number(const char *id, double x) {
  return (sozai_value){.id = id, .kind = SOZAI_KIND_FLOAT, .number = {x}};
}

static void any_face_shows_the_same(void **state) {
  (void)state;
  const sozai_texture_info *info = textures->find("stone");
  for (uint32_t k = 0; k < info->preset_count; k++) {
    sozai_texture *t = make(info->presets[k]->id, NULL, 0);
    points p = {0};
    uniform_seed(91);
    for (int i = 0; i < 2000; i++) {
      double x[3];
      for (int c = 0; c < 3; c++) x[c] = 400 * (uniform() - 0.5);
      for (int f = 0; f < 2; f++) {
        unsigned j = points_add(&p, x[0], x[1], x[2], 0);
        for (int c = 0; f && c < 3; c++) p.normal[c][j] = (float)(uniform() - 0.5);
      }
    }
    points_ask(&p, t);
    double worst = 0;
    for (unsigned i = 0; i < p.count; i += 2) {
      for (int c = 0; c < 3; c++) {
        worst = fmax(worst, fabs((double)(p.out[c][i] - p.out[c][i + 1])));
      }
    }
    /* the width of a line that is a micron of a vein's edge depends on the face */
    CHECK(worst < 1e-4, "%s: two faces through a point differ by %.2g\n", info->presets[k]->id,
          worst);
    points_free(&p);
    textures->destroy(t);
  }
}

static void shares_are_of_area(void **state) {
  (void)state;
  static const double black[] = {0.02, 0.06, 0.15};
  for (int k = 0; k < 3; k++) {
    const sozai_value v[] = {number("black_share", black[k]), number("white_share", 0.03)};
    sozai_texture *t = make(NULL, v, 2);
    points p = {0};
    uniform_seed(92);
    for (int i = 0; i < N; i++) {
      points_add(&p, 900 * (uniform() - 0.5), 900 * (uniform() - 0.5), 0, 0);
    }
    points_ask(&p, t);
    double share = 0;
    for (int i = 0; i < N; i++) share += (double)p.out[SPECK][i] / N;
    double wanted = black[k] + 0.03;
    CHECK(fabs(share - wanted) < 0.05 * wanted, "specks of %.2f and 0.03: %.4f of the area\n",
          black[k], share);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Every colour alone, the others black: their sum is the whole at a point; how closely a
 * footprint is looked at goes by the palette. */
static void linear_in_the_palette(void **state) {
  (void)state;
  static const char *const ids[] = {
      "base_colour",  "second_colour",         "third_colour",
      "bed_colour",   "inclusion_colour",      "inclusion_second_colour",
      "black_colour", "white_colour",          "vein_colour",
      "hole_colour",  "inclusion_third_colour"};
  enum { COLOURS = 11, POINTS = 4000 };
  static double sum[POINTS];
  points p = {0};
  uniform_seed(93);
  for (int i = 0; i < POINTS; i++) {
    points_add(&p, 300 * (uniform() - 0.5), 300 * (uniform() - 0.5), 0, 0);
  }
  double worst = 0;
  for (int k = 0; k <= COLOURS; k++) {
    sozai_value v[COLOURS + 2] = {number("vein_width", 4)};
    for (int c = 0; c < COLOURS; c++) {
      double x = k == COLOURS || k == c ? 0.05 * (c + 1) : 0;
      v[c + 1] = (sozai_value){
          .id = ids[c], .kind = SOZAI_KIND_COLOUR, .number = {x, x, x}, .text = "lin_rec709"};
    }
    v[COLOURS + 1] = number("inclusion_third_share", 0.05);
    sozai_texture *t = make("oya", v, COLOURS + 2);
    points_ask(&p, t);
    for (int i = 0; i < POINTS; i++) {
      if (k == COLOURS) {
        worst = fmax(worst, fabs(sum[i] - (double)p.out[0][i]));
      } else {
        sum[i] = (k ? sum[i] : 0) + (double)p.out[0][i];
      }
    }
    textures->destroy(t);
  }
  CHECK(worst < 1e-5, "the sum of eleven palettes of one colour is off by %.2g\n", worst);
  points_free(&p);
}

/* What is seen within crystals is as light as it is dark, and a wide footprint has
 * nothing of it left: the mean over many crystals is the mineral's own. */
static void crystals_keep_their_mean(void **state) {
  (void)state;
  static const char *const ids[] = {"cleavage", "turbidity", "grain_depth"};
  enum { CRYSTALS = 60000, SQUARES = 300 };
  double plain[2] = {0, 0};
  for (int k = -1; k < 3; k++) {
    sozai_value v[] = {number("mottle", 0), number("grain_size", 2), number("second_share", 0.4),
                       number("black_share", 0), number(k < 0 ? "seed" : ids[k], 1)};
    if (k < 0) v[4].kind = SOZAI_KIND_INT;
    sozai_texture *t = make("inada", v, 5);
    points p = {0};
    uniform_seed(94);
    for (int i = 0; i < CRYSTALS + SQUARES; i++)
      points_add(&p, 2000 * (uniform() - 0.5), 2000 * (uniform() - 0.5), 0,
                 i < CRYSTALS ? 0 : 8 * 2);
    points_ask(&p, t);
    double mean[2] = {0, 0}, square = 0;
    for (int i = 0; i < CRYSTALS; i++) {
      mean[0] += (double)p.out[0][i] / CRYSTALS;
      square += (double)(p.out[0][i] * p.out[0][i]) / CRYSTALS;
    }
    for (int i = CRYSTALS; i < CRYSTALS + SQUARES; i++) mean[1] += (double)p.out[0][i] / SQUARES;
    if (k < 0) {
      plain[0] = mean[0];
      plain[1] = mean[1];
    } else {
      for (int f = 0; f < 2; f++)
        CHECK(fabs(mean[f] / plain[f] - 1) < 0.002, "%s, %s: the mean is %.4f of that without it\n",
              ids[k], f ? "wide" : "at points", mean[f] / plain[f]);
    }
    print_message("%s: mean %.4f, sd %.4f\n", k < 0 ? "plain" : ids[k], mean[0],
                  sqrt(square - mean[0] * mean[0]));
    points_free(&p);
    textures->destroy(t);
  }
}

/* Points beside each other, as a raster's are, tell each other what is not near any of them, and
 * what covers them all. Each alone has to say the same. */
static void neighbours_see_what_each_sees(void **state) {
  (void)state;
  static const char *const ids[] = {"travertino", "oya", "nero_marquina", "terrazzo"};
  enum { ROWS = 120, ROW = 64, OUT = 11 };
  for (unsigned k = 0; k < sizeof ids / sizeof *ids; k++) {
    sozai_texture *t = make(ids[k], NULL, 0);
    points p = {0};
    uniform_seed(29 + k);
    for (int j = 0; j < ROWS; j++) {
      double s = j % 3 == 0 ? 0.02 : j % 3 == 1 ? 0.0625 : 0.25;
      double x = 400 * uniform(), y = 400 * uniform(), z = 400 * uniform();
      for (int i = 0; i < ROW; i++) points_add(&p, x + i * s, y, z, s);
    }
    points_ask(&p, t);
    unsigned differ = 0;
    for (unsigned i = 0; i < p.count; i++) {
      float own[OUT], *out[OUT];
      for (int c = 0; c < OUT; c++) out[c] = c >= 3 && c < 6 ? NULL : &own[c];
      sozai_batch b = {.size = sizeof b, .count = 1, .footprint = &p.footprint[i]};
      for (int c = 0; c < 3; c++) {
        b.point[c] = &p.point[c][i];
        b.normal[c] = &p.normal[c][i];
      }
      b.out = out;
      b.out_count = OUT;
      assert_int_equal(textures->evaluate(t, &b), SOZAI_OK);
      for (int c = 0; c < OUT; c++) differ += out[c] && memcmp(&own[c], &p.out[c][i], sizeof *own);
    }
    CHECK(differ == 0, "%s: %u numbers of %u points differ from each point's alone\n", ids[k],
          differ, p.count);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Lines through the stone cross the outlines of ragged holes more often for their share. */
static void holes_are_as_ragged(void **state) {
  (void)state;
  enum { LINES = 300, ON = 400 };
  double share[3], crossed[3];
  for (int k = 0; k < 3; k++) {
    char text[80];
    snprintf(text, sizeof text, "hole_share=0.12; hole_size=8; hole_raggedness=%g", 0.5 * k);
    sozai_texture *t = stone_make(NULL, text);
    points p = {0};
    uniform_seed(31);
    for (int j = 0; j < LINES; j++) {
      double x = 900 * uniform(), y = 900 * uniform(), z = 900 * uniform();
      for (int i = 0; i < ON; i++) points_add(&p, x + 0.15 * i, y, z, 0);
    }
    points_ask(&p, t);
    unsigned in = 0, edges = 0;
    for (unsigned i = 0; i < p.count; i++) {
      /* what is a hole reflects nothing */
      int here = p.out[SPECULAR][i] < 0.01f;
      in += (unsigned)here;
      if (i % ON) edges += here != (p.out[SPECULAR][i - 1] < 0.01f);
    }
    share[k] = (double)in / p.count;
    crossed[k] = edges / share[k] / p.count;
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(
      crossed[1] > crossed[0] && crossed[2] > 1.1 * crossed[0] && fabs(share[0] - 0.12) < 0.02 &&
          fabs(share[2] - 0.12) < 0.02,
      "hole_raggedness 0, 0.5, 1: of area %.3f, %.3f, %.3f; outlines on a line through them every "
      "%.2f, %.2f, %.2f mm\n",
      share[0], share[1], share[2], 0.15 / crossed[0], 0.15 / crossed[1], 0.15 / crossed[2]);
}

/* What lies between an inclusion's colour and the ground's takes as much of a face as its border is
 * wide. */
static void borders_are_as_wide(void **state) {
  (void)state;
  static const double wide[] = {0.4, 0.8, 1.6};
  double between[3];
  for (int k = 0; k < 3; k++) {
    char text[200];
    snprintf(text, sizeof text,
             "inclusion_share=0.3; inclusion_size=30; inclusion_variation=0; grain_variation=0; "
             "second_share=0; third_share=0; mottle=0; inclusion_blur=%g",
             wide[k]);
    sozai_texture *t = stone_make(NULL, text);
    points p = {0};
    uniform_seed(32);
    for (int i = 0; i < 40000; i++) points_add(&p, 900 * uniform(), 900 * uniform(), 0, 0);
    points_ask(&p, t);
    float low = 1, high = 0;
    for (unsigned i = 0; i < p.count; i++) {
      low = fminf(low, p.out[0][i]);
      high = fmaxf(high, p.out[0][i]);
    }
    unsigned in = 0;
    for (unsigned i = 0; i < p.count; i++) {
      float x = (p.out[0][i] - low) / (high - low);
      in += x > 0.01f && x < 0.99f;
    }
    between[k] = (double)in / p.count;
    points_free(&p);
    textures->destroy(t);
  }
  double twice = between[1] / between[0], again = between[2] / between[1];
  CHECK(between[0] > 0.01 && fabs(twice - 2) < 0.2 && fabs(again - 2) < 0.2,
        "inclusion_blur %g, %g, %g mm: borders take %.4f, %.4f, %.4f of the area\n", wide[0],
        wide[1], wide[2], between[0], between[1], between[2]);
}

/* Black flakes are of many blacks, with their cleavage; light ones of fewer. */
static void specks_differ(void **state) {
  (void)state;
  for (int k = 0; k < 2; k++) {
    double spread[2], mean[2];
    for (int light = 0; light < 2; light++) {
      const sozai_value v[] = {
          number("cleavage", 0.8 * k), number(light ? "white_share" : "black_share", 0.2),
          number("speck_size", 5), number("speck_flatness", 0.5), number("mottle", 0)};
      sozai_texture *t = make(NULL, v, 5);
      points p = {0};
      uniform_seed(33);
      for (int i = 0; i < 40000; i++) points_add(&p, 900 * uniform(), 900 * uniform(), 0, 0);
      points_ask(&p, t);
      double sum = 0, square = 0;
      unsigned count = 0;
      for (unsigned i = 0; i < p.count; i++) {
        if (p.out[SPECK][i] < 0.9999f) continue;
        double x = (double)p.out[0][i];
        sum += x;
        square += x * x;
        count++;
      }
      mean[light] = sum / count;
      spread[light] = sqrt(fmax(square / count - mean[light] * mean[light], 0)) / mean[light];
      points_free(&p);
      textures->destroy(t);
    }
    double ratio = spread[1] / spread[0];
    CHECK(k ? spread[0] > 0.3 && ratio > 0.3 && ratio < 0.5 : spread[0] + spread[1] < 1e-4,
          "cleavage %.1f: black specks' brightness has an sd of %.3f of it, white ones' %.3f\n",
          0.8 * k, spread[0], spread[1]);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(any_face_shows_the_same),       cmocka_unit_test(shares_are_of_area),
      cmocka_unit_test(linear_in_the_palette),         cmocka_unit_test(crystals_keep_their_mean),
      cmocka_unit_test(neighbours_see_what_each_sees), cmocka_unit_test(holes_are_as_ragged),
      cmocka_unit_test(borders_are_as_wide),           cmocka_unit_test(specks_differ)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
