/* SPDX-License-Identifier: Apache-2.0 */
#include "grid.h"

#include <string.h>

#include "../core/status.h"
#include "../core/crew.h"
#include "grid_signs.h"

#define PAD 2          /* cells about the hull's box */
#define NEAR 0.55f     /* a plane through a cell is within half of one from a corner */
#define BRICKS_JOB 32u /* bricks of one job */
#define FAR 3e38f

typedef struct {
  grid *f;
  const hull *h;
  const signs *signs;
} work;

static float node_value(const work *w, const uint32_t fine[3], uint32_t *hint) {
  float p[3];
  for (int a = 0; a < 3; a++) p[a] = signs_place(w->signs, a, fine[a]);
  float d = hull_distance_near(w->h, p, hint);
  return signs_inside(w->signs, fine) ? d : -d;
}

/* A row's nodes one after the other: the nearest triangle to the last one is
 * near the next one too, which spares the search most of the tree. */
static void fill_row(void *context, uint32_t row) {
  const work *w = context;
  grid *f = w->f;
  uint32_t ny = f->cells[1] + 1, nx = f->cells[0] + 1, hint = 0;
  uint32_t fine[3] = {0, row % ny * GRID_FINE, row / ny * GRID_FINE};
  for (uint32_t i = 0; i < nx; i++) {
    fine[0] = i * GRID_FINE;
    f->nodes[(size_t)row * nx + i] = node_value(w, fine, &hint);
  }
}

static void cell_at(const grid *f, uint32_t cell, uint32_t c[3]) {
  c[0] = cell % f->cells[0];
  c[1] = cell / f->cells[0] % f->cells[1];
  c[2] = cell / f->cells[0] / f->cells[1];
}

/* The brick's own nodes: four along each axis, to and fro. */
static void fill_own(const work *w, uint32_t b, uint32_t *hint) {
  grid *f = w->f;
  uint32_t c[3], fine[3];
  cell_at(f, f->brick_cells[b], c);
  for (uint32_t n = 0; n < 64; n++) {
    uint32_t k = n >> 4, j = (n >> 2 & 3) ^ (k & 1 ? 3u : 0u), i = (n & 3) ^ (n & 4 ? 3u : 0u);
    fine[0] = c[0] * 4 + i, fine[1] = c[1] * 4 + j, fine[2] = c[2] * 4 + k;
    f->bricks[(size_t)b * GRID_BRICK + (i + 5 * j + 25 * k)] = node_value(w, fine, hint);
  }
}

/* Its far faces: the neighbours' nodes where those are bricks. */
static void fill_shared(const work *w, uint32_t b, uint32_t *hint) {
  grid *f = w->f;
  uint32_t c[3];
  cell_at(f, f->brick_cells[b], c);
  for (uint32_t n = 0; n < GRID_BRICK; n++) {
    uint32_t at[3] = {n % 5, n / 5 % 5, n / 25}, own[3], cell = 0, fine[3];
    if (at[0] < 4 && at[1] < 4 && at[2] < 4) continue;
    int beyond = 0;
    for (int a = 2; a >= 0; a--) {
      own[a] = at[a] & 3;
      uint32_t there = c[a] + (at[a] >> 2);
      beyond |= there >= f->cells[a];
      cell = cell * f->cells[a] + there;
      fine[a] = c[a] * 4 + at[a];
    }
    int32_t other = beyond ? -1 : f->brick_of[cell];
    float *to = f->bricks + (size_t)b * GRID_BRICK + n;
    *to = other >= 0 ? f->bricks[(size_t)other * GRID_BRICK + (own[0] + 5 * own[1] + 25 * own[2])]
                     : node_value(w, fine, hint);
  }
}

static void own_job(void *context, uint32_t job) {
  const work *w = context;
  uint32_t end = (job + 1) * BRICKS_JOB, hint = 0;
  for (uint32_t b = job * BRICKS_JOB; b < end && b < w->f->brick_count; b++) fill_own(w, b, &hint);
}

static void shared_job(void *context, uint32_t job) {
  const work *w = context;
  uint32_t end = (job + 1) * BRICKS_JOB, hint = 0;
  for (uint32_t b = job * BRICKS_JOB; b < end && b < w->f->brick_count; b++)
    fill_shared(w, b, &hint);
}

/* The eight corners of a cell: the nearest to the surface, and how many are inside. */
static float corners_of(const grid *f, uint32_t cell, int *inside) {
  uint32_t c[3], y = f->cells[0] + 1, z = y * (f->cells[1] + 1);
  cell_at(f, cell, c);
  const float *n = f->nodes + (c[0] + y * c[1] + (size_t)z * c[2]);
  float least = FAR;
  *inside = 0;
  for (uint32_t k = 0; k < 8; k++) {
    float d = n[(k & 1) + (k >> 1 & 1) * y + (k >> 2) * (size_t)z];
    *inside += d > 0;
    d = d < 0 ? -d : d;
    least = d < least ? d : least;
  }
  return least;
}

static int32_t divide(grid *f, const sozai_host *host) {
  int inside;
  for (uint32_t i = 0; i < f->cell_count; i++) {
    /* an open hull's inside also ends where there is no surface */
    int near = corners_of(f, i, &inside) <= NEAR * f->spacing || (inside && inside < 8);
    f->brick_of[i] = near ? (int32_t)f->brick_count++ : -1;
    f->candidate_room += (uint32_t)(near || inside);
  }
  f->bricks = host_alloc(host, ((size_t)f->brick_count * GRID_BRICK + 1) * sizeof(float), 64);
  f->brick_cells = host_alloc(host, (f->brick_count + 1) * sizeof(uint32_t), 64);
  f->candidates = host_alloc(host, (f->candidate_room + 1) * sizeof(uint32_t), 64);
  if (!f->bricks || !f->brick_cells || !f->candidates) return SOZAI_ERROR_MEMORY;
  uint32_t at = 0;
  for (uint32_t i = 0; i < f->cell_count; i++) {
    corners_of(f, i, &inside);
    if (f->brick_of[i] >= 0) f->brick_cells[f->brick_of[i]] = i;
    if (f->brick_of[i] >= 0 || inside) f->candidates[at++] = i;
  }
  f->candidate_count = at;
  return SOZAI_OK;
}

