/* SPDX-License-Identifier: Apache-2.0
 *
 * Layer by layer: strands over what is below them.
 */
#ifndef SOZAI_FIBERTEX_LAYERS_H
#define SOZAI_FIBERTEX_LAYERS_H

#include "block.h"

/* A layer's strands over what is below them; direction: in the ground's frame. Of what has two
 * colours the first has all of it until the layers are through (stage_deep). */
INLINE void compose(const fibertex_constants *w, const fibertex_layer *c, block *k,
                    const lane_hit *q, vf bend, const vf direction[2], vf level, int woven,
                    int wants) {
  const int light = wants & WANTS_LIGHT;
  sums *sum = &k->sum;
  const vf zero = splat(0.0f);
  vf strand = sum->left * q->cover, share = strand + sum->left * q->mean;
  vf shaded = sum->left * k->shade;
  vf bright = shaded * (q->cover * q->bright); /* 1 is their mean */
  sum->left = sum->left - share;
  vf all = bright + shaded * q->dim[0], ambient = splat(c->ambient), lit = k->lit;
  sum->albedo[0] = sum->albedo[0] + all * ambient;
  sum->depth = sum->depth + share * level;
  if (w->second_chance) {
    vf of = sel(lane_first(w, q->id), zero, bright);
    vf second = of + shaded * q->dim[1];
    sum->albedo[1] = sum->albedo[1] + second * ambient;
    if (light) sum->direct[1] = sum->direct[1] + second * lit;
  }
  if (light) {
    vf reached = all * lit;
    sum->direct[0] = sum->direct[0] + reached;
    k->best.lit = sel(gt(share, k->most), reached, k->best.lit);
    k->lit = lit * k->step[0];
    k->step[0] = k->step[0] * k->step[1];
  }
  k->shade = k->shade - k->shade * (splat(w->contact) * q->soft);
  if (!(wants & WANTS_STRAND)) return;
  vm more = gt(share, k->most);
  k->next = vmax(k->next, vmin(share, k->most));
  k->most = vmax(share, k->most);
  k->best.id = selu(more, q->id, k->best.id);
  for (int i = 0; i < 2; i++) {
    k->best.direction[i] = sel(more, direction[i], k->best.direction[i]);
  }
  k->best.slope = sel(more, q->slope, k->best.slope);
  k->best.bend = sel(more, bend, k->best.bend);
  k->best.across = sel(more, q->across, k->best.across);
  k->best.strand = sel(more, strand, k->best.strand);
  if (woven) k->best.flown = sel(more, splat(c->ends ? 1.0f : 0.0f), k->best.flown);
}

/* What of it is only known when all layers have been: of what covers most, how much is a strand's
 * and how much its bundle's mean. */
INLINE void stage_best(block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf inverse = one / vmax(k->most, splat(1e-6f));
  vf part = k->best.detail = vmin(k->best.strand * inverse, one);
  k->best.bare = k->best.lit * inverse;
  k->best.slope = k->best.slope * part + (k->best.bend * (one - part) + zero);
  k->best.across = k->best.across * (splat(0.5f) * part) + zero; /* no -0 */
  k->best.id = (vu)seli(gt(part, zero), (vi)k->best.id, splati(0));
}

INLINE void yarn_place(const fibertex_layer *c, const vf at[2], vu h, lane_place *p) {
  vf co = splat(c->twist[0]), si = splat(c->twist[1]);
  p->x = at[0] * co + at[1] * si;
  p->y = at[1] * co - at[0] * si;
  p->bend = p->part = p->many = splat(0.0f);
  p->chord = p->widen = splat(1.0f);
  p->full = splati((int32_t)(c->presence - HASH_ONE));
  p->h = hash_mix(h + splatu(c->seed));
}

/* What the stages hand on from one to the next, of a layer of a block. */
typedef struct {
  bundle_cell cell;
  lane_place p;
  vf direction[2];
  lane_strand both[2];
  lane_hit hit;
  lane_counted counted;
} layer_work;

/* Of several blocks one layer goes through the stages at a time, of a point alone several:
 * side by side, so that none waits long. */
#define LAYERS_TOGETHER (LANES == 1 ? 8 : 1)
typedef layer_work layers_work[LAYERS_TOGETHER][BLOCKS_TOGETHER];
#define EACH_LAYER EACH(l, layers) EACH(b, blocks)

/* Of all blocks. */
typedef struct {
  float least, most;
} footprints;

INLINE footprints footprints_of(const block *k, uint32_t blocks) {
  vf low = splat(1e30f), high = splat(0.0f);
  EACH(b, blocks) {
    low = vmin(k[b].s, low);
    high = vmax(k[b].s, high);
  }
  footprints r = {lane(low, 0), lane(high, 0)};
  for (uint32_t i = 1; i < LANES; i++) {
    r.least = lane(low, i) < r.least ? lane(low, i) : r.least;
    r.most = lane(high, i) > r.most ? lane(high, i) : r.most;
  }
  return r;
}

