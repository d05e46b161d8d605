/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone in its light: what is wet, what joints are of, and who stands in whose shade.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "truth.h"

enum {
  S_RADIANCE = 3,
  S_NORMAL = 6,
  S_ROUGHNESS = 10,
  S_JOINT = 14,
  S_EDGE = 18,
  S_MOSS = 19,
  S_OCCLUSION = 21
};

static double at(const points *p, int what, unsigned i) { return (double)p->out[what][i]; }

/* Means over a face, of the roughness, of what is reflected towards the mirror's side, and of the
 * albedo. */
static void means_of(const char *preset, const char *parameters, double mean[3]) {
  sozai_texture *t = stone_make(preset, parameters);
  points p = {0};
  enum { N = 4000 };
  uniform_seed(91);
  for (int i = 0; i < N; i++) {
    unsigned a = points_add(&p, 300 * uniform(), 300 * uniform(), 0, 0.1);
    p.light[0][a] = 0.5f;
    p.view[0][a] = -0.5f;
    p.light[2][a] = p.view[2][a] = 0.8660254f;
  }
  points_ask(&p, t);
  for (int k = 0; k < 3; k++) mean[k] = 0;
  for (unsigned i = 0; i < N; i++) {
    mean[0] += at(&p, S_ROUGHNESS, i) / N;
    mean[1] += at(&p, S_RADIANCE, i) / N;
    mean[2] += at(&p, ALBEDO, i) / N;
  }
  points_free(&p);
  textures->destroy(t);
}

/* A film of water smooths what is rough, and leaves what is polished; it darkens what is open. */
static void wet_stone(void **state) {
  (void)state;
  static const char *const presets[] = {"inada", "gabbro", "nero_marquina", "carrara"};
  for (int k = 0; k < 4; k++) {
    double dry[3], wet[3], rough[3], soaked[3];
    means_of(presets[k], "finish=polished", dry);
    means_of(presets[k], "finish=polished; wet=1", wet);
    means_of(presets[k], "finish=flamed", rough);
    means_of(presets[k], "finish=flamed; wet=1", soaked);
    CHECK(wet[0] <= dry[0] + 0.001 && wet[1] > 0.4 * dry[1] && soaked[0] < 0.6 * rough[0],
          "%-13s wet, polished: roughness %.3f (dry %.3f), towards the mirror %.2f (%.2f); "
          "flamed: roughness %.3f (%.3f)\n",
          presets[k], wet[0], dry[0], wet[1], dry[1], soaked[0], rough[0]);
    CHECK(wet[2] > 0.9 * dry[2] && soaked[2] < 0.88 * rough[2],
          "  of the albedo polished keeps %.3f, flamed %.3f\n", wet[2] / dry[2],
          soaked[2] / rough[2]);
  }
}

static const struct {
  const char *preset, *parameters;
} pavings[] = {{"porphyry", ""},     {"granite_fan", ""},
               {"basalt_setts", ""}, {"inada", "layout=arcs; corner_radius=20; joint_width=8"},
               {"york", ""},         {"belgian_block", ""}};
enum { PAVINGS = sizeof pavings / sizeof *pavings };

/* What lies outside of every stone is joint, between rounded corners too. */
static void no_stone_in_the_joints(void **state) {
  (void)state;
  for (int k = 0; k < PAVINGS; k++) {
    sozai_texture *t = stone_make(pavings[k].preset, pavings[k].parameters);
    points p = {0};
    enum { N = 200000 };
    uniform_seed(92);
    for (int i = 0; i < N; i++) points_add(&p, 3000 * uniform(), 3000 * uniform(), 0, 0);
    points_ask(&p, t);
    unsigned outside = 0, stone = 0;
    for (unsigned i = 0; i < N; i++) {
      if (at(&p, S_EDGE, i) > -0.05) continue;
      outside++;
      stone += at(&p, S_JOINT, i) < 0.99;
    }
    CHECK(outside > 1000 && stone == 0, "%-14s of %u places outside of stones %u are stone\n",
          pavings[k].preset, outside, stone);
    points_free(&p);
    textures->destroy(t);
  }
}

/* Under a high sun nothing on the stones' tops is black. */
static void no_shade_on_faces(void **state) {
  (void)state;
  for (int k = 0; k < PAVINGS; k++) {
    sozai_texture *t = stone_make(pavings[k].preset, pavings[k].parameters);
    points p = {0};
    enum { N = 60000 };
    uniform_seed(93);
    for (int i = 0; i < N; i++) {
      unsigned a = points_add(&p, 3000 * uniform(), 3000 * uniform(), 0, 0);
      double turn = 6.2831853 * uniform();
      p.light[0][a] = (float)(0.44 * cos(turn));
      p.light[1][a] = (float)(0.44 * sin(turn));
      p.light[2][a] = 0.898f;
    }
    points_ask(&p, t);
    unsigned tops = 0, black = 0;
    for (unsigned i = 0; i < N; i++) {
      double towards = 0; /* what leans away from the sun is dark by itself */
      for (int c = 0; c < 3; c++) towards += at(&p, S_NORMAL + c, i) * (double)p.light[c][i];
      if (at(&p, S_EDGE, i) < 1 || towards < 0.15) continue;
      tops++;
      black += at(&p, S_RADIANCE, i) < 0.02 * at(&p, ALBEDO, i);
    }
    CHECK(tops > N / 2 && black == 0, "%-14s of %u places on stones %u are black\n",
          pavings[k].preset, tops, black);
    points_free(&p);
    textures->destroy(t);
  }
}

