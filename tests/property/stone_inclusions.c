/* SPDX-License-Identifier: Apache-2.0
 *
 * Inclusions that are not opaque: what they lie in is seen on within them.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "truth.h"

enum { SPECK = 12, PLACES = 4000 };

/* Whose edges are wide and not, in a ground of all that may lie below. */
#define STONE                                                                                      \
  "inclusion_size=20; inclusion_share=0.4; inclusion_second_share=0.15; inclusion_blur=2; "        \
  "inclusion_turbidity=0.6; inclusion_cleavage=0.4; mottle=0.2; mottle_size=8; bed_contrast=0.6; " \
  "bed_thickness=15; black_share=0.06; white_share=0.05; vein_width=0; hole_share=0"

static const char *const faces[] = {STONE, STONE "; inclusion_rim=2; inclusion_roundness=0.6"};

static sozai_texture *make(const char *face, const char *more) {
  char text[800];
  snprintf(text, sizeof text, "%s%s", face, more);
  return stone_make(NULL, text);
}

static void ask(points *p, const char *face, const char *more) {
  sozai_texture *t = make(face, more);
  points_ask(p, t);
  textures->destroy(t);
}

static void anywhere(points *p, double footprint) {
  points_clear(p);
  for (int i = 0; i < PLACES; i++)
    points_add(p, 900 * (uniform() - 0.5), 900 * (uniform() - 0.5), 0, footprint);
}

/* Of a point, and of a footprint of any width for as long as nothing is seen in parts, the colour
 * goes in a straight line from what lies below to the opaque inclusion. */
static void between_below_and_opaque(void **state) {
  (void)state;
  static points none, opaque, half;
  static const struct {
    const char *text;
    double share;
  } opacities[] = {{"; inclusion_opacity=0.5", 0.5}, {"; inclusion_opacity=0.15", 0.15}};
  points *all[] = {&none, &opaque, &half};
  for (int i = 0; i < 3; i++) {
    uniform_seed(81);
    anywhere(all[i], 0);
  }
  for (int f = 0; f < 2; f++) {
    double worst = 0, speck = 0, least = 1, most = 0;
    ask(&none, faces[f], "; inclusion_opacity=0");
    ask(&opaque, faces[f], "");
    for (int k = 0; k < 2; k++) {
      ask(&half, faces[f], opacities[k].text);
      for (unsigned i = 0; i < PLACES; i++) {
        for (int c = 0; c < 3; c++) {
          double a = points_value(&none, ALBEDO + c, i), b = points_value(&opaque, ALBEDO + c, i);
          double is = points_value(&half, ALBEDO + c, i);
          worst = fmax(worst, fabs(is - (a + opacities[k].share * (b - a))));
          least = fmin(least, is), most = fmax(most, is);
        }
        double a = points_value(&none, SPECK, i), b = points_value(&opaque, SPECK, i);
        speck =
            fmax(speck, fabs(points_value(&half, SPECK, i) - (a + opacities[k].share * (b - a))));
      }
    }
    CHECK(worst < 1e-6, "face %d: off the line between by %.2e at most\n", f, worst);
    CHECK(speck < 1e-6, "face %d: share of specks off by %.2e at most\n", f, speck);
    CHECK(least > 0 && most < 1, "face %d: albedo from %.3f to %.3f\n", f, least, most);
  }
}

/* At no opacity they are not there, but for what stands out of the face. */
static void none_is_no_inclusion(void **state) {
  (void)state;
  static points none, without;
  double worst = 0;
  uniform_seed(82);
  anywhere(&none, 0.3);
  uniform_seed(82);
  anywhere(&without, 0.3);
  ask(&none, faces[0], "; inclusion_opacity=0");
  ask(&without, faces[0], "; inclusion_share=0; inclusion_second_share=0");
  for (unsigned i = 0; i < PLACES; i++) {
    for (int c = 0; c < 3; c++)
      worst = fmax(
          worst, fabs(points_value(&none, ALBEDO + c, i) - points_value(&without, ALBEDO + c, i)));
  }
  CHECK(worst < 1e-6, "of a stone without any it differs by %.2e at most\n", worst);
}

/* As large as the crystals below, of which half are black. */
#define COARSE                                                                                     \
  "grain_size=6; second_share=0.5; third_share=0; grain_variation=0; inclusion_size=9; "           \
  "inclusion_share=0.45; base_colour=0.7 0.7 0.7 @ lin_rec709; second_colour=0 0 0 @ lin_rec709; " \
  "inclusion_colour=0.9 0.9 0.9 @ lin_rec709; vein_width=0; hole_share=0; black_share=0"

/* A wide footprint's mean is that of its points: what is below and what covers it vary together. */
static void wide_footprints_see_the_mean(void **state) {
  (void)state;
  static const struct {
    const char *face;
    double size, most; /* mm; RMS */
  } wide_as[] = {{STONE, 2, 0.01},   {STONE, 8, 0.01},   {STONE, 30, 0.01},  {STONE, 100, 0.01},
                 {COARSE, 5, 0.009}, {COARSE, 12, 0.01}, {COARSE, 25, 0.016}};
  enum { WIDE = 160 };
  points p = {0};
  for (unsigned k = 0; k < sizeof wide_as / sizeof *wide_as; k++) {
    const double size = wide_as[k].size;
    sozai_texture *t = make(wide_as[k].face, "; inclusion_opacity=0.5");
    double sum = 0, square = 0;
    uniform_seed(83);
    for (int i = 0; i < WIDE; i++) {
      double x = 4000 * (uniform() - 0.5), y = 4000 * (uniform() - 0.5);
      truth_ask(&p, t, ONLY3(ALBEDO), x, y, 0, size);
      double off = truth_error(&p, ALBEDO + 1);
      sum += off;
      square += off * off;
    }
    CHECK(sqrt(square / WIDE) < wide_as[k].most, "%g mm: RMS %.4f (held at %g)\n", size,
          sqrt(square / WIDE), wide_as[k].most);
    CHECK(fabs(sum / WIDE) < 0.002, "%g mm: mean %+.4f (goal 0.002)\n", size, sum / WIDE);
    textures->destroy(t);
  }
  points_free(&p);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(between_below_and_opaque),
                                     cmocka_unit_test(none_is_no_inclusion),
                                     cmocka_unit_test(wide_footprints_see_the_mean)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
