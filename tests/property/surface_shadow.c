/* SPDX-License-Identifier: Apache-2.0
 *
 * The shadows of a surface on itself: radiance of points against rays followed over the heights
 * that the plugin gives on a lattice, and of footprints against that of their points under light
 * that grazes the face.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "truth.h"

#define PI 3.14159265358979
#define STEP 0.03      /* mm, of the lattice, */
#define FINE_STEP 0.01 /* and of one for vessels */
enum { EDGE = 240, ROWS = 160, COLUMNS = 1000, HIGH = ROWS + 2 * EDGE, WIDE = COLUMNS + 2 * EDGE };

/* ---- a patch of a face --------------------------------------------------- */

/* Heights, and within an edge that light may come over also normals and albedo. */
typedef struct {
  double x, y, step; /* mm: of its corner, of the lattice */
  float height[HIGH][WIDE], normal[ROWS][COLUMNS][3], albedo[ROWS][COLUMNS];
  double highest;
} patch;

static patch face;
static points asked;

static void face_read(const sozai_texture *t, double x, double y, double step) {
  face.x = x;
  face.y = y;
  face.step = step;
  face.highest = -1e9;
  for (int row = 0; row < HIGH; row++) {
    points_clear(&asked);
    for (int i = 0; i < WIDE; i++) points_add(&asked, x + step * i, y + step * row, 0, 0);
    points_ask_only(&asked, t, ONLY(HEIGHT) | ONLY3(NORMAL) | ONLY3(ALBEDO));
    for (int i = 0; i < WIDE; i++) {
      face.height[row][i] = asked.out[HEIGHT][i];
      face.highest = fmax(face.highest, (double)asked.out[HEIGHT][i]);
      int a = row - EDGE, b = i - EDGE;
      if (a < 0 || b < 0 || a >= ROWS || b >= COLUMNS) continue;
      for (int c = 0; c < 3; c++) face.normal[a][b][c] = asked.out[NORMAL + c][i];
      face.albedo[a][b] = asked.out[ALBEDO + 1][i];
    }
  }
}

static double height_at(double u, double v) {
  int i = (int)u, j = (int)v;
  double a = u - i, b = v - j;
  const float *low = &face.height[j][i], *high = &face.height[j + 1][i];
  double below = (double)low[0] + a * (double)(low[1] - low[0]);
  double above = (double)high[0] + a * (double)(high[1] - high[0]);
  return below + b * (above - below);
}

/* Whether light from (x, y), a unit, comes to a place within; rise: of its ray, mm to a step. */
static int reached(int row, int i, double x, double y, double rise) {
  double u = i + EDGE, v = row + EDGE, h = (double)face.height[row + EDGE][i + EDGE];
  for (int k = 1;; k++) {
    double far = 0.7 * k, a = u + x * far, b = v + y * far, ray = h + far * rise;
    if (ray > face.highest || a < 0 || b < 0 || a >= WIDE - 1 || b >= HIGH - 1) return 1;
    if (height_at(a, b) > ray + 1e-5) return 0;
  }
}

/* Sums over a face. Cosines are between light and normal, where that is not turned away. */
typedef struct {
  double truth, told;  /* cosines where light comes to; what the radiance says they are, */
  double wrong;        /* and how far it is off, point by point */
  double shaded, dark; /* where none comes to: cosines and radiance, */
  double clear, light; /* and where it does */
  double area;         /* of those cosines over the slope's own area */
} lit_sums;

static lit_sums face_lit(const sozai_texture *t, double azimuth, double elevation, double diffuse) {
  lit_sums s = {0};
  double x = cos(azimuth), y = sin(azimuth), rise = face.step * tan(elevation);
  double l[3] = {x * cos(elevation), y * cos(elevation), sin(elevation)};
  for (int row = 0; row < ROWS; row++) {
    points_clear(&asked);
    for (int i = 0; i < COLUMNS; i++) {
      unsigned q = points_add(&asked, face.x + face.step * (i + EDGE),
                              face.y + face.step * (row + EDGE), 0, 0);
      for (int c = 0; c < 3; c++) asked.light[c][q] = (float)l[c];
    }
    points_ask_only(&asked, t, ONLY3(RADIANCE));
    for (int i = 0; i < COLUMNS; i++) {
      const float *n = face.normal[row][i];
      double cosine = (double)n[0] * l[0] + (double)n[1] * l[1] + (double)n[2] * l[2];
      double told = (double)(asked.out[RADIANCE + 1][i] / face.albedo[row][i]) / diffuse;
      if (cosine < 0) cosine = 0;
      int lit = cosine > 0 && reached(row, i, x, y, rise);
      double truth = lit ? cosine : 0;
      s.truth += truth;
      s.told += told;
      s.wrong += fabs(told - truth);
      s.area += truth / (double)n[2];
      *(lit ? &s.clear : &s.shaded) += cosine;
      *(lit ? &s.light : &s.dark) += told;
    }
  }
  return s;
}

