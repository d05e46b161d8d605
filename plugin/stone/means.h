/* SPDX-License-Identifier: Apache-2.0
 *
 * Means of what has no formula, by the kernel's own functions, as a texture is created.
 */
#ifndef SOZAI_STONE_MEANS_H
#define SOZAI_STONE_MEANS_H

#include "../core/measure.h"
#include "paper.h"
#include "surface.h"
#include "veins_seen.h"

#define MEASURED_EXTENT 512.0f /* large to everything */

/* What bodies fill, what of it is not rim, and what the widest looks see. */
static void measure_layer(const stone_cells *c, uint32_t count, double *fill, double *core,
                          double *seen) {
  const vf zero = splat(0.0f), one = splat(1.0f), side = splat(CELLS_LOOK_MOST);
  const cells_square point = {{zero, zero, zero}, {zero, zero, zero}};
  const cells_square look = {{side, zero, zero}, {zero, side, zero}};
  const vm all = le(zero, zero), body[2] = {all, all};
  const cells_parts one_part = cells_part(zero, c->whole), quarters = cells_part(side, c->whole);
  for (uint32_t i = 0; i < count; i += LANES) {
    vf q[3], share[3], inner[3];
    cells_near near[3];
    for (uint32_t a = 0; a < 3; a++) q[a] = measure_place(i, a, MEASURED_EXTENT);
    cells_find(c, 0, 1, q, near);
    cells_shares(c, near, body, &point, &one_part, 0, zero, share, inner);
    measure_add(fill, share[0] + share[1]);
    measure_add(core, inner[0] + inner[1]);
    cells_shares(c, near, body, &look, &quarters, 1, one, share, inner);
    measure_add(seen, share[0] + share[1]);
  }
  *fill /= count;
  *core /= count;
  *seen /= count;
}

/* Of a layer of whose cells all have bodies, and unbent. fill: what these fill. */
static void measure_domes(const stone_cells *c, uint32_t count, double fill, stone_means *out) {
  const height_form form = {.cells = c, .dome = 1};
  const vf zero = splat(0.0f), step = splat(0.01f), per = splat(100.0f);
  const vf by[3][3] = {{zero, zero, zero}, {step, zero, zero}, {zero, step, zero}};
  const vm all = le(zero, zero);
  double filled = fill * count;
  for (uint32_t i = 0; i < count; i += LANES) {
    vf q[3], h[3] = {zero, zero, zero};
    cells_near near[3] = {0};
    for (uint32_t a = 0; a < 3; a++) q[a] = measure_place(i, a, MEASURED_EXTENT);
    cells_find(c, 0, 0, q, near);
    height_of(&form, &near[0], &near[1], &near[2], all, 3, by, h);
    vf dx = (h[1] - h[0]) * per, dy = (h[2] - h[0]) * per;
    for (uint32_t k = 0; k < LANES; k++) {
      int bin = (int)(lane(h[0], k) * (float)DOME_BINS);
      if (lane(h[0], k) > 0.0f) out->dome_high[bin < DOME_BINS ? bin : DOME_BINS - 1]++;
    }
    measure_add(&out->dome, h[0]);
    measure_add(&out->dome_square, h[0] * h[0]);
    measure_add(&out->dome_steep2, splat(0.5f) * (dx * dx + dy * dy));
  }
  if (filled <= 0.0) filled = 1.0;
  for (int b = 0; b < DOME_BINS; b++) out->dome_high[b] /= filled;
  out->dome /= filled;
  out->dome_square /= filled;
  out->dome_steep2 /= filled * (double)c->size * (double)c->size;
}

#define VEIN_BLUR 0.2f /* of the spacing */

