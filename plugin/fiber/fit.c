/* SPDX-License-Identifier: Apache-2.0 */
#include "fit.h"

#include <string.h>

#include "../core/mix64.h"
#include "../core/scalar.h"
#include "parameters.h"

#define MOVES 12
#define VISITED_MOST 4097

typedef struct {
  double sum;
  int outside; /* any vertex */
} score;

float fit_distance(const fiber *f, const float p[3]) {
  if (f->plan.mode == MODE_LITERAL) return hull_literal(&f->hull, p);
  if (f->plan.mode == MODE_FIELD) return grid_at(&f->grid, p[0], p[1], p[2]);
  /* the field tells how far to look, and mostly the side */
  grid_place r = grid_find(&f->grid, p[0], p[1], p[2]);
  float v = grid_at(&f->grid, p[0], p[1], p[2]);
  float bound =
      r.beyond > 0 || f->hull.rule == HULL_VOTE ? 3e38f : (v < 0 ? -v : v) + 0.9f * r.spacing;
  float d = hull_distance(&f->hull, p, bound);
  return grid_inside(&f->grid, &f->hull, p) ? d : -d;
}

/* C of vertices o about m. */
static score sum_of(const fiber *f, const float *o, const float m[3]) {
  score s = {0, 0};
  uint32_t n = f->vertices;
  if (f->plan.mode == MODE_FIELD) {
    float least = 0;
    for (uint32_t i = 0; i < n; i++) {
      float d = grid_at(&f->grid, o[3 * i] + m[0], o[3 * i + 1] + m[1], o[3 * i + 2] + m[2]);
      s.sum += (double)d;
      least = d < least ? d : least;
    }
    s.outside = least < 0;
    return s;
  }
  for (uint32_t i = 0; i < n; i++) {
    float p[3] = {o[3 * i] + m[0], o[3 * i + 1] + m[1], o[3 * i + 2] + m[2]};
    float d = fit_distance(f, p);
    s.sum += (double)d;
    s.outside |= d < 0;
  }
  return s;
}

void fit_turned(const double *shape, uint32_t vertices, const double t[9], float *out) {
  for (uint32_t i = 0; i < vertices; i++) {
    const double *v = shape + 3 * i;
    for (int a = 0; a < 3; a++)
      out[3 * i + (uint32_t)a] =
          (float)(t[3 * a] * v[0] + t[3 * a + 1] * v[1] + t[3 * a + 2] * v[2]);
  }
}

/* Vertices turned about a world axis. */
static void turn_about(const float *o, uint32_t n, int axis, float c, float s, float *out) {
  uint32_t x = (uint32_t)axis, u = (x + 1) % 3, v = (x + 2) % 3;
  for (uint32_t i = 0; i < n; i++) {
    const float *p = o + 3 * i;
    float *q = out + 3 * i;
    q[x] = p[x];
    q[u] = p[u] * c - p[v] * s;
    q[v] = p[u] * s + p[v] * c;
  }
}

/* The pose's rotation after a turn about a world axis; rounding would make it
 * a little less than a rotation in a thousand moves, so it is squared up. */
