/* SPDX-License-Identifier: Apache-2.0
 *
 * What all directions of an aggregate's strands show together.
 */
#ifndef SOZAI_FIBERTEX_HULL_LOOKS_H
#define SOZAI_FIBERTEX_HULL_LOOKS_H

#include "means.h"

/* What the looks are made of is a sum over products of these: a direction's components along
 * and across a strand that lies flat, and along that of its mirror image about the axis. */
typedef struct {
  vf along[2], across[2];
} look_flat;

INLINE look_flat look_flat_of(const fibertex_look *o, const vf v[3]) {
  vf co = splat(o->across[1]), si = splat(-o->across[0]);
  vf a = co * v[0], b = si * v[1], c = co * v[1], d = si * v[0];
  return (look_flat){{a + b, a - b}, {c - d, c + d}};
}

/* A look and its mirror image. level: the eye looks squarely; the same result in fewer steps. */
INLINE void look_angles(const fibertex_constants *w, const fibertex_look *o, int level,
                        const hull_frame *f, strand_angles q[2]) {
  const vf shrink = splat(1.0f - 0.5f * (o->across2 + o->up2));
  vf up = w->nap > 0.0f ? f->pile.up : splat(o->up[2]);
  vf out = w->nap > 0.0f ? f->pile.out : splat(o->along[2]);
  vf steep = up * shrink, rise = out * shrink;
  look_flat l = look_flat_of(o, f->light), v = l;
  if (!level) v = look_flat_of(o, f->view);
  vf across2 = splat(o->across2), up2 = splat(o->up2);
  for (int i = 0; i < 2; i++) {
    vf sl = l.along[i] * steep + f->light[2] * rise;
    vf lu = f->light[2] * up - l.along[i] * out;
    vf a = across2 * l.across[i], u = up2 * lu, sl2 = a * l.across[i] + u * lu;
    vf sv = rise, sv2 = up2 * (up * up), both = u * up;
    if (!level) {
      sv = v.along[i] * steep + f->view[2] * rise;
      vf out_of = f->view[2] * up - v.along[i] * out;
      sv2 = across2 * (v.across[i] * v.across[i]) + up2 * (out_of * out_of);
      both = a * v.across[i] + u * out_of;
    }
    strand_angles_from(w, 0, sl, sv, sl2, sv2, both, f->between, &q[i]);
  }
}

/* Adds both. Strands across the view's slant look broader, and are more of what is seen. */
INLINE void look_add(const fibertex_constants *w, const fibertex_look *o, int level,
                     const hull_frame *f, const strand_angles a[2], strand_parts *sum,
                     vf *straight) {
  const vf zero = splat(0.0f);
  for (int i = 0; i < 2; i++) {
    strand_parts p;
    strand_parts_of(w, &a[i], &p);
    if (!level) {
      const float most = w->layer[w->layers - 1].widen_most, side = i ? -1.0f : 1.0f;
      vf co = splat(o->across[1]), si = splat(side * o->across[0]);
      /* a strand of either lies along (co, -si) */
      vf share = w->pile ? pile_widening(&f->pile, f->lean2, co, zero - si, most)
                         : widening(f->lean2[0] * si + f->lean2[1] * co, most);
      p.reflected = p.reflected * share;
      p.through = p.through * share;
      p.back = p.back * share;
      p.within = p.within * share;
      *straight = *straight + share;
    }
    sum->reflected = sum->reflected + p.reflected;
    sum->through = sum->through + p.through;
    sum->back = sum->back + p.back;
    sum->within = sum->within + p.within;
  }
}

/* All of them, of a block alone. */
INLINE void looks_of_block(const fibertex_constants *w, const block *k, strand_parts *sum,
                           vf *straight) {
  for (int m = 0; m < w->looks / 2; m++) {
    strand_angles a[2];
    look_angles(w, &w->look[m], 0, &k->f, a);
    look_add(w, &w->look[m], 0, &k->f, a, sum, straight);
  }
}

INLINE void looks_of_hull_as(const fibertex_constants *w, int level, const block *k,
                             uint32_t blocks, looks *q) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  strand_parts sum[BLOCKS_TOGETHER];
  vf straight[BLOCKS_TOGETHER];
  EACH(b, blocks) {
    sum[b] = (strand_parts){zero, zero, zero, zero};
    straight[b] = level ? splat((float)w->looks) : zero;
  }
  ROLLED for (int m = 0; m < w->looks / 2; m++) {
    const fibertex_look *o = &w->look[m];
    strand_angles a[BLOCKS_TOGETHER][2];
    EACH(b, blocks) look_angles(w, o, level, &k[b].f, a[b]);
    EACH(b, blocks) look_add(w, o, level, &k[b].f, a[b], &sum[b], &straight[b]);
  }
  EACH(b, blocks) {
    vf inverse = one / straight[b];
    strand_lit r;
    sum[b].reflected = sum[b].reflected * splat(w->from_afar[0]);
    sum[b].through = sum[b].through * splat(w->from_afar[1]);
    sum[b].back = sum[b].back * splat(w->from_afar[2]);
    strand_amounts(w, &sum[b], &r);
    q[b].white[0] = r.white * inverse;
    q[b].glow[0] = r.glow * inverse;
    q[b].bulk = r.bulk * inverse;
    q[b].onward = r.onward * inverse;
  }
}

static __attribute__((noinline, unused)) void
looks_of_hull_level(const fibertex_constants *w, const block *k, uint32_t blocks, looks *q) {
  looks_of_hull_as(w, 1, k, blocks, q);
}
static __attribute__((noinline, unused)) void
looks_of_hull_slant(const fibertex_constants *w, const block *k, uint32_t blocks, looks *q) {
  looks_of_hull_as(w, 0, k, blocks, q);
}

INLINE void stage_looks_of_hull(const fibertex_constants *w, const block *k, uint32_t blocks,
                                int level, int light, looks *q) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  EACH(b, blocks) {
    q[b].around[0] = k[b].ground.around;
    q[b].albedo[0] = q[b].straight = one;
    q[b].around[1] = q[b].albedo[1] = zero;
    q[b].white[0] = q[b].glow[0] = q[b].bulk = q[b].onward = zero;
    q[b].white[1] = q[b].glow[1] = q[b].flown = zero;
  }
  if (!light) return;
  if (level)
    looks_of_hull_level(w, k, blocks, q);
  else
    looks_of_hull_slant(w, k, blocks, q);
}

#endif
