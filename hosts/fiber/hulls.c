/* SPDX-License-Identifier: Apache-2.0 */
#include "hulls.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* ---- a surface out of a function: surface nets ------------------------- */

typedef double (*shape_function)(const double p[3]); /* below 0 inside */

typedef struct net {
  double low[3], gap;
  uint32_t n[3]; /* nodes */
  float *value;
  uint32_t *vertex; /* of each cell, or ~0 */
  mesh *m;
} net;

static size_t node_at(const net *w, uint32_t x, uint32_t y, uint32_t z) {
  return x + (size_t)w->n[0] * (y + (size_t)w->n[1] * z);
}

/* The middle of where the surface meets the cell's edges; 0: it does not. */
static int cell_vertex(const net *w, uint32_t x, uint32_t y, uint32_t z, double out[3]) {
  double v[8], sum[3] = {0, 0, 0};
  int met = 0;
  for (uint32_t k = 0; k < 8; k++)
    v[k] = (double)w->value[node_at(w, x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))];
  for (int a = 0; a < 3; a++) {
    for (int k = 0; k < 8; k++) {
      int l = k | 1 << a;
      if (l == k || (v[k] < 0) == (v[l] < 0)) continue;
      double t = v[k] / (v[k] - v[l]);
      for (int c = 0; c < 3; c++) sum[c] += c == a ? t : (double)(k >> c & 1);
      met++;
    }
  }
  if (!met) return 0;
  const uint32_t at[3] = {x, y, z};
  for (int c = 0; c < 3; c++) out[c] = w->low[c] + w->gap * (at[c] + sum[c] / met);
  return 1;
}

static void put_quad(const net *w, int axis, uint32_t x, uint32_t y, uint32_t z, bool inside) {
  const uint32_t at[3] = {x, y, z};
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  uint32_t q[4];
  for (int k = 0; k < 4; k++) {
    uint32_t c[3] = {at[0], at[1], at[2]};
    c[u] -= k == 1 || k == 2 ? 0 : 1;
    c[v] -= k >= 2 ? 0 : 1;
    q[k] = w->vertex[node_at(w, c[0], c[1], c[2])];
  }
  uint32_t *to = w->m->indices + 3 * (size_t)w->m->triangle_count;
  const uint32_t order[2][6] = {{0, 2, 1, 0, 3, 2}, {0, 1, 2, 0, 2, 3}};
  for (int i = 0; i < 6; i++) to[i] = q[order[inside][i]];
  w->m->triangle_count += 2;
}

/* One pass counts, the next one writes. */
static void net_pass(net *w, bool writing, uint32_t *points, uint32_t *triangles) {
  *points = *triangles = 0;
  for (uint32_t z = 0; z + 1 < w->n[2]; z++) {
    for (uint32_t y = 0; y + 1 < w->n[1]; y++) {
      for (uint32_t x = 0; x + 1 < w->n[0]; x++) {
        double p[3];
        if (cell_vertex(w, x, y, z, p)) {
          if (writing)
            for (int c = 0; c < 3; c++) w->m->points[3 * (size_t)*points + (size_t)c] = (float)p[c];
          w->vertex[node_at(w, x, y, z)] = (*points)++;
        }
        if (!x || !y || !z) continue;
        bool in = w->value[node_at(w, x, y, z)] < 0;
        const uint32_t next[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int a = 0; a < 3; a++) {
          float v = w->value[node_at(w, x + next[a][0], y + next[a][1], z + next[a][2])];
          if ((v < 0) == in) continue;
          if (writing) put_quad(w, a, x, y, z, in);
          *triangles += 2;
        }
      }
    }
  }
}

static void set_normals(mesh *m) {
  memset(m->normals, 0, 3 * (size_t)m->point_count * sizeof(float));
  for (size_t t = 0; t < m->triangle_count; t++) {
    const uint32_t *i = m->indices + 3 * t;
    double e[2][3], n[3];
    for (int k = 0; k < 2; k++)
      for (int a = 0; a < 3; a++)
        e[k][a] = (double)m->points[3 * (size_t)i[k + 1] + (size_t)a] -
                  (double)m->points[3 * (size_t)i[0] + (size_t)a];
    for (int a = 0; a < 3; a++)
      n[a] = e[0][(a + 1) % 3] * e[1][(a + 2) % 3] - e[0][(a + 2) % 3] * e[1][(a + 1) % 3];
    for (int k = 0; k < 3; k++)
      for (int a = 0; a < 3; a++) m->normals[3 * (size_t)i[k] + (size_t)a] += (float)n[a];
  }
  for (size_t p = 0; p < m->point_count; p++) {
    float *n = m->normals + 3 * p, l = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int a = 0; a < 3; a++) n[a] = l > 0 ? n[a] / l : (float)(a == 1);
  }
}

