/* SPDX-License-Identifier: Apache-2.0
 *
 * The fibre's direction, and how it dives.
 */
#ifndef SOZAI_WOOD_STAGES_DIRECTION_H
#define SOZAI_WOOD_STAGES_DIRECTION_H

#include "axes.h"
#include "knots.h"
#include "wants.h"

/* The fibre's direction: theta' and rho are constant along it. */
INLINE void stage_fibre(block *k) {
  const stem_place *stem = &k->stem;
  vf one = splat(1.0f), zero = splat(0.0f), *f = k->fibre;
  vf omega = k->grain.g_filtered * k->divisor;
  vf rho_r = stem->rho_x * stem->c + stem->rho_z * stem->s;
  vf rho_t = stem->r * (stem->rho_z * stem->c - stem->rho_x * stem->s);
  vf climb = (zero - stem->rho_y - rho_t * omega) / vmax(rho_r, splat(0.05f));
  vf around = stem->r * omega;
  if (k->knot) stage_knot_slopes(k, omega, rho_r, &climb, &around);
  f[0] = climb * stem->c - around * stem->s + stem->pith.dx;
  f[2] = climb * stem->s + around * stem->c + stem->pith.dz;
  f[1] = inverse_root(f[0] * f[0] + one + f[2] * f[2]);
  f[0] = f[0] * f[1];
  f[2] = f[2] * f[1];
  if (k->knot && any(gt(k->knot->inside, zero))) {
    vm in = gt(k->knot->inside, zero);
    const vf *along = k->knot->along;
    vf axis[3] = {along[0] + stem->pith.dx * along[1], along[1],
                  along[2] + stem->pith.dz * along[1]};
    unit_direction(axis);
    for (int c = 0; c < 3; c++) f[c] = sel(in, axis[c], f[c]);
  }
  k->sine = zero - (f[0] * k->nrm[0] + f[1] * k->nrm[1] + f[2] * k->nrm[2]);
}

INLINE void stage_direction(const wood_constants *w, int boards, const wood_io *io,
                            const wood_wants *want, block *k) {
  if (want->fibre) {
    vf back[3];
    from_log(w, boards, k, k->fibre, back);
    for (int c = 0; c < 3; c++) store_lanes(io, WOOD_FIBER + c, k, back[c]);
  }
  if (want->dive) store_lanes(io, WOOD_DIVE, k, arcsin(k->sine));
}

#endif
