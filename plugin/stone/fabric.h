/* SPDX-License-Identifier: Apache-2.0
 *
 * The stone's own colour: the layers of cells under each footprint, and one laid over the other
 * with all that varies slowly.
 */
#ifndef SOZAI_STONE_FABRIC_H
#define SOZAI_STONE_FABRIC_H

#include "bands.h"
#include "bed.h"
#include "together.h"
#include "veins_seen.h"

/* From the lowest to what lies over all. */
static const int fabric_order[STONE_LAYERS] = {LAYER_GRAINS, LAYER_SPECKS, LAYER_INCLUSIONS,
                                               LAYER_HOLES};

/* Field by field: the rest is set later, and looked at by few. */
INLINE void stage_eye(const block *k, const cells_view *view, cells_seen *looks, cells_eye *e) {
  e->p = k->p;
  e->t1 = k->t1;
  e->t2 = k->t2;
  e->s = k->s;
  e->view = view;
  e->looks = looks;
  e->thirds = NULL;
  e->found = NULL;
  e->bends = NULL;
  e->nearest = splatu(0);
  e->sum = cells_none();
  e->third = splat(0.0f);
}

/* What a layer's bodies are found to be, for who asks how high they are; NULL: nobody does. */
INLINE cells_found *stage_found(const stone_constants *w, int layer, block *k) {
  if (layer == LAYER_HOLES) return &k->holes;
  return layer == LAYER_INCLUSIONS && w->raise != 0.0f ? &k->inclusions : NULL;
}

INLINE void stage_seen(const stone_constants *w, int layer, const cells_eye *e, block *k) {
  cells_found *found = stage_found(w, layer, k);
  vf third;
  eye_close(&w->layer[layer], e, &k->cover[layer], &third);
  if (layer == LAYER_INCLUSIONS) k->third = third;
  if (found) {
    found->bent = 1;
    found->met =
        e->view->once && e->found; /* where other blocks' looks were many, nobody kept it */
    found->fine = e->view->fine;
    found->wide = e->view->most;
  }
  if (layer != LAYER_GRAINS) return;
  k->crystal_known = e->view->once;
  k->crystal = e->nearest;
}

/* How the layers see a block's footprints, and those of the blocks after it that lie alike. */
typedef struct {
  cells_view view[STONE_LAYERS];
  int of[STONE_LAYERS]; /* the first such block, or -1 */
} fabric_views;

/* Blocks that lie alike follow each other: only the first of them opens the view. */
INLINE void stage_view(const stone_cells *c, const block *k, cells_view *view, int *of) {
  if (*of != k->alike) view_open(c, k->t1, k->t2, k->s, view);
  *of = k->alike;
}

/* What moss covers of each part of a footprint, as a layer's looks. */
STAGE void stage_moss(const stone_constants *w, int paved, block *k, cells_covered *seen) {
  laid_square square;
  stage_square(w, paved, k, &square);
  k->moss = surface_moss(w, paved, &k->laid, k->at, &square, k->s, seen);
  k->mossed = 1;
}

/* The covariances of what a layer covers with the layers below it. thirds: NULL, or what the looks
 * at that one saw of its third kind. */
INLINE void stage_mixed(block *k, int above, int below, const cells_grid *grid, const vf *covered,
                        const cells_seen *seen, const vf (*thirds)[CELLS_STEPS * CELLS_STEPS]) {
  if (!any(gt(grid->weight * seen->grid.weight, splat(0.0f)))) return;
  k->mixed[above] |= 1 << below;
  vf *with = k->with[pair_of(above, below)];
  seen_covariance(grid, covered, seen, with);
  vf *third = &k->with_third[above == OVER_MOSS];
  if (thirds) *third = seen_covariance_third(grid, covered, &seen->grid, thirds);
  if (above >= STONE_LAYERS) return;
  /* where it covers all it goes with nothing, to the bit: where it does to all lanes, what is below
   * is not looked at */
  vm part = lt(k->cover[above].of[0], splat(1.0f));
  for (int p = 0; p < CELLS_PARTS; p++) with[p] = sel(part, with[p], splat(0.0f));
  if (thirds) *third = sel(part, *third, splat(0.0f));
}

/* The layers, a bit to each, of which a footprint takes more than a look. mossy: who asks for the
 * colour asks for what lies on it, too. */
