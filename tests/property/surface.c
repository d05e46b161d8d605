/* SPDX-License-Identifier: Apache-2.0
 *
 * Surfaces: the normal is the height's own, by central differences, for every
 * surface, face and footprint; tools' pitches and depths are those asked for;
 * wear follows the rings; slopes that a footprint averages become roughness.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
enum { ROUGHNESS = 11 };
static const char *const surfaces[] = {"band_sawn", "circular_sawn", "planed",  "hand_planed",
                                       "sanded",    "brushed",       "charred", "weathered"};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

static void add(points *p, const double x[3], const double n[3], double footprint) {
  unsigned i = points_add(p, x[0], x[1], x[2], footprint);
  for (int c = 0; c < 3; c++) p->normal[c][i] = (float)n[c];
}

/* ---- the gradient ------------------------------------------------------- */

/* Central differences of the height along two directions of the face, against
 * the slopes that the normal has there. Where a crease lies between the two
 * points the difference is none; the share of such is printed and bounded, and
 * the rest must agree. */
static void compare(const char *name, const char *parameters, const char *preset, int face,
                    double footprint) {
  enum { PLACES = 3000 };
  const double h = 0.0015;
  sozai_texture *t = wood_make(preset, parameters);
  points p = {0};
  uniform_seed(91);
  double n[3] = {0, 0, 0}, e[2][3] = {{0, 0, 0}, {0, 0, 0}};
  n[face] = 1;
  e[0][(face + 1) % 3] = e[1][(face + 2) % 3] = 1;
  for (int i = 0; i < PLACES; i++) {
    double x[3];
    /* small coordinates, whose floats are fine enough for the differences */
    for (int c = 0; c < 3; c++) x[c] = 24 * (uniform() - 0.5);
    add(&p, x, n, footprint);
    for (int k = 0; k < 4; k++) {
      double y[3];
      for (int c = 0; c < 3; c++) y[c] = x[c] + (k & 1 ? -h : h) * e[k / 2][c];
      add(&p, y, n, footprint);
    }
  }
  points_ask(&p, t);
  double square = 0, difference = 0, steepest = 0;
  unsigned off = 0;
  for (unsigned i = 0; i < p.count; i += 5) {
    double nf = (double)p.out[NORMAL + face][i], error = 0, slope = 0;
    for (int k = 0; k < 2; k++) {
      int axis = (face + 1 + k) % 3;
      unsigned j = i + 1 + 2 * (unsigned)k;
      double step = (double)p.point[axis][j] - (double)p.point[axis][j + 1];
      double d = ((double)p.out[HEIGHT][j] - (double)p.out[HEIGHT][j + 1]) / step;
      double g = -(double)p.out[NORMAL + axis][i] / nf;
      error = fmax(error, fabs(d - g));
      slope = hypot(slope, d);
    }
    steepest = fmax(steepest, slope);
    square += slope * slope / PLACES;
    if (error > 0.004 + 0.04 * slope) {
      off++;
    } else {
      difference += error * error / PLACES;
    }
  }
  double share = (double)off / PLACES, rms = sqrt(square);
  CHECK(share <= 0.04 && sqrt(difference) <= 0.002 + 0.01 * rms,
        "%-14s %-9s face %c, footprint %-4g slopes rms %.4f, to %.2f: off by %.5f rms, creases "
        "%.4f\n",
        name, preset, "xyz"[face], footprint, rms, steepest, sqrt(difference), share);
  points_free(&p);
  textures->destroy(t);
}

static void normal_is_the_heights(void **state) {
  (void)state;
  static const char *const species[] = {"mizunara", "sugi", "makaba"};
  static const double footprints[] = {0, 0.05, 0.3, 2};
  for (int f = 0; f < SURFACES; f++) {
    char text[160];
    snprintf(text, sizeof text, "surface=%s;cut=rift;mark_angle=11;grain=wavy", surfaces[f]);
    for (int k = 0; k < 4; k++) {
      compare(surfaces[f], text, species[(f + k) % 3], 2, footprints[k]);
    }
    compare(surfaces[f], text, species[f % 3], 0, 0.05);
    compare(surfaces[f], text, species[f % 3], 1, 0);
  }
}

/* ---- slopes into roughness ---------------------------------------------- */

/* A tree without long waves, whose slopes a sample of it shows. */
#define EVEN "undulation=0;section_wobble=0;taper=0;pith_wander=0;slope_noise=0;grain=straight"

