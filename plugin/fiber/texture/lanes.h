/* SPDX-License-Identifier: Apache-2.0
 *
 * The strands of a bundle: lanes side by side, each of which may hold one.
 *
 * In stages, each run over several layers before the next: a stage's work waits for its own
 * results most of the time, and does not for another layer's.
 */
#ifndef SOZAI_FIBERTEX_LANES_H
#define SOZAI_FIBERTEX_LANES_H

#include "../../core/hash.h"
#include "../../core/maths.h"
#include "texture.h"

/* How much darker a strand is where it dives at its ends, and its rim. Both are
 * divided by their means, so that neither changes a patch's. */
#define LANE_DIVE 0.5f
#define LANE_RIM 0.5f
#define LANE_ENDS 0.7f /* a strand's length over its lane's */
#define LANE_MANY                                                                                  \
  0.25f /* by how much of the usual bundles have more strands than others, or fewer */
#define LANE_NOWHERE 1e9f      /* mm */
#define LANE_WHOLE 12582912.0f /* added to a whole number, that is in the lowest bits */

/* The greatest whole number not above x; its sign where it is 0 is either. */
INLINE vf whole_of(vf x) {
#ifdef ROUND_DOWN_
  return ROUND_DOWN_(x);
#else
  vi whole;
  return vfloor(x, &whole);
#endif
}

