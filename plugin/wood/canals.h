/* SPDX-License-Identifier: Apache-2.0
 *
 * Resin canals along the stem of conifers: tubes like vessels, mostly in the
 * later half of the ring, lined with paler cells. Those of a year stand round
 * its ring at jittered places, as many as make the density that is asked for
 * whatever the ring's width, and each at a phase of its own. The grain carries
 * them.
 */
#ifndef SOZAI_WOOD_CANALS_H
#define SOZAI_WOOD_CANALS_H

#include "vessels.h"

#define CANAL_MIXED 0.05f /* square of a footprint over its ring that mixes half of it */

typedef struct {
  vf whole, core; /* share covered: by the canal and by its lumen */
} canal_cover;

INLINE canal_cover canals_expected(const wood_constants *w) {
  return (canal_cover){splat(w->canal.coverage), splat(w->canal.coverage * CANAL_CORE)};
}

/* Latewood's share of what is beside the canals. They take latewood rather than the
 * footprint's mix: all but in it when a ring lies under the footprint, and just what is
 * there when the footprint is small in its ring. */
INLINE vf canals_leave(const wood_constants *w, const canal_cover *c, vf bb, vf inverse_width,
                       vf late) {
  vf spread = bb * inverse_width * inverse_width, mixed = spread / (spread + splat(CANAL_MIXED));
  return late - c->whole * mixed * (splat(w->canal_late) - late);
}

INLINE canal_cover canals_at(const wood_constants *w, const vessel_place *p) {
  const ring_place *ring = &p->ring;
  vf one = splat(1.0f), zero = splat(0.0f), width = one / ring->inverse_width;
  vf start = ring->start + ring->turns * splat(w->ring_period),
     middle = start + splat(0.5f) * width;
  vi unused;
  vf per_row = splat(6.2831853f * w->canal_density / (float)w->canal_rows);
  vf count = vmax(vfloor(middle * width * per_row + splat(0.5f), &unused), one);
  vf arc = splat(6.2831853f) * vmax(p->rho, splat(0.05f)) / count;

  /* past the neighbours looked at and the ring, what is to be expected */
  vf far = vmax(vsqrt(p->f.aa) / arc, splat(1.4f) * vsqrt(p->f.bb) * ring->inverse_width);
  vf fade = smooth_step(splat(0.5f), one, far);
  canal_cover c = canals_expected(w);
  if (!any(lt(fade, one))) return c;

  vf turn = p->turn + splat(0.5f), k24 = splat(1.0f / 16777216.0f);
  vi n = to_int(count);
  vf radius2 = splat(w->canal.radius * w->canal.radius);
  matrix2 m = {p->f.aa, p->f.ab, p->f.bb};
  disc whole = disc_blurred(radius2, m), core = disc_blurred(radius2 * splat(CANAL_CORE), m);
  /* all of it within its ring */
  vf margin = splat(CANAL_MARGIN * w->canal.radius) * ring->inverse_width;
  vf low = vmin(vmax(splat(CANAL_LOW), margin), splat(0.5f)),
     high = vmax(one - margin, splat(0.5f));
  vf sum = zero, inner = zero;
  for (int row = 0; row < w->canal_rows; row++) {
    vu seed = (vu)ring->ring * splatu(HASH_Z) + wood_seed(w, p->own, SEED_CANALS);
    seed = hash_upper(seed + splatu((uint32_t)row * HASH_X));
    vf place = turn + to_float((vi)(seed >> 8)) * k24;
    place = (place - vfloor(place, &unused)) * count - splat(0.5f);
    vi k0;
    vf within = place - vfloor(place, &k0);
    UNROLL(2)
    for (int a = 0; a < 2; a++) {
      vi k = k0 + splati(a);
      k = seli(lti(k, splati(0)), k + n, k);
      k = seli(lti(k, n), k, k - n);
      vu h = hash_mix((vu)k * splatu(HASH_Y) + seed), g = hash_upper(h + splatu(HASH_X));
      vf jitter = to_float((vi)h) * splat(0.8f / 4294967296.0f);
      vf x = (within - splat((float)a) - jitter) * arc;
      vf at = low + (high - low) * vsqrt(to_float((vi)(g >> 8)) * k24);
      vf z = (ring->phase - at) * width;
      sum = sum + vessel_cover(&w->canal, &whole, h, disc_distance(&whole, x, z));
      inner = inner + vessel_cover(&w->canal, &core, h, disc_distance(&core, x, z));
    }
  }
  sum = vmin(sum * whole.height, one);
  inner = vmin(inner * core.height, sum);
  /* a mix by 1 may be a bit off: what a block skips must be what it would find */
  vm near = lt(fade, one);
  c.whole = sel(near, mix(sum, c.whole, fade), c.whole);
  c.core = sel(near, mix(inner, c.core, fade), c.core);
  return c;
}

#endif
