/* SPDX-License-Identifier: Apache-2.0
 * Grown strands are pressed flat to the rise that is wanted, and cut to a tile. */
#include "slab.h"

#include <math.h>
#include <stdio.h>
#include "parallel.h"
#include "samples.h"

enum { BOUNCES = 400, PARTS = 64 };

const float colours[3] = {0.85f, 0.45f, 0.06f};
const double lights[LIGHTS][2] = {{90, 0}, {45, 0},  {45, 90}, {45, 180},
                                  {20, 0}, {20, 90}, {20, 180}};
const double views[VIEWS] = {90, 45};

vec aim(double elevation, double azimuth) {
  double e = elevation * PI / 180, a = azimuth * PI / 180;
  return vec_of(cos(e) * cos(a), cos(e) * sin(a), sin(e));
}

/* ---- the slab ---------------------------------------------------------- */

/* Keeps of [from, to] what lies between -half and half of a + t d. */
static void keep_within(double a, double d, double half, double *from, double *to) {
  if (fabs(d) < 1e-9) {
    if (fabs(a) > half) *to = *from - 1;
    return;
  }
  double s = (-half - a) / d, t = (half - a) / d;
  *from = fmax(*from, fmin(s, t));
  *to = fmin(*to, fmax(s, t));
}

/* The straight strands, pressed flat, within a tile: it is repeated without end. */
static void cut(slab *b, const sozai_curves *c) {
  const aggregate *a = b->of;
  double radius = a->diameter / 2000, length = 0, level = 0;
  double half[3] = {a->side / 2, a->side / 2, a->thick / 2};
  uint64_t n = 0;
  b->points = malloc(6 * c->curve_count * sizeof *b->points);
  b->radii = malloc(2 * c->curve_count * sizeof *b->radii);
  b->first = malloc((c->curve_count + 1) * sizeof *b->first);
  assert_true(b->points && b->radii && b->first);
  for (uint64_t i = 0; i < c->curve_count; i++) {
    const float *p = c->points + 3 * c->first[i], *q = c->points + 3 * (c->first[i + 1] - 1);
    double from = 0, to = 1, at[3], d[3];
    for (int k = 0; k < 3; k++) {
      double press = k == 2 ? a->squeeze : 1;
      at[k] = (double)p[k] * press;
      d[k] = ((double)q[k] - (double)p[k]) * press;
      keep_within(at[k], d[k], half[k], &from, &to);
    }
    if (from >= to) continue;
    for (int k = 0; k < 3; k++) {
      b->points[6 * n + (uint64_t)k] = (float)(at[k] + from * d[k]);
      b->points[6 * n + 3 + (uint64_t)k] = (float)(at[k] + to * d[k]);
    }
    b->radii[2 * n] = b->radii[2 * n + 1] = (float)radius;
    b->first[n] = 2 * n;
    n++;
    length += (to - from) * sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    level += (to - from) * hypot(d[0], d[1]);
  }
  b->first[n] = 2 * n;
  double part = level / length;
  b->packing = length * PI * radius * radius / (a->side * a->side * a->thick);
  b->rise = sqrt(3 * (1 / (part * part) - 1));
  const sozai_curves made = {.size = sizeof made,
                             .curve_count = n,
                             .point_count = 2 * n,
                             .points = b->points,
                             .radii = b->radii,
                             .first = b->first};
  failure why;
  assert_true(strands_open(&b->s, &made, 1, false, &why));
}

/* To the tile that lies where the ray leaves this one; false: it leaves the slab. */
static bool into_next_tile(const slab *b, vec *origin, vec direction) {
  float half = (float)b->of->side / 2, high = (float)b->of->thick / 2 + 0.05f;
  float o[2] = {origin->x, origin->y}, d[2] = {direction.x, direction.y}, way = INFINITY;
  int side = -1;
  for (int k = 0; k < 2; k++) {
    if (!(fabsf(d[k]) > 1e-7f)) continue;
    float t = ((d[k] > 0 ? half : -half) - o[k]) / d[k];
    if (t < way) way = t, side = k;
  }
  if (side < 0) return false;
  way = fmaxf(way, 0);
  float z = origin->z + way * direction.z;
  if ((z > high && direction.z >= 0) || (z < -high && direction.z <= 0)) return false;
  *origin = vec_along(*origin, way, direction);
  float *at = side ? &origin->y : &origin->x;
  *at = d[side] > 0 ? -half : half;
  return true;
}

static bool trace(const slab *b, vec origin, vec direction, strand_hit *h) {
  for (int tiles = 0; tiles < 1000; tiles++) {
    if (strands_trace(&b->s, origin, direction, h)) return true;
    if (!into_next_tile(b, &origin, direction)) return false;
  }
  return false;
}

static bool blocked(const slab *b, vec origin, vec direction) {
  for (int tiles = 0; tiles < 1000; tiles++) {
    if (scene_blocked(&b->s.scene, origin, direction)) return true;
    if (!into_next_tile(b, &origin, direction)) return false;
  }
  return false;
}