STAGE void stage_looks(const stone_constants *w, int paved, int mossy, int layers,
                       fabric_views *views, block *k) {
  cells_seen seen[STONE_LAYERS];
  cells_covered moss;
  vf thirds[1][CELLS_STEPS * CELLS_STEPS];
  const int third = w->layer[LAYER_INCLUSIONS].third > 0.0f;
  if (mossy) stage_moss(w, paved, k, &moss);
  for (int n = k->hidden; n < STONE_LAYERS; n++) {
    int l = fabric_order[n];
    if (!(layers >> l & 1)) continue;
    const stone_cells *c = &w->layer[l];
    cells_eye e;
    stage_view(c, k, &views->view[l], &views->of[l]);
    stage_eye(k, &views->view[l], &seen[l], &e);
    const vf(*its)[CELLS_STEPS * CELLS_STEPS] = NULL;
    if (third && l == LAYER_INCLUSIONS) {
      e.thirds = thirds[0];
      its = thirds;
    }
    eye_look_about(c, &e);
    stage_seen(w, l, &e, k);
    for (int m = k->hidden; m < n; m++) {
      int below = fabric_order[m];
      if (!(layers >> below & 1)) continue;
      stage_mixed(k, l, below, &seen[l].grid, seen[l].of[0], &seen[below],
                  third && below == LAYER_INCLUSIONS ? thirds : NULL);
    }
    if (mossy) stage_mixed(k, OVER_MOSS, l, &moss.grid, moss.of, &seen[l], its);
  }
}

/* Whether no one asks for what lies under a layer's bodies. The relief of inclusions takes their
 * share wherever they are, under a hole, too. */
INLINE int stage_hides(const stone_constants *w, int layer) {
  const stone_cells *c = &w->layer[layer];
  return c->shaped && c->opacity == 1.0f && (layer != LAYER_HOLES || w->raise == 0.0f);
}

/* Layer n from below, over all of the blocks where it can; else 0. What it covers to the last
 * of the footprints is not looked at any more. */
STAGE int stage_layer(const stone_constants *w, int n, block *blocks, int count) {
  int l = fabric_order[n], once = 1, idle = 1, seen = 0;
  const stone_cells *c = &w->layer[l];
  cells_view views[STONE_BLOCKS];
  int viewed = -1;
  cells_eye eyes[STONE_BLOCKS];
  block *of[STONE_BLOCKS];
  /* what tells that a layer is wide is mostly the first block, and stage_looks opens that
   * one's view again: all layers' views would not stay near */
  for (int b = 0; b < count && (once || idle); b++) {
    if (n < blocks[b].hidden) continue;
    block *k = &blocks[b];
    cells_view *view = &views[k->alike];
    stage_view(c, k, view, &viewed);
    once &= view->once;
    idle &= view->idle;
    cells_eye *e = &eyes[seen];
    of[seen++] = k;
    stage_eye(k, view, NULL, e);
    e->found = stage_found(w, l, k);
    if (c->bends_shared) e->bends = &k->bends;
  }
  if (!once && !idle) return 0;
  if (once && seen) eyes_look(c, eyes, seen);
  const int hides = stage_hides(w, l);
  for (int b = 0; b < seen; b++) {
    stage_seen(w, l, &eyes[b], of[b]);
    int all = hides && !any(lt(of[b]->cover[l].of[0], splat(1.0f)));
    if (!all || n <= of[b]->hidden) continue;
    of[b]->hidden = n;
    for (int m = 0; m < n; m++) {
      of[b]->cover[fabric_order[m]] = cells_none();
      if (fabric_order[m] == LAYER_INCLUSIONS) of[b]->third = splat(0.0f);
    }
  }
  return 1;
}

/* The layers of cells, from the uppermost down. */
STAGE void stage_cells(const stone_constants *w, int paved, int mossy, block *blocks, int count) {
  int wide = 0;
  for (int b = 0; b < count; b++) {
    blocks[b].hidden = 0;
    for (int l = 0; l < STONE_LAYERS; l++) blocks[b].mixed[l] = 0;
  }
  for (int n = STONE_LAYERS - 1; n >= 0; n--) {
    int l = fabric_order[n];
    if (w->layer[l].on && !stage_layer(w, n, blocks, count)) wide |= 1 << l;
  }
  if (!wide) return;
  fabric_views views;
  for (int l = 0; l < STONE_LAYERS; l++) views.of[l] = -1;
  for (int b = 0; b < count; b++) stage_looks(w, paved, mossy, wide, &views, &blocks[b]);
}

