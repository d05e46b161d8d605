/* SPDX-License-Identifier: Apache-2.0
 *
 * Vessels: how many, how large, where, and how they show on a cut face.
 *
 * A face is sampled on a fine grid at no footprint, and what lies above half
 * coverage and hangs together is one vessel.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979

typedef struct {
  double area;        /* in samples */
  double x, z;        /* centre of gravity, in samples */
  int x0, x1, z0, z1; /* bounds */
} spot;

/* Spots of a w x h grid of flags that do not touch its edge; returns how many.
 * Flood fill with a stack; the flags are used up. */
static int find_spots(unsigned char *flag, int w, int h, spot *out, int room) {
  int *stack = malloc((size_t)w * (size_t)h * sizeof *stack), n = 0;
  for (int start = 0; start < w * h; start++) {
    if (!flag[start]) continue;
    int top = 0, edge = 0;
    spot s = {0, 0, 0, w, 0, h, 0};
    stack[top++] = start;
    flag[start] = 0;
    while (top) {
      int at = stack[--top], x = at % w, z = at / w;
      s.area++;
      s.x += x;
      s.z += z;
      if (x < s.x0) s.x0 = x;
      if (x > s.x1) s.x1 = x;
      if (z < s.z0) s.z0 = z;
      if (z > s.z1) s.z1 = z;
      edge |= x == 0 || z == 0 || x == w - 1 || z == h - 1;
      const int next[4] = {x > 0 ? at - 1 : -1, x + 1 < w ? at + 1 : -1, z > 0 ? at - w : -1,
                           z + 1 < h ? at + w : -1};
      for (int k = 0; k < 4; k++) {
        if (next[k] >= 0 && flag[next[k]]) {
          flag[next[k]] = 0;
          stack[top++] = next[k];
        }
      }
    }
    if (edge || n == room) continue;
    s.x /= s.area;
    s.z /= s.area;
    out[n++] = s;
  }
  free(stack);
  return n;
}

/* Coverage on a grid of the plane through `at` spanned by u and v, at the step
 * given, as flags; row by row so that memory stays small. */
static unsigned char *look(const sozai_texture *t, const double at[3], const double u[3],
                           const double v[3], int w, int h, double step) {
  unsigned char *flag = malloc((size_t)w * (size_t)h);
  points p = {0};
  for (int z = 0; z < h; z++) {
    points_clear(&p);
    for (int x = 0; x < w; x++) {
      double a = (x + 0.5) * step, b = (z + 0.5) * step;
      points_add(&p, at[0] + a * u[0] + b * v[0], at[1] + a * u[1] + b * v[1],
                 at[2] + a * u[2] + b * v[2], 0);
    }
    points_ask(&p, t);
    for (int x = 0; x < w; x++) flag[z * w + x] = p.out[VESSEL][x] > 0.5f;
  }
  points_free(&p);
  return flag;
}

#define PLAIN "undulation=0; taper=0; pith_wander=0; slope_noise=0; ring_variation=0; "

static void diffuse_counts_and_radii(void **state) {
  (void)state;
  enum { N = 4400, ROOM = 20000, CELLS = 20 };
  const double step = 0.005, side = N * step, density = 6, diameter = 0.06, spread = 0.2;
  sozai_texture *t = wood_make(NULL, PLAIN "section_wobble=0.08; porosity=diffuse; "
                                           "vessel_density=6; vessel_diameter=60; "
                                           "vessel_diameter_spread=0.2");
  const double at[3] = {40, 0, -side / 2}, u[3] = {1, 0, 0}, v[3] = {0, 0, 1};
  unsigned char *flag = look(t, at, u, v, N, N, step);
  spot *spots = malloc(ROOM * sizeof *spots);
  int n = find_spots(flag, N, N, spots, ROOM);
  double expected = density * side * side;
  /* overlapping vessels are seen as one: pairs closer than two radii, of which
   * a Poisson process of this density has N rho pi (2R)^2 / 2 */
  double merged = expected * density * PI * diameter * diameter / 2;
  CHECK(fabs(n + merged - expected) < 3 * sqrt(expected) + 4 * side * density * diameter,
        "%d vessels on %.0f mm2 (and about %.0f seen as one with another): %.0f expected, "
        "3 sigma %.0f\n",
        n, side * side, merged, expected, 3 * sqrt(expected));

  double mean = 0, square = 0;
  int round = 0, count[CELLS * CELLS] = {0};
  for (int i = 0; i < n; i++) {
    int cx = (int)(spots[i].x * CELLS / N), cz = (int)(spots[i].z * CELLS / N);
    count[cz * CELLS + cx]++;
    double wide = spots[i].x1 - spots[i].x0 + 1, high = spots[i].z1 - spots[i].z0 + 1;
    if (wide > 1.35 * high || high > 1.35 * wide) continue; /* two in one */
    double r = sqrt(spots[i].area / PI) * step;
    mean += r;
    square += r * r;
    round++;
  }
  mean /= round;
  double sd = sqrt(square / round - mean * mean);
  CHECK(fabs(mean / (diameter / 2) - 1) < 0.03 && fabs(sd / mean - spread) < 0.03,
        "radius %.2f um (%.1f), relative sd %.3f (%.2f), of %d\n", 1e3 * mean, 500 * diameter,
        sd / mean, spread, round);

  double average = n / (double)(CELLS * CELLS), variance = 0;
  for (int i = 0; i < CELLS * CELLS; i++) {
    variance += (count[i] - average) * (count[i] - average) / (CELLS * CELLS - 1);
  }
  /* the index of dispersion of Poisson counts is 1 with sd sqrt(2 / n) */
  CHECK(fabs(variance / average - 1) < 3 * sqrt(2.0 / (CELLS * CELLS)) + 0.02,
        "counts in %d squares: variance over mean %.3f (1 for a uniform distribution)\n",
        CELLS * CELLS, variance / average);
  free(spots);
  free(flag);
  textures->destroy(t);
}