static bool net_make(mesh *m, shape_function f, const double low[3], const double high[3],
                     uint32_t cells, failure *why) {
  net w = {.gap = (high[1] - low[1]) / cells, .m = m};
  for (int a = 0; a < 3; a++) {
    w.low[a] = low[a];
    w.n[a] = (uint32_t)((high[a] - low[a]) / w.gap) + 2;
  }
  size_t nodes = (size_t)w.n[0] * w.n[1] * w.n[2];
  w.value = malloc(nodes * sizeof *w.value);
  w.vertex = malloc(nodes * sizeof *w.vertex);
  bool ok = (w.value && w.vertex) || fail(why, EXIT_FAILURE, "out of memory");
  for (size_t i = 0; ok && i < nodes; i++) {
    const size_t at[3] = {i % w.n[0], i / w.n[0] % w.n[1], i / w.n[0] / w.n[1]};
    double p[3];
    for (int a = 0; a < 3; a++) p[a] = low[a] + w.gap * (double)at[a];
    w.value[i] = (float)f(p);
  }
  uint32_t points, triangles;
  if (ok) net_pass(&w, false, &points, &triangles);
  ok = ok && mesh_allocate(m, points, triangles, why);
  if (ok) {
    m->triangle_count = 0;
    net_pass(&w, false, &points, &triangles); /* numbers all vertices before quads name them */
    net_pass(&w, true, &points, &triangles);
    set_normals(m);
  }
  free(w.value);
  free(w.vertex);
  return ok;
}

/* ---- the bunny --------------------------------------------------------- */

typedef struct lobe {
  double at[3], half[3], lean[2]; /* lean about z, about x, degrees */
} lobe;

static const lobe lobes[] = {{{0, 14, 0}, {12, 13, 14}, {0, 0}},      /* body */
                             {{0, 9, -6}, {13, 9.5, 11}, {0, 0}},     /* haunches */
                             {{0, 27, 10}, {7.5, 7.5, 8.5}, {0, 15}}, /* head */
                             {{0, 8, -17}, {4, 4, 4}, {0, 0}},        /* tail */
                             {{5, 3, 11}, {3.2, 3, 6}, {0, 0}},       /* paws */
                             {{-5, 3, 11}, {3.2, 3, 6}, {0, 0}},
                             {{4.6, 40, 5}, {2.9, 10, 1.5}, {-14, -18}}, /* ears */
                             {{-4.6, 40, 5}, {2.9, 10, 1.5}, {14, -18}}};

static double lobe_distance(const lobe *l, const double p[3]) {
  double d[3], c = cos(l->lean[0] * PI / 180), s = sin(l->lean[0] * PI / 180);
  for (int a = 0; a < 3; a++) d[a] = p[a] - l->at[a];
  double x = c * d[0] + s * d[1], y = c * d[1] - s * d[0], z = d[2];
  c = cos(l->lean[1] * PI / 180), s = sin(l->lean[1] * PI / 180);
  double y2 = c * y + s * z, z2 = c * z - s * y;
  double u = x / l->half[0], v = y2 / l->half[1], w = z2 / l->half[2];
  double k = sqrt(u * u + v * v + w * w);
  u /= l->half[0], v /= l->half[1], w /= l->half[2];
  double g = sqrt(u * u + v * v + w * w);
  return g > 0 ? k * (k - 1) / g : -l->half[2];
}

static double bunny(const double p[3]) {
  double d = 1e9;
  for (size_t i = 0; i < sizeof lobes / sizeof *lobes; i++) {
    double e = lobe_distance(&lobes[i], p), h = fmax(1.6 - fabs(d - e), 0) / 1.6;
    d = fmin(d, e) - 0.25 * 1.6 * h * h;
  }
  return d;
}

bool hull_make_bunny(mesh *m, uint32_t cells, failure *why) {
  const double low[3] = {-16, -3, -23}, high[3] = {16, 54, 23};
  return net_make(m, bunny, low, high, cells, why);
}