/* What has been laid so far, for what is laid over it. */
typedef struct {
  int mixes; /* whether any layer covers another unevenly */
  int count, layer[STONE_LAYERS + 1], colour[STONE_LAYERS + 1][2];
  vf cover[STONE_LAYERS + 1], under[STONE_LAYERS + 1][3]; /* and what it was laid over */
  vf grains[CELLS_PARTS][3];                              /* the crystals' colours */
} fabric_stack;

/* The covariance of what a layer covers with the colour below it. */
INLINE void fabric_with(const stone_constants *w, const fabric_stack *o, const block *k, int layer,
                        vf out[3]) {
  vf one = splat(1.0f), zero = splat(0.0f);
  for (int c = 0; c < 3; c++) out[c] = zero;
  for (int p = 0; p < CELLS_PARTS && (k->mixed[layer] >> LAYER_GRAINS & 1); p++) {
    for (int c = 0; c < 3; c++)
      out[c] = out[c] + k->with[pair_of(layer, LAYER_GRAINS)][p] * o->grains[p][c];
  }
  for (int n = 0; n < o->count; n++) {
    for (int c = 0; c < 3; c++) out[c] = out[c] * (one - o->cover[n]);
    if (!(k->mixed[layer] >> o->layer[n] & 1)) continue;
    const vf *both = k->with[pair_of(layer, o->layer[n])];
    vf with[CELLS_PARTS];
    const vf opacity = splat(w->layer[o->layer[n]].opacity);
    for (int p = 0; p < CELLS_PARTS; p++) with[p] = both[p] * opacity;
    for (int c = 0; c < 3; c++) {
      out[c] = out[c] + with[1] * splat(w->colour[o->colour[n][0]][c]) +
               with[2] * splat(w->colour[o->colour[n][1]][c]) - with[0] * o->under[n][c];
    }
    if (o->layer[n] != LAYER_INCLUSIONS || w->layer[LAYER_INCLUSIONS].third <= 0.0f) continue;
    const vf third = k->with_third[layer == OVER_MOSS] * opacity;
    for (int c = 0; c < 3; c++)
      out[c] = out[c] + third * splat(w->colour[COLOUR_INCLUSION_THIRD][c]);
  }
}

/* The same of what shows specks: what lies between hides of it what it hides of them. */
INLINE vf fabric_with_specks(const fabric_stack *o, const block *k, int layer) {
  if (!(k->mixed[layer] >> LAYER_SPECKS & 1)) return splat(0.0f);
  vf out = k->with[pair_of(layer, LAYER_SPECKS)][0];
  for (int n = 0; n < o->count; n++)
    if (o->layer[n] != LAYER_SPECKS) out = out * (splat(1.0f) - o->cover[n]);
  return out;
}

INLINE void fabric_add(fabric_stack *o, int layer, int first, int second, vf cover,
                       const vf under[3]) {
  if (!o->mixes) return;
  int n = o->count++;
  o->layer[n] = layer;
  o->colour[n][0] = first;
  o->colour[n][1] = second;
  o->cover[n] = cover;
  for (int c = 0; c < 3; c++) o->under[n][c] = under[c];
}

INLINE float fabric_least(float a, float b) {
  float least = a < b ? a : b;
  return least < 0.0f ? least : 0.0f;
}

/* The darkest that a layer's kinds may mix to: no darker than black, but for what a palette has
 * below that. */
INLINE float fabric_darkest(const stone_constants *w, int layer, int first, int second, int c) {
  float least = fabric_least(w->colour[first][c], w->colour[second][c]);
  if (w->layer[layer].third <= 0.0f) return least;
  return fabric_least(least, w->colour[COLOUR_INCLUSION_THIRD][c]);
}

/* Two colours of the palette, by their shares, over a part of what is there: that part, which
 * hides what is below as far as the layer is opaque. */
