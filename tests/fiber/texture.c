/* SPDX-License-Identifier: Apache-2.0
 * Row 10: curves and texture of one aggregate. A slab is filled with strands that
 * point every way; rays from above meet the curves, and the texture of the same
 * diameter, packing, thickness and rise answers under five footprints. */
#include <math.h>
#include "fiber.h"
#include "textured.h"

#define SIDE 30.0
#define THICK 2.0
#define BIN 0.2
enum { BINS = 150, RAYS = 40000, SCALES = 5 };
static const double inner = 12; /* of the slab, away from its edges: half */

typedef struct {
  const sozai_curves *curves;
  uint32_t *start, *list; /* segments of each bin: their first points */
  double length, flat;    /* within: of all, mm; mean of the part that lies level */
  double area, depth, covered;
} slab;

static int bin_of(double x) {
  int i = (int)floor((x + SIDE / 2) / BIN);
  return i < 0 ? 0 : i >= BINS ? BINS - 1 : i;
}

/* Calls for every segment and every bin that its box touches; with fill, lists them. */
static void sort_segments(slab *s, double radius, int fill) {
  const sozai_curves *c = s->curves;
  for (uint64_t i = 0; i < c->curve_count; i++) {
    for (uint64_t k = c->first[i]; k + 1 < c->first[i + 1]; k++) {
      const float *p = c->points + 3 * k, *q = p + 3;
      int x0 = bin_of(fmin((double)p[0], (double)q[0]) - radius);
      int x1 = bin_of(fmax((double)p[0], (double)q[0]) + radius);
      int y0 = bin_of(fmin((double)p[1], (double)q[1]) - radius);
      int y1 = bin_of(fmax((double)p[1], (double)q[1]) + radius);
      for (int y = y0; y <= y1; y++) {
        for (int x = x0; x <= x1; x++) {
          uint32_t *at = &s->start[y * BINS + x];
          if (fill)
            s->list[--*at] = (uint32_t)k;
          else
            ++*at;
        }
      }
    }
  }
}

/* How much is within: by points along each segment. */
static void measure(slab *s) {
  const sozai_curves *c = s->curves;
  double level = 0;
  for (uint64_t i = 0; i < c->curve_count; i++) {
    for (uint64_t k = c->first[i]; k + 1 < c->first[i + 1]; k++) {
      const float *p = c->points + 3 * k;
      double d[3], l = 0;
      for (int a = 0; a < 3; a++) {
        d[a] = (double)p[3 + a] - (double)p[a];
        l += d[a] * d[a];
      }
      l = sqrt(l);
      for (int m = 0; m < 8; m++) {
        double t = (m + 0.5) / 8, at[3];
        for (int a = 0; a < 3; a++) at[a] = (double)p[a] + t * d[a];
        if (fabs(at[0]) > inner || fabs(at[1]) > inner || fabs(at[2]) > THICK / 2) continue;
        s->length += l / 8;
        level += hypot(d[0], d[1]) / 8;
      }
    }
  }
  s->flat = level / s->length;
}

/* The depth below the slab's face at which a ray from above meets a strand; or -1. */
static double meet(const slab *s, double x, double y, double radius) {
  double best = -1;
  uint32_t bin = (uint32_t)(bin_of(y) * BINS + bin_of(x));
  for (uint32_t n = s->start[bin]; n < s->start[bin + 1]; n++) {
    const float *p = s->curves->points + 3 * s->list[n];
    double dx = (double)p[3] - (double)p[0], dy = (double)p[4] - (double)p[1];
    double dz = (double)p[5] - (double)p[2], l2 = dx * dx + dy * dy;
    if (l2 < 1e-12) continue;
    double t = ((x - (double)p[0]) * dx + (y - (double)p[1]) * dy) / l2;
    if (t < 0 || t > 1) continue;
    double off = ((x - (double)p[0]) * dy - (y - (double)p[1]) * dx) / sqrt(l2);
    if (fabs(off) >= radius) continue;
    double depth = THICK / 2 - ((double)p[2] + t * dz);
    if (depth < 0 || depth > THICK) continue;
    if (best < 0 || depth < best) best = depth;
  }
  return best;
}