/* ---- rings ------------------------------------------------------------- */

/* Rings of `around` points, from the first to the last, and a point at each end. */
static bool rings_allocate(mesh *m, uint32_t rings, uint32_t around, failure *why) {
  if (!mesh_allocate(m, rings * around + 2, 2 * rings * around, why)) return false;
  uint32_t *to = m->indices, last = rings * around + 1;
  for (uint32_t r = 0; r <= rings; r++) {
    for (uint32_t k = 0; k < around; k++) {
      uint32_t k2 = (k + 1) % around, a = 1 + (r - 1) * around, b = 1 + r * around;
      const uint32_t all[6] = {a + k, b + k2, a + k2, a + k, b + k, b + k2};
      const uint32_t begin[3] = {0, b + k, b + k2}, end[3] = {a + k, last, a + k2};
      uint32_t n = r == 0 || r == rings ? 3 : 6;
      memcpy(to, r == 0 ? begin : r == rings ? end : all, n * sizeof *to);
      to += n;
    }
  }
  m->triangle_count = (uint32_t)((to - m->indices) / 3);
  return true;
}

static void turn_over(mesh *m) {
  for (size_t i = 0; i < m->triangle_count; i++) {
    uint32_t keep = m->indices[3 * i + 1];
    m->indices[3 * i + 1] = m->indices[3 * i + 2];
    m->indices[3 * i + 2] = keep;
  }
}

static void serpent_path(double t, double p[3]) {
  double a = 2 * PI * 1.6 * t;
  p[0] = 46 * (t - 0.5);
  p[1] = 9 * sin(a) + 6;
  p[2] = 10 * cos(a * 0.8);
}

bool hull_make_serpent(mesh *m, uint32_t around, failure *why) {
  uint32_t rings = around * 5;
  if (!rings_allocate(m, rings, around, why)) return false;
  double side[3] = {0, 0, 1};
  for (uint32_t r = 0; r <= rings + 1; r++) {
    double t = (double)r / (rings + 1), p[3], q[3], o[3], way[3], up[3], l = 0, d = 0, k = 0;
    serpent_path(t, p);
    serpent_path(t + 1e-4, q);
    serpent_path(t - 1e-4, o);
    for (int a = 0; a < 3; a++) way[a] = q[a] - o[a], l += way[a] * way[a];
    for (int a = 0; a < 3; a++) way[a] /= sqrt(l), d += way[a] * side[a];
    for (int a = 0; a < 3; a++) side[a] -= d * way[a], k += side[a] * side[a];
    for (int a = 0; a < 3; a++) side[a] /= sqrt(k);
    for (int a = 0; a < 3; a++)
      up[a] = way[(a + 1) % 3] * side[(a + 2) % 3] - way[(a + 2) % 3] * side[(a + 1) % 3];
    double end = 1 - fabs(2 * t - 1), cap = end < 0.12 ? sqrt(1 - pow(1 - end / 0.12, 2)) : 1;
    double radius = cap * (1.5 + 1.5 * pow(sin(PI * fmin(1, 1.25 * t)), 2));
    bool tip = r == 0 || r == rings + 1;
    for (uint32_t i = 0; i < (tip ? 1 : around); i++) {
      double a = 2 * PI * i / around;
      float *to = m->points + 3 * (size_t)(r == 0 ? 0 : 1 + (r - 1) * around + i);
      for (int c = 0; c < 3; c++)
        to[c] = (float)(p[c] + (tip ? 0 : radius * (cos(a) * side[c] + sin(a) * up[c])));
    }
  }
  turn_over(m); /* along a path the rings turn the other way than from a ball's top */
  set_normals(m);
  return true;
}

static double lump(uint32_t seed, const double n[3]) {
  double sum = 0, weight = 1;
  for (uint32_t o = 0; o < 12; o++) {
    double f = 1.5 + 0.8 * o, phase[3];
    for (uint32_t a = 0; a < 3; a++) {
      uint32_t h = (seed * 97u + o * 3u + a + 1u) * 2654435761u;
      h ^= h >> 15;
      h *= 0x846ca68bu;
      phase[a] = (double)(h >> 8) / 16777216.0 * 2 * PI;
    }
    sum += weight * sin(f * n[0] + phase[0]) * sin(f * n[1] + phase[1]) * sin(f * n[2] + phase[2]);
    weight *= 0.82;
  }
  return sum;
}

