/* SPDX-License-Identifier: Apache-2.0 */
#include "traced.h"

#include <math.h>
#include "parallel.h"
#include "samples.h"

enum { BOUNCES = 400, PARTS = 64 };

const float colours[3] = {0.85f, 0.45f, 0.06f};
const double lights[LIGHTS][2] = {{90, 0}, {45, 0},  {45, 90}, {45, 180},
                                  {20, 0}, {20, 90}, {20, 180}};

double seen_chance(const seen *s, int light, int colour, uint32_t rays) {
  double mean = s->sum[light][colour];
  return sqrt(fmax(s->square[light][colour] - mean * mean, 0) / rays);
}

vec aim(double elevation, double azimuth) {
  double e = elevation * PI / 180, a = azimuth * PI / 180;
  return vec_of(cos(e) * cos(a), cos(e) * sin(a), sin(e));
}

/* To the tile that lies where the ray leaves this one; false: it leaves the slab. */
static bool into_next_tile(const traced *b, vec *origin, vec direction) {
  const float *half = b->half, high = b->high;
  float o[2] = {origin->x, origin->y}, d[2] = {direction.x, direction.y}, way = INFINITY;
  int side = -1;
  for (int k = 0; k < 2; k++) {
    if (!(fabsf(d[k]) > 1e-7f)) continue;
    float t = ((d[k] > 0 ? half[k] : -half[k]) - o[k]) / d[k];
    if (t < way) way = t, side = k;
  }
  if (side < 0) return false;
  way = fmaxf(way, 0);
  float z = origin->z + way * direction.z;
  if ((z > high && direction.z >= 0) || (z < -high && direction.z <= 0)) return false;
  *origin = vec_along(*origin, way, direction);
  float *at = side ? &origin->y : &origin->x;
  *at = d[side] > 0 ? -half[side] : half[side];
  return true;
}

/* What lies beyond this tile's edge is met in the next one. */
static bool trace(const traced *b, vec origin, vec direction, strand_hit *h) {
  for (int tiles = 0; tiles < 1000; tiles++) {
    bool met = strands_trace(&b->s, origin, direction, h);
    if (met && fabsf(h->point.x) <= b->half[0] && fabsf(h->point.y) <= b->half[1]) return true;
    if (!into_next_tile(b, &origin, direction)) return false;
  }
  return false;
}

static bool blocked(const traced *b, vec origin, vec direction) {
  for (int tiles = 0; tiles < 1000; tiles++) {
    if (scene_blocked(&b->s.scene, origin, direction)) return true;
    if (!into_next_tile(b, &origin, direction)) return false;
  }
  return false;
}

/* ---- curves ------------------------------------------------------------ */

static void follow(const traced *b, strand_hit h, vec direction, vec absorption, double turn,
                   sample_stream *d, double got[LIGHTS][3], vec *around) {
  vec through = {1, 1, 1}, weight;
  for (int bounce = 0; bounce < BOUNCES; bounce++) {
    if (vec_dot(h.normal, direction) > 0) h.normal = vec_scale(-1, h.normal);
    fiber_view_from f =
        fiber_lobe_from(&b->lobe, h.tangent, h.normal, vec_scale(-1, direction), absorption);
    for (int l = 0; l < LIGHTS; l++) {
      vec towards = aim(lights[l][0], lights[l][1] + turn);
      vec value = fiber_lobe_value(&b->lobe, &f, towards);
      if (value.x + value.y + value.z < 1e-5f) continue;
      if (blocked(b, strand_leave(&h, towards), towards)) continue;
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
    if (!trace(b, strand_leave(&h, direction), direction, &h)) {
      if (direction.z > 0) *around = through;
      return;
    }
  }
}

typedef struct {
  const traced *b;
  eye e;
  uint32_t rays;
  seen part[PARTS];
} task;

static void add_ray(seen *out, double got[LIGHTS][3], vec around) {
  const double rgb[3] = {(double)around.x, (double)around.y, (double)around.z};
  for (int k = 0; k < 3; k++) {
    double all = 0;
    for (int l = 0; l < LIGHTS; l++) {
      out->sum[l][k] += got[l][k];
      out->square[l][k] += got[l][k] * got[l][k];
      all += got[l][k];
    }
    out->square_of_all[k] += all * all;
    out->around[k] += rgb[k];
    out->around2[k] += rgb[k] * rgb[k];
  }
  out->covered += 1;
}

static void look_part(void *context, uint32_t part) {
  task *t = context;
  const traced *b = t->b;
  const eye *e = &t->e;
  seen *out = &t->part[part];
  memset(out, 0, sizeof *out);
  vec absorption = fiber_lobe_absorption((vec){b->colour[0], b->colour[1], b->colour[2]}, b->round);
  uint32_t seed = 7919u * b->seed + 77u + (uint32_t)((90 - e->elevation) / 45) +
                  1000u * (uint32_t)fabs(e->from);
  for (uint32_t i = part; i < t->rays; i += PARTS) {
    sample_stream d = {sample_hash(i * 2654435761u + seed)};
    float x = b->half[0] * (2 * sample_next(&d) - 1), y = b->half[1] * (2 * sample_next(&d) - 1);
    double turn = e->from + e->range * (double)sample_next(&d);
    vec direction = vec_scale(-1, aim(e->elevation, turn)), around = {0, 0, 0};
    strand_hit h;
    if (!trace(b, (vec){x, y, b->high - 0.01f}, direction, &h)) continue;
    double got[LIGHTS][3] = {{0}};
    follow(b, h, direction, absorption, turn, &d, got, &around);
    add_ray(out, got, around);
  }
}

seen look_at_curves(const traced *b, eye e, uint32_t rays) {
  static task t;
  t.b = b;
  t.e = e;
  t.rays = rays;
  parallel_for(2, PARTS, look_part, &t);
  seen s = {0};
  for (int p = 0; p < PARTS; p++) {
    const seen *q = &t.part[p];
    for (int k = 0; k < 3; k++) {
      for (int l = 0; l < LIGHTS; l++) {
        s.sum[l][k] += q->sum[l][k] / rays;
        s.square[l][k] += q->square[l][k] / rays;
      }
      s.square_of_all[k] += q->square_of_all[k] / rays;
      s.around[k] += q->around[k] / rays;
      s.around2[k] += q->around2[k] / rays;
    }
    s.covered += q->covered / rays;
  }
  return s;
}

void ground_look(ground *g, uint32_t i, vec view, vec light) {
  const vec of[2] = {view, light};
  float **to[2] = {g->view, g->light};
  for (int q = 0; q < 2; q++) {
    to[q][0][i] = of[q].x;
    to[q][1][i] = of[q].y;
    to[q][2][i] = of[q].z;
  }
}
