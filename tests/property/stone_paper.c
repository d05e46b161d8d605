/* SPDX-License-Identifier: Apache-2.0
 *
 * The paper's colours: R' = {R +- eR} in 8-bit sRGB for each channel by itself,
 * rounded, held within 0 to 255, one colour to a texel; black and white in
 * their proportions; and the footprint's mean.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

enum { N = 200000 };

static sozai_texture *make(const char *mode, double base, double variation, double black,
                           double white) {
  const sozai_value v[] = {
      {.id = "colour_mode", .kind = SOZAI_KIND_CHOICE, .text = mode},
      {.id = "paper_base", .kind = SOZAI_KIND_FLOAT3, .number = {base, base + 30, base - 20}},
      {.id = "paper_variation", .kind = SOZAI_KIND_FLOAT3, .number = {variation, 10, 0}},
      {.id = "paper_lightness", .kind = SOZAI_KIND_FLOAT, .number = {variation}},
      {.id = "paper_chroma", .kind = SOZAI_KIND_FLOAT, .number = {0.5}},
      {.id = "paper_texel", .kind = SOZAI_KIND_FLOAT, .number = {2}},
      {.id = "paper_black", .kind = SOZAI_KIND_FLOAT, .number = {black}},
      {.id = "paper_white", .kind = SOZAI_KIND_FLOAT, .number = {white}}};
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "stone", NULL, v, 8, &t), SOZAI_OK);
  return t;
}

/* IEC 61966-2-1; the test runs without a colour service, in linear Rec.709. */
static double encoded(double x) {
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1 / 2.4) - 0.055);
}

static void codes_are_the_papers(void **state) {
  (void)state;
  sozai_texture *t = make("paper_rgb", 100, 40, 0.05, 0.1);
  points p = {0};
  uniform_seed(81);
  for (int i = 0; i < N; i++) {
    points_add(&p, 900 * (uniform() - 0.5), 900 * (uniform() - 0.5), 900 * (uniform() - 0.5), 0);
  }
  points_ask_only(&p, t, ONLY3(ALBEDO));
  double off = 0, mean[3] = {0}, square[3] = {0}, cross = 0, low[3] = {999, 999, 999},
         high[3] = {0};
  unsigned black = 0, white = 0, n = 0;
  for (int i = 0; i < N; i++) {
    double code[3];
    for (int c = 0; c < 3; c++) {
      code[c] = encoded((double)p.out[c][i]);
      off = fmax(off, fabs(code[c] - round(code[c])));
    }
    if (code[0] + code[1] + code[2] < 1) {
      black++;
    } else if (code[0] + code[1] + code[2] > 764) {
      white++;
    } else {
      n++;
      for (int c = 0; c < 3; c++) {
        mean[c] += code[c];
        square[c] += code[c] * code[c];
        low[c] = fmin(low[c], code[c]);
        high[c] = fmax(high[c], code[c]);
      }
      cross += code[0] * code[1];
    }
  }
  for (int c = 0; c < 3; c++) mean[c] /= n;
  double r = square[0] / n - mean[0] * mean[0], g = square[1] / n - mean[1] * mean[1];
  double correlation = (cross / n - mean[0] * mean[1]) / sqrt(r * g);
  CHECK(off < 0.01, "codes are whole numbers to %.4f\n", off);
  CHECK(fabs(mean[0] - 100) < 0.3 && fabs(mean[1] - 130) < 0.1 && fabs(mean[2] - 80) < 0.01,
        "means %.2f %.2f %.2f (100, 130, 80)\n", mean[0], mean[1], mean[2]);
  CHECK(round(low[0]) == 60 && round(high[0]) == 140 && round(low[1]) == 120 &&
            round(high[1]) == 140,
        "R %.0f to %.0f (60 to 140), G %.0f to %.0f (120 to 140)\n", low[0], high[0], low[1],
        high[1]);
  /* of a uniform distribution, rounded */
  CHECK(fabs(sqrt(r) - sqrt(80.0 * 80 / 12 + 1.0 / 12)) < 0.15 && fabs(correlation) < 0.01,
        "sd of R %.2f (23.10); correlation of R and G %+.4f (independent: 0)\n", sqrt(r),
        correlation);
  CHECK(fabs((double)black / N - 0.05) < 0.002 && fabs((double)white / N - 0.1) < 0.003,
        "black %.4f (0.05), white %.4f (0.10)\n", (double)black / N, (double)white / N);
  points_free(&p);
  textures->destroy(t);
}

static void held_within_255(void **state) {
  (void)state;
  sozai_texture *t = make("paper_rgb", 225, 60, 0, 0);
  points p = {0};
  double high = 0, least = 999;
  for (int i = 0; i < N; i++) points_add(&p, 2 * i + 1, 1, 1, 0);
  points_ask_only(&p, t, ONLY3(ALBEDO));
  unsigned at = 0;
  for (int i = 0; i < N; i++) {
    double code = encoded((double)p.out[0][i]);
    high = fmax(high, code);
    least = fmin(least, code);
    at += round(code) == 255;
  }
  /* 225 + 60 u >= 254.5 */
  CHECK(high < 255.001 && fabs((double)at / N - 30.5 / 120) < 0.005,
        "R %.2f to %.2f; %.4f of the texels are at 255 (0.2542)\n", least, high, (double)at / N);
  points_free(&p);
  textures->destroy(t);
}

