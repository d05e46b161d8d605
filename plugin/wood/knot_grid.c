/* SPDX-License-Identifier: Apache-2.0
 *
 * Where knots are: cells of the log that list those near them, parts of cells that
 * say whether there is any, and the shares of knots in larger and larger cells.
 */
#include "knot_grid.h"

#include <string.h>

#include "../core/meter.h"
#include "../core/scalar.h"
#include "../core/status.h"

/* ---- the grid ---------------------------------------------------------- */

typedef struct {
  wood_knots *all;
  int32_t *stamp; /* of each cell: the last knot put into it, + 1 */
  int32_t *fill;  /* counting: how many; then where the next goes */
  int writing, wide;
} grid_pen;

static void put_cell(grid_pen *g, int32_t x, int32_t y, int32_t z, int32_t knot) {
  int level = g->wide ? KNOT_COARSE : 0;
  int32_t across = g->all->far_across[level], tall = g->all->far_tall[level];
  if (x < 0 || z < 0 || x >= across || z >= across) return;
  y %= tall;
  if (y < 0) y += tall;
  int32_t cell = (y * across + z) * across + x;
  if (g->stamp[cell] == knot + 1) return;
  g->stamp[cell] = knot + 1;
  if (g->writing) g->all->index[g->fill[cell]] = knot;
  g->fill[cell]++;
}

/* Every cell that holds a point so near to the axis. */
static void put_knot(grid_pen *g, int32_t n) {
  const wood_knot *k = &g->all->list[n];
  int level = g->wide ? KNOT_COARSE : 0;
  double per_mm = (double)g->all->inverse_cell * (double)g->all->far_scale[level];
  double tall = g->all->far_tall[level] * (double)g->all->inverse_period, step = 0.5 / per_mm;
  double sees = (double)k->sees + 1.5 * (double)(g->wide ? KNOT_FAR : KNOT_NEAR);
  double far = !g->wide && (double)k->bends > sees ? (double)k->bends : sees;
  double before = g->wide ? (double)KNOT_FAR : 0.0;
  double side = 1.12 * far + step, rise = side / (double)k->cosine;
  for (double u = -before; u < (double)k->reach + before + step; u += step) {
    double x = u * (double)k->c - (double)g->all->low, z = u * (double)k->s - (double)g->all->low;
    double y = (double)k->height + u * (double)k->slope, up = rise + step * (double)k->slope;
    if (k->slope < 0.0f) up = rise - step * (double)k->slope;
    int32_t x0 = scalar_floor((x - side) * per_mm), x1 = scalar_floor((x + side) * per_mm);
    int32_t z0 = scalar_floor((z - side) * per_mm), z1 = scalar_floor((z + side) * per_mm);
    int32_t y0 = scalar_floor((y - up) * tall - 0.01), y1 = scalar_floor((y + up) * tall + 0.01);
    if (y1 - y0 >= g->all->far_tall[level]) y1 = y0 + g->all->far_tall[level] - 1;
    for (int32_t j = y0; j <= y1; j++) {
      for (int32_t i = z0; i <= z1; i++) {
        for (int32_t h = x0; h <= x1; h++) put_cell(g, h, j, i, n);
      }
    }
  }
}

/* Every part of a cell that holds a point which the knot has to do with. */
static void put_parts(wood_knots *all, int32_t *parts, double footprint, const wood_knot *k) {
  double per_mm = 4.0 * (double)all->inverse_cell, step = 1.0 / per_mm;
  double per_rise = 2.0 * (double)all->tall * (double)all->inverse_period;
  int32_t across = 4 * all->across, tall = 2 * all->tall;
  /* a section is oblong by up to 0.93 of d; and a hair for what floats are off by */
  double sees = 1.09 * ((double)k->sees + 0.75 * footprint);
  double side = __builtin_sqrt((double)k->near), rise = 2.0 * side;
  side = (side > sees ? side : sees) + 0.3;
  rise = (rise > sees ? rise : sees) + 0.3;
  double c = (double)k->c, s = (double)k->s, slope = (double)k->slope;
  double wide_x = side * __builtin_fabs(s) + 0.5 * step * __builtin_fabs(c);
  double wide_z = side * __builtin_fabs(c) + 0.5 * step * __builtin_fabs(s);
  double high = rise / (double)k->cosine + 0.5 * step * __builtin_fabs(slope);
  /* a wide footprint looks past the pith, and past the knot's end */
  double past = footprint > (double)KNOT_CLOSE ? (double)KNOT_FAR : 0.0;
  for (double u = -past; u < (double)k->reach + past + step; u += step) {
    double x = u * c - (double)all->low, z = u * s - (double)all->low;
    double y = (double)k->height + u * slope;
    int32_t x0 = scalar_floor((x - wide_x) * per_mm), x1 = scalar_floor((x + wide_x) * per_mm);
    int32_t z0 = scalar_floor((z - wide_z) * per_mm), z1 = scalar_floor((z + wide_z) * per_mm);
    int32_t y0 = scalar_floor((y - high) * per_rise - 0.01),
            y1 = scalar_floor((y + high) * per_rise + 0.01);
    if (y1 - y0 >= tall) y1 = y0 + tall - 1;
    if (x0 < 0) x0 = 0;
    if (z0 < 0) z0 = 0;
    if (x1 >= across) x1 = across - 1;
    if (z1 >= across) z1 = across - 1;
    for (int32_t j = y0; j <= y1; j++) {
      int32_t up = j % tall;
      if (up < 0) up += tall;
      for (int32_t i = z0; i <= z1; i++) {
        for (int32_t h = x0; h <= x1; h++) {
          int32_t cell = ((up >> 1) * all->across + (i >> 2)) * all->across + (h >> 2);
          uint32_t bit = (uint32_t)((h & 3) | (i & 3) << 2 | (up & 1) << 4);
          parts[cell] = (int32_t)((uint32_t)parts[cell] | 1u << bit);
        }
      }
    }
  }
}