INLINE void stages_of_lanes(const fibertex_constants *w, const fibertex_layer *c, uint32_t layers,
                            int ends, const block *k, uint32_t blocks, const footprints *s,
                            layers_work of) {
  int strands = 0, means = 0;
  EACH(l, layers) {
    strands |= (s->least - c[l].vague) * c[l].vague_inverse < 1.0f;
    means |= s->most > c[l].vague;
  }
  if (strands) {
    EACH_LAYER lane_pair(w, &c[l], ends, &of[l][b].p, of[l][b].both);
    EACH_LAYER {
      lane_course(&c[l], &of[l][b].both[0]);
      lane_course(&c[l], &of[l][b].both[1]);
    }
    EACH_LAYER {
      layer_work *q = &of[l][b];
      lane_filter seen = lane_seen(&c[l], &k[b].filter);
      vf ramp = q->p.chord * seen.inverse_end;
      lane_cover(ends, &q->p, &seen, ramp, &q->both[0]);
      lane_cover(ends, &q->p, &seen, ramp, &q->both[1]);
    }
    EACH_LAYER {
      layer_work *q = &of[l][b];
      lane_filter seen = lane_seen(&c[l], &k[b].filter);
      lane_choose(w, &c[l], ends, &seen, &q->p, q->both, &q->hit);
    }
  } else {
    EACH_LAYER lane_none(&of[l][b].hit);
  }
  if (!means) return;
  EACH_LAYER {
    layer_work *q = &of[l][b];
    /* a hair further than they count, lest rounding leave something of them */
    int some = s->least * c[l].counted_end < 4.001f * c[l].spacing;
    lane_count(w, &c[l], ends, some, &q->p, &k[b].filter, &q->counted);
  }
  EACH_LAYER {
    layer_work *q = &of[l][b];
    vf edge = ends ? bundle_edge(&c[l], &q->cell) : splat(1e9f);
    lane_blend(w, &c[l], &q->p, edge, &k[b].filter, &q->counted, &q->hit);
  }
}

INLINE void stages_of_hull(const fibertex_constants *w, const fibertex_layer *c, uint32_t layers,
                           const block *k, uint32_t blocks, int level, const footprints *s,
                           layers_work of) {
  EACH_LAYER bundle_cube(&c[l], k[b].g, level, &of[l][b].cell);
  EACH_LAYER bundle_find(&c[l], &of[l][b].cell);
  EACH_LAYER {
    layer_work *q = &of[l][b];
    bundle_middle(w, &c[l], &k[b].f, k[b].g, level, &q->cell, &q->p, q->direction);
  }
  EACH_LAYER bundle_course(w, &c[l], &of[l][b].cell, &of[l][b].p);
  stages_of_lanes(w, c, layers, 1, k, blocks, s, of);
}

STAGE void layers_of_hull(const fibertex_constants *w, const fibertex_layer *c, uint32_t layers,
                          block *k, uint32_t blocks, int level, const footprints *s, int woven,
                          int wants) {
  layers_work of;
  stages_of_hull(w, c, layers, k, blocks, level, s, of);
  EACH_LAYER {
    const layer_work *q = &of[l][b];
    compose(w, &c[l], &k[b], &q->hit, q->p.bend, q->direction, splat(c[l].depth), woven, wants);
  }
}

STAGE void layers_of_yarn(const fibertex_constants *w, const fibertex_layer *c, uint32_t layers,
                          block *k, uint32_t blocks, const footprints *s, int wants) {
  layers_work of;
  EACH_LAYER yarn_place(&c[l], k[b].ground.place, k[b].ground.h, &of[l][b].p);
  stages_of_lanes(w, c, layers, 0, k, blocks, s, of);
  EACH_LAYER {
    const vf d[2] = {splat(c[l].twist[0]), splat(c[l].twist[1])};
    const lane_hit *hit = &of[l][b].hit;
    compose(w, &c[l], &k[b], hit, splat(0.0f), d, splat(c[l].depth) + k[b].ground.level, 1, wants);
  }
}

/* Whether any of the blocks has anything left to be covered. */
INLINE int layers_wanted(const block *k, uint32_t blocks) {
  vf left = splat(0.0f);
  EACH(b, blocks) left = vmax(k[b].sum.left, left);
  return any(gt(left, splat(0.0f)));
}

/* What of a footprint lies between yarns is so for all of their layers; and what light
 * reaches the first of them. */
INLINE void enter_yarns(block *k) {
  k->hole = k->sum.left * (splat(1.0f) - k->ground.solid);
  k->sum.left = k->sum.left - k->hole;
  k->lit = k->reach;
}

/* Down through the shell. */
INLINE void stage_layers(const fibertex_constants *w, int woven, block *k, uint32_t blocks,
                         int level, int wants) {
  const footprints s = footprints_of(k, blocks);
  if (s.least >= w->far[1]) return; /* nothing near is left of them */
  /* of a cloth what stands off it first */
  uint32_t all = (uint32_t)w->layers, first = (uint32_t)w->yarns_from, layers;
  for (uint32_t l = 0; l < all && layers_wanted(k, blocks); l += layers) {
    uint32_t to = l < first ? first : all;
    layers = to - l < LAYERS_TOGETHER ? to - l : LAYERS_TOGETHER;
    if (LAYERS_TOGETHER == 1) layers = 1;
    if (woven && l == first) EACH(b, blocks) enter_yarns(&k[b]);
    if (woven && l >= first)
      layers_of_yarn(w, w->layer + l, layers, k, blocks, &s, wants);
    else
      layers_of_hull(w, w->layer + l, layers, k, blocks, level, &s, woven, wants);
  }
}

#endif
