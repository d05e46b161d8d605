/* SPDX-License-Identifier: Apache-2.0
 *
 * The nap: which way a pile leans, in patches, as it was brushed, stroked or lain upon. The frame
 * that directions are counted from is turned, so that all that follows is as it is; under
 * footprints that hold many patches the mean of several turns is taken.
 */
#ifndef SOZAI_FIBERTEX_NAP_H
#define SOZAI_FIBERTEX_NAP_H

#include "../../core/filter.h"
#include "../../core/noise.h"
#include "hull_looks.h"
#include "shown.h"
#include "surface.h"

#define NAP_OCTAVES 2
#define NAP_FINER 2.17f
#define NAP_WEAKER 0.5f
#define NAP_ALL 1.25f    /* sum of the octaves' squares */
#define NAP_SIGMA 4.683f /* 1 over the standard deviation of the octaves' sum, 0.191 sqrt(1.25) */

/* A pile leans no less and no more than this many times its mean's tangent. */
#define NAP_STEEPER 2.0f /* log2 */

/* How much steeper it leans; by how far of the noise, log2. */
INLINE void nap_lean(const fibertex_constants *w, vf steeper, hull_frame *f) {
  pile_lean_of(w, exp2_(clamp(steeper, splat(-NAP_STEEPER), splat(NAP_STEEPER))), &f->pile);
}

/* Turned about (1, 1, 1), since a lattice that lies along the axes shows on faces that do. */
INLINE void nap_place(const vf at[3], vf out[3]) {
  const vf one = splat(1.0f / 3.0f), two = splat(2.0f / 3.0f);
  for (int c = 0; c < 3; c++) {
    out[c] = two * (at[c] + at[(c + 2) % 3]) - one * at[(c + 1) % 3];
  }
}

/* Turns the frame at the point and leans the pile, by what the footprint leaves of two noises. */
INLINE void nap_turn(const fibertex_constants *w, block *k) {
  vf turn = splat(0.0f), steeper = turn, kept = turn;
  float finer = w->nap_frequency, weight = 1.0f;
  vf at[3];
  nap_place(k->at, at);
  for (uint32_t o = 0; o < NAP_OCTAVES; o++) {
    vf g[3], f = splat(finer), keep = splat(weight) * filter_keep(k->s, 1.0f / finer);
    vf x = at[0] * f, y = at[1] * f, z = at[2] * f;
    turn = turn + keep * noise_gradient3(x, y, z, splatu(w->nap_seed + 2u * o), g);
    steeper = steeper + keep * noise_gradient3(x, y, z, splatu(w->nap_seed + 2u * o + 1u), g);
    kept = kept + keep * keep;
    finer *= NAP_FINER;
    weight *= NAP_WEAKER;
  }
  const vf sigma = splat(NAP_SIGMA);
  k->nap[0] = turn * (sigma * splat(w->nap));
  k->nap[1] = steeper * (sigma * splat(w->nap_steeper));
  /* 0 where all is kept */
  k->nap_lost = vsqrt(vmax(splat(NAP_ALL) - kept, splat(0.0f)) * splat(1.0f / NAP_ALL));
  vf si, co;
  sine_cosine(k->nap[0], &si, &co);
  hull_frame *f = &k->f;
  for (int c = 0; c < 3; c++) {
    vf e1 = f->e1[c], e2 = f->e2[c];
    f->e1[c] = co * e1 + si * e2;
    f->e2[c] = co * e2 - si * e1;
  }
  nap_lean(w, k->nap[1], f);
}

/* Light and view as a frame has them that is turned further. */
INLINE void turned(vf co, vf si, vf v[2]) {
  vf x = v[0];
  v[0] = co * x + si * v[1];
  v[1] = co * v[1] - si * x;
}

/* From afar, over what the footprint holds of the nap: a Gaussian's nodes (Gauss and Hermite), of
 * turns five, of leans three. */
STAGE void show_far_of_nap(const fibertex_constants *w, const block *k, int light, shown *o) {
  static const float at[5] = {0.0f, 1.3556262f, -1.3556262f, 2.8569700f, -2.8569700f};
  static const float weight[5] = {0.53333333f, 0.22207592f, 0.22207592f, 0.01125741f, 0.01125741f};
  static const float lean_at[3] = {0.0f, 1.7320508f, -1.7320508f};
  static const float lean_weight[3] = {0.66666667f, 0.16666667f, 0.16666667f};
  shown one = *o;
  block turn = *k;
  looks q;
  sums s;
  ROLLED for (int m = 0; m < 15; m++) {
    vf co, si, lost = k->nap_lost;
    sine_cosine(lost * splat(at[m / 3] * w->nap), &si, &co);
    nap_lean(w, k->nap[1] + lost * splat(lean_at[m % 3] * w->nap_steeper), &turn.f);
    for (int c = 0; c < 2; c++) {
      turn.f.light[c] = k->f.light[c];
      turn.f.view[c] = k->f.view[c];
      turn.f.lean2[c] = k->f.lean2[c];
    }
    turned(co, si, turn.f.light);
    turned(co, si, turn.f.view);
    turned(co, si, turn.f.lean2);
    if (light) {
      stage_met(w, &turn);
      stage_reach(w, &turn);
    }
    stage_looks_of_hull(w, &turn, 1, 0, light, &q);
    far_sums(w, &turn, light, &s);
    show_far(w, 0, &turn, &s, &q, &one);
    const vf part = splat(weight[m / 3] * lean_weight[m % 3]);
#define ADD_(x) o->x = m ? o->x + part * one.x : part * one.x
    ADD_(cover);
    ADD_(depth);
    for (int i = 0; i < COLOUR_WEFT; i++) ADD_(albedo[i]);
    if (!light) continue;
    ADD_(white);
    for (int i = 0; i < COLOUR_WEFT; i++) {
      ADD_(glow[i]);
      ADD_(bulk[i]);
    }
#undef ADD_
  }
}

#endif