static void look_at_curves(slab *s, double radius) {
  uint32_t r = 7;
  double covered = 0, depth = 0;
  for (int i = 0; i < RAYS; i++) {
    double x = inner * (2 * random_of(&r) - 1), y = inner * (2 * random_of(&r) - 1);
    double z = meet(s, x, y, radius);
    covered += z >= 0;
    depth += z >= 0 ? z : 0;
  }
  s->covered = covered / RAYS;
  s->depth = depth / covered;
}

static void look_at_texture(const sozai_texture *t, const sozai_textures_1 *textures,
                            double footprint, double *covered, double *depth) {
  ground g = ground_of(RAYS, 0);
  uint32_t r = 9;
  for (int i = 0; i < RAYS; i++) {
    for (int a = 0; a < 2; a++) g.at[a][i] = (float)(400 * random_of(&r));
  }
  ground_ask(&g, textures, t, footprint);
  double sum = 0, down = 0;
  for (int i = 0; i < RAYS; i++) {
    sum += (double)g.out[COVERAGE][i];
    down += (double)g.out[COVERAGE][i] * (double)g.out[DEPTH][i];
  }
  *covered = sum / RAYS;
  *depth = down / sum;
  ground_free(&g);
}

static void compare(const char *strands, double diameter) {
  double radius = diameter / 2000;
  mesh m = box_of(SIDE, SIDE, THICK);
  sozai_geometry *g = grow(&m, strands);
  slab s = {.curves = curves_of(g)};
  s.start = calloc(BINS * BINS + 1, sizeof *s.start);
  assert_non_null(s.start);
  sort_segments(&s, radius, 0);
  for (uint32_t i = 1, sum = s.start[0]; i <= BINS * BINS; i++) {
    sum += s.start[i];
    s.start[i] = sum;
  }
  s.list = malloc((s.start[BINS * BINS] + 1) * sizeof *s.list);
  assert_non_null(s.list);
  sort_segments(&s, radius, 1);
  measure(&s);
  look_at_curves(&s, radius);

  double area = 4 * inner * inner, packing = s.length * 3.14159265 * radius * radius / area / THICK;
  double rise = sqrt(3 * (1 / (s.flat * s.flat) - 1));
  const sozai_value values[] = {{.id = "diameter", .kind = SOZAI_KIND_FLOAT, .number = {diameter}},
                                {.id = "diameter_spread", .kind = SOZAI_KIND_FLOAT},
                                {.id = "thickness", .kind = SOZAI_KIND_FLOAT, .number = {THICK}},
                                {.id = "packing", .kind = SOZAI_KIND_FLOAT, .number = {packing}},
                                {.id = "flyaway", .kind = SOZAI_KIND_FLOAT},
                                {.id = "elevation_spread",
                                 .kind = SOZAI_KIND_FLOAT,
                                 .number = {atan(rise) * 180 / 3.14159265}}};
  const sozai_textures_1 *textures = textures_of();
  sozai_texture *t;
  if (textures->create(NULL, "fiber", NULL, values, 6, &t)) fail_msg("%s", textures->last_error());
  print_message("%llu strands, packing %.4f, level part %.3f: rays meet %.4f, at %.3f mm\n",
                (unsigned long long)s.curves->curve_count, packing, s.flat, s.covered, s.depth);
  static const double footprints[SCALES] = {0, 0.03, 0.3, 3, 30};
  for (int k = 0; k < SCALES; k++) {
    double covered, depth;
    look_at_texture(t, textures, footprints[k], &covered, &depth);
    print_message("  under %5g mm the texture covers %.4f (%+.1f %%), at %.3f mm (%+.1f %%)\n",
                  footprints[k], covered, 100 * (covered / s.covered - 1), depth,
                  100 * (depth / s.depth - 1));
    assert_true(fabs(covered / s.covered - 1) <= 0.03);
    assert_true(fabs(depth / s.depth - 1) <= 0.1);
  }
  textures->destroy(t);
  free(s.start);
  free(s.list);
  geometry()->release_curves(s.curves);
  geometry()->release(g);
  mesh_free(&m);
}

static void sparse(void **unused) {
  (void)unused;
  compare("count=24000 vertices=4 length=0.6 diameter=20 iterations=0", 20);
}
static void dense(void **unused) {
  (void)unused;
  compare("count=90000 vertices=4 length=0.6 diameter=20 iterations=0", 20);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(sparse), cmocka_unit_test(dense)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