/* Of a divided cell the share by its nodes, each softened over half a gap;
 * whole cells are on one side. Bricks that turn out to be outside are no
 * candidates. */
static void measure(grid *f) {
  double unit = (double)f->spacing * (double)f->spacing * (double)f->spacing, sum = 0;
  float gap = f->spacing / GRID_FINE;
  uint32_t kept = 0;
  for (uint32_t i = 0; i < f->candidate_count; i++) {
    int32_t b = f->brick_of[f->candidates[i]];
    float part = 0, most = -FAR;
    for (uint32_t n = 0; b >= 0 && n < GRID_BRICK; n++) {
      float v = f->bricks[(size_t)b * GRID_BRICK + n], t = 0.5f + v / gap;
      float w =
          (n % 5 & 3 ? 1.0f : 0.5f) * (n / 5 % 5 & 3 ? 1.0f : 0.5f) * (n / 25 & 3 ? 1.0f : 0.5f);
      part += w * (t < 0 ? 0 : t > 1 ? 1 : t);
      most = v > most ? v : most;
    }
    sum += b >= 0 ? unit * (double)part / 64 : unit;
    if (b < 0 || most > -gap) f->candidates[kept++] = f->candidates[i];
  }
  f->candidate_count = kept;
  f->volume = sum;
}

static int32_t fill(grid *f, const sozai_host *host, const hull *h, const signs *s) {
  work w = {f, h, s};
  uint32_t rows = (f->cells[1] + 1) * (f->cells[2] + 1);
  int32_t r = crew_run(host, rows, fill_row, &w, (crew_progress){"measuring the hull", 0, 0.05});
  if (!r) r = divide(f, host);
  uint32_t jobs = (f->brick_count + BRICKS_JOB - 1) / BRICKS_JOB;
  if (!r) r = crew_run(host, jobs, own_job, &w, (crew_progress){"measuring the hull", 0.05, 0.15});
  if (!r)
    r = crew_run(host, jobs, shared_job, &w, (crew_progress){"measuring the hull", 0.15, 0.2});
  if (!r) measure(f);
  return r;
}

int32_t grid_make(grid *f, const sozai_host *host, const hull *h, uint32_t cells) {
  double spacing = (double)h->side * GRID_FINE / cells, origin[3];
  uint32_t fine[3];
  f->spacing = (float)spacing;
  f->inverse = (float)(1 / spacing);
  f->node_count = f->cell_count = 1;
  for (int a = 0; a < 3; a++) {
    double extent = (double)h->high[a] - (double)h->low[a];
    f->cells[a] = (uint32_t)(extent / spacing + 0.999999) + 2 * PAD;
    if (f->cells[a] < 1 + 2 * PAD) f->cells[a] = 1 + 2 * PAD;
    origin[a] = (double)h->low[a] + 0.5 * extent - 0.5 * spacing * f->cells[a];
    f->origin[a] = (float)origin[a];
    f->end[a] = (float)f->cells[a] - 0.0001f;
    f->node_count *= f->cells[a] + 1;
    f->cell_count *= f->cells[a];
    fine[a] = f->cells[a] * GRID_FINE + 1;
  }
  f->nodes = host_alloc(host, f->node_count * sizeof(float), 64);
  f->brick_of = host_alloc(host, f->cell_count * sizeof(int32_t), 64);
  if (!f->nodes || !f->brick_of) return SOZAI_ERROR_MEMORY;
  signs s;
  int32_t r = signs_make(&s, host, h, origin, spacing / GRID_FINE, fine);
  if (!r) r = fill(f, host, h, &s);
  signs_free(&s, host);
  return r;
}

void grid_free(grid *f, const sozai_host *host) {
  host_free(host, f->nodes, f->node_count * sizeof(float), 64);
  host_free(host, f->brick_of, f->cell_count * sizeof(int32_t), 64);
  host_free(host, f->bricks, ((size_t)f->brick_count * GRID_BRICK + 1) * sizeof(float), 64);
  host_free(host, f->brick_cells, (f->brick_count + 1) * sizeof(uint32_t), 64);
  host_free(host, f->candidates, (f->candidate_room + 1) * sizeof(uint32_t), 64);
  memset(f, 0, sizeof *f);
}

uint64_t grid_bytes(const grid *f) {
  return f->node_count * sizeof(float) + f->cell_count * sizeof(int32_t) +
         (uint64_t)f->brick_count * (GRID_BRICK * sizeof(float) + sizeof(uint32_t)) +
         f->candidate_room * sizeof(uint32_t);
}

int grid_inside(const grid *f, const hull *h, const float p[3]) {
  /* of an open hull the inside ends where there is no surface */
  if (h->rule == HULL_VOTE) return hull_inside(h, p);
  grid_place r = grid_find(f, p[0], p[1], p[2]);
  float v = grid_at(f, p[0], p[1], p[2]);
  /* distances change by no more than the way: what is further from the surface
   * than the nodes about it are from the point is on their side */
  if (v > 0.9f * r.spacing) return 1;
  if (v < -0.9f * r.spacing || r.beyond > 0) return 0;
  return hull_inside(h, p);
}