/* Both of the lists: of effects, and of what a wide footprint sees. */
static void put_all(grid_pen *g, int writing) {
  size_t cells = (size_t)g->all->cells;
  g->writing = writing;
  int32_t *fill = g->fill;
  for (g->wide = 0; g->wide < 2; g->wide++, g->fill += cells + 1) {
    memset(g->stamp, 0, cells * sizeof *g->stamp);
    for (uint32_t i = 0; i < g->all->count; i++) put_knot(g, (int32_t)i);
  }
  g->fill = fill;
}

/* ---- shares of knots in large cells ------------------------------------- */

static void put_share(wood_knots *all, double x, double y, double z, double volume) {
  double per_mm = (double)all->inverse_cell, tall = (double)all->tall / (double)all->period;
  int32_t ix = scalar_floor((x - (double)all->low) * per_mm);
  int32_t iz = scalar_floor((z - (double)all->low) * per_mm),
          iy = scalar_floor(y * tall) % all->tall;
  if (ix < 0 || iz < 0 || ix >= all->across || iz >= all->across) return;
  if (iy < 0) iy += all->tall;
  all->far[(iy * all->across + iz) * all->across + ix] += (float)(volume * per_mm * per_mm * tall);
}

static void far_knot(wood_knots *all, const wood_knot *k) {
  enum { PARTS = 7 }; /* of its section: the middle and six about it */
  double q = (double)k->q,
         end = (double)k->end < (double)k->reach ? (double)k->end : (double)k->reach;
  for (double u = 1.0; u < end; u += 2.0) {
    double front = u < (double)k->death ? u : (double)k->death;
    double tau = (front - (double)k->born) / (double)k->length;
    if (tau <= 0.0) continue;
    double e = 2.0 * tau / (1.0 - q + __builtin_sqrt((1.0 - q) * (1.0 - q) + 4.0 * q * tau));
    double radius = (double)k->radius * e, away = 0.7 * radius;
    double round = (double)k->round * radius;
    double volume = PI * round * round / (double)k->upright * 2.0 / (double)k->cosine / PARTS;
    for (int i = 0; i < PARTS; i++) {
      double a = i ? away * scalar_cos(i * PI / 3.0) : 0.0;
      double h = i ? away * scalar_sin(i * PI / 3.0) : 0.0;
      put_share(all, u * (double)k->c - a * (double)k->s,
                (double)k->height + u * (double)k->slope + h / (double)k->cosine,
                u * (double)k->s + a * (double)k->c, volume);
    }
  }
}

static void average_levels(wood_knots *all) {
  for (int l = 1; l < KNOT_LEVELS; l++) {
    const float *fine = all->far + all->far_first[l - 1];
    float *coarse = all->far + all->far_first[l];
    int32_t n = all->far_across[l], m = all->far_across[l - 1];
    for (int32_t y = 0; y < all->far_tall[l]; y++) {
      for (int32_t z = 0; z < n; z++) {
        for (int32_t x = 0; x < n; x++) {
          float sum = 0.0f;
          for (int i = 0; i < 8; i++) {
            int32_t fx = 2 * x + (i & 1), fy = 2 * y + (i >> 1 & 1), fz = 2 * z + (i >> 2);
            sum += fine[(fy * m + fz) * m + fx];
          }
          coarse[(y * n + z) * n + x] = 0.125f * sum;
        }
      }
    }
  }
}

/* ---- the whole ---------------------------------------------------------- */

