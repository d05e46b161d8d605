/* SPDX-License-Identifier: Apache-2.0
 *
 * The photograph, as a coarse grid of means, blurred, and split in two along
 * its first principal axis. It shows two parts if the split is what no single
 * part gives: see docs/match.md for the thresholds. */
#include "regions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "appearance.h"
#include "linear.h"

#define LONGER_SIDE 48 /* cells */
#define BLURS 3        /* of 3x3 each: a standard deviation of 1.4 cells */
/* The best split of a normal distribution separates by 2.65, of an even one by
 * 3.46; two parts, with a border that the blur takes a fifth of, by 5 or more. */
#define LEAST_SEPARATION 6
/* Across the border from cell to cell, of the difference of the means: the
 * blur leaves 0.28 of a sharp one, and of an even slope there is 0.04. */
#define LEAST_STEP 0.1
#define LEAST_DIFFERENCE 5 /* CIEDE2000: plainly two colours side by side */
#define LEAST_SHARE 0.08
#define LEAST_WHOLE 0.85 /* of a part's cells in one piece: rings lie in many */

typedef struct grid {
  uint32_t width, height;
  double cell;  /* pixels */
  float *lab;   /* mean of each cell */
  float *count; /* of pixels kept in it */
  uint8_t *label;
  float *scratch;
} grid;

static void grid_free(grid *g) {
  free(g->lab);
  free(g->count);
  free(g->label);
  free(g->scratch);
}

static size_t cell_of(const grid *g, uint32_t x, uint32_t y) {
  uint32_t cx = (uint32_t)(x / g->cell), cy = (uint32_t)(y / g->cell);
  if (cx >= g->width) cx = g->width - 1;
  if (cy >= g->height) cy = g->height - 1;
  return (size_t)cy * g->width + cx;
}

static bool grid_fill(grid *g, const photo *p, failure *why) {
  uint32_t longer = p->width > p->height ? p->width : p->height;
  g->cell = fmax(1, (double)longer / LONGER_SIDE);
  g->width = (uint32_t)fmax(1, floor(p->width / g->cell));
  g->height = (uint32_t)fmax(1, floor(p->height / g->cell));
  size_t cells = (size_t)g->width * g->height;
  g->lab = calloc(3 * cells, sizeof(float));
  g->scratch = calloc(4 * cells, sizeof(float));
  g->count = calloc(cells, sizeof(float));
  g->label = calloc(cells, 1);
  if (!g->lab || !g->count || !g->label || !g->scratch)
    return fail(why, EXIT_FAILURE, "out of memory");
  for (uint32_t y = 0; y < p->height; y++)
    for (uint32_t x = 0; x < p->width; x++) {
      size_t i = (size_t)y * p->width + x, cell = cell_of(g, x, y);
      if (p->pixel[i] == PIXEL_OUT) continue;
      for (int k = 0; k < 3; k++) g->lab[3 * cell + (size_t)k] += p->rgb[3 * i + (size_t)k];
      g->count[cell]++;
    }
  return true;
}

/* Sums of colours and counts alike, so that the mean of what is kept is blurred. */
static void blur(grid *g) {
  size_t cells = (size_t)g->width * g->height;
  memset(g->scratch, 0, 4 * cells * sizeof(float));
  for (uint32_t y = 0; y < g->height; y++)
    for (uint32_t x = 0; x < g->width; x++)
      for (int dy = -1; dy <= 1; dy++)
        for (int dx = -1; dx <= 1; dx++) {
          int64_t nx = (int64_t)x + dx, ny = (int64_t)y + dy;
          if (nx < 0 || ny < 0 || nx >= g->width || ny >= g->height) continue;
          size_t from = (size_t)ny * g->width + (size_t)nx, to = (size_t)y * g->width + x;
          for (size_t k = 0; k < 3; k++) g->scratch[4 * to + k] += g->lab[3 * from + k];
          g->scratch[4 * to + 3] += g->count[from];
        }
  for (size_t i = 0; i < cells; i++) {
    memcpy(g->lab + 3 * i, g->scratch + 4 * i, 3 * sizeof(float));
    g->count[i] = g->scratch[4 * i + 3];
  }
}

