/* SPDX-License-Identifier: Apache-2.0 */
#include "curves.h"

#include <string.h>

#include "../core/scalar.h"
#include "../core/status.h"
#include "../generator.h"

#define REPORT_EACH 16384u /* strands */

static const char *const part_ids[2] = {"fiber", "fiber_2"};

/* What is kept of the strands at a level. */
typedef struct {
  uint32_t every, points; /* vertices: every so many-th; how many of a strand */
  uint32_t strands_every;
} sieve;

static sieve sieve_of(const fiber *f, uint32_t level) {
  sieve s = {1, f->vertices, 1};
  for (uint32_t i = 0; i < level; i++) {
    if (s.points > 2) {
      s.every *= 2;
      s.points = (f->vertices - 1 + s.every - 1) / s.every + 1;
    } else {
      s.strands_every *= 2;
    }
  }
  return s;
}

static uint32_t vertex_of(const fiber *f, const sieve *s, uint32_t i) {
  uint32_t v = i * s->every;
  return v < f->vertices ? v : f->vertices - 1;
}

static int part_of(const fiber *f, uint32_t strand) {
  const fiber_plan *p = &f->plan;
  return p->share_2 > 0 && strand_random(p->shape.seed, strand, STRAND_LOOK, 0) < p->share_2;
}

/* strand: a kept strand's number in f. */
static float put_point(const fiber *f, uint32_t strand, uint32_t vertex, float to[3]) {
  const float *p = f->points + 3 * ((size_t)strand * f->vertices + vertex);
  for (int a = 0; a < 3; a++) to[a] = (float)(f->hull.centre[a] + (double)p[a]);
  return f->radii[strand] * (float)fiber_profile(&f->plan, (double)vertex / (f->vertices - 1));
}

typedef struct {
  uint64_t counts[2];
  sieve sieve;
} selection;

static selection select_strands(const fiber *f, uint32_t level) {
  selection s = {.sieve = sieve_of(f, level)};
  for (uint32_t i = 0; i < f->strands; i += s.sieve.strands_every) s.counts[part_of(f, i)]++;
  return s;
}

static uint32_t put_parts(const fiber *f, sozai_part *parts, const uint64_t counts[2],
                          uint32_t flags) {
  uint32_t n = 0;
  uint64_t first = 0;
  for (int k = 0; k < 2; k++) {
    if (!counts[k]) continue;
    parts[n] = (sozai_part){.id = part_ids[k], .first = first, .count = counts[k], .flags = flags};
    memcpy(parts[n++].colour, f->plan.colour[k], sizeof parts->colour);
    first += counts[k];
  }
  return n;
}

int32_t fiber_curves(const fiber *f, const sozai_host *host, uint32_t level, curves_block **out) {
  int32_t r = host_progress(host, 0.0, "making curves");
  if (r) return r;
  selection s = select_strands(f, level);
  uint64_t curves = s.counts[0] + s.counts[1], at = 0;
  curves_block *c = curves_block_make(host, curves, curves * s.sieve.points, 0);
  if (!c) return SOZAI_ERROR_MEMORY;
  for (int k = 0; !r && k < 2; k++) {
    if (!s.counts[k]) continue;
    for (uint32_t i = 0; !r && i < f->strands; i += s.sieve.strands_every) {
      if (part_of(f, i) != k) continue;
      c->ids[at] = i;
      c->first[at] = at * s.sieve.points;
      for (uint32_t v = 0; v < s.sieve.points; v++) {
        uint64_t to = c->first[at] + v;
        c->radii[to] = put_point(f, i, vertex_of(f, &s.sieve, v), c->points + 3 * to);
      }
      at++;
      if (at % REPORT_EACH == 0)
        r = host_progress(host, (double)at / (double)curves, "making curves");
    }
  }
  if (!r) r = host_progress(host, 1.0, "making curves");
  if (r) {
    host_free(host, c, c->bytes, 64);
    return r;
  }
  c->first[curves] = curves * s.sieve.points;
  c->out.part_count = put_parts(f, c->parts, s.counts, 0);
  *out = c;
  return SOZAI_OK;
}

/* ---- tubes ------------------------------------------------------------- */

static void unit(double v[3]) {
  double l = scalar_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int a = 0; a < 3; a++) v[a] = l > 0 ? v[a] / l : a == 0;
}

/* The direction at a vertex: from the one before to the one after. */
static void direction(const fiber *f, const sieve *s, uint32_t strand, uint32_t v, double out[3]) {
  float a[3], b[3];
  put_point(f, strand, vertex_of(f, s, v ? v - 1 : 0), a);
  put_point(f, strand, vertex_of(f, s, v + 1 < s->points ? v + 1 : v), b);
  for (int k = 0; k < 3; k++) out[k] = (double)b[k] - (double)a[k];
  unit(out);
}

