/* SPDX-License-Identifier: Apache-2.0
 *
 * Plies under a footprint. A square on a sheet's edge reaches so far down the
 * sheet, and each ply that it meets is asked for its wood, over the part of the
 * square that lies in the ply; glue has the rest of the ply's part. Answers are
 * averaged by how much of the square each part is, so that the shares of plies
 * and glue are those of a box. What cannot be averaged (a direction, a number)
 * is that of the ply that the point lies in.
 *
 * Where more than PLIES_TAPS would be asked, as many are, evenly down the
 * square. The bookkeeping is by points, in whole blocks the asking, which is
 * evaluate_points's: kernel.c includes this after that.
 */
#ifndef SOZAI_WOOD_PLIES_TAPS_H
#define SOZAI_WOOD_PLIES_TAPS_H

#include "../../core/hash1.h"
#include "../stages/block.h"
#include "../stages/wants.h"

#define TAPS_ROOM (BLOCKS * LANES)
#define PLY_LEAST 1e-3f    /* mm: a point's own blur */
#define PLY_THINNEST 0.02f /* of a footprint, down the surface: its area is never rounded away */

enum { IN_POINT, IN_NORMAL = 3, IN_LIGHT = 6, IN_VIEW = 9, IN_COLOUR = 12, IN_COLUMNS = 15 };

/* Of a point's plies: the one that it lies in, the first and the last asked. */
enum { OF_OWN = 1, OF_FIRST = 2, OF_LAST = 4 };

typedef struct {
  uint32_t count;
  int alone; /* points that follow one another, each of one ply: answers need no averaging */
  uint32_t point[TAPS_ROOM]; /* whose it is */
  float weight[TAPS_ROOM];
  uint8_t flags[TAPS_ROOM];
  float in[IN_COLUMNS][TAPS_ROOM], footprint[TAPS_ROOM];
  float told[TAP_COLUMNS][TAPS_ROOM];
  float out[WOOD_COMPONENTS][TAPS_ROOM];
  float normal[3]; /* what has been added up of the last point's */
} ply_queue;

/* Not averaged: directions and numbers. */
static int taps_of_own(int c) {
  return (c >= WOOD_FIBER && c <= WOOD_DIVE) || c == WOOD_TIME || c == WOOD_REFERENCE ||
         c == WOOD_REFERENCE + 1 || (c >= WOOD_BOARD_ID && c <= WOOD_BOARD_EDGE);
}

static int taps_normal(int c) { return c >= WOOD_NORMAL && c < WOOD_NORMAL + 3; }

/* Its length is that of all three, whichever are asked for. */
static void taps_store_normals(const kernel_io *io, ply_queue *q) {
  for (uint32_t k = 0; k < q->count; k++) {
    float length = 1.0f, *n = q->normal;
    for (int c = 0; c < 3; c++) {
      float x = q->weight[k] * q->out[WOOD_NORMAL + c][k];
      n[c] = q->flags[k] & OF_FIRST ? x : n[c] + x;
    }
    if (!(q->flags[k] & OF_LAST)) continue;
    float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    if (!(q->flags[k] & OF_FIRST) && !(square < 1e-12f)) length = __builtin_sqrtf(square);
    for (int c = 0; c < 3; c++) {
      float *out = io->out[WOOD_NORMAL + c];
      if (out) out[q->point[k]] = n[c] / length;
    }
  }
}

static void taps_store(const kernel_io *io, const ply_queue *q) {
  for (int c = 0; c < WOOD_COMPONENTS; c++) {
    float *out = io->out[c];
    if (!out || taps_normal(c)) continue;
    int of_own = taps_of_own(c);
    for (uint32_t k = 0; k < q->count; k++) {
      float x = q->out[c][k], *to = &out[q->point[k]];
      if (of_own) {
        if (q->flags[k] & OF_OWN) *to = x;
      } else if (q->flags[k] & OF_FIRST) {
        *to = q->weight[k] * x;
      } else {
        *to += q->weight[k] * x;
      }
    }
  }
}

/* A column of the batch's, for the queue's points. */
static const float *taps_given(const ply_queue *q, const float *all, float *room) {
  if (!all) return NULL;
  if (q->alone) return all + q->point[0];
  for (uint32_t k = 0; k < q->count; k++) room[k] = all[q->point[k]];
  return room;
}