/* How much of the sky a place sees changes by degrees, from little in the joint to all of it. */
static void sky_by_degrees(void **state) {
  (void)state;
  for (int k = 0; k < PAVINGS; k++) {
    char text[256];
    snprintf(text, sizeof text, "relief=0; moss=0; grime=0; edge_chipping=0%s%s",
             *pavings[k].parameters ? "; " : "", pavings[k].parameters);
    sozai_texture *t = stone_make(pavings[k].preset, text);
    points p = {0};
    enum { N = 60000 };
    uniform_seed(94);
    for (int i = 0; i < N; i++) {
      double x = 3000 * uniform(), y = 3000 * uniform();
      points_add(&p, x, y, 0, 0);
      points_add(&p, x + 0.05, y, 0, 0);
    }
    points_ask(&p, t);
    double most = 0, deepest = 1, face = 0;
    unsigned faces = 0;
    for (unsigned i = 0; i < 2 * N; i += 2) {
      double a = at(&p, S_OCCLUSION, i), b = at(&p, S_OCCLUSION, i + 1);
      int same = fabs(at(&p, S_EDGE, i) - at(&p, S_EDGE, i + 1)) < 0.06;
      if (same) most = fmax(most, fabs(a - b));
      deepest = fmin(deepest, a);
      if (at(&p, S_EDGE, i) < 25) continue;
      face += a;
      faces++;
    }
    CHECK(most < 0.08 && deepest < 0.85 && face > 0.97 * faces,
          "%-14s of the sky the deepest place sees %.2f, faces %.3f; within 0.05 mm it changes by "
          "%.3f at most\n",
          pavings[k].preset, deepest, face / faces, most);
    points_free(&p);
    textures->destroy(t);
  }
}

/* What slopes steeply dulls only itself: towards the mirror's side footprints are as bright as the
 * points in them. */
static void as_bright_far_as_near(void **state) {
  (void)state;
  static const struct {
    const char *preset, *parameters;
    double low, high;
  } cases[] = {{"travertino", "finish=polished", 0.92, 1.05},
               {"travertino", "finish=honed", 0.97, 1.03},
               {"inada", "finish=flamed", 0.97, 1.05},
               {"terrazzo", "finish=bush_hammered", 0.94, 1.07},
               {"inada", "finish=split", 0.97, 1.05},
               {"inada", "finish=riven", 0.86, 1.03}};
  points p = {0};
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    sozai_texture *t = stone_make(cases[k].preset, cases[k].parameters);
    double least = 1e9, most = 0;
    for (int f = 0; f < 6; f++) {
      static const double sizes[] = {0.3, 3, 30}, sines[] = {0.5, 0.906};
      double s = sines[f / 3], c = sqrt(1 - s * s);
      const double light[3] = {s, 0, c}, view[3] = {-s, 0, c};
      double ratio = truth_lit_at(&p, t, light, view, sizes[f % 3], 240);
      least = fmin(least, ratio);
      most = fmax(most, ratio);
    }
    CHECK(least >= cases[k].low && most <= cases[k].high,
          "%-10s %-20s far over near %.3f to %.3f (%g to %g)\n", cases[k].preset,
          cases[k].parameters, least, most, cases[k].low, cases[k].high);
    textures->destroy(t);
  }
  points_free(&p);
}

/* Moss that has filled a joint between stones that lie level hides edges and sand. */
static void no_edges_through_moss(void **state) {
  (void)state;
  static const char *const presets[] = {"ishidatami", "granite_fan", "belgian_block"};
  for (int k = 0; k < 3; k++) {
    sozai_texture *t =
        stone_make(presets[k], "moss=1; moss_height=0; relief=0; tilt=0; settle=0; crown=0");
    points p = {0};
    enum { N = 40000 };
    uniform_seed(97);
    for (int i = 0; i < N; i++) points_add(&p, 3000 * uniform(), 3000 * uniform(), 0, 0);
    points_ask(&p, t);
    double steep = 0;
    unsigned filled = 0;
    for (unsigned i = 0; i < N; i++) {
      double nz = at(&p, S_NORMAL + 2, i);
      if (at(&p, S_MOSS, i) < 0.999 || at(&p, S_EDGE, i) > 3) continue;
      filled++;
      steep += 1 / (nz * nz) - 1;
    }
    steep = sqrt(steep / filled);
    CHECK(filled > 500 && steep < 0.05, "%-14s slopes of moss in joints, %u places: RMS %.3f\n",
          presets[k], filled, steep);
    points_free(&p);
    textures->destroy(t);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(wet_stone),
                                     cmocka_unit_test(no_stone_in_the_joints),
                                     cmocka_unit_test(no_shade_on_faces),
                                     cmocka_unit_test(sky_by_degrees),
                                     cmocka_unit_test(as_bright_far_as_near),
                                     cmocka_unit_test(no_edges_through_moss)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