static void turn_pose(double t[9], int axis, double c, double s) {
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (int k = 0; k < 3; k++) {
    double a = t[3 * u + k], b = t[3 * v + k];
    t[3 * u + k] = a * c - b * s;
    t[3 * v + k] = a * s + b * c;
  }
  for (int r = 0; r < 2; r++) {
    double *row = t + 3 * r;
    if (r) {
      double d = row[0] * t[0] + row[1] * t[1] + row[2] * t[2];
      for (int k = 0; k < 3; k++) row[k] -= d * t[k];
    }
    double l = 1 / scalar_root(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
    for (int k = 0; k < 3; k++) row[k] *= l;
  }
  for (int k = 0; k < 3; k++)
    t[6 + k] = t[(k + 1) % 3] * t[3 + (k + 2) % 3] - t[(k + 2) % 3] * t[3 + (k + 1) % 3];
}

/* ---- poses that were --------------------------------------------------- */

typedef struct {
  uint64_t list[VISITED_MOST];
  uint32_t count;
} visited;

/* To a hundred-thousandth of a step: what came back over another way differs by
 * rounding. Steps may be next to nothing beside where a strand is: then poses far out are one. */
static uint64_t pose_hash(const strand_pose *p, double step) {
  uint64_t h = 0x9e3779b97f4a7c15ull;
  for (int i = 0; i < 12; i++) {
    double x = i < 3 ? p->middle[i] / (1e-5 * step) : p->turn[i - 3] * 1e7;
    double y = x + (x < 0 ? -0.5 : 0.5);
    h = mix64(h + (uint64_t)(int64_t)scalar_most(-9e18, scalar_least(9e18, y)));
  }
  return h;
}

static int was_there(visited *v, uint64_t h) {
  for (uint32_t i = 0; i < v->count; i++)
    if (v->list[i] == h) return 1;
  if (v->count < VISITED_MOST) v->list[v->count++] = h;
  return 0;
}

/* ---- moves ------------------------------------------------------------- */

typedef struct {
  double step, sine, cosine;
} pace;

static pace pace_of(double step, double turn) {
  pace p = {.step = step};
  strand_sine_cosine(turn, &p.sine, &p.cosine);
  return p;
}

static score try_move(const fiber *f, const strand_pose *pose, const float *o, int move,
                      const pace *by) {
  int axis = move % 6 / 2;
  double way = move & 1 ? -1 : 1;
  float m[3], turned[3 * STRAND_VERTICES_MAX];
  for (int a = 0; a < 3; a++)
    m[a] = (float)(pose->middle[a] + (move < 6 && a == axis ? way * by->step : 0));
  if (move < 6) return sum_of(f, o, m);
  turn_about(o, f->vertices, axis, (float)by->cosine, (float)(way * by->sine), turned);
  return sum_of(f, turned, m);
}

static void make_move(strand_pose *pose, int move, const pace *by) {
  int axis = move % 6 / 2;
  double way = move & 1 ? -1 : 1;
  if (move < 6)
    pose->middle[axis] += way * by->step;
  else
    turn_pose(pose->turn, axis, by->cosine, way * by->sine);
}

/* One pace until nothing is a gain: what ended it, or -1 for a finer pace. */
static int walk(const fiber *f, const double *shape, strand_pose *pose, const pace *by, visited *v,
                score *now, strand_result *result) {
  int literal = f->plan.mode == MODE_LITERAL;
  float o[3 * STRAND_VERTICES_MAX];
  for (;;) {
    if (!now->outside) return END_INSIDE;
    if (result->moves >= f->plan.iterations) return END_BOUND;
    fit_turned(shape, f->vertices, pose->turn, o);
    int best = -1;
    score most = {-1e300, 1};
    for (int move = 0; move < MOVES; move++) {
      score s = try_move(f, pose, o, move, by);
      if (s.sum > most.sum) most = s, best = move;
    }
    result->tries++;
    /* never to a lower sum; along the paper's level ground until it comes round */
    if (best < 0 || most.sum < now->sum || (most.sum <= now->sum && !literal)) return -1;
    strand_pose next = *pose;
    make_move(&next, best, by);
    if (literal && was_there(v, pose_hash(&next, by->step))) return END_VISITED;
    *pose = next;
    *now = most;
    result->moves++;
  }
}

void fit_strand(const fiber *f, const double *shape, strand_pose *pose, strand_result *result) {
  const fiber_plan *p = &f->plan;
  float o[3 * STRAND_VERTICES_MAX], m[3];
  visited v;
  v.count = 0;
  for (int a = 0; a < 3; a++) m[a] = (float)pose->middle[a];
  fit_turned(shape, f->vertices, pose->turn, o);
  score now = sum_of(f, o, m);
  result->first = (float)now.sum;
  double step = p->step, turn = p->turn;
  was_there(&v, pose_hash(pose, step));
  int end = -1;
  for (uint32_t k = 0; end < 0 && k <= p->halvings; k++) {
    pace by = pace_of(step, turn);
    end = walk(f, shape, pose, &by, &v, &now, result);
    step *= 0.5, turn *= 0.5;
  }
  result->end = (uint16_t)(end < 0 ? END_BEST : end);
  result->last = (float)now.sum;
}
