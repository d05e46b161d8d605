/* SPDX-License-Identifier: Apache-2.0
 *
 * Reading a hull: what is refused, and which rule tells its inside.
 */
#include "hull.h"

#include <string.h>

#include "../core/limits.h"
#include "../core/mix64.h"
#include "../core/scalar.h"
#include "../core/status.h"

#define FARTHEST 1e6 /* mm: as of textures */
#define SMALLEST 1e-3

typedef struct {
  const sozai_buffer *mesh;
  const double *centre;
  const uint32_t *kept; /* NULL: all */
} source;

static void corner_of(const source *s, uint32_t point, float out[3]) {
  for (uint32_t a = 0; a < 3; a++) {
    /* + 0: a zero has one sign only, for what is hashed */
    out[a] = (float)((double)s->mesh->points[3 * (size_t)point + a] - s->centre[a]) + 0.0f;
  }
}

static void triangle_of(const void *context, uint32_t i, float out[9]) {
  const source *s = context;
  size_t t = s->kept ? s->kept[i] : i;
  for (uint32_t c = 0; c < 3; c++) corner_of(s, s->mesh->indices[3 * t + c], out + 3 * c);
}

static double twice_area(const float t[9], double n[3]) {
  double e[2][3];
  for (int k = 0; k < 2; k++)
    for (int a = 0; a < 3; a++) e[k][a] = (double)t[3 * (k + 1) + a] - (double)t[a];
  for (int a = 0; a < 3; a++)
    n[a] = e[0][(a + 1) % 3] * e[1][(a + 2) % 3] - e[0][(a + 2) % 3] * e[1][(a + 1) % 3];
  return scalar_root(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

/* ---- whether it is closed ---------------------------------------------- */

static uint64_t hash_corner(const float p[3]) {
  uint32_t b[3];
  memcpy(b, p, sizeof b);
  return mix64(mix64(mix64(b[0] + 0x9e3779b97f4a7c15ull) + b[1]) + b[2]);
}

/* Edges by their ends' places, so that seams of points that are there twice
 * close. Every edge must be met by one that runs the other way: then the sum of
 * their hashes, taken with signs, is 0. Likewise without direction for parity.
 * It wants no memory, and errs once in 2^64. */
static int rule_of(const source *s, uint32_t triangles) {
  uint64_t turned = 0, odd = 0;
  for (uint32_t t = 0; t < triangles; t++) {
    float n[9];
    uint64_t c[3];
    triangle_of(s, t, n);
    for (int k = 0; k < 3; k++) c[k] = hash_corner(n + 3 * k);
    for (int k = 0; k < 3; k++) {
      uint64_t a = c[k], b = c[(k + 1) % 3];
      if (a == b) continue;
      uint64_t ab = mix64(a + 3 * b), ba = mix64(b + 3 * a);
      turned += ab - ba;
      odd ^= ab + ba;
    }
  }
  return !turned ? HULL_WINDING : !odd ? HULL_PARITY : HULL_VOTE;
}

/* ---- checks ------------------------------------------------------------ */

static int32_t check_points(const char *id, const sozai_buffer *b) {
  for (uint64_t i = 0; i < 3 * b->dims[0]; i++) {
    double x = (double)b->points[i];
    if (x >= -FARTHEST && x <= FARTHEST) continue;
    return fail(SOZAI_ERROR_RANGE, "%s: %c of point %llu is %.6g: outside %.0f to %.0f mm", id,
                "xyz"[i % 3], (unsigned long long)(i / 3), x, -FARTHEST, FARTHEST);
  }
  return SOZAI_OK;
}

static int32_t set_box(hull *h, const char *id, const double low[3], const double high[3]) {
  double side = 0;
  for (int a = 0; a < 3; a++) {
    h->centre[a] = 0.5 * (low[a] + high[a]);
    h->low[a] = (float)(low[a] - h->centre[a]);
    h->high[a] = (float)(high[a] - h->centre[a]);
    if (high[a] - low[a] > side) side = high[a] - low[a];
  }
  h->side = (float)side;
  if (side >= SMALLEST) return SOZAI_OK;
  return fail(SOZAI_ERROR_RANGE, "%s: the longest side of its box is %.3g mm: at least %.3g", id,
              side, SMALLEST);
}

static int32_t box_of(hull *h, const char *id, const sozai_buffer *b, uint64_t count,
                      const uint32_t *indices) {
  double low[3] = {1e30, 1e30, 1e30}, high[3] = {-1e30, -1e30, -1e30};
  for (uint64_t i = 0; i < count; i++) {
    size_t p = indices ? indices[i] : (size_t)i;
    for (int a = 0; a < 3; a++) {
      double x = (double)b->points[3 * p + (size_t)a];
      low[a] = x < low[a] ? x : low[a];
      high[a] = x > high[a] ? x : high[a];
    }
  }
  return set_box(h, id, low, high);
}

/* ---- a mesh ------------------------------------------------------------ */

static int32_t from_triangles(hull *h, const sozai_host *host, source *s) {
  size_t bytes = h->given * sizeof(uint32_t);
  uint32_t *kept = host_alloc(host, bytes, 64);
  if (!kept) return SOZAI_ERROR_MEMORY;
  for (uint32_t t = 0; t < h->given; t++) {
    float n[9];
    double normal[3];
    triangle_of(s, t, n);
    double twice = twice_area(n, normal);
    if (twice > 0) kept[h->items++] = t;
    h->area += 0.5 * twice;
  }
  h->rule = rule_of(s, h->given);
  int32_t r =
      h->items ? SOZAI_OK
               : fail(SOZAI_ERROR_RANGE, "hull: none of its %u triangles has any area", h->given);
  s->kept = kept;
  if (!r) r = hull_tree(h, host, triangle_of, s);
  host_free(host, kept, bytes, 64);
  return r;
}

/* ---- dense vertices, for the literal mode ------------------------------ */

typedef struct {
  float *list; /* a vertex and its normal each */
  uint32_t count;
} dense;

static void dense_of(const void *context, uint32_t i, float out[9]) {
  const dense *d = context;
  memcpy(out, d->list + 6 * (size_t)i, 6 * sizeof(float));
  out[6] = out[7] = out[8] = 0;
}

/* Into how many the longest edge is cut. */
static uint32_t cuts(const float t[9], double spacing) {
  double longest = 0;
  for (int c = 0; c < 3; c++) {
    double square = 0;
    for (int a = 0; a < 3; a++) {
      double e = (double)t[3 * ((c + 1) % 3) + a] - (double)t[3 * c + a];
      square += e * e;
    }
    if (square > longest) longest = square;
  }
  double n = scalar_root(longest) / spacing;
  return n < 1 ? 1 : n > 4096 ? 4097 : (uint32_t)n + 1;
}

/* Normals of the points: the mesh's own, else the sum over triangles, weighted
 * by area, of points as they are indexed. */
static float *point_normals(const sozai_host *host, const source *s, uint32_t triangles) {
  size_t count = 3 * (size_t)s->mesh->dims[0];
  float *n = host_alloc(host, count * sizeof *n, 64);
  if (!n) return NULL;
  if (s->mesh->normals) {
    memcpy(n, s->mesh->normals, count * sizeof *n);
    return n;
  }
  for (uint32_t t = 0; t < triangles; t++) {
    float corner[9];
    double normal[3];
    triangle_of(s, t, corner);
    twice_area(corner, normal);
    for (uint32_t c = 0; c < 3; c++) {
      float *to = n + 3 * (size_t)s->mesh->indices[3 * (size_t)t + c];
      for (int a = 0; a < 3; a++) to[a] += (float)normal[a];
    }
  }
  return n;
}

/* Subdivided without moving: a lattice on each triangle; what it shares with
 * its neighbours is there twice, which the nearest does not mind. */
static void put_lattice(dense *d, const source *s, const float *normals, uint32_t t,
                        double spacing) {
  float corner[9];
  triangle_of(s, t, corner);
  uint32_t n = cuts(corner, spacing);
  for (uint32_t i = 0; i <= n; i++) {
    for (uint32_t j = 0; i + j <= n; j++) {
      double w[3] = {(double)(n - i - j) / n, (double)i / n, (double)j / n}, p[6] = {0};
      for (uint32_t c = 0; c < 3; c++) {
        const float *m = normals + 3 * (size_t)s->mesh->indices[3 * (size_t)t + c];
        double l = scalar_root((double)m[0] * (double)m[0] + (double)m[1] * (double)m[1] +
                               (double)m[2] * (double)m[2]);
        for (uint32_t a = 0; a < 3; a++) {
          p[a] += w[c] * (double)corner[3 * c + a];
          if (l > 0) p[3 + a] += w[c] * (double)m[a] / l;
        }
      }
      for (int a = 0; a < 6; a++) d->list[6 * (size_t)d->count + (size_t)a] = (float)p[a];
      d->count++;
    }
  }
}

static int32_t from_lattices(hull *h, const sozai_host *host, const source *s, double spacing) {
  uint64_t total = 0;
  float corner[9];
  double normal[3];
  for (uint32_t t = 0; t < h->given; t++) {
    triangle_of(s, t, corner);
    uint64_t n = cuts(corner, spacing);
    total += (n + 1) * (n + 2) / 2;
    h->area += 0.5 * twice_area(corner, normal);
  }
  if (!(h->area > 0))
    return fail(SOZAI_ERROR_RANGE, "hull: none of its %u triangles has any area", h->given);
  uint64_t most = limit_of(host, LIMIT_HULL_VERTICES);
  if (total > most) {
    return fail(SOZAI_ERROR_LIMIT,
                "spacing: %.6g mm asks for %llu vertices on the hull, above the ceiling "
                "hull_vertices, %llu",
                spacing, (unsigned long long)total, (unsigned long long)most);
  }
  h->rule = HULL_VERTICES;
  h->items = (uint32_t)total;
  size_t bytes = (size_t)total * 6 * sizeof(float);
  dense d = {.list = host_alloc(host, bytes, 64)};
  float *normals = point_normals(host, s, h->given);
  int32_t r = d.list && normals ? SOZAI_OK : SOZAI_ERROR_MEMORY;
  for (uint32_t t = 0; !r && t < h->given; t++) put_lattice(&d, s, normals, t, spacing);
  if (!r) r = hull_tree(h, host, dense_of, &d);
  host_free(host, normals, 3 * (size_t)s->mesh->dims[0] * sizeof(float), 64);
  host_free(host, d.list, bytes, 64);
  return r;
}

int32_t hull_from_mesh(hull *h, const sozai_host *host, const sozai_buffer *mesh, double spacing) {
  if (!mesh || !mesh->dims[0] || !mesh->dims[1])
    return fail(SOZAI_ERROR_RANGE,
                "hull: a mesh of %llu points and %llu triangles encloses nothing",
                mesh ? (unsigned long long)mesh->dims[0] : 0ull,
                mesh ? (unsigned long long)mesh->dims[1] : 0ull);
  int32_t r = limit_check(host, LIMIT_HULL_TRIANGLES, mesh->dims[1], "hull");
  if (!r) r = check_points("hull", mesh);
  if (!r) r = box_of(h, "hull", mesh, 3 * mesh->dims[1], mesh->indices);
  if (r) return r;
  source s = {mesh, h->centre, NULL};
  h->given = (uint32_t)mesh->dims[1];
  return spacing > 0 ? from_lattices(h, host, &s, spacing) : from_triangles(h, host, &s);
}

/* ---- points ------------------------------------------------------------ */

typedef struct {
  const sozai_buffer *points;
  const double *centre;
} cloud;

static void point_of(const void *context, uint32_t i, float out[9]) {
  const cloud *c = context;
  for (size_t a = 0; a < 3; a++) {
    out[a] = (float)((double)c->points->points[3 * (size_t)i + a] - c->centre[a]);
    out[3 + a] = c->points->normals[3 * (size_t)i + a];
    out[6 + a] = 0;
  }
}

int32_t hull_from_points(hull *h, const sozai_host *host, const sozai_buffer *points) {
  if (!points->dims[0]) return fail(SOZAI_ERROR_RANGE, "hull_points: it has no points");
  if (!points->normals)
    return fail(SOZAI_ERROR_RANGE, "hull_points: its normals are missing: they tell the inside");
  int32_t r = limit_check(host, LIMIT_HULL_TRIANGLES, points->dims[0], "hull_points");
  if (!r) r = check_points("hull_points", points);
  if (!r) r = box_of(h, "hull_points", points, points->dims[0], NULL);
  if (r) return r;
  cloud c = {points, h->centre};
  h->rule = HULL_VERTICES;
  h->given = h->items = (uint32_t)points->dims[0];
  return hull_tree(h, host, point_of, &c);
}