/* Sums into means; a cell without pixels, within a border, gets the mean of all. */
static void divide(grid *g) {
  size_t cells = (size_t)g->width * g->height;
  double all[4] = {0, 0, 0, 1e-9};
  for (size_t i = 0; i < cells; i++) {
    for (size_t k = 0; k < 3; k++) all[k] += (double)g->lab[3 * i + k];
    all[3] += (double)g->count[i];
  }
  for (size_t i = 0; i < cells; i++)
    for (size_t k = 0; k < 3; k++)
      g->lab[3 * i + k] =
          g->count[i] > 0 ? g->lab[3 * i + k] / g->count[i] : (float)(all[k] / all[3]);
}

/* ---- splitting ------------------------------------------------------------------- */

typedef struct ranked {
  double at;
  size_t cell;
} ranked;

static int by_place(const void *a, const void *b) {
  double x = ((const ranked *)a)->at, y = ((const ranked *)b)->at;
  return (x > y) - (x < y);
}

static void first_axis(const grid *g, double axis[3]) {
  size_t cells = (size_t)g->width * g->height;
  double mean[3] = {0}, covariance[9] = {0}, values[3], vectors[9];
  for (size_t i = 0; i < cells; i++)
    for (size_t k = 0; k < 3; k++) mean[k] += (double)g->lab[3 * i + k] / (double)cells;
  for (size_t i = 0; i < cells; i++)
    for (size_t a = 0; a < 3; a++)
      for (size_t b = 0; b < 3; b++)
        covariance[3 * a + b] += ((double)g->lab[3 * i + a] - mean[a]) *
                                 ((double)g->lab[3 * i + b] - mean[b]) / (double)cells;
  symmetric_eigen(covariance, values, vectors);
  double sign = vectors[0] < 0 ? -1 : 1; /* towards the light */
  for (int k = 0; k < 3; k++) axis[k] = sign * vectors[3 * k];
}

/* The best 2-means of numbers in order: how many are below, and the separation. */
static size_t split(const ranked *r, size_t n, double *separation, double *out_apart) {
  double total = 0, squares = 0, sum = 0, best = -1;
  size_t at = 0;
  for (size_t i = 0; i < n; i++) {
    total += r[i].at;
    squares += r[i].at * r[i].at;
  }
  double spread = squares - total * total / (double)n, apart = 0;
  for (size_t i = 1; i < n; i++) {
    sum += r[i - 1].at;
    double low = sum / (double)i, high = (total - sum) / (double)(n - i);
    double between = (double)i * (double)(n - i) / (double)n * (high - low) * (high - low);
    if (between <= best) continue;
    best = between;
    apart = high - low;
    at = i;
  }
  double within = sqrt(fmax(spread - best, 1e-12) / (double)n);
  *separation = apart / within;
  *out_apart = fmax(apart, 1e-9);
  return at;
}

/* The most of a label's cells that hang together, as a share of them. */
static double largest_piece(const grid *g, uint8_t label, size_t *stack, uint8_t *seen) {
  size_t cells = (size_t)g->width * g->height, all = 0, most = 0;
  memset(seen, 0, cells);
  for (size_t s = 0; s < cells; s++) {
    if (g->label[s] != label || seen[s]) continue;
    size_t depth = 0, piece = 0;
    stack[depth++] = s;
    seen[s] = 1;
    while (depth) {
      size_t i = stack[--depth], x = i % g->width, y = i / g->width;
      const size_t next[4] = {x > 0 ? i - 1 : i, x + 1 < g->width ? i + 1 : i,
                              y > 0 ? i - g->width : i, y + 1 < g->height ? i + g->width : i};
      piece++;
      for (int k = 0; k < 4; k++)
        if (g->label[next[k]] == label && !seen[next[k]]) {
          seen[next[k]] = 1;
          stack[depth++] = next[k];
        }
    }
    all += piece;
    if (piece > most) most = piece;
  }
  return all ? (double)most / (double)all : 0;
}

/* How much of the difference lies between cells beside each other. at: every
 * cell's place on the axis. */
static double step_across(const grid *g, const float *at, double apart) {
  double sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < (size_t)g->width * g->height; i++) {
    const size_t next[2] = {i % g->width + 1 < g->width ? i + 1 : i,
                            i / g->width + 1 < g->height ? i + g->width : i};
    for (int k = 0; k < 2; k++) {
      if (g->label[i] == g->label[next[k]]) continue;
      sum += fabs((double)at[i] - (double)at[next[k]]);
      count++;
    }
  }
  return count ? sum / (double)count / apart : 0;
}