/* What slopes all over the face: no vessels, checks, rings' edges or cracks. */
#define GENTLE "open_vessels=0;checks=0;erosion=0;charring=0.5;"

/* Mean square slope without a footprint, against what is left of it under one
 * and what the roughness has gained: alpha^2 = before + lost. */
static void lost_slopes_are_roughness(void **state) {
  (void)state;
  static const char *const species[] = {"sugi", "mizunara", "makaba"};
  static const double footprints[] = {0.2, 1, 8, 100};
  enum { N = 60000 };
  for (int f = 0; f < SURFACES; f++) {
    for (int k = 0; k < 3; k++) {
      char text[240];
      snprintf(text, sizeof text,
               "surface=%s;cut=rift;cut_distance=150;shininess=1000;" GENTLE EVEN, surfaces[f]);
      sozai_texture *t = wood_make(species[k], text);
      double left[5], alpha2[5];
      for (int e = 0; e < 5; e++) {
        points p = {0};
        uniform_seed(93);
        for (int i = 0; i < N; i++) {
          points_add(&p, 200 * (uniform() - 0.5), 2000 * (uniform() - 0.5), 0,
                     e ? footprints[e - 1] : 0);
        }
        points_ask(&p, t);
        left[e] = alpha2[e] = 0;
        for (int i = 0; i < N; i++) {
          double nz = (double)p.out[NORMAL + 2][i], r = (double)p.out[ROUGHNESS][i];
          double gx = (double)p.out[NORMAL][i] / nz, gy = (double)p.out[NORMAL + 1][i] / nz;
          left[e] += (gx * gx + gy * gy) / N;
          alpha2[e] += r * r / N;
        }
        points_free(&p);
      }
      textures->destroy(t);
      for (int e = 1; e < 5; e++) {
        double gone = left[0] - left[e], gained = alpha2[e] - alpha2[0];
        /* alpha goes no further than 1 */
        int full = gone > 0.5 && gained > 0.45;
        CHECK(full || fabs(gained - gone) <= 0.15 * left[0] + 2e-6,
              "%-14s %-9s slopes^2 %.5f, under %5g mm %.5f: gone %.5f, gained %.5f (%+.0f%%)\n",
              surfaces[f], species[k], left[0], footprints[e - 1], left[e], gone, gained,
              100 * (gained - gone) / left[0]);
      }
    }
  }
}

/* What is steep takes its share of the coat's highlight, and leaves the roughness of the rest: the
 * coat under a wide footprint, against how many points slope by more than 1 in 5. */
static void steep_slopes_dim_the_coat(void **state) {
  (void)state;
  static const char *const cases[][2] = {
      {"mizunara", "surface=weathered;checks=0;erosion=0;fibre_wear=0"},
      {"walnut", "surface=planed;mark_depth=0"},
      {"sugi", "surface=weathered;erosion=0;fibre_wear=0;checks=25;check_width=0.8"},
      {"sugi", "surface=weathered;checks=0;fibre_wear=0;erosion=1"},
      {"sugi", "surface=charred;erosion=0;fibre_wear=0"}};
  enum { N = 60000, CASES = sizeof cases / sizeof *cases };
  for (int k = 0; k < CASES; k++) {
    char text[240];
    snprintf(text, sizeof text, "%s;cut=rift;cut_distance=150;coat=1;coat_roughness=0.03;" EVEN,
             cases[k][1]);
    sozai_texture *t = wood_make(cases[k][0], text);
    points p = {0};
    uniform_seed(96);
    for (int i = 0; i < 2 * N; i++) {
      points_add(&p, 200 * (uniform() - 0.5), 2000 * (uniform() - 0.5), 0, i < N ? 0 : 40);
    }
    points_ask(&p, t);
    double steep = 0, near = 0, far = 0;
    for (int i = 0; i < N; i++) {
      double nz = (double)p.out[NORMAL + 2][i];
      steep += 1 / (nz * nz) > 1.04 ? 1.0 / N : 0;
      near += (double)p.out[COAT][i] / N;
      far += (double)p.out[COAT][i + N] / N;
    }
    points_free(&p);
    textures->destroy(t);
    double gone = near - far;
    CHECK(fabs(near - 1) < 1e-4 && gone > 0.7 * steep && gone < 1.35 * steep,
          "%-9s %-55s steep %.3f of the face, the coat %.3f lower from afar\n", cases[k][0],
          cases[k][1], steep, gone);
  }
}

/* ---- tools -------------------------------------------------------------- */