/* What a wood without a surface's relief reflects of light from above, over its albedo. */
static double diffuse_of(const char *preset) {
  sozai_texture *t = wood_make(preset, "cut=flat;reflection=kawai;specular=0");
  points_clear(&asked);
  points_add(&asked, 3, 7, 0, 0);
  points_ask_only(&asked, t, ONLY3(RADIANCE) | ONLY3(ALBEDO));
  textures->destroy(t);
  return (double)(asked.out[RADIANCE + 1][0] / asked.out[ALBEDO + 1][0]);
}

/* ---- points ---------------------------------------------------------------- */

/* Degrees: which way light comes from, from x on, which is across the stem; and its elevation. */
static const double ways[][2] = {{5, 6}, {5, 12}, {185, 12}, {80, 12}, {5, 25}, {85, 25}};
enum { WAYS = sizeof ways / sizeof *ways };

static const struct {
  const char *preset, *parameters;
  double step;
  double low, high; /* what the radiance is of that of followed rays */
  double wrong;     /* of that, how far points are off on the whole */
} kinds[] = {{"sugi", "surface=brushed", STEP, 0.98, 1.02, 0.05},
             {"sugi", "surface=brushed;erosion=1", STEP, 0.95, 1.05, 0.11},
             {"oak", "surface=brushed", FINE_STEP, 0.91, 1.02, 0.2},
             {"oak", "surface=weathered", FINE_STEP, 0.9, 1.02, 0.35},
             {"sugi", "surface=weathered;checks=20", STEP, 0.98, 1.03, 0.14},
             {"sugi", "surface=weathered;fibre_wear=0.15", STEP, 0.98, 1.09, 0.45},
             {"sugi", "surface=band_sawn;mark_depth=0.4", STEP, 0.97, 1.02, 0.16},
             {"oak", "surface=circular_sawn;open_vessels=0", STEP, 0.96, 1.02, 0.25},
             {"sugi", "surface=planed;mark_depth=0.3", STEP, 0.97, 1.02, 0.1},
             {"walnut", "surface=planed", FINE_STEP, 0.97, 1.01, 0.03},
             {"itayakaede", "surface=sanded;sanding_grit=40", STEP, 0.93, 1.02, 0.27}};

static void as_rays_over_the_heights(void **state) {
  (void)state;
  for (unsigned k = 0; k < sizeof kinds / sizeof *kinds; k++) {
    char text[200];
    double diffuse = diffuse_of(kinds[k].preset), low = 9, high = 0, wrong = 0, unshaded = 0;
    snprintf(text, sizeof text, "cut=flat;cut_distance=80;reflection=kawai;specular=0;%s",
             kinds[k].parameters);
    sozai_texture *t = wood_make(kinds[k].preset, text);
    face_read(t, -14, 7, kinds[k].step);
    for (int way = 0; way < WAYS; way++) {
      lit_sums s = face_lit(t, ways[way][0] * PI / 180, ways[way][1] * PI / 180, diffuse);
      double told = s.told / s.truth, off = s.wrong / s.truth, all = s.shaded / s.truth;
      print_message(
          "  light %3.0f, %2.0f: in shadow %.3f, radiance %.3f of rays', points %.3f off\n",
          ways[way][0], ways[way][1], all, told, off);
      low = fmin(low, told);
      high = fmax(high, told);
      wrong = fmax(wrong, off);
      unshaded = fmax(unshaded, all);
    }
    textures->destroy(t);
    CHECK(low >= kinds[k].low && high <= kinds[k].high && wrong <= kinds[k].wrong,
          "%-11s %-36s radiance %.3f to %.3f of rays' (%g to %g), points up to %.3f off (%g); "
          "without shadows %.3f\n",
          kinds[k].preset, kinds[k].parameters, low, high, kinds[k].low, kinds[k].high, wrong,
          kinds[k].wrong, unshaded);
  }
}