static void taps_ask(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                     ply_queue *q) {
  if (!q->count) return;
  sozai_batch in = *io->in;
  float *out[WOOD_COMPONENTS];
  ply_taps told;
  in.count = q->count;
  in.footprint = q->footprint;
  for (int c = 0; c < 3; c++) {
    in.point[c] = q->in[IN_POINT + c];
    if (in.normal[c]) in.normal[c] = q->in[IN_NORMAL + c];
    in.light[c] = taps_given(q, in.light[c], q->in[IN_LIGHT + c]);
    in.view[c] = taps_given(q, in.view[c], q->in[IN_VIEW + c]);
    in.light_colour[c] = taps_given(q, in.light_colour[c], q->in[IN_COLOUR + c]);
  }
  int normals = io->out[WOOD_NORMAL] || io->out[WOOD_NORMAL + 1] || io->out[WOOD_NORMAL + 2];
  for (int c = 0; c < WOOD_COMPONENTS; c++) {
    if (q->alone) {
      out[c] = io->out[c] ? io->out[c] + q->point[0] : NULL;
    } else {
      out[c] = io->out[c] || (normals && taps_normal(c)) ? q->out[c] : NULL;
    }
  }
  for (int c = 0; c < TAP_COLUMNS; c++) told.column[c] = q->told[c];
  wood_wants asked = *want;
  asked.taps = &told;
  kernel_io part = {&in, out, io->wanted};
  evaluate_points(w, &part, &asked, 1, 0, q->count);
  if (!q->alone) {
    taps_store(io, q);
    if (normals) taps_store_normals(io, q);
  }
  q->count = 0;
}

/* ---- where the glue is -------------------------------------------------- */

/* The line of glue above ply k of all: its middle, mm deep, and half its
 * thickness. Above the first and below the last there is none. */
typedef struct {
  float at, half;
} glue_line;

static int32_t plies_of_all(const wood_plies *p) { return p->count * p->sheets; }

/* Which sheet a ply is of; most are of the first, and a division is slow. */
static int32_t sheet_of(const wood_plies *p, int32_t k) { return k < p->count ? 0 : k / p->count; }

/* As it would be if it were even. */
static glue_line taps_even(const wood_plies *p, int32_t k) {
  if (k <= 0) return (glue_line){-1e30f, 0.0f};
  if (k >= plies_of_all(p)) return (glue_line){1e30f, 0.0f};
  int32_t sheet = sheet_of(p, k);
  return (glue_line){(float)sheet * p->thick + p->top[k - sheet * p->count], 0.5f * p->glue};
}

/* mm: how far from there it can have an effect, and more than is rounded. */
static float taps_margin(const wood_plies *p, const glue_line *even) {
  return 1.001f * p->wander + even->half * (1.001f + p->swell) + 1e-6f * even->at + 1e-6f;
}

/* Corners of the noises' cells last asked for: points come side by side. */
#define TAPS_CELLS 8
typedef struct {
  uint32_t x, y, line;
  float corner[4];
} taps_cell;
/* And the ply last found, with the depths where no line of glue has an effect,
 * wherever it wanders. */
typedef struct {
  taps_cell cell[TAPS_CELLS];
  int32_t ply;
  float from, to;
  glue_line above, below;
} taps_known;

static void taps_begin(taps_known *known) {
  /* the place of no line */
  for (int k = 0; k < TAPS_CELLS; k++) known->cell[k].line = 0xffffffffu;
  known->from = 1.0f;
  known->to = 0.0f;
}

/* -1..1, smooth over cells of `size` mm of the plane, another for each line. */
static float taps_noise(const wood_plies *p, taps_known *known, const float at[3],
                        float inverse_size, uint32_t line) {
  float x = at[0] * inverse_size, y = at[1] * inverse_size;
  int32_t i = (int32_t)x - (x < (float)(int32_t)x), j = (int32_t)y - (y < (float)(int32_t)y);
  float u = x - (float)i, v = y - (float)j;
  uint32_t hx = (uint32_t)i * HASH_X, hy = (uint32_t)j * HASH_Y;
  taps_cell *cell = &known->cell[line % TAPS_CELLS];
  if (cell->line != line || cell->x != hx || cell->y != hy) {
    *cell = (taps_cell){.x = hx, .y = hy, .line = line};
    for (uint32_t k = 0; k < 4; k++) {
      uint32_t h = hx + (k & 1 ? HASH_X : 0) + hy + (k >> 1 ? HASH_Y : 0);
      h = hash1(h + line * HASH_Z + p->seed);
      cell->corner[k] = (float)(int32_t)h * (1.0f / 2147483648.0f);
    }
  }
  const float *corner = cell->corner;
  u = u * u * (3.0f - 2.0f * u);
  v = v * v * (3.0f - 2.0f * v);
  float low = corner[0] + (corner[1] - corner[0]) * u;
  float high = corner[2] + (corner[3] - corner[2]) * u;
  return low + (high - low) * v;
}