/* Cells of about 40 mm, a whole number of the largest level's to each side. */
static void lay_out(wood_knots *all, const wood_knot *list, double height) {
  enum { STEP = 1 << (KNOT_LEVELS - 1) };
  double reach = 0.0, top = height;
  for (uint32_t i = 0; i < all->count; i++) {
    double r = (double)list[i].reach + (double)list[i].bends;
    if (r > reach) reach = r;
  }
  if (top < 1000.0) top = 1000.0;
  int blocks = (int)(2.0 * reach / (36.0 * STEP));
  blocks = blocks < 1 ? 1 : blocks > 3 ? 3 : blocks;
  double cell = 2.0 * reach / (blocks * STEP);
  int tall = (int)(top / (cell * STEP)) + 1;
  if (tall > 64) tall = 64;
  all->across = blocks * STEP;
  all->tall = tall * STEP;
  all->cells = all->across * all->across * all->tall;
  all->low = (float)-reach;
  all->inverse_cell = (float)(1.0 / cell);
  all->period = (float)top;
  all->inverse_period = (float)(1.0 / (double)all->period);
  int32_t first = 0;
  for (int l = 0; l < KNOT_LEVELS; l++) {
    all->far_first[l] = first;
    all->far_across[l] = all->across >> l;
    all->far_tall[l] = all->tall >> l;
    all->far_scale[l] = 1.0f / (float)(1 << l);
    int32_t cells = all->far_across[l] * all->far_across[l] * all->far_tall[l];
    if (l == KNOT_COARSE) all->coarse = cells;
    first += cells;
  }
}

static size_t far_count(const wood_knots *all) {
  const int last = KNOT_LEVELS - 1;
  return (size_t)(all->far_first[last] +
                  all->far_across[last] * all->far_across[last] * all->far_tall[last]);
}

/* Of both lists, and after each a cell without any. */
static size_t cell_count(const wood_knots *all) {
  return (size_t)all->cells + 1 + (size_t)all->coarse + 1;
}

static size_t part_count(const wood_knots *all) { return (size_t)all->cells + 1; }

/* One block of memory: the head, the list, the cells, what is in them. */
static size_t block_bytes(const wood_knots *plan, size_t entries) {
  return sizeof *plan + plan->count * sizeof(wood_knot) +
         (cell_count(plan) + 1 + entries + 1 + 2 * part_count(plan)) * sizeof(int32_t) +
         far_count(plan) * sizeof(float);
}

static wood_knots *gather_block(const wood_knots *plan, const sozai_host *host,
                                const wood_knot *list, size_t entries) {
  size_t list_bytes = plan->count * sizeof *list, cells = cell_count(plan) + 1;
  size_t bytes = block_bytes(plan, entries);
  wood_knots *all = host_alloc(host, bytes, 64);
  if (!all) return NULL;
  *all = *plan;
  all->bytes = bytes;
  all->list = (wood_knot *)(all + 1);
  memcpy(all->list, list, list_bytes);
  all->first = (int32_t *)(all->list + plan->count);
  all->index = all->first + cells;
  all->parts[0] = all->index + entries + 1;
  all->parts[1] = all->parts[0] + part_count(plan);
  memset(all->parts[0], 0, 2 * part_count(plan) * sizeof(int32_t));
  all->far = (float *)(all->parts[1] + part_count(plan));
  memset(all->far, 0, far_count(plan) * sizeof(float));
  all->index[entries] = INT32_MAX;
  return all;
}

static int32_t fill_grid(wood_knots **out, const wood_knots *plan, const sozai_host *host,
                         wood_knot *list) {
  size_t cells = cell_count(plan);
  size_t bytes = (cells + (size_t)plan->cells) * sizeof(int32_t);
  wood_knots counting = *plan, *all;
  int32_t *work = host_alloc(host, bytes, 64);
  if (!work) return SOZAI_ERROR_MEMORY;
  counting.list = list;
  grid_pen g = {&counting, work + cells, work, 0, 0};
  memset(g.fill, 0, cells * sizeof *g.fill);
  put_all(&g, 0);
  size_t entries = 0;
  for (size_t i = 0; i < cells; i++) entries += (size_t)g.fill[i];
  if (host_rehearses(host)) {
    int32_t r = host_claim(host, block_bytes(plan, entries));
    host_free(host, work, bytes, 64);
    return r;
  }
  all = gather_block(plan, host, list, entries);
  if (all) {
    int32_t at = 0;
    for (size_t i = 0; i < cells; i++) {
      all->first[i] = at;
      at += g.fill[i];
      g.fill[i] = all->first[i];
    }
    all->first[cells] = at;
    g.all = all;
    put_all(&g, 1);
    for (uint32_t i = 0; i < all->count; i++) {
      put_parts(all, all->parts[0], (double)KNOT_CLOSE, &all->list[i]);
      put_parts(all, all->parts[1], 2.0 * (double)KNOT_NEAR, &all->list[i]);
      far_knot(all, &all->list[i]);
    }
    average_levels(all);
  }
  host_free(host, work, bytes, 64);
  *out = all;
  return all ? SOZAI_OK : SOZAI_ERROR_MEMORY;
}

int32_t knot_grid_make(wood_knots **out, wood_knots *plan, const sozai_host *host, wood_knot *list,
                       double height) {
  lay_out(plan, list, height);
  return fill_grid(out, plan, host, list);
}