static void part_means(const grid *g, double mean[2][3], size_t count[2]) {
  memset(mean, 0, 6 * sizeof(double));
  count[0] = count[1] = 0;
  for (size_t i = 0; i < (size_t)g->width * g->height; i++) {
    count[g->label[i]]++;
    for (size_t k = 0; k < 3; k++) mean[g->label[i]][k] += (double)g->lab[3 * i + k];
  }
  for (int l = 0; l < 2; l++)
    for (int k = 0; k < 3; k++) mean[l][k] /= fmax(1, (double)count[l]);
}

static bool judge(regions *r, grid *g, failure *why) {
  size_t cells = (size_t)g->width * g->height;
  ranked *order = malloc(cells * sizeof *order);
  size_t *stack = malloc(cells * sizeof *stack);
  uint8_t *seen = malloc(cells);
  bool ok = order && stack && seen;
  if (ok) {
    double axis[3], mean[2][3], apart;
    size_t count[2];
    first_axis(g, axis);
    for (size_t i = 0; i < cells; i++) {
      order[i] = (ranked){0, i};
      for (size_t k = 0; k < 3; k++) order[i].at += axis[k] * (double)g->lab[3 * i + k];
      g->scratch[i] = (float)order[i].at;
    }
    qsort(order, cells, sizeof *order, by_place);
    size_t below = split(order, cells, &r->separation, &apart);
    for (size_t i = below; i < cells; i++) g->label[order[i].cell] = 1;
    part_means(g, mean, count);
    r->difference = ciede2000(mean[0], mean[1]);
    double lesser = (double)(count[0] < count[1] ? count[0] : count[1]) / (double)cells;
    r->two = r->separation >= LEAST_SEPARATION && r->difference >= LEAST_DIFFERENCE &&
             lesser >= LEAST_SHARE && step_across(g, g->scratch, apart) >= LEAST_STEP &&
             largest_piece(g, 0, stack, seen) >= LEAST_WHOLE &&
             largest_piece(g, 1, stack, seen) >= LEAST_WHOLE;
  }
  free(order);
  free(stack);
  free(seen);
  return ok || fail(why, EXIT_FAILURE, "out of memory");
}

/* ---- marking ------------------------------------------------------------------------ */

/* A cell beside one of the other part is on the border, and neither. */
static bool on_border(const grid *g, size_t i) {
  size_t x = i % g->width, y = i / g->width;
  return (x > 0 && g->label[i - 1] != g->label[i]) ||
         (x + 1 < g->width && g->label[i + 1] != g->label[i]) ||
         (y > 0 && g->label[i - g->width] != g->label[i]) ||
         (y + 1 < g->height && g->label[i + g->width] != g->label[i]);
}

static void mark(regions *r, const grid *g, photo *p) {
  uint64_t all = 0, parts[2] = {0, 0};
  for (uint32_t y = 0; y < p->height; y++)
    for (uint32_t x = 0; x < p->width; x++) {
      size_t i = (size_t)y * p->width + x, cell = cell_of(g, x, y);
      if (p->pixel[i] == PIXEL_OUT) continue;
      all++;
      if (on_border(g, cell)) {
        p->pixel[i] = PIXEL_OUT;
        continue;
      }
      parts[g->label[cell]]++;
      p->pixel[i] = g->label[cell] ? PIXEL_SECOND : PIXEL_PART;
    }
  r->share = (double)parts[0] / (double)all;
  r->second_share = (double)parts[1] / (double)all;
}

bool regions_find(regions *r, photo *p, const colour *c, failure *why) {
  memset(r, 0, sizeof *r);
  r->share = 1;
  grid g = {0};
  bool ok = grid_fill(&g, p, why);
  for (int i = 0; ok && i < BLURS; i++) blur(&g);
  size_t cells = (size_t)g.width * g.height;
  if (ok) divide(&g);
  ok = ok && appearance_lab(c, g.lab, cells, why) && judge(r, &g, why);
  if (ok && r->two) mark(r, &g, p);
  grid_free(&g);
  return ok;
}