/* One ring unrolled: x along the arc from theta -pi to pi, z along phase. */
static void ring_rows(void **state) {
  (void)state;
  enum { W = 24000, H = 60, ROOM = 4000 };
  static const int years[3] = {12, 25, 40};
  const double density = 2.5;
  sozai_texture *t = wood_make(
      NULL, PLAIN "section_wobble=0.1; ring_width=3; porosity=ring; vessel_density=0.1; "
                  "vessel_diameter=5; earlywood_rows=1; earlywood_density=2.5; "
                  "earlywood_diameter=120; earlywood_diameter_spread=0.1; earlywood_jitter=0.4");
  for (int k = 0; k < 3; k++) {
    unsigned char *flag = malloc((size_t)W * H);
    spot *spots = malloc(ROOM * sizeof *spots);
    float *time = malloc(W * sizeof *time), *theta = malloc(W * sizeof *theta);
    float *zero = calloc(W, sizeof *zero), *r = malloc(W * sizeof *r);
    points p = {0};
    double mean_radius = 0;
    for (int z = 0; z < H; z++) {
      for (int x = 0; x < W; x++) {
        time[x] = (float)years[k] - 0.05f + 0.2f * ((float)z + 0.5f) / H; /* -0.15 to 0.45 mm */
        theta[x] = (float)(2 * PI * ((x + 0.5) / W - 0.5));
      }
      woods->ring_radius(t, W, time, theta, zero, r);
      points_clear(&p);
      for (int x = 0; x < W; x++) {
        points_add(&p, (double)r[x] * cos((double)theta[x]), 0,
                   (double)r[x] * sin((double)theta[x]), 0);
        if (z == 0) mean_radius += (double)r[x] / W;
      }
      points_ask(&p, t);
      for (int x = 0; x < W; x++) flag[z * W + x] = p.out[VESSEL][x] > 0.5f;
    }
    /* one that lies across the seam would be counted twice: find_spots leaves
     * out what touches an edge, so it may be missing instead */
    int n = find_spots(flag, W, H, spots, ROOM), seen = 0;
    double gap = 0, gap2 = 0;
    double arc = 2 * PI * 3 * years[k];
    for (int i = 0; i < n; i++) seen += spots[i].area * (arc / W) * (0.6 / H) > 0.003;
    double expected = floor(arc * density + 0.5);
    /* spacing: order by x */
    for (int x = 0, last = -1; x < W; x++) {
      for (int i = 0; i < n; i++) {
        if ((int)spots[i].x != x || spots[i].area * (arc / W) * (0.6 / H) <= 0.003) continue;
        if (last >= 0) {
          double d = (x - last) * arc / W * density;
          gap += d;
          gap2 += d * d;
        }
        last = x;
      }
    }
    gap /= seen - 1;
    double sd = sqrt(gap2 / (seen - 1) - gap * gap);
    CHECK(fabs(seen - expected) <= 1 && fabs(gap - 1) < 0.01 && sd > 0.05 && sd < 0.3,
          "year %d, mean radius %.1f mm: %d vessels in the row (2 pi R P = %.0f), gaps %.3f +- "
          "%.3f of 1/P\n",
          years[k], mean_radius, seen, expected, gap, sd);
    points_free(&p);
    free(flag);
    free(spots);
    free(time);
    free(theta);
    free(zero);
    free(r);
  }
  textures->destroy(t);
}

