/* SPDX-License-Identifier: Apache-2.0
 *
 * Axial parenchyma under the footprint.
 */
#ifndef SOZAI_WOOD_STAGES_PARENCHYMA_H
#define SOZAI_WOOD_STAGES_PARENCHYMA_H

#include "vessels.h"

/* Under a long footprint. A function of its own, since what it is told would be written to memory
 * for every other point as well. */
static __attribute__((noinline)) vf parenchyma_parts(const wood_constants *w, int boards,
                                                     const block *k) {
  soft_place here = soft_place_of(w, boards, k);
  return soft_leave_parts(w, &here);
}

/* Bands of it, and what lies between the vessels of others: what they leave of the tissue. */
INLINE vf parenchyma_leaves(const wood_constants *w, int boards, const block *k) {
  if (any(soft_cut(w, &grown_at(k)->f))) return parenchyma_parts(w, boards, k);
  vf left = splat(1.0f);
  if (w->parenchyma.between > 0.0f) {
    if (k->between_found) {
      left = left - k->between;
    } else {
      soft_place here = soft_place_of(w, boards, k);
      vessel_bands bands = bands_of(w, boards, k);
      left = left - soft_between(w, &here, &bands, NULL);
    }
  }
  if (w->parenchyma.bands_often > 0.0f) {
    soft_place here = soft_place_of(w, boards, k);
    left = left - left * soft_bands(w, &here, NULL);
  }
  return left;
}

/* k->rest: what neither vessels nor parenchyma are; k->tough: how much of latewood that leaves. */
INLINE void stage_parenchyma(const wood_constants *w, int boards, const wood_io *io, block *k) {
  const wood_parenchyma *m = &w->parenchyma;
  vf one = splat(1.0f), left = one;
  if (m->bands_often > 0.0f || m->between > 0.0f) left = parenchyma_leaves(w, boards, k);
  k->tough = left;
  if (m->sheaths) {
    vf bare = vmax(one - k->vessels.pores, splat(1e-3f));
    vf share = (k->vessels.sheaths - k->vessels.pores) / bare;
    share = share + share * splat(m->sheath_late - 1.0f) * k->vessels.pores_faded;
    k->tough = left * (one - share);
  }
  if (m->margin > 0.0f) {
    k->margin = rings_mean_strayed(w, boards, MEAN_MARGIN, k);
    left = left - left * k->margin;
  }
  k->rest = k->rest * left;
  k->soft = one - k->cover - k->rest;
  if (m->sheaths) k->soft = vmax(k->soft, splat(0.0f)); /* which they round otherwise */
  store_lanes(io, WOOD_PARENCHYMA, k, k->soft);
}

#endif