/* Char has a gloss that is more than its albedo: of what rays do not come to, the radiance over the
 * cosine against the same of the rest. */
static void char_is_dark_in_its_cracks(void **state) {
  (void)state;
  static const char *const kinds_of_char[][2] = {
      {"sugi", "surface=charred"},
      {"oak", "surface=charred;open_vessels=0"},
      {"sugi", "surface=charred;charring=0.8;char_cell=4"}};
  for (unsigned k = 0; k < sizeof kinds_of_char / sizeof *kinds_of_char; k++) {
    char text[200];
    snprintf(text, sizeof text, "cut=flat;cut_distance=80;%s", kinds_of_char[k][1]);
    sozai_texture *t = wood_make(kinds_of_char[k][0], text);
    face_read(t, -14, 7, STEP);
    double most = 0;
    for (int way = 0; way < WAYS; way++) {
      lit_sums s = face_lit(t, ways[way][0] * PI / 180, ways[way][1] * PI / 180, 1);
      double share = s.shaded / (s.shaded + s.clear);
      double left = s.dark / s.shaded / (s.light / s.clear);
      print_message("  light %3.0f, %2.0f: in shadow %.3f, of radiance there is left %.3f\n",
                    ways[way][0], ways[way][1], share, left);
      most = fmax(most, left);
    }
    textures->destroy(t);
    CHECK(most < 0.35, "%-5s %-40s in shadow %.3f of the radiance elsewhere at most (%g)\n",
          kinds_of_char[k][0], kinds_of_char[k][1], most, 0.35);
  }
}

/* ---- footprints ------------------------------------------------------------ */

/* What lies in shadow takes no light from the rest: from afar a face has all of it. */
static void as_bright_far_as_near(void **state) {
  (void)state;
  static const struct {
    const char *preset, *parameters;
    double low, high;
  } cases[] = {{"sugi", "surface=brushed;erosion=1", 0.96, 1.26},
               {"oak", "surface=brushed", 0.84, 1.05},
               {"oak", "surface=weathered", 0.89, 1.07},
               {"sugi", "surface=weathered;checks=30;check_width=0.8", 0.85, 1.23},
               {"sugi", "surface=band_sawn;mark_depth=0.4", 0.9, 1.16},
               {"oak", "surface=circular_sawn", 0.88, 1.26},
               {"walnut", "surface=planed", 0.96, 1.03},
               {"sugi", "surface=charred", 0.57, 1.22},
               {"oak", "surface=charred", 0.44, 1.34}};
  points p = {0};
  for (unsigned k = 0; k < sizeof cases / sizeof *cases; k++) {
    for (int cone = 0; cone < 2; cone++) {
      char text[200];
      snprintf(text, sizeof text, "cut=flat;reflection=%s;%s", cone ? "fibre_cone" : "kawai",
               cases[k].parameters);
      sozai_texture *t = wood_make(cases[k].preset, text);
      double least = 9, most = 0;
      for (int way = 0; way < WAYS; way++) {
        static const double view[3] = {0, 0, 1};
        double a = ways[way][0] * PI / 180, e = ways[way][1] * PI / 180;
        double light[3] = {cos(a) * cos(e), sin(a) * cos(e), sin(e)};
        for (int f = 0; f < 3; f++) {
          static const double sizes[] = {0.3, 3, 30};
          double ratio = truth_lit(&p, t, light, view, sizes[f]);
          print_message(" %.3f", ratio);
          least = fmin(least, ratio);
          most = fmax(most, ratio);
        }
      }
      print_message("\n");
      textures->destroy(t);
      CHECK(least >= cases[k].low && most <= cases[k].high,
            "%-5s %-36s %-5s far over near %.3f to %.3f (%g to %g)\n", cases[k].preset,
            cases[k].parameters, cone ? "cone" : "kawai", least, most, cases[k].low, cases[k].high);
    }
  }
  points_free(&p);
}

static int teardown(void **state) {
  points_free(&asked);
  return wood_teardown(state);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_rays_over_the_heights),
                                     cmocka_unit_test(char_is_dark_in_its_cracks),
                                     cmocka_unit_test(as_bright_far_as_near)};
  return cmocka_run_group_tests(tests, wood_setup, teardown);
}
