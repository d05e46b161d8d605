/* SPDX-License-Identifier: Apache-2.0
 *
 * Filtering of fibre: albedo, radiance and coverage under a footprint against the
 * mean of 1,024 points of the square that it stands for, for every preset and
 * size of footprint.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
enum { PLACES = 150, SIZES = 8, KINDS = 3, COVERAGE = 6 };
static const double sizes[SIZES] = {0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10};

/* As truth_ask, under a light and from an eye that are not above. */
static void ask(points *p, const sozai_texture *t, double size) {
  double x = 400 * (uniform() - 0.5), y = 400 * (uniform() - 0.5), turn = PI * uniform();
  double co = cos(turn), si = sin(turn);
  double from[2] = {2 * PI * uniform(), 2 * PI * uniform()};
  double sine[2] = {0.85 * sqrt(uniform()), 0.7 * sqrt(uniform())};
  points_clear(p);
  for (int i = 0; i <= TRUTH_SAMPLES; i++) {
    int sample = i < TRUTH_SAMPLES;
    double u = sample ? ((i % TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size : 0;
    double v = sample ? ((i / TRUTH_SIDE + uniform()) / TRUTH_SIDE - 0.5) * size : 0;
    unsigned j = points_add(p, x + u * co - v * si, y + u * si + v * co, 0, sample ? 0 : size);
    for (int k = 0; k < 2; k++) {
      float **to = k ? p->view : p->light;
      to[0][j] = (float)(sine[k] * cos(from[k]));
      to[1][j] = (float)(sine[k] * sin(from[k]));
      to[2][j] = (float)sqrt(1 - sine[k] * sine[k]);
    }
  }
  points_ask(p, t);
}

static void add(truth_errors *e, const points *p, int first, int count) {
  for (int c = first; c < first + count; c++) {
    double error = truth_error(p, c);
    e->square += error * error;
    e->mean += error;
    e->n++;
  }
}

static void against_1024_samples(void **state) {
  (void)state;
  static const char *const names[KINDS] = {"albedo", "radiance", "coverage"};
  const sozai_texture_info *info = textures->find("fiber");
  double worst[KINDS] = {0}, worst_mean[KINDS] = {0};
  unsigned missed[KINDS] = {0}, missed_mean[KINDS] = {0};
  points p = {0};
  uniform_seed(71);
  print_message("RMS / mean error by footprint in mm:\n%-26s", "");
  for (unsigned f = 0; f < SIZES; f++) print_message("%16g", sizes[f]);
  print_message("\n");
  for (unsigned k = 0; k < info->preset_count; k++) {
    sozai_texture *t;
    assert_int_equal(textures->create(NULL, "fiber", info->presets[k]->id, NULL, 0, &t), SOZAI_OK);
    truth_errors e[SIZES][KINDS];
    memset(e, 0, sizeof e);
    for (unsigned f = 0; f < SIZES; f++) {
      for (int i = 0; i < PLACES; i++) {
        ask(&p, t, sizes[f]);
        add(&e[f][0], &p, ALBEDO, 3);
        add(&e[f][1], &p, RADIANCE, 3);
        add(&e[f][2], &p, COVERAGE, 1);
      }
    }
    for (int kind = 0; kind < KINDS; kind++) {
      print_message("%-17s%-9s", info->presets[k]->id, names[kind]);
      for (unsigned f = 0; f < SIZES; f++) {
        double rms = truth_rms(&e[f][kind]), mean = truth_mean(&e[f][kind]);
        /* what chance gives the mean in so many places is no error of the filter's */
        double far = fmax(fabs(mean) - 3 * rms / sqrt(PLACES), 0);
        missed[kind] += rms > 0.01;
        missed_mean[kind] += far > 0.002;
        worst[kind] = fmax(worst[kind], rms);
        worst_mean[kind] = fmax(worst_mean[kind], far);
        print_message("  %.4f/%+.4f", rms, mean);
      }
      print_message("\n");
    }
    textures->destroy(t);
  }
  points_free(&p);
  for (int kind = 0; kind < KINDS; kind++) {
    print_message("%s: worst RMS %.4f (goal 0.01), missed by %u of %u; worst mean beyond chance "
                  "%.4f (goal 0.002), missed by %u\n",
                  names[kind], worst[kind], missed[kind], info->preset_count * SIZES,
                  worst_mean[kind], missed_mean[kind]);
  }
  /* The goals are missed where a footprint holds some strands: docs/fiber-texture.md.
   * What is held is that this gets no worse. */
  static const double held[KINDS] = {0.055, 0.13, 0.06}, held_mean[KINDS] = {0.002, 0.002, 0.002};
  static const unsigned held_missed[KINDS] = {127, 156, 49};
  for (int kind = 0; kind < KINDS; kind++) {
    assert_true(worst[kind] <= held[kind] && worst_mean[kind] <= held_mean[kind]);
    assert_true(missed[kind] <= held_missed[kind]);
  }
}

/* Of what, under which footprint, how far off at most and how much alike at least. */
typedef struct {
  const char *preset;
  int component;
  double wide, rms_most, alike_least;
} stays;

static void same_pattern(points *p, const stays *s) {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0, square = 0;
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "fiber", s->preset, NULL, 0, &t), SOZAI_OK);
  for (int i = 0; i < PLACES; i++) {
    ask(p, t, s->wide);
    double seen = (double)p->out[s->component][TRUTH_SAMPLES];
    double off = truth_error(p, s->component), truth = seen - off;
    a += seen / PLACES, b += truth / PLACES;
    aa += seen * seen / PLACES, bb += truth * truth / PLACES, ab += seen * truth / PLACES;
    square += off * off / PLACES;
  }
  textures->destroy(t);
  double own = sqrt(aa - a * a), truths = sqrt(bb - b * b), alike = (ab - a * b) / (own * truths);
  double rms = sqrt(square);
  print_message("%-17s %.1f mm: contrast %.4f of %.4f, alike %.3f (%.2f), RMS %.4f (%.3f)\n",
                s->preset, s->wide, own, truths, alike, s->alike_least, rms, s->rms_most);
  assert_true(rms <= s->rms_most && alike >= s->alike_least);
  assert_true(own > 0.7 * truths && own < 1.2 * truths);
}