/* Heights along a line of the face, without what grows: heights[i] at i step. */
static void profile(const char *parameters, int axis, double step, double *heights, unsigned n) {
  sozai_texture *t = wood_make(NULL, parameters);
  points p = {0};
  for (unsigned i = 0; i < n; i++) {
    points_add(&p, axis == 0 ? step * i : 3.3, axis == 1 ? step * i : 7.7, 0, 0);
  }
  points_ask(&p, t);
  for (unsigned i = 0; i < n; i++) heights[i] = (double)p.out[HEIGHT][i];
  points_free(&p);
  textures->destroy(t);
}

/* Deepest places of a line: how many to a mm, the mean distance; and the
 * deepest of all below the highest. */
static double pitch_of(const double *h, unsigned n, double step, double *depth) {
  unsigned count = 0, first = 0, last = 0;
  double least = 1e9, most = -1e9;
  for (unsigned i = 1; i + 1 < n; i++) {
    least = fmin(least, h[i]);
    most = fmax(most, h[i]);
    if (h[i] < h[i - 1] && h[i] <= h[i + 1]) {
      if (!count++) first = i;
      last = i;
    }
  }
  *depth = most - least;
  return count > 1 ? (last - first) * step / (count - 1) : 0;
}

#define BARE "porosity=none;fibre_wear=0;erosion=0;"

static void marks_are_as_asked(void **state) {
  (void)state;
  enum { N = 40000 };
  static double h[N];
  static const struct {
    const char *parameters;
    int axis;
    double pitch, depth, step;
  } cases[] = {
      {BARE "surface=band_sawn", 1, 2.4, 0.15, 0.02},
      {BARE "surface=band_sawn;mark_pitch=5;mark_depth=0.4", 1, 5, 0.4, 0.02},
      {BARE "surface=planed", 1, 1.6, 0.0064, 0.01},
      {BARE "surface=planed;mark_pitch=3.2", 1, 3.2, 0.0256, 0.01},
      {BARE "surface=planed;mark_angle=90", 0, 1.6, 0.0064, 0.01},
      {BARE "surface=hand_planed", 0, 38, 0.12, 0.1},
      {BARE "surface=hand_planed;mark_pitch=20;mark_depth=0.3", 0, 20, 0.3, 0.1},
  };
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    double depth;
    profile(cases[k].parameters, cases[k].axis, cases[k].step, h, N);
    double pitch = pitch_of(h, N, cases[k].step, &depth);
    CHECK(fabs(pitch / cases[k].pitch - 1) < 0.06 && depth > 0.8 * cases[k].depth &&
              depth < 1.7 * cases[k].depth,
          "%-70s pitch %.3f of %.3f mm, depth %.4f of %.4f mm\n",
          cases[k].parameters + strlen(BARE), pitch, cases[k].pitch, depth, cases[k].depth);
  }
}

/* A circular saw's marks lie on arcs of its radius. One is followed across the
 * feed by the lowest place near the last; the parabola of least squares through
 * it has the circle's curvature. */
static double curvature_of_a_mark(const sozai_texture *t, double y) {
  enum { LINES = 121, NEAR = 81 };
  /* sums for y = a + b u + c (u^2 - m2) over u symmetrical about 0 */
  double m2 = 0, u4 = 0, syu = 0, syu2 = 0, suu = 0;
  for (int line = 0; line < LINES; line++) {
    double u = 0.5 * (line - LINES / 2);
    m2 += u * u / LINES;
  }
  for (int line = 0; line < LINES; line++) {
    double u = 0.5 * (line - LINES / 2), low = 1e9, from = y;
    double reach = line ? 0.5 : 4;
    points p = {0};
    for (int i = 0; i < NEAR; i++) {
      points_add(&p, u, from + reach * (2.0 * i / (NEAR - 1) - 1), 0, 0);
    }
    points_ask(&p, t);
    for (int i = 0; i < NEAR; i++) {
      if ((double)p.out[HEIGHT][i] < low) {
        low = (double)p.out[HEIGHT][i];
        y = (double)p.point[1][i];
      }
    }
    points_free(&p);
    syu += y * u;
    suu += u * u;
    syu2 += y * (u * u - m2);
    u4 += (u * u - m2) * (u * u - m2);
  }
  double slope = syu / suu, bend = 2 * syu2 / u4;
  return fabs(bend) / pow(1 + slope * slope, 1.5);
}