static glue_line taps_line(const wood_plies *p, taps_known *known, const float at[3], int32_t k) {
  glue_line line = taps_even(p, k);
  if (p->wander > 0.0f && k > 0 && k < plies_of_all(p)) {
    line.at += p->wander * taps_noise(p, known, at, 1.0f / 23.0f, 2u * (uint32_t)k);
    line.half *= 1.0f + p->swell * taps_noise(p, known, at, 1.0f / 3.7f, 2u * (uint32_t)k + 1u);
  }
  return line;
}

/* The same for one who looks at depths from..to alone: a line that cannot reach
 * there is told as if it were even, and lies on the side where it does. */
static glue_line taps_line_by(const wood_plies *p, taps_known *known, const float at[3], int32_t k,
                              float from, float to) {
  glue_line even = taps_even(p, k);
  float most = taps_margin(p, &even);
  if (even.at + most < from || even.at - most > to) return even;
  return taps_line(p, known, at, k);
}

/* The ply at a depth, if glue were even. */
static int32_t ply_even(const wood_plies *p, float depth) {
  float within = depth;
  int32_t sheet = 0;
  if (depth > p->thick && p->sheets > 1) {
    float n = depth / p->thick, most = (float)(p->sheets - 1);
    sheet = (int32_t)(n < most ? n : most);
    within = depth - (float)sheet * p->thick;
  }
  int32_t low = 0, high = p->count - 1;
  while (low < high) {
    int32_t middle = (low + high + 1) / 2;
    if (p->top[middle] <= within) {
      low = middle;
    } else {
      high = middle - 1;
    }
  }
  return sheet * p->count + low;
}

/* The ply at a depth. */
static int32_t ply_number(const wood_plies *p, taps_known *known, const float at[3], float depth) {
  int32_t k = ply_even(p, depth);
  if (p->wander > 0.0f) {
    if (depth < taps_line_by(p, known, at, k, depth, depth).at) return k - 1;
    if (depth >= taps_line_by(p, known, at, k + 1, depth, depth).at) return k + 1;
  }
  return k;
}

/* Whether all depths from..to are of one ply, and its glue is out of reach. */
static int taps_sure(const wood_plies *p, taps_known *known, float from, float to) {
  if (from >= known->from && to <= known->to) return 1;
  int32_t k = ply_even(p, from);
  known->ply = k;
  known->above = taps_even(p, k);
  known->below = taps_even(p, k + 1);
  known->from = k > 0 ? known->above.at + taps_margin(p, &known->above) : -1e30f;
  known->to = k + 1 < plies_of_all(p) ? known->below.at - taps_margin(p, &known->below) : 1e30f;
  return from >= known->from && to <= known->to;
}

/* ---- the plies of a point ------------------------------------------------ */

typedef struct {
  uint32_t i;
  float at[3], n[3], s;
  float depth;      /* mm below the first face */
  float steep;      /* how fast the surface goes down, 0..1 */
  float down[2];    /* across the plane, to a mm down */
  float reach;      /* mm of depth that the footprint has */
  float step, tilt; /* the glue's: mm, and its slope down the surface */
} taps_point;

static float taps_overlap(float a, float b, float c, float d) {
  float low = a > c ? a : c, high = b < d ? b : d;
  return high > low ? high - low : 0.0f;
}

/* Height and slope of the glue's step: over a box no narrower than its ramp. */
static void taps_step(const wood_plies *p, taps_known *known, taps_point *pt, int32_t k) {
  float e = pt->reach > p->step_ramp ? pt->reach : p->step_ramp, sum = 0.0f, ends = 0.0f;
  float from = pt->depth - 0.5f * e, to = pt->depth + 0.5f * e;
  while (k > 0 && taps_line_by(p, known, pt->at, k, from, to).at > from) k--;
  for (int n = 0; n < PLIES_TAPS; n++, k++) {
    glue_line line = taps_line_by(p, known, pt->at, k, from, to);
    float a = line.at - line.half, b = line.at + line.half;
    if (a > to) break;
    sum += taps_overlap(from, to, a, b);
    ends += (float)(to > a && to < b) - (float)(from > a && from < b);
  }
  pt->step = p->step * pt->steep * sum / e;
  pt->tilt = p->step * pt->steep * pt->steep * ends / e;
}

