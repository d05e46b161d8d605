/* SPDX-License-Identifier: Apache-2.0
 *
 * Strands of the texture: they run along their tangents, are as thick and as many
 * as is said, lie in the directions asked for, and cloth shows its yarns.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
enum { COVERAGE = 6, TANGENT = 7, STRAND = 10, DEPTH = 11 };

static sozai_texture *make(const char *preset, const sozai_value *values, uint32_t count) {
  sozai_texture *t = NULL;
  if (textures->create(NULL, "fiber", preset, values, count, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

static double number_of(const sozai_texture *t, const char *id) {
  sozai_value v;
  assert_int_equal(textures->value(t, id, &v), SOZAI_OK);
  return v.number[0];
}

/* A small step along the tangent stays on the strand; one across it of more than its
 * thickness leaves it. */
static void along_their_tangents(void **state) {
  (void)state;
  static const char *const presets[] = {"felt", "cotton", "wool_merino", "coir", "denim", "linen"};
  for (int k = 0; k < 6; k++) {
    sozai_texture *t = make(presets[k], NULL, 0);
    double d = number_of(t, "diameter") * 0.001;
    points p = {0}, q = {0};
    uniform_seed(91);
    for (int i = 0; i < 4000; i++) points_add(&p, 100 * uniform(), 100 * uniform(), 0, 0);
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) {
      double x = (double)p.out[TANGENT][i], y = (double)p.out[TANGENT + 1][i], n = hypot(x, y);
      if (n < 1e-3) x = n = 1;
      x *= 0.5 * d / n;
      y *= 0.5 * d / n;
      points_add(&q, (double)p.point[0][i] + x, (double)p.point[1][i] + y, 0, 0);
      points_add(&q, (double)p.point[0][i] - 5 * y, (double)p.point[1][i] + 5 * x, 0, 0);
    }
    points_ask(&q, t);
    unsigned stay = 0, leave = 0, seen = 0;
    for (unsigned i = 0; i < p.count; i++) {
      if (p.out[COVERAGE][i] < 0.5f || p.out[STRAND][i] == 0.0f) continue;
      seen++;
      stay += q.out[STRAND][2 * i] == p.out[STRAND][i];
      leave += q.out[STRAND][2 * i + 1] != p.out[STRAND][i];
    }
    print_message(
        "%s: %.1f %% stay on the strand half a diameter along it, %.1f %% leave it across\n",
        presets[k], 100.0 * stay / seen, 100.0 * leave / seen);
    assert_true(stay > 0.75 * seen && leave > 0.97 * seen);
    points_free(&p);
    points_free(&q);
    textures->destroy(t);
  }
}

/* Looked at squarely a shell of cylinders that lie in it covers 1 - e^-(4 packing
 * thickness / (pi diameter)). */
static void as_many_as_packed(void **state) {
  (void)state;
  static const double depths[] = {0.05, 0.2, 0.5, 1, 1.5};
  for (int k = 0; k < 5; k++) {
    double d = 0.025, thickness = 1, packing = depths[k] * d * PI / 4 / thickness;
    const sozai_value values[] = {
        {.id = "diameter", .kind = SOZAI_KIND_FLOAT, .number = {25}},
        {.id = "thickness", .kind = SOZAI_KIND_FLOAT, .number = {thickness}},
        {.id = "packing", .kind = SOZAI_KIND_FLOAT, .number = {packing}},
        {.id = "flyaway", .kind = SOZAI_KIND_FLOAT},
        {.id = "elevation_spread", .kind = SOZAI_KIND_FLOAT}};
    sozai_texture *t = make(NULL, values, 5);
    points p = {0};
    uniform_seed(92);
    for (int i = 0; i < 60000; i++) points_add(&p, 900 * uniform(), 900 * uniform(), 0, 0);
    for (int i = 0; i < 1000; i++) points_add(&p, 900 * uniform(), 900 * uniform(), 0, 100);
    points_ask(&p, t);
    double near = 0, far = 0, expected = 1 - exp(-depths[k]);
    for (unsigned i = 0; i < 60000; i++) near += (double)p.out[COVERAGE][i] / 60000;
    for (unsigned i = 60000; i < p.count; i++) far += (double)p.out[COVERAGE][i] / 1000;
    print_message("optical depth %g: covers %.4f by points, %.4f from afar; %.4f by the formula\n",
                  depths[k], near, far, expected);
    assert_true(fabs(near - expected) < 0.03 * expected && fabs(far - near) < 0.03 * expected);
    points_free(&p);
    textures->destroy(t);
  }
}

/* The mean of e^2ia over the strands' angles a on the surface: 0 where all directions
 * are as frequent, 1 where all are one. */