/* Mean coverage by phase of the ring, over many rings. */
static void coverage_by_phase(const char *parameters, double out[4]) {
  char text[512];
  snprintf(text, sizeof text, PLAIN "section_wobble=0; ring_width=4; %s", parameters);
  sozai_texture *t = wood_make(NULL, text);
  points p = {0};
  uniform_seed(21);
  for (int i = 0; i < 200000; i++) {
    double r = 40 + 160 * uniform(), theta = 2 * PI * uniform();
    points_add(&p, r * cos(theta), 0, r * sin(theta), 0);
  }
  points_ask(&p, t);
  double count[4] = {0};
  memset(out, 0, 4 * sizeof *out);
  for (unsigned i = 0; i < p.count; i++) {
    double f = (double)p.out[TIME][i] - floor((double)p.out[TIME][i]);
    out[(int)(f * 4)] += (double)p.out[VESSEL][i];
    count[(int)(f * 4)]++;
  }
  for (int q = 0; q < 4; q++) out[q] /= count[q];
  points_free(&p);
  textures->destroy(t);
}

static void porosity_orders_the_ring(void **state) {
  (void)state;
  double c[4];
  coverage_by_phase("porosity=none", c);
  CHECK(c[0] + c[1] + c[2] + c[3] == 0, "none: no coverage\n");
  coverage_by_phase("porosity=diffuse; vessel_density=30; vessel_diameter=80", c);
  CHECK(fabs(c[0] / c[3] - 1) < 0.06, "diffuse: coverage by quarter %.3f %.3f %.3f %.3f\n", c[0],
        c[1], c[2], c[3]);
  coverage_by_phase(
      "porosity=semi_ring; vessel_density=10; vessel_diameter=160; vessel_diameter_late=80", c);
  CHECK(c[0] > c[1] && c[1] > c[2] && c[2] > c[3] && c[3] > 0.02,
        "semi_ring: coverage by quarter %.3f %.3f %.3f %.3f\n", c[0], c[1], c[2], c[3]);
  coverage_by_phase("porosity=ring; earlywood_rows=2; vessel_density=20; vessel_diameter=40", c);
  CHECK(c[0] > 5 * c[2] && c[2] > 0.01, "ring: coverage by quarter %.3f %.3f %.3f %.3f\n", c[0],
        c[1], c[2], c[3]);
}

/* On a face that fibres cross at alpha, a tube of radius R is an ellipse of
 * half axes R and R / sin(alpha). */
static void streaks_follow_the_dive(void **state) {
  (void)state;
  enum { W = 1200, H = 1500, ROOM = 20000 };
  static const double slopes[3] = {0.1, 0.2, 0.4};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text,
             PLAIN "section_wobble=0; porosity=diffuse; vessel_density=4; vessel_diameter=100; "
                   "vessel_diameter_spread=0; grain=spiral; spiral_slope=%g",
             slopes[k]);
    sozai_texture *t = wood_make(NULL, text);
    /* a radial face: x along the radius, y up the stem, z = 0 */
    const double step = 0.01, at[3] = {150, -7.5, 0}, u[3] = {1, 0, 0}, v[3] = {0, 1, 0};
    unsigned char *flag = look(t, at, u, v, W, H, step);
    spot *spots = malloc(ROOM * sizeof *spots);
    int n = find_spots(flag, W, H, spots, ROOM), used = 0;
    double length = 0, width = 0;
    for (int i = 0; i < n; i++) {
      double wide = (spots[i].x1 - spots[i].x0 + 1) * step;
      double high = (spots[i].z1 - spots[i].z0 + 1) * step;
      if (wide < 0.08 || wide > 0.115) continue; /* grazed, or two in one */
      length += high;
      width += wide;
      used++;
    }
    double ratio = length / width, want = 1 / sin(atan(slopes[k]));
    CHECK(used > 30 && fabs(ratio / want - 1) < 0.08,
          "slope %.1f: %d streaks, %.2f mm long, %.2f times their width; 1/sin(alpha) = %.2f\n",
          slopes[k], used, length / used, ratio, want);
    free(spots);
    free(flag);
    textures->destroy(t);
  }
}

/* ---- how they are arranged ---------------------------------------------- */