/* One ply's part, from a to b of the footprint's depth. */
static void taps_add(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                     ply_queue *q, const taps_point *pt, int32_t ply, glue_line above,
                     glue_line below, float a, float b, float weight, int flags) {
  const wood_plies *p = &w->plies;
  uint32_t k = q->count;
  int32_t sheet = sheet_of(p, ply), kind = ply - sheet * p->count;
  float wood_top = above.at + above.half, wood_end = below.at - below.half;
  float low = a > wood_top ? a : wood_top, high = b < wood_end ? b : wood_end;
  float wood = high - low;
  if (!(wood > 0.0f)) {
    /* glue alone: the wood beside it; or, where floats are too coarse for a width, a place */
    wood = 0.0f;
    low = high = a <= wood_top ? wood_top : a >= wood_end ? wood_end : a;
  }
  float middle = 0.5f * (low + high), shift = middle - pt->depth;
  q->point[k] = pt->i;
  q->weight[k] = weight;
  q->flags[k] = (uint8_t)flags;
  q->in[IN_POINT][k] = pt->at[0] + pt->down[0] * shift;
  q->in[IN_POINT + 1][k] = pt->at[1] + pt->down[1] * shift;
  q->in[IN_POINT + 2][k] = pt->at[2] - shift;
  const sozai_batch *in = io->in;
  for (int c = 0; c < 3; c++) {
    if (in->normal[c]) q->in[IN_NORMAL + c][k] = pt->n[c];
  }
  if (k == 0) q->alone = 1;
  if (flags != (OF_OWN | OF_FIRST | OF_LAST) || weight != 1.0f || pt->i != q->point[0] + k) {
    q->alone = 0;
  }
  q->footprint[k] = pt->s;
  float share = pt->reach > PLY_LEAST ? wood / pt->reach : 1.0f;
  if (share < PLY_THINNEST) share = PLY_THINNEST;
  float to_above = pt->depth - above.at - above.half, to_below = below.at - below.half - pt->depth;
  float edge = to_above < to_below ? to_above : to_below;
  q->told[TAP_NUMBER][k] = (float)ply;
  q->told[TAP_KIND][k] = (float)p->kind[kind];
  q->told[TAP_CROSSED][k] = (float)p->crossed[kind];
  q->told[TAP_THICK][k] = p->deep[kind];
  q->told[TAP_DEPTH][k] = middle - (float)sheet * p->thick - p->top[kind] - 0.5f * p->deep[kind];
  q->told[TAP_SHARE][k] = share < 1.0f ? share : 1.0f;
  q->told[TAP_GLUE][k] = b > a ? 1.0f - wood / (b - a) : 0.0f;
  q->told[TAP_EDGE][k] = edge < 1e6f ? edge : 1e6f;
  q->told[TAP_STEP][k] = pt->step;
  q->told[TAP_TILT][k] = pt->tilt;
  if (++q->count == TAPS_ROOM) taps_ask(w, io, want, q);
}