void grow_slab(slab *b, const aggregate *a) {
  memset(b, 0, sizeof *b);
  b->of = a;
  double height = a->thick / a->squeeze + a->length, radius = a->diameter / 2000;
  mesh m = box_of(a->side + a->length, a->side + a->length, height);
  /* squeezing makes what is steep shorter */
  double volume = (a->side + a->length) * (a->side + a->length) * height * a->squeeze;
  double count = a->packing * volume / (PI * radius * radius * a->length);
  char text[256];
  snprintf(text, sizeof text, "count=%d vertices=2 length=%g diameter=%g iterations=0 seed=5",
           (int)count, a->length, a->diameter);
  sozai_geometry *g = grow(&m, text);
  const sozai_curves *c = curves_of(g);
  cut(b, c);
  geometry()->release_curves(c);
  geometry()->release(g);
  mesh_free(&m);
  b->lobe = fiber_lobe_make(a->roughness, a->round, a->tilt, a->index);
}

void free_slab(slab *b) {
  strands_close(&b->s);
  free(b->points);
  free(b->radii);
  free(b->first);
}

/* ---- curves ------------------------------------------------------------ */

static vec leave(const strand_hit *h, vec direction) {
  vec middle = vec_along(h->point, -h->radius, h->normal);
  vec flat = vec_along(direction, -vec_dot(direction, h->tangent), h->tangent);
  float l = vec_length(flat);
  vec out = l > 1e-4f ? vec_scale(1 / l, flat) : h->normal;
  return vec_along(middle, 1.03f * h->radius, out);
}

static void follow(const slab *b, strand_hit h, vec direction, vec absorption, double turn,
                   sample_stream *d, double got[LIGHTS][3]) {
  vec through = {1, 1, 1}, weight;
  for (int bounce = 0; bounce < BOUNCES; bounce++) {
    if (vec_dot(h.normal, direction) > 0) h.normal = vec_scale(-1, h.normal);
    fiber_view_from f =
        fiber_lobe_from(&b->lobe, h.tangent, h.normal, vec_scale(-1, direction), absorption);
    for (int l = 0; l < LIGHTS; l++) {
      vec towards = aim(lights[l][0], lights[l][1] + turn);
      vec value = fiber_lobe_value(&b->lobe, &f, towards);
      if (value.x + value.y + value.z < 1e-5f) continue;
      if (blocked(b, leave(&h, towards), towards)) continue;
      vec lit = vec_scale((float)PI, vec_mul(through, value));
      double rgb[3] = {(double)lit.x, (double)lit.y, (double)lit.z};
      for (int k = 0; k < 3; k++) got[l][k] += rgb[k];
    }
    float u[4];
    for (int k = 0; k < 4; k++) u[k] = sample_next(d);
    direction = fiber_lobe_sample(&b->lobe, &f, u, &weight);
    through = vec_mul(through, weight);
    if (bounce >= 8) {
      /* never less than what is left, or long ways would weigh more and more */
      float keep = fminf(1, fmaxf(through.x, fmaxf(through.y, through.z)));
      if (!(sample_next(d) < keep)) return;
      through = vec_scale(1 / keep, through);
    }
    if (!trace(b, leave(&h, direction), direction, &h)) return;
  }
}

typedef struct {
  const slab *b;
  int view;
  uint32_t rays;
  seen part[PARTS];
} task;

static void look_part(void *context, uint32_t part) {
  task *t = context;
  const slab *b = t->b;
  seen *out = &t->part[part];
  memset(out, 0, sizeof *out);
  vec absorption = fiber_lobe_absorption((vec){colours[0], colours[1], colours[2]}, b->of->round);
  for (uint32_t i = part; i < t->rays; i += PARTS) {
    sample_stream d = {sample_hash(i * 2654435761u + 77u + (uint32_t)t->view)};
    float half = (float)b->of->side / 2;
    float x = half * (2 * sample_next(&d) - 1), y = half * (2 * sample_next(&d) - 1);
    double turn = 360 * (double)sample_next(&d);
    vec to = aim(views[t->view], turn), direction = vec_scale(-1, to);
    vec origin = {x, y, (float)b->of->thick / 2 + 0.04f};
    strand_hit h;
    if (!trace(b, origin, direction, &h)) continue;
    double got[LIGHTS][3] = {{0}};
    follow(b, h, direction, absorption, turn, &d, got);
    for (int l = 0; l < LIGHTS; l++) {
      for (int k = 0; k < 3; k++) {
        out->sum[l][k] += got[l][k];
        out->square[l][k] += got[l][k] * got[l][k];
      }
    }
    for (int k = 0; k < 3; k++) {
      double all = 0;
      for (int l = 0; l < LIGHTS; l++) all += got[l][k];
      out->square_of_all[k] += all * all;
    }
  }
}

seen look_at_curves(const slab *b, int view, uint32_t rays) {
  static task t;
  t.b = b;
  t.view = view;
  t.rays = rays;
  parallel_for(2, PARTS, look_part, &t);
  seen s = {0};
  for (int p = 0; p < PARTS; p++) {
    for (int l = 0; l < LIGHTS; l++) {
      for (int k = 0; k < 3; k++) {
        s.sum[l][k] += t.part[p].sum[l][k] / rays;
        s.square[l][k] += t.part[p].square[l][k] / rays;
      }
    }
    for (int k = 0; k < 3; k++) s.square_of_all[k] += t.part[p].square_of_all[k] / rays;
  }
  return s;
}
