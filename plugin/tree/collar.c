/* SPDX-License-Identifier: Apache-2.0 */
#include "collar.h"

#include "mesh.h"
#include "turn.h"

/* How far it reaches along the parent, in the branch's radii: */
#define BESIDE 0.8f
#define BELOW 1.3f
#define ABOVE 0.9f
/* and along the branch, */
#define ALONG 0.9f
#define ALONG_BELOW 0.6f /* and below it more */
#define LESS 0.4f        /* how much less of a branch as thick as its parent */
#define ROUNDED 0.55f /* of the way to where the surfaces would meet: how far the cubic follows */
#define HEM 0.5f      /* of the reach along the parent: how far on under it the collar's hem runs */
/* Tubes have flat sides. Of what those of the parent lie under its radius, how deep its hem begins
 * under that; and of what lines between its own points do, how high over the parent it ends. */
#define SUNK 1.3f
#define RAISED 1.2f
#define RAISED_FINE 0.4f  /* of branches that have more sides, for their bark */
#define SUNK_LEAST 0.003f /* of the parent's radius; and so much at most is raised */
#define RAISED_MOST 0.015f
#define FURROWED 1.5f    /* mm: shallower bark has no normals of its own on a hem */
#define THICKEST 0.93f   /* of the parent's radius: thicker ones have none */
#define LEAST 3.0f       /* mm of radius, */
#define LEAST_WHOLE 6.0f /* and from where on it is not of a few sides alone */
#define LONGEST 0.6f     /* of the branch */
#define WINDOW 6.0f      /* radii of the parent to either side: what of it is looked at */
#define PROBES 16u       /* lines by which its extent is found */
#define STEPS_MOST 96u   /* from the parent's axis to its surface */

typedef struct {
  float off;                /* mm, above 0 outside */
  float normal[3], axis[3]; /* unit: out of the axis, and along it */
  float middle[3], r;       /* the axis's nearest point, and the radius there */
} nearest;