/* All of a point's plies. */
static void taps_of(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                    ply_queue *q, taps_known *known, taps_point *pt) {
  const wood_plies *p = &w->plies;
  float reach = pt->reach > PLY_LEAST ? pt->reach : PLY_LEAST;
  float from = pt->depth - 0.5f * reach, to = pt->depth + 0.5f * reach;
  /* how far the next line is, only where someone asks */
  int edge = kernel_wants(io, WOOD_BOARD_EDGE, 1);
  if (taps_sure(p, known, from, to)) {
    int32_t k = known->ply;
    if (p->step != 0.0f && pt->steep > 1e-3f) taps_step(p, known, pt, k);
    glue_line above = edge ? taps_line(p, known, pt->at, k) : known->above;
    glue_line below = edge ? taps_line(p, known, pt->at, k + 1) : known->below;
    taps_add(w, io, want, q, pt, k, above, below, from, to, 1.0f, OF_OWN | OF_FIRST | OF_LAST);
    return;
  }
  int32_t first = ply_number(p, known, pt->at, from), last = ply_number(p, known, pt->at, to);
  int32_t here = ply_number(p, known, pt->at, pt->depth);
  if (p->step != 0.0f && pt->steep > 1e-3f) taps_step(p, known, pt, first);
  if (last - first < PLIES_TAPS) {
    float low = edge ? -1e30f : from, high = edge ? 1e30f : to;
    glue_line above = taps_line_by(p, known, pt->at, first, low, high);
    for (int32_t k = first; k <= last; k++) {
      glue_line below = taps_line_by(p, known, pt->at, k + 1, low, high);
      float a = k == first ? from : above.at, b = k == last ? to : below.at;
      if (!(b > a)) b = a;
      int flags =
          (k == here ? OF_OWN : 0) | (k == first ? OF_FIRST : 0) | (k == last ? OF_LAST : 0);
      taps_add(w, io, want, q, pt, k, above, below, a, b, first == last ? 1.0f : (b - a) / reach,
               flags);
      above = below;
    }
    return;
  }
  /* whole plies, evenly down the square, two and two: one along and one across.
   * The one that the point lies in stands for its own part */
  const int parts = PLIES_TAPS / 2;
  int nearest = (int)((pt->depth - from) / reach * (float)parts);
  if (nearest >= parts) nearest = parts - 1;
  for (int t = 0; t < PLIES_TAPS; t++) {
    float at = from + ((float)(t / 2) + 0.5f) * reach * (1.0f / (PLIES_TAPS / 2));
    int32_t k = t / 2 == nearest ? here : ply_number(p, known, pt->at, at);
    int own = t == 2 * nearest;
    if (t & 1) k += k + 1 < plies_of_all(p) ? 1 : -1;
    int32_t sheet = sheet_of(p, k), ply = k - sheet * p->count;
    float top = (float)sheet * p->thick + p->top[ply];
    int flags = (own ? OF_OWN : 0) | (t == 0 ? OF_FIRST : 0) | (t == PLIES_TAPS - 1 ? OF_LAST : 0);
    taps_add(w, io, want, q, pt, k, taps_line(p, known, pt->at, k),
             taps_line(p, known, pt->at, k + 1), top, top + p->deep[ply], 1.0f / PLIES_TAPS, flags);
  }
}

static float taps_coordinate(float x) {
  return x != x ? 0.0f : x < -1e6f ? -1e6f : x > 1e6f ? 1e6f : x;
}

static __attribute__((noinline)) void evaluate_plies(const wood_constants *w, const kernel_io *io,
                                                     const wood_wants *want, uint32_t from,
                                                     uint32_t to) {
  const sozai_batch *in = io->in;
  ply_queue q;
  taps_known known;
  float normals[3][LANES] = {{0}};
  q.count = 0;
  taps_begin(&known);
  for (uint32_t i = from; i < to; i++) {
    uint32_t within = (i - from) % LANES;
    if (in->normal[0] && within == 0) {
      vf n[3];
      for (int c = 0; c < 3; c++) {
        n[c] = load_lanes(in->normal[c], i, to - i < LANES ? to - i : LANES);
      }
      unit_direction(n);
      for (int c = 0; c < 3; c++) store(normals[c], n[c]);
    }
    taps_point pt = {.i = i, .n = {0, 0, 1}, .steep = 1.0f};
    for (int c = 0; c < 3; c++) pt.at[c] = taps_coordinate(in->point[c][i]);
    float s = in->footprint ? in->footprint[i] : 0.0f;
    pt.s = s > 0.0f ? s < 1e4f ? s : 1e4f : 0.0f;
    pt.depth = w->plies.face - pt.at[2];
    if (in->normal[0]) {
      for (int c = 0; c < 3; c++) pt.n[c] = normals[c][within];
      float flat2 = pt.n[0] * pt.n[0] + pt.n[1] * pt.n[1];
      pt.steep = __builtin_sqrtf(flat2);
      if (pt.steep > 1e-3f) {
        /* along the surface, n_xy n_z / |n_xy|^2 across for each mm down */
        for (int c = 0; c < 2; c++) pt.down[c] = pt.n[c] * pt.n[2] / flat2;
      }
    }
    pt.reach = pt.s * pt.steep;
    taps_of(w, io, want, &q, &known, &pt);
  }
  taps_ask(w, io, want, &q);
}

#endif
