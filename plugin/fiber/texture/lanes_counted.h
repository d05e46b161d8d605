/* SPDX-License-Identifier: Apache-2.0
 *
 * Lanes under a footprint of several: strands are counted, not placed. Which lanes hold one, how
 * thick it is, how bright and of which colour is a lane's own chance, and its end is where the
 * bundle has it; how strands lie within their lanes no longer matters. Of more lanes than are
 * counted, and of what lies beyond the bundle, the mean.
 */
#ifndef SOZAI_FIBERTEX_LANES_COUNTED_H
#define SOZAI_FIBERTEX_LANES_COUNTED_H

#include "lanes.h"

#define LANES_COUNTED 4 /* that are looked at; a footprint of one less is had whole */
/* What a strand has of nearness to what lies beside it, over its thickness: lane_nearness on both
 * sides, of a strand of the mean radius. */
#define LANE_NEARNESS 1.21f
/* Of nearnesses that lie over one another the greatest counts: 1 - e^-x, nearly. */
#define LANE_NEARNESS_LOST 0.55f

/* From strands that are seen, 0, to strands that are counted, 1. */
INLINE vf lane_far(const fibertex_layer *c, vf s) {
  return smooth_of(clamp01((s - splat(c->vague)) * splat(c->vague_inverse)));
}

/* How much broader than squarely strands cross their bundle where it bends. */
INLINE vf lane_steep(const lane_place *p) {
  return splat(1.0f) + splat(0.43f) * vmin(p->bend * p->bend, splat(1.6f));
}

/* Coverage expected of a place in a bundle, whatever its lanes hold, seen squarely. */
INLINE vf lane_expected_squarely(const fibertex_layer *c, int ends, const lane_place *p) {
  vf wide = splat(c->formula) + splat(c->formula * FIELD(LANE_MANY)) * p->many;
  wide = wide * lane_steep(p);
  if (ends) {
    const float k = 1.0f / (2.0f - 2.0f * LANE_ENDS);
    wide = wide * clamp01(splat(k) - vabs(p->part) * splat(k));
  }
  return wide;
}
INLINE vf lane_expected(const fibertex_layer *c, int ends, const lane_place *p) {
  return vmin(lane_expected_squarely(c, ends, p) * p->widen, splat(1.0f));
}

/* How bright its strands are there, the mean: they dive at their ends, which lie about the
 * bundle's. */
INLINE vf lane_expected_bright(const fibertex_layer *c, const lane_place *p) {
  const float stray = 1.0f - LANE_ENDS, dive = LANE_DIVE / (LANE_ENDS * LANE_ENDS);
  vf part = vmin(vabs(p->part), splat(1.0f));
  /* a strand's place along itself is anywhere from a to b: the mean of its square */
  vf a = part - splat(stray), b = vmin(part + splat(stray), splat(LANE_ENDS));
  return splat(c->pale) - splat(c->pale * dive / 3.0f) * (a * a + b * (a + b));
}

/* What of a footprint a bundle's strands cover; that times how bright they are, of both colours and
 * of the second; and how near what they leave bare is to one. */
typedef struct {
  vf cover, dim[2], near;
  vf luck; /* how much is chance of few lanes: a variance, over one lane's */
} lane_counted;

/* Sums over the lanes about the middle of a footprint, of what it has of them that reaches so far,
 * in lanes, to either side: half of the strands' thickness; that times brightness. */
INLINE void lane_sums(const fibertex_constants *w, const fibertex_layer *c, int ends,
                      const lane_place *p, vf ramp, vf reach, lane_counted *q) {
  const vf zero = splat(0.0f), half = splat(0.5f), one = splat(1.0f);
  const float first = (float)(LANES_COUNTED / 2 - 1);
  const float bright = c->counted_lift,
              dive = !ends ? 0.0f : bright * LANE_DIVE / (LANE_ENDS * LANE_ENDS);
  vf at = p->y * splat(c->inverse_spacing), low = whole_of(at), off = (at - low) + splat(first);
  vu key = p->h + (vu)bits_of(low - splat(first) + splat(LANE_WHOLE)) * splatu(HASH_X);
  for (int k = 0; k < LANES_COUNTED; k++) {
    vu id = lane_chance(key);
    vf from = ends ? lane_from(p, id) : splat(0.0f), v = vmin(from, splat(LANE_ENDS));
    vf share = vmax(vmin(reach - vabs(off), one), zero);
    if (ends) share = share * clamp01((splat(LANE_ENDS) - from) * ramp + half);
    share = share * (splat(c->radius) + splat(c->radius_vary) * field_of(id, 2));
    share = sel(lane_there(p, id), share, zero);
    vf shown = share * (splat(bright) - splat(dive) * (v * v));
    shown = shown * (one + splat(FIELD(1.0f) * w->variation) * field_of(id, 3));
    q->cover = q->cover + share;
    q->dim[0] = q->dim[0] + shown;
    if (w->second_chance) q->dim[1] = q->dim[1] + sel(lane_first(w, id), zero, shown);
    off = off - one;
    key += splatu(HASH_X);
  }
}