/* side: the frame's first axis, carried along the strand without a twist. */
static void carry(double side[3], const double way[3]) {
  double d = side[0] * way[0] + side[1] * way[1] + side[2] * way[2];
  for (int a = 0; a < 3; a++) side[a] -= d * way[a];
  if (side[0] * side[0] + side[1] * side[1] + side[2] * side[2] < 1e-12) {
    int least = way[0] * way[0] < way[1] * way[1] ? 0 : 1;
    if (way[2] * way[2] < way[least] * way[least]) least = 2;
    for (int a = 0; a < 3; a++) side[a] = (a == least) - way[least] * way[a];
  }
  unit(side);
}

typedef struct {
  mesh_block *m;
  uint64_t point, triangle;
  uint32_t sides;
  double sine[8], cosine[8];
} tube;

static void put_triangle(tube *t, uint64_t a, uint64_t b, uint64_t c) {
  uint32_t *to = t->m->indices + 3 * t->triangle++;
  to[0] = (uint32_t)a, to[1] = (uint32_t)b, to[2] = (uint32_t)c;
}

static void put_ring(tube *t, const float at[3], double radius, const double side[3],
                     const double way[3], uint32_t owner, double along) {
  double up[3];
  for (int a = 0; a < 3; a++)
    up[a] = way[(a + 1) % 3] * side[(a + 2) % 3] - way[(a + 2) % 3] * side[(a + 1) % 3];
  for (uint32_t k = 0; k < t->sides; k++, t->point++) {
    for (int a = 0; a < 3; a++) {
      double n = t->cosine[k] * side[a] + t->sine[k] * up[a];
      t->m->normals[3 * t->point + (uint64_t)a] = (float)n;
      t->m->points[3 * t->point + (uint64_t)a] = (float)((double)at[a] + radius * n);
    }
    t->m->uv[2 * t->point] = (float)k / (float)t->sides;
    t->m->uv[2 * t->point + 1] = (float)(along / 100);
    t->m->owner[t->point] = owner;
  }
}

static void put_tube(tube *t, const fiber *f, const sieve *s, uint32_t strand) {
  double side[3] = {0, 0, 0}, way[3];
  double step = strand_length(&f->plan.shape, strand) / (f->vertices - 1);
  uint64_t base = t->point, n = t->sides;
  for (uint32_t v = 0; v < s->points; v++) {
    float at[3];
    double r = (double)put_point(f, strand, vertex_of(f, s, v), at);
    direction(f, s, strand, v, way);
    carry(side, way);
    put_ring(t, at, r, side, way, strand, step * vertex_of(f, s, v));
    for (uint64_t k = 0; v && k < n; k++) {
      uint64_t a = base + (v - 1) * n + k, b = base + (v - 1) * n + (k + 1) % n;
      put_triangle(t, a, b, b + n);
      put_triangle(t, a, b + n, a + n);
    }
  }
  uint64_t last = base + (s->points - 1) * n;
  for (uint64_t k = 1; k + 1 < n; k++) {
    put_triangle(t, base, base + k + 1, base + k);
    put_triangle(t, last, last + k, last + k + 1);
  }
}

int32_t fiber_mesh(const fiber *f, const sozai_host *host, uint32_t level, mesh_block **out) {
  int32_t r = host_progress(host, 0.0, "making the mesh");
  if (r) return r;
  selection s = select_strands(f, level);
  tube t = {.sides = level < 2 ? 6 : 3};
  for (uint32_t k = 0; k < t.sides; k++) {
    strand_sine_cosine(6.28318530717958647692 * k / t.sides, &t.sine[k], &t.cosine[k]);
  }
  uint64_t strands = s.counts[0] + s.counts[1];
  uint64_t each = 2ull * t.sides * (s.sieve.points - 1) + 2ull * (t.sides - 2);
  t.m = mesh_block_make(host, strands * s.sieve.points * t.sides, strands * each, 0);
  if (!t.m)
    return strands * s.sieve.points * t.sides >> 32 ? SOZAI_ERROR_UNSUPPORTED : SOZAI_ERROR_MEMORY;
  uint64_t done = 0;
  for (int k = 0; !r && k < 2; k++) {
    if (!s.counts[k]) continue;
    for (uint32_t i = 0; !r && i < f->strands; i += s.sieve.strands_every) {
      if (part_of(f, i) != k) continue;
      put_tube(&t, f, &s.sieve, i);
      if (++done % REPORT_EACH == 0)
        r = host_progress(host, (double)done / (double)strands, "making the mesh");
    }
  }
  if (!r) r = host_progress(host, 1.0, "making the mesh");
  if (r) {
    host_free(host, t.m, t.m->bytes, 64);
    return r;
  }
  uint64_t counts[2] = {s.counts[0] * each, s.counts[1] * each};
  t.m->out.part_count = put_parts(f, t.m->parts, counts, SOZAI_PART_CLOSED);
  *out = t.m;
  return SOZAI_OK;
}
