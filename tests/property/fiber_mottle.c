/* SPDX-License-Identifier: Apache-2.0
 *
 * Clouds of brightness: as strong as asked, of all light alike, of nothing else, 1 in the mean,
 * and under a wide footprint the mean of its points.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "truth.h"

enum { PLACES = 20000, SQUARES = 400, COVERAGE = 6 };

static sozai_texture *clouded(const char *preset, double mottle, double size) {
  const sozai_value values[] = {
      {.id = "mottle", .kind = SOZAI_KIND_FLOAT, .number = {mottle}},
      {.id = "mottle_size", .kind = SOZAI_KIND_FLOAT, .number = {size}},
  };
  sozai_texture *t = NULL;
  if (textures->create(NULL, "fiber", preset, values, 2, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

typedef struct {
  double mean, spread; /* the latter over the mean */
} seen;

/* At places far apart, or under footprints. Light from aside. */
static void ask(points *p, const sozai_texture *t, double footprint) {
  uniform_seed(91);
  points_clear(p);
  for (int i = 0; i < PLACES; i++) {
    unsigned j = points_add(p, 40000 * uniform(), 40000 * uniform(), 0, footprint);
    p->light[0][j] = p->light[2][j] = (float)sqrt(0.5);
    p->light[1][j] = 0;
  }
  points_ask(p, t);
}

static seen of(const points *p, int component) {
  double sum = 0, square = 0;
  for (int i = 0; i < PLACES; i++) {
    double x = (double)p->out[component][i];
    sum += x / PLACES, square += x * x / PLACES;
  }
  return (seen){sum, sqrt(fmax(square - sum * sum, 0)) / sum};
}

static void as_strong_as_asked(void **state) {
  (void)state;
  static const char *const presets[] = {"felt", "cotton", "velvet", "canvas"};
  static const double strong[] = {0.05, 0.2, 0.3};
  points p = {0}, even = {0};
  for (unsigned k = 0; k < sizeof presets / sizeof *presets; k++) {
    sozai_texture *none = clouded(presets[k], 0, 40);
    ask(&even, none, 8);
    textures->destroy(none);
    for (unsigned m = 0; m < sizeof strong / sizeof *strong; m++) {
      sozai_texture *t = clouded(presets[k], strong[m], 100);
      ask(&p, t, 8);
      seen albedo = of(&p, ALBEDO + 1), light = of(&p, RADIANCE + 1);
      double mean = albedo.mean / of(&even, ALBEDO + 1).mean,
             lit = light.mean / of(&even, RADIANCE + 1).mean;
      /* what the texture has without them is beside it */
      double own = of(&even, ALBEDO + 1).spread,
             clouds = sqrt(fmax(pow(albedo.spread, 2) - own * own, 0));
      print_message("%-7s mottle %.2f: sd of albedo under 8 mm %.4f, mean %.4f of what it is "
                    "without, of radiance %.4f\n",
                    presets[k], strong[m], clouds, mean, lit);
      assert_true(fabs(clouds / strong[m] - 1) < 0.04);
      assert_true(fabs(mean - 1) < 4 * strong[m] / sqrt(PLACES) + 1e-4);
      assert_true(fabs(lit - 1) < 4 * strong[m] / sqrt(PLACES) + 1e-3);
      assert_memory_equal(p.out[COVERAGE], even.out[COVERAGE], PLACES * sizeof(float));
      ask(&p, t, 1000);
      assert_true(of(&p, ALBEDO + 1).spread < 0.01 * strong[m] + own);
      textures->destroy(t);
    }
  }
  points_free(&p);
  points_free(&even);
}

/* Where it asks for three millimetres, with clouds of the size that felt has. */
static void clouds_of_felt(void **state) {
  (void)state;
  points p = {0};
  sozai_texture *t = clouded("felt", 0.1, 40);
  ask(&p, t, 3);
  seen albedo = of(&p, ALBEDO + 1);
  print_message("felt, mottle 0.1 of 40 mm: sd under 3 mm %.4f\n", albedo.spread);
  assert_true(fabs(albedo.spread / 0.1 - 1) < 0.04);
  textures->destroy(t);
  points_free(&p);
}

/* A square is the mean of its points, from far below the clouds' size to far above it. */
static void filtered(void **state) {
  (void)state;
  static const double wide[] = {0.05, 0.1, 0.2, 0.5, 1, 1.5, 2, 3, 5};
  points p = {0};
  sozai_texture *t = clouded("felt", 0.2, 200); /* whose strands are not told apart from 10 mm on */
  uniform_seed(92);
  for (unsigned k = 0; k < sizeof wide / sizeof *wide; k++) {
    double sum = 0, square = 0, size = 200 * wide[k];
    for (int i = 0; i < SQUARES; i++) {
      double x = 1e5 * (uniform() - 0.5), y = 1e5 * (uniform() - 0.5), turn = 7 * uniform();
      double co = cos(turn), si = sin(turn), mean = 0;
      points_clear(&p);
      for (int s = 0; s <= TRUTH_SAMPLES; s++) {
        int sample = s < TRUTH_SAMPLES;
        double u = sample ? ((s % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size : 0;
        double v = sample ? ((s / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size : 0;
        points_add(&p, x + u * co - v * si, y + u * si + v * co, 0, sample ? 4 : size);
      }
      points_ask(&p, t);
      for (int s = 0; s < TRUTH_SAMPLES; s++) mean += (double)p.out[ALBEDO][s] / TRUTH_SAMPLES;
      double off = (double)p.out[ALBEDO][TRUTH_SAMPLES] / mean - 1;
      sum += off / SQUARES, square += off * off / SQUARES;
    }
    print_message("felt, mottle 0.2, %.2f of the clouds' size: RMS %.4f of the mean, mean %+.4f\n",
                  wide[k], sqrt(square), sum);
    assert_true(sqrt(square) < 0.2 * 0.2);
    assert_true(fabs(sum) < 3 * sqrt(square / SQUARES) + 0.002);
  }
  textures->destroy(t);
  points_free(&p);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(as_strong_as_asked),
      cmocka_unit_test(clouds_of_felt),
      cmocka_unit_test(filtered),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