/* Seen squarely, as if nothing lay over one another. some: whether lanes are counted at all. */
INLINE void lane_count(const fibertex_constants *w, const fibertex_layer *c, int ends, int some,
                       const lane_place *p, const lane_filter *t, lane_counted *q) {
  const vf zero = splat(0.0f), half = splat(0.5f), one = splat(1.0f);
  const vf most = splat(0.5f * (LANES_COUNTED - 1));
  vf wide = vmax(t->half * splat(c->inverse_spacing), half), inverse = one / wide;
  vf reach = vmin(wide, most), known = zero;
  q->cover = q->dim[0] = q->dim[1] = q->luck = zero;
  if (some) {
    lane_sums(w, c, ends, p, p->chord * t->inverse_end, reach + half, q);
    vf keep = clamp01(splat(2.0f) - wide * splat(c->counted_end));
    known = reach * inverse * keep;
    inverse = inverse * keep;
    q->luck = known * inverse;
  }
  /* what is wider than that has more of the same, of which the mean is known */
  vf rest = (one - known) * lane_expected_squarely(c, ends, p);
  vf pale = ends ? rest * lane_expected_bright(c, p) : rest;
  vf lanes = lane_steep(p) * inverse * splat(c->counted * c->inverse_spacing);
  q->cover = q->cover * lanes + rest;
  q->dim[0] = q->dim[0] * lanes + pale;
  q->dim[1] = q->dim[1] * lanes + pale * splat(w->second_share);
}

/* As it is seen: broader at a slant, and some over others. */
INLINE void lane_overlap(const lane_place *p, lane_counted *q) {
  const vf one = splat(1.0f);
  vf sum = q->cover * p->widen, near = q->cover * splat(LANE_NEARNESS);
  vf bare = vmax(one - sum, splat(0.02f)) + splat(LANE_NEARNESS_LOST) * near;
  /* one division serves two: of what lies over one another, and of what is bare */
  vf over = vmax(sum, one), both = one / (over * bare), few = both * bare * p->widen;
  q->near = vmin(near * (both * over), one);
  q->cover = vmin(sum, one);
  for (int i = 0; i < 2; i++) q->dim[i] = q->dim[i] * few;
}

/* What of a footprint lies in the bundle that its middle is in, so far from its edge. */
INLINE vf lane_within(vf edge, const lane_filter *t) {
  return clamp01(splat(0.5f) + edge * t->inverse_box);
}

/* From strands that are seen to how many there are. */
INLINE void lane_blend(const fibertex_constants *w, const fibertex_layer *c, const lane_place *p,
                       vf edge, const lane_filter *t, lane_counted *n, lane_hit *q) {
  vf far = lane_far(c, t->s), near = splat(1.0f) - far;
  lane_overlap(p, n);
  /* at a slant strands beyond it look as much broader, nearly */
  vf in = lane_within(edge, t), wide = vmin(p->widen, splat(c->beyond_widen));
  vf dim = splat(c->beyond[1]) * wide;
  vf close = n->near + splat(c->counted_luck) * n->luck;
  close = mix(splat(c->beyond_near), close, in) - splat(c->counted_near);
  q->cover = near * q->cover;
  q->soft = near * q->soft + far * close;
  q->mean = far * mix(splat(c->beyond[0]) * wide, n->cover, in);
  q->dim[0] = far * mix(dim, n->dim[0], in);
  q->dim[1] = far * mix(dim * splat(w->second_share), n->dim[1], in);
}

#endif