static double order(const char *preset, double alignment, double *angle) {
  const sozai_value values[] = {
      {.id = "alignment", .kind = SOZAI_KIND_FLOAT, .number = {alignment}},
      {.id = "crimp", .kind = SOZAI_KIND_FLOAT}};
  sozai_texture *t = make(preset, values, 2);
  points p = {0};
  double sum[2] = {0};
  uniform_seed(93);
  for (int i = 0; i < 40000; i++) points_add(&p, 900 * uniform(), 900 * uniform(), 0, 0);
  points_ask(&p, t);
  for (unsigned i = 0; i < p.count; i++) {
    if (p.out[STRAND][i] == 0.0f) continue; /* deeper than single strands are */
    double a = atan2((double)p.out[TANGENT + 1][i], (double)p.out[TANGENT][i]);
    sum[0] += cos(2 * a) / p.count;
    sum[1] += sin(2 * a) / p.count;
  }
  points_free(&p);
  textures->destroy(t);
  *angle = 0.5 * atan2(sum[1], sum[0]) * 180 / PI;
  return hypot(sum[0], sum[1]);
}

static void in_the_directions_asked_for(void **state) {
  (void)state;
  double angle, none = order("felt", 0, &angle), half = order("felt", 0.6, &angle);
  double all = order("felt", 1, &angle);
  print_message("order of felt: %.3f at alignment 0, %.3f at 0.6, %.3f at 1 (along %.1f degrees)\n",
                none, half, all, angle);
  assert_true(none < 0.05 && half > 0.2 && all > 0.7 && fabs(fabs(angle) - 90) < 3);
}