enum { FIELD = 1200, FIELD_ROOM = 30000 };
#define FIELD_STEP 0.01
#define FIELD_OUT 150.0 /* mm from the pith, on end grain, at an angle to the lattice of cells */
#define FIELD_TURN 0.6

/* Vessels of a field of end grain: places about its middle along the arc and the radius, mm. */
typedef struct {
  double *arc, *rho, *x, *z, mean_radius;
  int count;
} field;

static field field_of(const char *preset, const char *parameters) {
  char text[512];
  snprintf(text, sizeof text, PLAIN "section_wobble=0; earlywood_rows=0; %s", parameters);
  sozai_texture *t = wood_make(preset, text);
  double half = 0.5 * FIELD * FIELD_STEP, c = cos(FIELD_TURN), s = sin(FIELD_TURN);
  double cx = FIELD_OUT * c, cz = FIELD_OUT * s;
  const double at[3] = {cx - half, 0, cz - half}, u[3] = {1, 0, 0}, v[3] = {0, 0, 1};
  unsigned char *flag = look(t, at, u, v, FIELD, FIELD, FIELD_STEP);
  spot *spots = malloc(FIELD_ROOM * sizeof *spots);
  field f = {.count = find_spots(flag, FIELD, FIELD, spots, FIELD_ROOM)};
  size_t size = (size_t)f.count * sizeof(double);
  f.arc = malloc(size);
  f.rho = malloc(size);
  f.x = malloc(size);
  f.z = malloc(size);
  int round = 0;
  for (int i = 0; i < f.count; i++) {
    f.x[i] = at[0] + (spots[i].x + 0.5) * FIELD_STEP;
    f.z[i] = at[2] + (spots[i].z + 0.5) * FIELD_STEP;
    f.rho[i] = hypot(f.x[i], f.z[i]) - FIELD_OUT;
    f.arc[i] = FIELD_OUT * (atan2(f.z[i], f.x[i]) - FIELD_TURN);
    double wide = spots[i].x1 - spots[i].x0 + 1, high = spots[i].z1 - spots[i].z0 + 1;
    if (wide > 1.35 * high || high > 1.35 * wide) continue;
    f.mean_radius += sqrt(spots[i].area / PI) * FIELD_STEP;
    round++;
  }
  f.mean_radius /= round;
  free(spots);
  free(flag);
  textures->destroy(t);
  return f;
}

static void field_free(field *f) {
  free(f->arc);
  free(f->rho);
  free(f->x);
  free(f->z);
}

/* Variance over mean of the counts in boxes `wide` across a direction and `long` along it, mm.
 * The direction is at an angle to the radius: 1 for evenly strewn vessels in all of them. */
static double dispersion(const field *f, double angle, double wide, double length) {
  double c = cos(angle), s = sin(angle), side = 0.5 * FIELD * FIELD_STEP / 1.5;
  int across = (int)(2 * side / wide), along = (int)(2 * side / length);
  int *count = calloc((size_t)(across * along), sizeof *count), all = 0;
  for (int i = 0; i < f->count; i++) {
    double a = f->arc[i] * c - f->rho[i] * s + side, b = f->arc[i] * s + f->rho[i] * c + side;
    int x = (int)floor(a / wide), z = (int)floor(b / length);
    if (x < 0 || z < 0 || x >= across || z >= along) continue;
    count[z * across + x]++;
    all++;
  }
  int boxes = across * along;
  double mean = (double)all / boxes, variance = 0;
  for (int i = 0; i < boxes; i++) variance += (count[i] - mean) * (count[i] - mean) / (boxes - 1);
  free(count);
  return variance / mean;
}

/* How much more vessels are in bands along a direction than they are strewn in the catalogue's
 * wood without: the excess there, and at right angles or on the other side of the radius. */