INLINE vf lay_over(const stone_constants *w, int layer, int first, int second, fabric_stack *o,
                   block *k) {
  vf one = splat(1.0f), zero = splat(0.0f), with[3] = {zero, zero, zero};
  const cells_cover *q = &k->cover[layer];
  const vf opacity = splat(w->layer[layer].opacity);
  int mixed = k->mixed[layer];
  vf cover = vmin(q->of[0], one), hides = cover * opacity;
  vf own[2] = {q->of[1] * opacity, q->of[2] * opacity}, specks = fabric_with_specks(o, k, layer);
  if (mixed) fabric_with(w, o, k, layer, with);
  fabric_add(o, layer, first, second, hides, k->albedo);
  for (int c = 0; c < 3; c++) {
    k->albedo[c] = k->albedo[c] * (one - hides) + own[0] * splat(w->colour[first][c]) +
                   own[1] * splat(w->colour[second][c]);
    if (w->layer[layer].third > 0.0f)
      k->albedo[c] =
          k->albedo[c] + k->third * opacity * splat(w->colour[COLOUR_INCLUSION_THIRD][c]);
    if (w->layer[layer].mixing > 0.0f)
      k->albedo[c] = vmax(k->albedo[c], splat(fabric_darkest(w, layer, first, second, c)));
    if (mixed) k->albedo[c] = vmax(k->albedo[c] - with[c] * opacity, vmin(k->albedo[c], zero));
  }
  k->speck = k->speck * (one - hides);
  if (mixed >> LAYER_SPECKS & 1) k->speck = vmax(k->speck - specks * opacity, zero);
  return cover;
}

/* From the layers' shares, and all that varies slowly, to the colour. */
STAGE void stage_fabric(const stone_constants *w, block *k) {
  vf zero = splat(0.0f), one = splat(1.0f), bed = zero, shift = one;
  fabric_stack over;
  over.count = over.mixes = 0;
  for (int l = 0; l < STONE_COVERS; l++) over.mixes |= k->mixed[l];
  k->speck = k->hole = k->inclusion = zero;
  const int seen = !k->hidden, veins = k->hidden < STONE_LAYERS - 1;
  if (w->has_beds && seen) bed = splat(w->bed_contrast) * bed_share(w, k->p, k->nrm, k->s);
  if (w->has_mottle && seen) shift = one + mottle_shift(w, k->p, k->t1, k->t2, k->s);
  for (int c = 0; c < 3; c++) {
    vf base = splat(w->colour[COLOUR_BASE][c]);
    if (w->has_beds) base = mix(base, splat(w->colour[COLOUR_BED][c]), bed);
    if (over.mixes) {
      over.grains[0][c] = base * shift;
      over.grains[1][c] = splat(w->colour[COLOUR_SECOND][c]) * shift;
      over.grains[2][c] = splat(w->colour[COLOUR_THIRD][c]) * shift;
    }
    if (w->layer[LAYER_GRAINS].on) {
      const vf *toned = k->cover[LAYER_GRAINS].of;
      base = toned[0] * base + toned[1] * splat(w->colour[COLOUR_SECOND][c]) +
             toned[2] * splat(w->colour[COLOUR_THIRD][c]);
    }
    k->albedo[c] = base * shift;
  }
  if (w->layer[LAYER_SPECKS].on) {
    k->speck = lay_over(w, LAYER_SPECKS, COLOUR_BLACK, COLOUR_WHITE, &over, k);
    k->speck = vmax(k->speck, zero); /* a mean is a difference, and rounds to less than nothing */
  }
  if (w->layer[LAYER_INCLUSIONS].on)
    k->inclusion =
        lay_over(w, LAYER_INCLUSIONS, COLOUR_INCLUSION, COLOUR_INCLUSION_SECOND, &over, k);
  if (w->has_veins && veins) {
    vf v = vmin(vein_share(w, k->p, k->t1, k->t2, k->s), one);
    fabric_add(&over, OVER_VEINS, COLOUR_VEIN, COLOUR_VEIN, v, k->albedo);
    for (int c = 0; c < 3; c++)
      k->albedo[c] = mix(k->albedo[c], splat(w->colour[COLOUR_VEIN][c]), v);
    k->speck = k->speck * (one - v);
  }
  if (w->layer[LAYER_HOLES].on)
    k->hole = lay_over(w, LAYER_HOLES, COLOUR_HOLE, COLOUR_HOLE, &over, k);
  if (k->mixed[OVER_MOSS]) fabric_with(w, &over, k, OVER_MOSS, k->moss_hides);
  k->moss_hides_specks = fabric_with_specks(&over, k, OVER_MOSS);
}

#endif