/* Denim's face: three crossings of four are warp's. Its colour is between. */
static void cloth_shows_its_yarns(void **state) {
  (void)state;
  static const sozai_value colours[] = {
      {.id = "colour", .kind = SOZAI_KIND_COLOUR, .number = {1, 0, 0}, .text = "sRGB"},
      {.id = "weft_colour", .kind = SOZAI_KIND_COLOUR, .number = {0, 1, 0}, .text = "sRGB"},
      {.id = "second_share", .kind = SOZAI_KIND_FLOAT}};
  static const struct {
    const char *weave;
    double least, most;
  } weaves[] = {{"plain", 0.4, 0.6},      {"basket", 0.4, 0.6},     {"twill_2_2", 0.4, 0.6},
                {"twill_2_1", 0.6, 0.85}, {"twill_3_1", 0.7, 0.93}, {"satin", 0.8, 0.97}};
  for (int k = 0; k < 6; k++) {
    sozai_value values[4];
    memcpy(values, colours, sizeof colours);
    values[3] = (sozai_value){.id = "weave", .kind = SOZAI_KIND_CHOICE, .text = weaves[k].weave};
    sozai_texture *t = make("canvas", values, 4);
    points p = {0};
    uniform_seed(94);
    for (int i = 0; i < 20000; i++) points_add(&p, 90 * uniform(), 90 * uniform(), 0, 0);
    points_ask(&p, t);
    double warp = 0, weft = 0;
    for (unsigned i = 0; i < p.count; i++) {
      warp += p.out[ALBEDO][i] > p.out[ALBEDO + 1][i];
      weft += p.out[ALBEDO][i] < p.out[ALBEDO + 1][i];
    }
    print_message("%s: %.3f of the face is warp's\n", weaves[k].weave, warp / (warp + weft));
    assert_true(warp / (warp + weft) > weaves[k].least && warp / (warp + weft) < weaves[k].most);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Where a warp yarn lies on top it is as broad as yarn_width says, and half of yarn_swell more. */
static void what_floats_spreads(void **state) {
  (void)state;
  enum { ACROSS = 2000 };
  static const double swells[] = {0, 0.2, 0.5};
  for (int k = 0; k < 3; k++) {
    const double width = 0.4; /* as far out the weft below has not come up yet */
    const sozai_value values[] = {
        {.id = "structure", .kind = SOZAI_KIND_CHOICE, .text = "woven"},
        {.id = "weave", .kind = SOZAI_KIND_CHOICE, .text = "plain"},
        {.id = "axis", .kind = SOZAI_KIND_CHOICE, .text = "x"},
        {.id = "yarn_spacing", .kind = SOZAI_KIND_FLOAT, .number = {1}},
        {.id = "yarn_width", .kind = SOZAI_KIND_FLOAT, .number = {width}},
        {.id = "yarn_swell", .kind = SOZAI_KIND_FLOAT, .number = {swells[k]}},
        {.id = "slub", .kind = SOZAI_KIND_FLOAT},
        {.id = "twist", .kind = SOZAI_KIND_FLOAT},
        {.id = "crimp", .kind = SOZAI_KIND_FLOAT},
        {.id = "flyaway", .kind = SOZAI_KIND_FLOAT}};
    sozai_texture *t = make(NULL, values, sizeof values / sizeof *values);
    points p = {0};
    for (int i = 0; i < ACROSS; i++) points_add(&p, 0.5, (i + 0.5) / ACROSS, 0, 0);
    points_ask(&p, t);
    double warp = 0;
    for (unsigned i = 0; i < p.count; i++)
      warp += fabs((double)p.out[TANGENT][i]) > fabs((double)p.out[TANGENT + 1][i]);
    warp /= ACROSS;
    print_message("swell %.1f: on top a yarn is %.3f of the spacing wide\n", swells[k], warp);
    assert_true(fabs(warp - width * (1 + 0.5 * swells[k])) < 0.003);
    points_free(&p);
    textures->destroy(t);
  }
}

/* With slub a yarn's middle strays from its straight way, by a tenth of the spacing at most. */
static void yarns_stray(void **state) {
  (void)state;
  enum { CROSSINGS = 200, ACROSS = 400 };
  const sozai_value values[] = {{.id = "structure", .kind = SOZAI_KIND_CHOICE, .text = "woven"},
                                {.id = "weave", .kind = SOZAI_KIND_CHOICE, .text = "plain"},
                                {.id = "axis", .kind = SOZAI_KIND_CHOICE, .text = "x"},
                                {.id = "yarn_spacing", .kind = SOZAI_KIND_FLOAT, .number = {1}},
                                {.id = "yarn_width", .kind = SOZAI_KIND_FLOAT, .number = {0.3}},
                                {.id = "slub", .kind = SOZAI_KIND_FLOAT, .number = {1}},
                                {.id = "twist", .kind = SOZAI_KIND_FLOAT},
                                {.id = "crimp", .kind = SOZAI_KIND_FLOAT},
                                {.id = "flyaway", .kind = SOZAI_KIND_FLOAT}};
  sozai_texture *t = make(NULL, values, sizeof values / sizeof *values);
  points p = {0};
  for (int k = 0; k < CROSSINGS; k++) /* those where this warp is on top */
    for (int i = 0; i < ACROSS; i++) points_add(&p, 2 * k + 0.5, (i + 0.5) / ACROSS, 0, 0);
  points_ask(&p, t);
  double least = 1, most = 0;
  for (unsigned k = 0; k < CROSSINGS; k++) {
    double middle = 0, count = 0;
    for (unsigned i = 0; i < ACROSS; i++) {
      unsigned j = k * ACROSS + i;
      if (fabs((double)p.out[TANGENT][j]) <= fabs((double)p.out[TANGENT + 1][j])) continue;
      middle += (i + 0.5) / ACROSS;
      count++;
    }
    assert_true(count > 0.2 * ACROSS);
    least = fmin(least, middle / count);
    most = fmax(most, middle / count);
  }
  print_message("of a yarn the middle is from %.3f to %.3f spacings\n", least, most);
  assert_true(fabs(least - 0.4) < 0.01 && fabs(most - 0.6) < 0.01);
  points_free(&p);
  textures->destroy(t);
}

/* Single strands that stand off cover what they are said to, of cloth and of felt, in as many
 * layers as that takes: they hang 5 mm over the rest here, which tells them from it. */
static void what_stands_off(void **state) {
  (void)state;
  static const char *const presets[] = {"flannel", "felt"};
  static const double shares[] = {0.03, 0.08, 0.2, 0.33, 0.39};
  for (int k = 0; k < 10; k++) {
    double share = shares[k % 5];
    const sozai_value values[] = {
        {.id = "flyaway", .kind = SOZAI_KIND_FLOAT, .number = {share}},
        {.id = "flyaway_height", .kind = SOZAI_KIND_FLOAT, .number = {5}}};
    sozai_texture *t = make(presets[k / 5], values, 2);
    points p = {0};
    uniform_seed(92);
    for (int i = 0; i < 40000; i++) points_add(&p, 400 * uniform(), 400 * uniform(), 0, 0);
    points_ask(&p, t);
    double off = 0;
    for (unsigned i = 0; i < p.count; i++) off += fabs((double)p.out[DEPTH][i]) < 4.6;
    off /= p.count;
    print_message("%s: of flyaway %.2f %.3f are seen\n", presets[k / 5], share, off);
    assert_true(fabs(off - share) < 0.01 + 0.03 * share);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(along_their_tangents),
      cmocka_unit_test(as_many_as_packed),
      cmocka_unit_test(in_the_directions_asked_for),
      cmocka_unit_test(cloth_shows_its_yarns),
      cmocka_unit_test(what_floats_spreads),
      cmocka_unit_test(yarns_stray),
      cmocka_unit_test(what_stands_off),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