/* The whole number nearest to x, of two the even one. */
INLINE vf nearest_of(vf x) {
#if defined(SOZAI_ISA_AVX512) && LANES == 16
  return (vf)_mm512_roundscale_ps((__m512)x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
#elif defined(SOZAI_ISA_AVX2) && LANES == 8
  return (vf)_mm256_round_ps((__m256)x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
#elif (defined(SOZAI_ISA_AVX2) || defined(SOZAI_ISA_AVX512)) && LANES == 4
  return (vf)_mm_round_ps((__m128)x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
#elif defined(SOZAI_ISA_AVX2) || defined(SOZAI_ISA_AVX512)
  __m128 v = _mm_set_ss(x);
  return _mm_cvtss_f32(_mm_round_ss(v, v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
#else
  /* beyond 2^23 there are no others */
  vf a = vabs(x), whole = (a + splat(8388608.0f)) - splat(8388608.0f);
  vi sign = bits_of(x) & splati(INT32_MIN);
  return float_of(bits_of(sel(lt(a, splat(8388608.0f)), whole, a)) | sign);
#endif
}

/* A wave of period 1, of parabolas, with its slope; its amplitude is an eighth of what is given. */
INLINE vf wave(vf turns, float amplitude, vf *slope) {
  vf t = turns - nearest_of(turns), b = splat(amplitude) - vabs(t) * splat(2.0f * amplitude);
  *slope = (b + b) - splat(amplitude);
  return t * b;
}

/* A hash from its k-th byte on, from the top: a number within +-HASH_ONE. */
INLINE vf field_of(vu h, int k) { return to_float((vi)(h << (8 * k))); }
#define FIELD(x) ((x) / HASH_ONE) /* what it is multiplied by to lie within +-x */

/* The lower 23 bits of a hash: a number from 1 to 2. */
INLINE vf phase_of(vu h) { return float_of((vi)((h & splatu(0x7fffffu)) | splatu(0x3f800000u))); }

INLINE vu selu(vm m, vu a, vu b) { return (vu)bits_of(sel(m, float_of((vi)a), float_of((vi)b))); }

/* 1 / sqrt(1 + x) for 0 <= x <= 1.6, within 0.007; what is steeper counts as that. */
INLINE vf lane_inverse_root(vf x) {
  x = vmin(x, splat(1.6f));
  return splat(0.9934f) + x * (splat(0.1052f) * x - splat(0.39746f));
}

typedef struct {
  vf x, y;  /* place in the bundle, mm: along; across, straightened */
  vf bend;  /* slope of the bundle itself there */
  vf widen; /* how much broader strands look at the eye's slant */
  vf chord; /* half of the bundle's extent along x there */
  vf part;  /* x over that */
  vf many;  /* how many more strands than usual it has, over a field's 2^31 */
  vi full;  /* what a lane's second number of chance is below where there is one */
  vu h;     /* the bundle */
} lane_place;

/* A footprint, as lanes see it: of a strand's thickness, which all layers share. */
typedef struct {
  vf s, inverse_box, half; /* of the box that stands for the footprint */
  vf inverse_end;
} lane_filter;

INLINE lane_filter lane_filter_of(float radius, vf s) {
  vf box = vmax(s, splat(0.02f * radius));
  return (lane_filter){s, splat(1.0f) / box, box * splat(0.5f),
                       splat(1.0f) / vmax(s, splat(2.0f * radius))};
}

/* What of a footprint the two lanes that are looked at stand for: the middle of a wide one. */
INLINE lane_filter lane_seen(const fibertex_layer *c, const lane_filter *t) {
  lane_filter r = *t;
  r.half = vmin(r.half, splat(c->seen));
  r.inverse_box = vmax(r.inverse_box, splat(c->seen_inverse));
  return r;
}

/* What a layer shows: coverage, and of the strand that covers most the rest. */
typedef struct {
  vf cover;  /* by its strands, */
  vf mean;   /* and by what is no more than counted, or a mean of them; */
  vf dim[2]; /* that times its brightness, of both colours and of the second */
  vf slope;  /* of the centreline, the bundle's and its own */
  vf across; /* place across the strand, -2 to 2 */
  vf bright; /* of what its strands cover */
  vf soft;   /* how near strands are to what they leave bare, 0 to 1, less the layer's mean: they
              * take light from what is below */
  vu id;
} lane_hit;

/* Nothing of it: one by one, which is faster than what a compiler makes of all at once. */
INLINE void lane_none(lane_hit *q) {
  q->cover = q->mean = q->dim[0] = q->dim[1] = q->slope = q->across = q->bright = q->soft =
      splat(0.0f);
  q->id = splatu(0);
}

/* One lane's strand at the point. */
typedef struct {
  vf off;              /* from its centreline, along y */
  vf slope;            /* of that */
  vf thick;            /* half of its thickness, seen squarely */
  vf from;             /* its middle, along it, over half of the bundle's extent */
  vf frequency, turns; /* of its swing */
  vf cover, lo, hi, r;
  vu id;
} lane_strand;

/* Whether it is of the first colour and not of the second: by what also puts it to a side of its
 * lane. */
INLINE vm lane_first(const fibertex_constants *w, vu id) {
  int32_t bound = (int32_t)((((uint32_t)w->second_chance << 24) - 1u) ^ 0x80000000u);
  return lti(splati(bound), (vi)id);
}

/* A lane's chance: the place's hash is a good one, and a round is enough. */
INLINE vu lane_chance(vu id) {
  id ^= id >> 15;
  id *= splatu(0x7feb352du);
  return id ^ id >> 13;
}

/* Whether it has a strand. A product's upper half is good. */
INLINE vm lane_there(const lane_place *p, vu id) {
  return lti((vi)(id * splatu(0x846ca68bu)), p->full);
}

/* How far along it, over half of the bundle's extent, a strand's middle is. */
INLINE vf lane_from(const lane_place *p, vu id) {
  const float stray = 1.0f - LANE_ENDS;
  return vabs((p->part + splat(3.0f * stray)) - splat(2.0f * stray) * phase_of(id));
}

/* What chance gives a strand: two things share a field where nobody sees that they go together. */
INLINE void lane_draw(const fibertex_constants *w, const fibertex_layer *c, int ends,
                      const lane_place *p, vu id, vf off, vf shift, lane_strand *q) {
  q->id = id = lane_chance(id);
  vf aside = field_of(id, 0), thick = field_of(id, 2), phase = phase_of(id);
  q->frequency = splat(w->own_frequency) + splat(w->own_vary) * thick;
  q->turns = p->x * q->frequency + phase;
  q->slope = p->bend + splat(c->tilt) * aside;
  q->thick = splat(c->radius) + splat(c->radius_vary) * thick;
  if (ends) q->from = lane_from(p, id);
  /* where there is none it is far away */
  q->off = sel(lane_there(p, id), off - shift * aside, splat(LANE_NOWHERE));
}

/* Its centreline. */
INLINE void lane_course(const fibertex_layer *c, lane_strand *q) {
  vf rate;
  q->off = q->off - wave(q->turns, c->sway, &rate);
  q->slope = q->slope + rate * q->frequency;
}

/* The two lanes whose strands may cover the point. */
INLINE void lane_pair(const fibertex_constants *w, const fibertex_layer *c, int ends,
                      const lane_place *p, lane_strand both[2]) {
  vf at = p->y * splat(c->inverse_spacing), low = whole_of(at);
  vf off = (at - low) * splat(c->spacing);
  vu key = p->h + (vu)bits_of(low + splat(LANE_WHOLE)) * splatu(HASH_X);
  vf shift = splat(c->shift) + splat(c->tilt) * p->x;
  lane_draw(w, c, ends, p, key, off, shift, &both[0]);
  lane_draw(w, c, ends, p, key + splatu(HASH_X), off - splat(c->spacing), shift, &both[1]);
}

/* What of it a footprint has. */
INLINE void lane_cover(int ends, const lane_place *p, const lane_filter *t, vf ramp,
                       lane_strand *q) {
  const vf zero = splat(0.0f), half = splat(0.5f);
  vf e = q->off * lane_inverse_root(q->slope * q->slope);
  vf r = q->thick * p->widen;
  vf lo = vmax(e - t->half, zero - r), hi = vmin(e + t->half, r);
  vf cover = vmax(hi - lo, zero) * t->inverse_box;
  q->off = e;
  q->lo = lo;
  q->hi = hi;
  q->r = r;
  if (ends) cover = cover * clamp01((splat(LANE_ENDS) - q->from) * ramp + half);
  q->cover = cover;
}

/* How near a strand is falls from its rim on to nothing at 2.2 times its thickness: the integral
 * from the rim to x beyond it. */
INLINE vf lane_nearness(const fibertex_layer *c, vf thick, vf x) {
  vf u = clamp(x, splat(0.0f), splat(2.2f) * thick);
  return u * (splat(1.1f) * thick - splat(0.25f) * u) * splat(c->inverse_radius);
}

/* Of a footprint, what the strand leaves bare of it times how near it is to that. Of a thickness
 * seen squarely from its shadow's rim on: then its mean hardly changes with the slant. */
INLINE vf lane_near(const fibertex_layer *c, int ends, const lane_filter *t, vf ramp,
                    const lane_strand *q) {
  vf right = q->off + t->half - q->r, left = t->half - q->off - q->r, box = t->half + t->half;
  vf near = lane_nearness(c, q->thick, right) - lane_nearness(c, q->thick, right - box);
  near = near + (lane_nearness(c, q->thick, left) - lane_nearness(c, q->thick, left - box));
  near = near * t->inverse_box;
  if (ends) near = near * clamp01((splat(LANE_ENDS) - q->from) * ramp + splat(0.5f));
  return near;
}

/* How bright it is, over the part of the footprint that is covered: in the middle more, 1 at the
 * mean. inverse: 1 over its radius, as it is seen; across: where on it that part lies. */
INLINE vf lane_bright(const fibertex_constants *w, const fibertex_layer *c, int ends,
                      const lane_strand *q, vf inverse, vf *across) {
  const vf one = splat(1.0f);
  const float rim = 1.0f / (1.0f - LANE_RIM / 3.0f), dive = 1.0f / (1.0f - LANE_DIVE / 3.0f);
  vf lo = q->lo * inverse, hi = q->hi * inverse, sum = *across = lo + hi;
  vf bright = splat(c->lift * rim) - splat(c->lift * rim * LANE_RIM / 3.0f) * (sum * sum - lo * hi);
  if (ends) {
    vf v = vmin(q->from, splat(LANE_ENDS));
    bright = bright * (splat(dive) - splat(dive * LANE_DIVE / (LANE_ENDS * LANE_ENDS)) * (v * v));
  }
  /* the mean of tones is 1 */
  return bright * (one + splat(FIELD(1.0f) * w->variation) * field_of(q->id, 3));
}

/* Both, and the rest of that which covers more. What nothing covers is anything, but a number. */
INLINE void lane_choose(const fibertex_constants *w, const fibertex_layer *c, int ends,
                        const lane_filter *t, const lane_place *p, const lane_strand both[2],
                        lane_hit *q) {
  const vf one = splat(1.0f);
  const lane_strand *m = &both[0], *n = &both[1];
  vf sum = m->cover + n->cover, ramp = p->chord * t->inverse_end, across[2];
  q->cover = vmin(sum, one);
  /* one division serves two: of what is covered, and of what is bare */
  vf covered = vmax(sum, splat(1e-6f)), bare = vmax(one - sum, splat(0.02f));
  vf inverse = one / (covered * bare), thick = one / (m->r * n->r);
  vf near = lane_near(c, ends, t, ramp, m) + lane_near(c, ends, t, ramp, n);
  vf wide = (t->half + t->half) * splat(c->seen_inverse);
  vf mean = splat(c->soft) + splat(c->soft_wide) * (wide * (splat(2.0f) - wide));
  q->soft = vmin(near * (inverse * covered), one) - mean;
  vf bright = m->cover * lane_bright(w, c, ends, m, thick * n->r, &across[0]);
  bright = bright + n->cover * lane_bright(w, c, ends, n, thick * m->r, &across[1]);
  q->bright = bright * (inverse * bare);
  vm other = lt(m->cover, n->cover);
  q->id = selu(other, n->id, m->id);
  q->slope = sel(other, n->slope, m->slope);
  q->across = sel(other, across[1], across[0]);
  q->mean = q->dim[0] = q->dim[1] = splat(0.0f);
}

#endif