static float dot(const float a[3], const float b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* To length 1; whether it had any. */
static int unit(float v[3]) {
  float square = dot(v, v);
  if (!(square > 1e-12f)) return 0;
  float s = 1.0f / __builtin_sqrtf(square);
  for (int k = 0; k < 3; k++) v[k] *= s;
  return 1;
}

/* ---- the parent ------------------------------------------------------------- */

/* Of one piece of an axis. */
static void nearest_of(const ring *a, const ring *b, const float p[3], nearest *out) {
  float d[3], o[3];
  for (int k = 0; k < 3; k++) d[k] = b->p[k] - a->p[k], o[k] = p[k] - a->p[k];
  float square = dot(d, d), t = square > 0.0f ? dot(d, o) / square : 0.0f;
  t = t > 0.0f ? t < 1.0f ? t : 1.0f : 0.0f;
  out->r = a->r + t * (b->r - a->r);
  for (int k = 0; k < 3; k++) {
    out->middle[k] = a->p[k] + t * d[k];
    out->normal[k] = p[k] - out->middle[k];
    out->axis[k] = d[k];
  }
  out->off = __builtin_sqrtf(dot(out->normal, out->normal)) - out->r;
}

static void parent_at(const collar *c, const float p[3], nearest *out) {
  nearest_of(&c->axis[0], &c->axis[1], p, out);
  for (uint32_t i = 1; i + 1 < c->nodes; i++) {
    nearest n;
    nearest_of(&c->axis[i], &c->axis[i + 1], p, &n);
    if (n.off < out->off) *out = n;
  }
  unit(out->normal);
  unit(out->axis);
}

/* How far a circle's sides lie within it, of its radius. */
static float flat(uint32_t sides) { return 4.9348f / (float)(sides * sides); }

/* Its axis about the base, and its bark there. */
static void set_parent(collar *c, const tree *t, const tree_branch *b, const bark_surface *bark,
                       uint32_t level) {
  const tree_branch *on = &t->branches[b->parent];
  const uint32_t room = sizeof c->axis / sizeof *c->axis;
  ring all[RINGS_MOST];
  uint32_t count = rings_lay(t, on, level, all);
  float share;
  uint32_t at = rings_nearest(all, count, c->rings[0].p, &share), from = at, to = at + 1;
  const ring *here = &all[at];
  float reach = WINDOW * here->r, below = 0.0f, above = 0.0f;
  while (from > 0 && below < reach && to - from + 1 < room / 2) {
    from--;
    below += rings_apart(&all[from], &all[from + 1]);
  }
  while (to + 1 < count && above < 2.0f * reach && to - from + 1 < room) {
    above += rings_apart(&all[to], &all[to + 1]);
    to++;
  }
  c->nodes = to - from + 1;
  c->age = here->age;
  int fine = bark_surface_on(bark, t, on);
  c->bark = 0.0f;
  c->furrowed = 0;
  if (fine) {
    bark_ring there = bark_ring_at(bark, &t->plan, c->age, here->r, here->p[1], level);
    c->bark = there.depth * bark->furrows.mean;
    c->furrowed = there.depth * there.cut > FURROWED;
  }
  float wide = b->radius * (1.0f + BESIDE) / here->r;
  float lower = (bark_surface_on(bark, t, b) ? RAISED_FINE : RAISED) * wide * wide *
                flat(tube_sides(b, level));
  c->sunk = (SUNK_LEAST + (fine ? 0.0f : SUNK * flat(tube_sides(on, level)))) * here->r;
  c->raised = (lower < RAISED_MOST ? lower : RAISED_MOST) * here->r;
  for (uint32_t i = 0; i < c->nodes; i++) {
    c->axis[i] = all[from + i];
    c->axis[i].r += c->bark;
  }
}

/* ---- the branch ------------------------------------------------------------- */

/* Out of its axis; turned: a share of the way to where its rings are round. */
static void outward(const collar *c, const float round[2], float turned, float out[3]) {
  for (int k = 0; k < 3; k++) {
    float level = c->level[k] + turned * (c->end_level[k] - c->level[k]);
    float side = c->side[k] + turned * (c->end_side[k] - c->side[k]);
    out[k] = round[0] * level + round[1] * side;
  }
}

/* A place on it s mm from its base; along: its direction there. */
static void branch_at(const collar *c, const float round[2], float s, float turned, float p[3],
                      float along[3]) {
  float out[3];
  ring at;
  rings_along(c->rings, c->count, s, &at, along);
  outward(c, round, turned, out);
  for (int k = 0; k < 3; k++) p[k] = at.p[k] + at.r * out[k];
}

/* Where a line of it leaves the parent: no step is longer than the way to the surface. Below 0: it
 * does not. */
static float leaves_at(const collar *c, const float round[2], float most, nearest *there,
                       float p[3]) {
  float s = 0.0f, along[3];
  for (uint32_t i = 0; i < STEPS_MOST && s < most; i++) {
    branch_at(c, round, s, 0.0f, p, along);
    parent_at(c, p, there);
    if (there->off > -0.002f * there->r) return s;
    s -= there->off;
  }
  return -1.0f;
}

/* How far it reaches over a line that leaves the parent towards out, along the parent's surface,
 * and how far along the branch. */
static void reaches(const nearest *at, const float out[3], float r, float reach[2]) {
  float up = dot(out, at->axis), square = up * up;
  float scale = r * (1.0f - LESS * (r < at->r ? r / at->r : 1.0f));
  reach[0] = scale * (BESIDE + square * ((up < 0.0f ? BELOW : ABOVE) - BESIDE));
  reach[1] = scale * (ALONG + (up < 0.0f ? ALONG_BELOW * square : 0.0f));
}

/* To so deep under the parent's surface. */
static void sink(const collar *c, float p[3], float deep, float normal[3]) {
  nearest at;
  parent_at(c, p, &at);
  for (int k = 0; k < 3; k++) {
    p[k] = at.middle[k] + (at.r - deep) * at.normal[k];
    normal[k] = at.normal[k];
  }
}

static int line_of(const collar *c, const float round[2], float most, collar_line *out) {
  nearest at;
  float edge[3], away[3], along[3], reach[2], *foot = out->bend[0], *tip = out->bend[3];
  float s = leaves_at(c, round, most, &at, edge);
  if (s < 0.0f) return 0;
  outward(c, round, 0.0f, away);
  float in = dot(away, at.normal);
  for (int k = 0; k < 3; k++) away[k] -= in * at.normal[k];
  if (!unit(away)) return 0;
  ring here;
  rings_along(c->rings, c->count, s, &here, along);
  reaches(&at, away, here.r, reach);
  for (int k = 0; k < 3; k++) {
    foot[k] = edge[k] + reach[0] * away[k];
    out->hem[k] = edge[k] + (1.0f + HEM) * reach[0] * away[k];
  }
  sink(c, foot, -c->raised, out->normal);
  sink(c, out->hem, c->sunk, out->hem_normal);
  branch_at(c, round, s + reach[1], 0.0f, tip, along);
  /* along the surfaces, at both ends */
  float back[3];
  for (int k = 0; k < 3; k++) back[k] = edge[k] - foot[k];
  in = dot(back, out->normal);
  for (int k = 0; k < 3; k++) {
    out->bend[1][k] = foot[k] + ROUNDED * (back[k] - in * out->normal[k]);
    out->bend[2][k] = tip[k] - ROUNDED * reach[1] * along[k];
  }
  out->along[1] = s + reach[1];
  out->along[0] = s > reach[0] ? s - reach[0] : 0.0f;
  return 1;
}

/* How far it reaches, by a few of its lines. */
static int set_extent(collar *c, const tree_plan *p, float most) {
  float first = 1e30f, last = 0.0f, longest = 0.0f, r = c->rings[0].r;
  for (uint32_t i = 0; i < PROBES; i++) {
    collar_line line;
    if (!line_of(c, p->round[i * 1024u / PROBES], most, &line)) return 0;
    float length = 0.0f;
    for (int k = 0; k < 3; k++) {
      float d[3];
      for (int j = 0; j < 3; j++) d[j] = line.bend[k + 1][j] - line.bend[k][j];
      length += __builtin_sqrtf(dot(d, d));
    }
    if (length > longest) longest = length;
    if (line.along[1] < first) first = line.along[1];
    if (line.along[1] > last) last = line.along[1];
  }
  c->end = last + 0.3f * r;
  c->lengths[0] = HEM * longest;
  c->lengths[1] = longest;
  c->lengths[2] = c->end - first;
  return c->end < most;
}

int collar_may_be(const tree_branch *b, uint32_t level) {
  return b->order == 1 && level < 2 && b->radius > LEAST;
}

int collar_of(collar *c, const tree *t, const tree_branch *b, const bark_surface *bark,
              uint32_t level, const ring *rings, uint32_t count) {
  if (!collar_may_be(b, level) || t->branches[b->parent].nodes < 2) return 0;
  int whole = b->radius > LEAST_WHOLE;
  c->rings = rings;
  c->count = count;
  c->parts[0] = 1;
  c->parts[1] = level || !whole ? 3 : 6;
  c->parts[2] = level || !whole ? 1 : 2;
  set_parent(c, t, b, bark, level);
  float length = 0.0f, most, p[3];
  for (uint32_t i = 0; i + 1 < count; i++) length += rings_apart(&rings[i], &rings[i + 1]);
  most = LONGEST * length;
  nearest at;
  parent_at(c, rings[0].p, &at);
  if (!(b->radius < THICKEST * at.r && at.off < -b->radius)) return 0;
  /* its axis's direction, where that leaves the parent */
  static const float middle[2] = {0.0f, 0.0f};
  for (int k = 0; k < 3; k++) c->level[k] = c->side[k] = c->end_level[k] = c->end_side[k] = 0.0f;
  c->begin = leaves_at(c, middle, most, &at, p);
  if (c->begin < 0.0f) return 0;
  ring here;
  rings_along(rings, count, c->begin, &here, c->along);
  turn_level(c->along, c->level);
  skin_side(c->along, c->level, c->side);
  if (!set_extent(c, &t->plan, most)) return 0;
  float last[3];
  rings_along(rings, count, c->end, &here, last);
  c->own_age = here.age;
  for (int k = 0; k < 3; k++) c->end_level[k] = c->level[k];
  skin_carry(c->end_level, last);
  skin_side(last, c->end_level, c->end_side);
  return 1;
}

uint32_t collar_sides(const tree_branch *b, uint32_t level) {
  uint32_t n = b->radius < LEAST_WHOLE ? 5 : b->radius < 20.0f ? 8 : b->radius < 60.0f ? 14 : 20;
  return level ? (n + 3) / 2 : n;
}

/* ---- its rings -------------------------------------------------------------- */

/* The first of the branch's own that is kept. */
static uint32_t kept_from(const collar *c) {
  float s = 0.0f;
  for (uint32_t i = 0; i + 2 < c->count; i++) {
    s += rings_apart(&c->rings[i], &c->rings[i + 1]);
    if (s > c->end + 0.25f * c->rings[0].r) return i + 1;
  }
  return c->count - 1;
}

uint32_t collar_count(const collar *c) {
  return c->parts[0] + c->parts[1] + c->parts[2] + 1 + c->count - kept_from(c);
}

void collar_rings(const collar *c, ring *out) {
  uint32_t n = 0, from = kept_from(c);
  float along[3];
  for (uint32_t part = 0; part < 3; part++)
    for (uint32_t i = 0; i < c->parts[part]; i++) {
      float way = (float)part + (float)i / (float)c->parts[part];
      float share = way > COLLAR_SEEN ? way < COLLAR_TUBE ? way - COLLAR_SEEN : 1.0f : 0.0f;
      rings_along(c->rings, c->count, c->begin + share * (c->end - c->begin), &out[n], along);
      out[n].age = c->age + share * (c->own_age - c->age);
      out[n].way = way;
      out[n++].next = c->lengths[part] / (float)c->parts[part];
    }
  ring *last = &out[n++];
  rings_along(c->rings, c->count, c->end, last, along);
  last->way = COLLAR_END;
  last->next = rings_apart(last, &c->rings[from]);
  for (uint32_t i = from; i < c->count; i++) out[n++] = c->rings[i];
}

void collar_line_of(const collar *c, const float round[2], collar_line *out) {
  if (line_of(c, round, 1e30f, out)) return;
  /* between lines that leave the parent one that does not: the branch alone */
  float along[3];
  branch_at(c, round, 0.0f, 0.0f, out->hem, along);
  for (int k = 0; k < 4; k++)
    branch_at(c, round, (float)(k + 1) * 0.25f * c->end, 0.0f, out->bend[k], along);
  outward(c, round, 0.0f, out->normal);
  outward(c, round, 0.0f, out->hem_normal);
  out->along[0] = 0.25f * c->end, out->along[1] = c->end;
}

float collar_at(const collar *c, const collar_line *line, const float round[2], float way,
                float p[3], float out[3]) {
  float own[3];
  outward(c, round, 0.0f, own);
  if (way < COLLAR_SEEN) {
    for (int k = 0; k < 3; k++) {
      p[k] = line->hem[k] + way * (line->bend[0][k] - line->hem[k]);
      out[k] = line->hem_normal[k] + way * (line->normal[k] - line->hem_normal[k]);
    }
    unit(out);
    return line->along[0];
  }
  if (way > COLLAR_TUBE) {
    float along[3], turned = way - COLLAR_TUBE;
    float s = line->along[1] + turned * (c->end - line->along[1]);
    branch_at(c, round, s, turned, p, along);
    outward(c, round, turned, out);
    return s;
  }
  /* closer to each other where it leaves the parent */
  float u = 0.5f * (way - COLLAR_SEEN) * (1.0f + (way - COLLAR_SEEN)), v = 1.0f - u;
  const float w[4] = {v * v * v, 3.0f * v * v * u, 3.0f * v * u * u, u * u * u};
  for (int k = 0; k < 3; k++) {
    p[k] = 0.0f;
    for (int i = 0; i < 4; i++) p[k] += w[i] * line->bend[i][k];
    out[k] = line->normal[k] + u * (own[k] - line->normal[k]);
  }
  if (!unit(out))
    for (int k = 0; k < 3; k++) out[k] = own[k];
  return line->along[0] + u * (line->along[1] - line->along[0]);
}