/* The weave is there as long as the truth has it: green of denim, whose weft is white and warp
 * blue, under footprints of 0.75 to 2.5 of its warp's spacings. And strands on their yarns, under
 * some of their lanes. */
static void the_weave_stays(void **state) {
  (void)state;
  static const stays weave[] = {
      {"denim", ALBEDO + 1, 0.3, 0.02, 0.96},    {"denim", ALBEDO + 1, 0.6, 0.018, 0.93},
      {"denim", ALBEDO + 1, 1.0, 0.018, 0.78},   {"tweed", ALBEDO + 1, 0.2, 0.016, 0.8},
      {"flannel", ALBEDO + 1, 0.1, 0.018, 0.85}, {"burlap", ALBEDO + 1, 0.3, 0.022, 0.94}};
  points p = {0};
  uniform_seed(72);
  for (size_t i = 0; i < sizeof weave / sizeof *weave; i++) same_pattern(&p, &weave[i]);
  points_free(&p);
}

/* And so are the bundles of an aggregate, and how many strands they happen to have, under
 * footprints of 5 to 50 strands' thicknesses, a twentieth to a third of a bundle's length. */
static void bundles_stay(void **state) {
  (void)state;
  static const stays bundles[] = {{"cotton", ALBEDO + 1, 0.2, 0.022, 0.7},
                                  {"wool_merino", ALBEDO + 1, 0.3, 0.02, 0.78},
                                  {"wool_merino", ALBEDO + 1, 1.0, 0.016, 0.65},
                                  {"polyester_staple", ALBEDO + 1, 0.6, 0.02, 0.75},
                                  {"felt_grey", ALBEDO + 1, 0.3, 0.017, 0.75},
                                  {"dust", COVERAGE, 0.6, 0.05, 0.7},
                                  {"body_hair", COVERAGE, 1.0, 0.06, 0.7}};
  points p = {0};
  uniform_seed(73);
  for (size_t i = 0; i < sizeof bundles / sizeof *bundles; i++) same_pattern(&p, &bundles[i]);
  points_free(&p);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(against_1024_samples),
                                     cmocka_unit_test(the_weave_stays),
                                     cmocka_unit_test(bundles_stay)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