bool hull_make_ball(mesh *m, double radius, double height, double lumps, uint32_t seed,
                    uint32_t around, failure *why) {
  uint32_t rings = around / 2 - 1;
  if (!rings_allocate(m, rings, around, why)) return false;
  for (uint32_t r = 0; r <= rings + 1; r++) {
    double t = PI * r / (rings + 1);
    bool tip = r == 0 || r == rings + 1;
    for (uint32_t i = 0; i < (tip ? 1 : around); i++) {
      double a = 2 * PI * i / around;
      double n[3] = {sin(t) * sin(a), cos(t), sin(t) * cos(a)};
      double own = radius * (1 + lumps * lump(seed, n));
      float *to = m->points + 3 * (size_t)(r == 0 ? 0 : 1 + (r - 1) * around + i);
      for (int c = 0; c < 3; c++) to[c] = (float)(own * n[c] * (c == 1 ? height : 1));
    }
  }
  set_normals(m);
  return true;
}

bool hull_make_box(mesh *m, const double size[3], uint32_t cuts, failure *why) {
  uint32_t side = (cuts + 1) * (cuts + 1), points = 0, at = 0;
  if (!mesh_allocate(m, 6 * side, 12 * cuts * cuts, why)) return false;
  for (int f = 0; f < 6; f++) {
    int axis = f / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (uint32_t i = 0; i <= cuts; i++) {
      for (uint32_t j = 0; j <= cuts; j++) {
        float *to = m->points + 3 * (size_t)points, *n = m->normals + 3 * (size_t)points++;
        n[0] = n[1] = n[2] = 0;
        n[axis] = f & 1 ? 1 : -1;
        to[axis] = (float)((f & 1 ? 0.5 : -0.5) * size[axis]);
        to[u] = (float)(size[u] * ((double)i / cuts - 0.5));
        to[v] = (float)(size[v] * ((double)j / cuts - 0.5));
        if (i == cuts || j == cuts) continue;
        uint32_t a = (uint32_t)f * side + i * (cuts + 1) + j, b = a + cuts + 1;
        const uint32_t up[6] = {a, b, b + 1, a, b + 1, a + 1},
                       down[6] = {a, b + 1, b, a, a + 1, b + 1};
        memcpy(m->indices + at, f & 1 ? up : down, sizeof up);
        at += 6;
      }
    }
  }
  return true;
}

/* "box:6x1.2x6" and "lump:9": sizes in mm. 1: made; 0: refused; -1: no such name. */
static int make_sized(mesh *m, const char *name, failure *why) {
  double size[3], radius;
  char end;
  if (sscanf(name, "box:%lfx%lfx%lf%c", &size[0], &size[1], &size[2], &end) == 3) {
    for (int a = 0; a < 3; a++)
      if (!(size[a] >= 0.01 && size[a] <= 1e5))
        return fail(why, EXIT_BAD_INPUT, "--hull: a box's side of %g is outside 0.01 to 1e5 mm",
                    size[a]);
    return hull_make_box(m, size, 40, why);
  }
  if (sscanf(name, "lump:%lf%c", &radius, &end) == 1) {
    if (!(radius >= 0.01 && radius <= 1e5))
      return fail(why, EXIT_BAD_INPUT, "--hull: a lump's radius of %g is outside 0.01 to 1e5 mm",
                  radius);
    return hull_make_ball(m, radius, 0.7, 0.2, 11, 160, why);
  }
  return -1;
}

bool hull_make_named(mesh *m, const char *name, failure *why) {
  const double slab[3] = {40, 8, 40};
  int sized = make_sized(m, name, why);
  if (sized >= 0) return sized;
  if (!strcmp(name, "bunny")) return hull_make_bunny(m, 106, why);
  if (!strcmp(name, "serpent")) return hull_make_serpent(m, 59, why);
  if (!strcmp(name, "ball")) return hull_make_ball(m, 20, 1, 0, 1, 188, why);
  if (!strcmp(name, "lump")) return hull_make_ball(m, 20, 0.8, 0.14, 5, 188, why);
  if (!strcmp(name, "slab")) return hull_make_box(m, slab, 54, why);
  return fail(why, EXIT_BAD_INPUT,
              "'%s' is none of: bunny, serpent, ball, lump, slab, box:WxHxD, lump:RADIUS", name);
}