static void arcs_have_the_blades_radius(void **state) {
  (void)state;
  static const double radii[] = {150, 250, 400};
  for (int r = 0; r < 3; r++) {
    char text[160];
    snprintf(text, sizeof text,
             BARE "surface=circular_sawn;mark_pitch=9;mark_depth=0.2;saw_radius=%g", radii[r]);
    sozai_texture *t = wood_make(NULL, text);
    double sum = 0;
    for (int mark = 0; mark < 16; mark++) sum += curvature_of_a_mark(t, 60.0 * mark) / 16;
    textures->destroy(t);
    CHECK(fabs(1 / sum / radii[r] - 1) < 0.15, "saw_radius %g mm: arcs of %.0f mm\n", radii[r],
          1 / sum);
  }
}

/* Scratches of a grit: their depth falls with it, along the board they are
 * long, across it as wide as grains. */
static void scratches_follow_the_grit(void **state) {
  (void)state;
  enum { N = 40000 };
  static double h[N];
  static const int grits[] = {40, 80, 120, 240, 400};
  /* sd of height, um; and what a correlation of 1/2 takes, um */
  double before = 1e9;
  for (int k = 0; k < 5; k++) {
    char text[160];
    snprintf(text, sizeof text, BARE "surface=sanded;sanding_grit=%d", grits[k]);
    double grain = 425 * pow(40.0 / grits[k], 1.085), sd[2], half[2];
    for (int axis = 0; axis < 2; axis++) {
      double step = axis ? 0.03 * grain * 0.5 : 0.03e-3 * grain, mean = 0, square = 0;
      if (axis) step = 1e-3 * grain * 3;
      profile(text, axis, step, h, N);
      for (int i = 0; i < N; i++) mean += h[i] / N;
      for (int i = 0; i < N; i++) square += (h[i] - mean) * (h[i] - mean) / N;
      sd[axis] = 1e3 * sqrt(square);
      int lag = 0;
      for (double c = 1; c > 0.5; lag++) {
        c = 0;
        for (int i = 0; i + lag < N; i++) c += (h[i] - mean) * (h[i + lag] - mean) / (N - lag);
        c /= square;
      }
      half[axis] = 1e3 * step * lag;
    }
    CHECK(sd[0] < before && sd[0] > 0.02 * grain && sd[0] < 0.12 * grain && half[0] > 0.2 * grain &&
              half[0] < 1.5 * grain && half[1] > 20 * half[0],
          "P%-3d grains of %.0f um: sd %.2f um, wide %.0f um, long %.1f mm\n", grits[k], grain,
          sd[0], half[0], half[1] / 1e3);
    before = sd[0];
  }
}

/* ---- wear --------------------------------------------------------------- */

/* Earlywood lies low: by the erosion asked for, and the more the less latewood. */
static void wear_follows_the_rings(void **state) {
  (void)state;
  static const char *const worn[] = {"brushed", "weathered", "charred"};
  for (int k = 0; k < 3; k++) {
    char text[160];
    snprintf(
        text, sizeof text,
        "cut=quarter;cut_distance=120;surface=%s;erosion=0.5;fibre_wear=0;checks=0;charring=0.4",
        worn[k]);
    sozai_texture *t = wood_make("sugi", text);
    points p = {0};
    uniform_seed(95);
    for (int i = 0; i < 20000; i++) points_add(&p, 60 * uniform(), 60 * uniform(), 0, 0);
    points_ask(&p, t);
    double mh = 0, ml = 0, hl = 0, hh = 0, ll = 0, low = 1e9, high = -1e9;
    for (unsigned i = 0; i < p.count; i++) {
      mh += (double)p.out[HEIGHT][i] / p.count;
      ml += (double)p.out[LATEWOOD][i] / p.count;
    }
    for (unsigned i = 0; i < p.count; i++) {
      double h = (double)p.out[HEIGHT][i], l = (double)p.out[LATEWOOD][i];
      hl += (h - mh) * (l - ml);
      hh += (h - mh) * (h - mh);
      ll += (l - ml) * (l - ml);
      low = fmin(low, h);
      high = fmax(high, h);
    }
    double c = hl / sqrt(hh * ll);
    CHECK(c > 0.85 && low > -0.501 && low < -0.49 && high > -0.1,
          "%-10s height correlates with latewood by %.3f; from %.3f to %.3f mm\n", worn[k], c, low,
          high);
    points_free(&p);
    textures->destroy(t);
  }
}

/* ---- char ---------------------------------------------------------------- */