static void bands_lie_as_they_are_named(void **state) {
  (void)state;
  static const struct {
    const char *preset;
    double density, spacing, angle, other, least;
  } woods_of[] = {
      {"keyaki", 30, 0.5, PI / 2, 0, 1.6},    {"elm", 50, 0.5, PI / 2, 0, 1.6},
      {"mizunara", 14, 1.0, 0, PI / 2, 1.25}, {"chestnut", 40, 0.9, 0, PI / 2, 1.5},
      {"hornbeam", 70, 0.5, 0, PI / 2, 1.6},  {"jarrah", 9, 1.2, -0.7, 0.7, 1.3},
  };
  for (unsigned k = 0; k < sizeof woods_of / sizeof *woods_of; k++) {
    double wide = woods_of[k].spacing / 4, length = 1.2 * woods_of[k].spacing, d[2][2];
    int count[2];
    double radius[2], area = pow(FIELD * FIELD_STEP, 2);
    for (int on = 0; on < 2; on++) {
      field f = field_of(woods_of[k].preset,
                         on ? "vessel_diameter=40" : "vessel_diameter=40; vessel_arrangement=even");
      d[on][0] = dispersion(&f, woods_of[k].angle, wide, length);
      d[on][1] = dispersion(&f, woods_of[k].other, wide, length);
      count[on] = f.count;
      radius[on] = f.mean_radius;
      field_free(&f);
    }
    double want = woods_of[k].density * area;
    CHECK(d[1][0] > woods_of[k].least * d[0][0] && d[1][0] > 1.2 * d[1][1] && d[0][0] < 1.25,
          "%s: variance over mean of counts along its bands %.2f, the other way %.2f; without "
          "%.2f, %.2f\n",
          woods_of[k].preset, d[1][0], d[1][1], d[0][0], d[0][1]);
    /* some are seen as one with another, in bands as without */
    CHECK(abs(count[1] - count[0]) < 3 * sqrt(2 * want) + 0.02 * want &&
              fabs(radius[1] / radius[0] - 1) < 0.02,
          "%s: %d vessels in bands, %d without (%.0f with those that hide behind others); mean "
          "radius %.2f and %.2f um\n",
          woods_of[k].preset, count[1], count[0], want, 1e3 * radius[1], 1e3 * radius[0]);
  }
}

/* Nothing shows of the lattice that they are looked up in: vessels are as many at every place of
 * its cells. */
static void bands_show_no_lattice(void **state) {
  (void)state;
  enum { BINS = 8 };
  const double density = 40, in_bands = 0.9, wide = 0.42;
  double share = 1 / (1 - in_bands + in_bands / wide), cell = sqrt(share / density);
  field f = field_of(NULL, "porosity=diffuse; vessel_density=40; vessel_diameter=30; ring_width=4; "
                           "vessel_arrangement=tangential; vessel_bands=0.9; "
                           "vessel_band_spacing=0.5; vessel_band_waviness=0.3");
  double expected = f.count / (double)BINS;
  for (int axis = 0; axis < 2; axis++) {
    int bin[BINS] = {0};
    double chi2 = 0;
    for (int i = 0; i < f.count; i++) {
      double at = (axis ? f.z[i] : f.x[i]) / cell;
      bin[(int)((at - floor(at)) * BINS)]++;
    }
    for (int b = 0; b < BINS; b++) chi2 += pow(bin[b] - expected, 2) / expected;
    /* 99.9 % of the distribution with 7 degrees of freedom */
    CHECK(chi2 < 24.3, "%d vessels by their place in cells of %.3f mm along %s: chi2 %.1f\n",
          f.count, cell, axis ? "z" : "x", chi2);
  }
  field_free(&f);
}

/* Under any footprint what vessels cover is a share: bands from afar leave no less than none. */
static void covers_are_shares(void **state) {
  (void)state;
  static const char *const species[] = {"keyaki", "kihada", "chestnut", "hornbeam", "jarrah"};
  points p = {0};
  for (unsigned k = 0; k < sizeof species / sizeof *species; k++) {
    sozai_texture *t = wood_make(species[k], "vessel_bands=1");
    double least = 1, most = 0;
    uniform_seed(55);
    points_clear(&p);
    for (int i = 0; i < 40000; i++) {
      unsigned a = points_add(&p, 200 * (uniform() - 0.5), 400 * (uniform() - 0.5),
                              200 * (uniform() - 0.5), pow(10, 3 * uniform() - 2));
      p.normal[1][a] = i % 2 ? 1.0f : 0.0f;
      p.normal[2][a] = i % 2 ? 0.0f : 1.0f;
    }
    points_ask_only(&p, t, ONLY(VESSEL));
    for (unsigned i = 0; i < p.count; i++) {
      least = fmin(least, (double)p.out[VESSEL][i]);
      most = fmax(most, (double)p.out[VESSEL][i]);
    }
    CHECK(least >= 0 && most <= 1, "%-9s vessels cover %.6f to %.6f\n", species[k], least, most);
    textures->destroy(t);
  }
  points_free(&p);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(diffuse_counts_and_radii),    cmocka_unit_test(ring_rows),
      cmocka_unit_test(porosity_orders_the_ring),    cmocka_unit_test(streaks_follow_the_dive),
      cmocka_unit_test(bands_lie_as_they_are_named), cmocka_unit_test(bands_show_no_lattice),
      cmocka_unit_test(covers_are_shares),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
