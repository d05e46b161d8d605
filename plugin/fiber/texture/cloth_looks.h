/* SPDX-License-Identifier: Apache-2.0
 *
 * What the faces of a cloth's yarns, and the strands that stand off them, show together.
 */
#ifndef SOZAI_FIBERTEX_CLOTH_LOOKS_H
#define SOZAI_FIBERTEX_CLOTH_LOOKS_H

#include "means.h"

/* Of a yarn's two faces one is the other, half a turn about the cloth's normal: of a component
 * along an axis of the one what lies out of the cloth has the other sign in the other. */
INLINE void dots_of_both(const float axis[3], const vf v[3], vf out[2]) {
  vf flat = v[0] * splat(axis[0]) + v[1] * splat(axis[1]), rise = v[2] * splat(axis[2]);
  out[0] = flat + rise;
  out[1] = flat - rise;
}

INLINE void faces_angles(const fibertex_constants *w, const fibertex_look *o, const hull_frame *f,
                         strand_angles q[2]) {
  const float shrink = 1.0f - 0.5f * (o->across2 + o->up2);
  const float along[3] = {o->along[0] * shrink, o->along[1] * shrink, o->along[2] * shrink};
  vf sl[2], sv[2], la[2], va[2], lu[2], vu_[2];
  dots_of_both(along, f->light, sl);
  dots_of_both(along, f->view, sv);
  dots_of_both(o->across, f->light, la);
  dots_of_both(o->across, f->view, va);
  dots_of_both(o->up, f->light, lu);
  dots_of_both(o->up, f->view, vu_);
  vf across2 = splat(o->across2), up2 = splat(o->up2);
  for (int i = 0; i < 2; i++) {
    vf a = across2 * la[i], u = up2 * lu[i];
    vf sl2 = a * la[i] + u * lu[i], both = a * va[i] + u * vu_[i];
    vf sv2 = across2 * (va[i] * va[i]) + up2 * (vu_[i] * vu_[i]);
    strand_angles_from(w, 1, sl[i], sv[i], sl2, sv2, both, f->between, &q[i]);
  }
}

/* Adds both. */
INLINE void faces_add(const fibertex_constants *w, const fibertex_look *o, const block *k,
                      const strand_angles a[2], looks *q) {
  const int yarn = o->weft;
  for (int i = 0; i < 2; i++) {
    const float side = i ? -1.0f : 1.0f;
    const vf tip[2] = {splat(side * o->tip[0]), splat(side * o->tip[1])};
    yarn_parts p;
    yarn_parts_of(w, &a[i], &p);
    face_light f;
    face_of(k, tip, &f);
    vf share = splat(o->share) * f.seen, lit = share * face_lit(&f);
    q->around[yarn] = q->around[yarn] + splat(o->level) * f.seen * f.in * p.often;
    q->glow[yarn] = q->glow[yarn] + lit * p.through;
    q->white[yarn] = q->white[yarn] + lit * p.reflected;
    q->straight = q->straight + share;
  }
}

/* What stands off, along one axis of the frame. */
INLINE void flown_add(const fibertex_constants *w, const fibertex_look *o, const block *k,
                      looks *q) {
  const int i = o->weft;
  const vf *l = k->f.light, *v = k->f.view;
  vf shrink = splat(1.0f - 0.5f * (o->across2 + o->up2));
  vf across2 = splat(o->across2), up2 = splat(o->up2);
  vf a = across2 * l[1 - i], u = up2 * l[2];
  vf sl2 = a * l[1 - i] + u * l[2], both = a * v[1 - i] + u * v[2];
  vf sv2 = across2 * (v[1 - i] * v[1 - i]) + up2 * (v[2] * v[2]);
  strand_angles angles;
  strand_angles_from(w, 1, l[i] * shrink, v[i] * shrink, sl2, sv2, both, k->f.between, &angles);
  yarn_parts p;
  yarn_parts_of(w, &angles, &p);
  q->flown = q->flown + splat(o->share) * widening(k->f.lean2[1 - i], FLOWN_WIDEST) * p.through;
}

/* Over all of them. */
INLINE void looks_of_yarns(const fibertex_constants *w, const block *k, looks *q) {
  const vf one = splat(1.0f);
  const vf share[2] = {splat(w->warp_share), splat(1.0f - w->warp_share)};
  yarn_parts all[2];
  strand_lit r[2], off;
  for (int i = 0; i < 2; i++) {
    all[i] = (yarn_parts){q->white[i], q->glow[i], q->around[i]};
    yarn_amounts(w, &all[i], &r[i]);
  }
  all[0].through = q->flown;
  yarn_amounts(w, &all[0], &off);
  q->straight = one / q->straight;
  vf yarn = splat(1.0f - w->flown) * q->straight, around = q->straight * k->ground.around;
  vf alone = off.onward * k->ground.flown;
  q->flown = alone * splat(w->hair);
  vf over = alone * splat(w->flown) + q->flown * splat(1.0f - w->flown);
  for (int i = 0; i < 2; i++) {
    q->around[i] = r[i].even * around;
    q->white[i] = r[i].white * yarn;
    q->glow[i] = r[i].glow * yarn + over * share[i];
  }
}

STAGE void looks_of_cloth_lit(const fibertex_constants *w, const block *k, uint32_t blocks,
                              looks *q) {
  ROLLED for (int m = 0; m < FIBERTEX_FACES; m += 2) {
    strand_angles a[BLOCKS_TOGETHER][2];
    EACH(b, blocks) faces_angles(w, &w->look[m], &k[b].f, a[b]);
    EACH(b, blocks) faces_add(w, &w->look[m], &k[b], a[b], &q[b]);
  }
  if (w->flown + w->hair > 0.0f) {
    ROLLED for (int m = FIBERTEX_FACES; m < w->looks; m++) EACH(b, blocks)
        flown_add(w, &w->look[m], &k[b], &q[b]);
  }
  EACH(b, blocks) looks_of_yarns(w, &k[b], &q[b]);
}

INLINE void stage_looks_of_cloth(const fibertex_constants *w, const block *k, uint32_t blocks,
                                 int light, looks *q) {
  const vf zero = splat(0.0f);
  for (int i = 0; i < 2; i++) {
    vf albedo = splat(w->look[2 * i].lit + w->look[2 * i + 1].lit);
    EACH(b, blocks) {
      q[b].white[i] = q[b].glow[i] = q[b].around[i] = zero;
      q[b].albedo[i] = albedo;
    }
  }
  EACH(b, blocks) q[b].straight = q[b].bulk = q[b].onward = q[b].flown = zero;
  if (light) looks_of_cloth_lit(w, k, blocks, q);
}

#endif