/* Of veins whose borders are so soft that many places have some, and which take as much. */
static void measure_veins(const stone_constants *w, uint32_t count, stone_means *out) {
  const vf none[3] = {splat(0.0f), splat(0.0f), splat(0.0f)};
  const int families = vein_families(w);
  const float spacing = 1.0f / w->vein_frequency;
  stone_constants soft = *w;
  if (soft.vein_soft < VEIN_BLUR * spacing) soft.vein_soft = VEIN_BLUR * spacing;
  for (uint32_t i = 0; i < count; i += LANES) {
    vf p[3];
    for (uint32_t a = 0; a < 3; a++) p[a] = measure_place(i, a, MEASURED_EXTENT) * splat(spacing);
    vein_fold fold = vein_folded(&soft, p);
    for (int f = 0; f < families; f++)
      measure_add(&out->veins[f], vein_family_share(&soft, p, none, none, &fold, f));
  }
  for (int f = 0; f < families; f++) out->veins[f] /= count;
}

static void measure(const stone_constants *w, uint32_t count, stone_means *out) {
  memset(out, 0, sizeof *out);
  for (int l = 0; l < STONE_LAYERS; l++) {
    const stone_cells *c = &w->layer[l];
    if (c->on && c->shaped) measure_layer(c, count, &out->fill[l], &out->core[l], &out->seen[l]);
  }
  if (w->raise != 0.0f)
    measure_domes(&w->layer[LAYER_INCLUSIONS], count, out->fill[LAYER_INCLUSIONS], out);
  if (w->has_veins) measure_veins(w, count, out);
}

/* Means over twenty metres of paving, of its edges and moss alone. */
static void measure_laid(const stone_constants *w, uint32_t count, stone_laid_means *out) {
  const vf zero = splat(0.0f), p2 = zero, one = splat(1.0f);
  const vf x[3] = {one, zero, zero}, y[3] = {zero, one, zero};
  const laid_square square = {{{one, zero, zero}, {zero, one, zero}}, NULL};
  memset(out, 0, sizeof *out);
  if (w->paving.layout.kind == LAYOUT_NONE) return;
  for (uint32_t i = 0; i < count; i += LANES) {
    vf p[3] = {measure_place(i, 0, MEASURED_EXTENT) * splat(40.0f),
               measure_place(i, 1, MEASURED_EXTENT) * splat(40.0f), p2};
    laid q;
    laid_at(w, p, NULL, x, y, zero, &q);
    surface f = surface_none();
    surface_lay(w, 1, &q, p, &square, zero, field_of(zero), NULL, &f);
    vf lost, slope;
    laid_round round = surface_round(w, &q, p, zero);
    field profile = laid_profile(&w->paving, &q, &round, &lost);
    slope = profile.g[0] * profile.g[0] + profile.g[1] * profile.g[1];
    measure_add(&out->height, profile.v);
    measure_add(&out->slope2, slope * splat(0.5f));
    measure_add(&out->occlusion, f.occlusion);
    measure_add(&out->moss, f.moss);
  }
  out->height /= count;
  out->slope2 /= count;
  out->occlusion /= count;
  out->moss /= count;
}

static void scan_tile(const stone_constants *w, paper_scanned *out) {
  const stone_tile *t = &w->tile;
  const vf one = splat(1.0f);
  uint32_t count = (uint32_t)(t->tile[0] * t->tile[1]), stones = 0;
  uint32_t across = (uint32_t)t->tile[0];
  memset(out, 0, sizeof *out);
  vu seed = splatu(w->seed ^ 0x27d4eb2fu);
  for (uint32_t i = 0; i < count; i += LANES) {
    vf x = splat(0.0f), y = x;
    for (uint32_t k = 0; k < LANES; k++) {
      set_lane(&x, k, (float)((i + k) % across));
      set_lane(&y, k, (float)((i + k) / across));
    }
    tile_place q = tile_at(t, x, y);
    vf h = tile_height(t, seed, x, y, one);
    for (uint32_t k = 0; k < LANES && i + k < count; k++) {
      if (lane(q.depth, k) <= 0.0f) continue;
      stones++;
      double z = (double)lane(h, k);
      out->mean += z;
      if (lane(q.depth, k) >= t->repair && z > out->highest) out->highest = z;
    }
  }
  out->joint = 1.0 - (double)stones / count;
  out->mean /= stones ? stones : 1;
  if (out->highest <= 0.0) out->highest = 256.0;
}

#endif