static void one_colour_to_a_texel(void **state) {
  (void)state;
  sozai_texture *t = make("paper_rgb", 100, 40, 0.05, 0.1);
  points p = {0};
  uniform_seed(82);
  for (int i = 0; i < 20000; i++) {
    double x[3];
    for (int c = 0; c < 3; c++) x[c] = 2 * floor(400 * (uniform() - 0.5));
    for (int k = 0; k < 2; k++) {
      points_add(&p, x[0] + 0.01 + 1.98 * uniform(), x[1] + 0.01 + 1.98 * uniform(),
                 x[2] + 0.01 + 1.98 * uniform(), 0);
    }
  }
  points_ask_only(&p, t, ONLY3(ALBEDO));
  unsigned differ = 0;
  for (unsigned i = 0; i < p.count; i += 2) differ += p.out[0][i] != p.out[0][i + 1];
  CHECK(differ == 0, "two points of a texel, 20000 times: %u differ\n", differ);
  points_free(&p);
  textures->destroy(t);
}

/* lightness and chroma: the direction from grey, which is the hue, stays. */
static void hue_holds(void **state) {
  (void)state;
  sozai_texture *t = make("paper_lightness", 100, 40, 0, 0);
  points p = {0};
  for (int i = 0; i < 20000; i++) points_add(&p, 2 * i + 1, 1, 1, 0);
  points_ask_only(&p, t, ONLY3(ALBEDO));
  const double luma = 0.2126 * 100 + 0.7152 * 130 + 0.0722 * 80;
  const double d[3] = {100 - luma, 130 - luma, 80 - luma};
  double worst = 0, low = 9, high = 0, light[2] = {999, 0};
  for (unsigned i = 0; i < p.count; i++) {
    double c[3], y = 0, k = 0, dd = 0;
    static const double weight[3] = {0.2126, 0.7152, 0.0722};
    for (int a = 0; a < 3; a++) {
      c[a] = encoded((double)p.out[a][i]);
      y += weight[a] * c[a];
      dd += d[a] * d[a];
    }
    for (int a = 0; a < 3; a++) k += (c[a] - y) * d[a] / dd;
    for (int a = 0; a < 3; a++) worst = fmax(worst, fabs(c[a] - y - k * d[a]));
    low = fmin(low, k);
    high = fmax(high, k);
    light[0] = fmin(light[0], y);
    light[1] = fmax(light[1], y);
  }
  CHECK(worst < 1.2 && low > 0.45 && low < 0.56 && high > 1.44 && high < 1.55 &&
            fabs(light[0] - luma + 40) < 1.5 && fabs(light[1] - luma - 40) < 1.5,
        "lightness %.1f to %.1f (%.1f +- 40), chroma times %.3f to %.3f (0.5 to 1.5), hue off by "
        "%.2f codes (rounding)\n",
        light[0], light[1], luma, low, high, worst);
  points_free(&p);
  textures->destroy(t);
}

static void footprint_is_the_mean(void **state) {
  (void)state;
  static const double sizes[] = {0.1, 0.5, 1, 2, 4, 8, 16, 100};
  for (int mode = 0; mode < 2; mode++) {
    /* figure 6: base 50, variation 30 */
    sozai_texture *t = make(mode ? "paper_lightness" : "paper_rgb", 50, 30, 0, 0);
    double worst = 0, worst_mean = 0;
    uniform_seed(83);
    points p = {0};
    for (int f = 0; f < 8; f++) {
      double square = 0, mean = 0;
      for (int place = 0; place < 200; place++) {
        double x[3];
        for (int c = 0; c < 3; c++) x[c] = 900 * (uniform() - 0.5);
        points_clear(&p);
        for (int i = 0; i < 1024; i++) {
          points_add(&p, x[0] + ((i % 32 + uniform()) / 32 - 0.5) * sizes[f],
                     x[1] + ((i / 32 + uniform()) / 32 - 0.5) * sizes[f], x[2], 0);
        }
        points_add(&p, x[0], x[1], x[2], sizes[f]);
        points_ask_only(&p, t, ONLY3(ALBEDO));
        double truth = 0;
        for (int i = 0; i < 1024; i++) truth += (double)p.out[0][i] / 1024;
        double error = (double)p.out[0][1024] - truth;
        square += error * error / 200;
        mean += error / 200;
      }
      worst = fmax(worst, sqrt(square));
      worst_mean = fmax(worst_mean, fabs(mean));
    }
    CHECK(worst <= 0.01 && worst_mean <= 0.002, "mode %d: worst RMS %.4f, worst mean %.4f\n", mode,
          worst, worst_mean);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(codes_are_the_papers), cmocka_unit_test(held_within_255),
      cmocka_unit_test(one_colour_to_a_texel), cmocka_unit_test(hue_holds),
      cmocka_unit_test(footprint_is_the_mean)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