/* Between cracks the face of a plate is plane, and no two lie alike. */
static void plates_lie_their_own_way(void **state) {
  (void)state;
  static const char *const woods[] = {"sugi", "oak"};
  for (int k = 0; k < 2; k++) {
    sozai_texture *t = wood_make(woods[k], "cut=flat;cut_distance=70;surface=charred;erosion=0;"
                                           "fibre_wear=0;charring=1");
    points p = {0};
    uniform_seed(96);
    enum { PLACES = 6000 };
    for (int i = 0; i < PLACES; i++) {
      double x = 60 * (uniform() - 0.5), y = 400 * uniform();
      for (int j = 0; j < 3; j++) points_add(&p, x + (j == 1) * 0.1, y + (j == 2) * 0.1, 0, 0);
    }
    points_ask(&p, t);
    double plane = 0, tilted = 0, square = 0;
    for (unsigned i = 0; i < p.count; i += 3) {
      double most = 0, slope[2];
      for (int c = 0; c < 2; c++) {
        slope[c] = (double)(p.out[NORMAL + c][i] / p.out[NORMAL + 2][i]);
        for (unsigned j = 1; j < 3; j++) {
          double other = (double)(p.out[NORMAL + c][i + j] / p.out[NORMAL + 2][i + j]);
          most = fmax(most, fabs(other - slope[c]));
        }
      }
      if (most > 0.01) continue;
      double s = hypot(slope[0], slope[1]);
      plane++;
      tilted += s > 0.03;
      square += s * s;
    }
    CHECK(plane > 0.1 * PLACES && tilted > 0.6 * plane && sqrt(square / plane) < 0.16,
          "%-5s %.2f of char is plane; of that %.2f is tilted, by %.3f RMS\n", woods[k],
          plane / PLACES, tilted / plane, sqrt(square / plane));
    points_free(&p);
    textures->destroy(t);
  }
}

/* Fire and weather spare nothing: neither knots nor resin canals, bleached wood nor rays. */
static double palest_under_char(const char *preset) {
  sozai_texture *t = wood_make(preset, "cut=flat; cut_height=700; surface=charred; charring=1");
  points p = {0};
  double most = 0;
  uniform_seed(17);
  for (int i = 0; i < 4000; i++)
    points_add(&p, 160 * (uniform() - 0.5), 1200 * (uniform() - 0.5), 0, 0);
  points_ask_only(&p, t, ONLY3(ALBEDO));
  for (unsigned i = 0; i < p.count; i++)
    for (int c = 0; c < 3; c++) most = fmax(most, points_value(&p, ALBEDO + c, i));
  points_free(&p);
  textures->destroy(t);
  return most;
}

static double knots_of(const char *values) {
  sozai_texture *t = wood_make("knotty_pine", values);
  points p = {0};
  double sum = 0;
  unsigned knots = 0;
  uniform_seed(18);
  for (int i = 0; i < 20000; i++)
    points_add(&p, 200 * (uniform() - 0.5), 200 * (uniform() - 0.5), 0, 0);
  points_ask(&p, t);
  for (unsigned i = 0; i < p.count; i++) {
    if (points_value(&p, KNOT, i) < 0.99) continue;
    sum += points_value(&p, ALBEDO + 1, i);
    knots++;
  }
  assert_true(knots > 10);
  points_free(&p);
  textures->destroy(t);
  return sum / knots;
}

static void nothing_is_spared(void **state) {
  (void)state;
  double worst = 0;
  for (unsigned k = 0; k < wood_presets(); k++) {
    if (wood_is_panel(wood_preset(k))) continue;
    double most = palest_under_char(wood_preset(k));
    if (most > 0.06) print_message("%s, charred: %.3f\n", wood_preset(k), most);
    worst = fmax(worst, most);
  }
  double old = knots_of("cut_height=700; age_years=50") / knots_of("cut_height=700");
  CHECK(worst <= 0.1 && old < 0.8,
        "under char the palest is %.3f; knots of 50 years are %.3f times as bright as new ones\n",
        worst, old);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(nothing_is_spared),           cmocka_unit_test(plates_lie_their_own_way),
      cmocka_unit_test(normal_is_the_heights),       cmocka_unit_test(lost_slopes_are_roughness),
      cmocka_unit_test(steep_slopes_dim_the_coat),   cmocka_unit_test(marks_are_as_asked),
      cmocka_unit_test(arcs_have_the_blades_radius), cmocka_unit_test(scratches_follow_the_grit),
      cmocka_unit_test(wear_follows_the_rings),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
