/* SPDX-License-Identifier: Apache-2.0
 *
 * Where light comes from and where it is seen from, and the radiance under the light's colour.
 */
#ifndef SOZAI_WOOD_STAGES_LIGHT_H
#define SOZAI_WOOD_STAGES_LIGHT_H

#include "../coat.h"
#include "axes.h"

INLINE void stage_light(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf light[3], *l = k->light;
  if (!boards && k->o && as_before(io->in->light, k->i, k->n)) {
    for (int c = 0; c < 3; c++) l[c] = k[-1].light[c];
  } else {
    for (int c = 0; c < 3; c++) light[c] = load_lanes(io->in->light[c], k->i, k->n);
    unit_direction(light);
    to_log(w, boards, k, light, l);
  }
}

/* How it falls on the surface, whose normal is the relief's own by now. */
INLINE void stage_incident(block *k) {
  const vf *l = k->light;
  k->incident = l[0] * k->nrm[0] + l[1] * k->nrm[1] + l[2] * k->nrm[2];
  /* up the stem within the surface */
  vf rise = (l[1] - k->nrm[1] * k->incident) * k->inverse_up;
  k->rise = sel(gt(k->up2, splat(1e-6f)), rise, splat(0.0f));
}

/* Radiance of a channel, under the light's colour. */
INLINE void store_lit(const wood_io *io, const block *k, int c, vf r) {
  if (io->in->light_colour[c]) {
    vf e = load_lanes(io->in->light_colour[c], k->i, k->n);
    r = r * sel(lt(vabs(e), splat(1e30f)), e, splat(0.0f));
  }
  store_lanes(io, WOOD_RADIANCE + c, k, r);
}

/* Towards the eye, log space; the normal where no view is given, or none that
 * is a direction. */
INLINE void view_of(const wood_constants *w, int boards, const wood_io *io, const block *k,
                    vf out[3]) {
  for (int c = 0; c < 3; c++) out[c] = k->nrm[c];
  if (!io->in->view[0]) return;
  vf v[3], turned[3], size = splat(0.0f);
  for (int c = 0; c < 3; c++) {
    v[c] = load_lanes(io->in->view[c], k->i, k->n);
    size = size + vabs(v[c]);
  }
  vm given = and_(gt(size, splat(0.0f)), lt(size, splat(1e38f)));
  unit_direction(v);
  to_log(w, boards, k, v, turned);
  for (int c = 0; c < 3; c++) out[c] = sel(given, turned[c], k->nrm[c]);
}

/* Of the fibres' slopes that the footprint averages, the variance of how far they dive: what goes
 * round the stem dives where the face is along the radius, and the other way round. */
INLINE vf lost_towards_normal(const block *k) {
  vf across = k->nrm[2] * k->stem.c - k->nrm[0] * k->stem.s;
  vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
  return k->grain.variance * across * across + k->stem.lost_slope * out * out;
}

/* Of the coat's facets, squared: its own, and the gentle slopes that the footprint averages. */
INLINE vf coat_alpha2(const wood_constants *w, const block *k) {
  vf alpha2 = splat(w->coat_alpha * w->coat_alpha);
  return w->surface.relief ? vmin(alpha2 + slopes_sum(&k->lost->gentle), splat(1.0f)) : alpha2;
}

#endif
