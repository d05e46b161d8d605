/* SPDX-License-Identifier: Apache-2.0
 *
 * Single cells, for footprints of some hundredths of a millimetre: in conifers
 * radial files of tracheids, flattening from early- to latewood while their walls
 * thicken; in broadleaved wood fibres; tyloses and the rims of elements within
 * vessels.
 *
 * What they add to a colour has mean zero: a lumen is darker than its tissue's
 * mean by the share of walls, a wall brighter by the share of lumina. Over a box
 * the pattern of each file is integrated exactly, and those of five files at most are
 * summed; from four cells on nothing is left and nothing computed.
 */
#ifndef SOZAI_WOOD_CELLS_H
#define SOZAI_WOOD_CELLS_H

#include "../core/noise.h"
#include "vessels.h"

/* The mean over x - e/2 .. x + e/2 of a pulse that repeats with 1: 1 over the
 * middle `on` of each unit, else 0. */
INLINE vf cell_pulse_integral(vf x, vf on) {
  vi unused;
  vf whole = vfloor(x, &unused);
  return whole * on + clamp(x - whole - splat(0.5f) * (splat(1.0f) - on), splat(0.0f), on);
}

INLINE vf cell_pulse(vf x, vf e, vf on) {
  vf half = splat(0.5f) * e;
  return (cell_pulse_integral(x + half, on) - cell_pulse_integral(x - half, on)) / e;
}

#define CELL_SHARP 0.12f                                  /* of a cell: no wall's edge is sharper */
#define CELL_TAPER 0.05f                                  /* of a cell's length, at each end */
#define CELL_TIP 0.4f                                     /* of its width, at the end */
#define CELL_MEAN (1.0f - CELL_TAPER * (1.0f - CELL_TIP)) /* of the width */

/* What cells add to a tissue's colour, relative, before the contrast. late: how far
 * towards latewood; end: 1 on end grain, 0 along the fibre. */
INLINE vf cells_tissue(const wood_constants *w, const vessel_place *p, vf y, vf late, vf end,
                       vf *contrast) {
  *contrast = splat(0.0f);
  vf zero = splat(0.0f), one = splat(1.0f), half = splat(0.5f);
  vf e2 = p->f.aa + p->f.bb;
  if (!any(lt(e2, splat(w->cell_gone * w->cell_gone)))) return zero;
  const ring_place *ring = &p->ring;
  vi file, n;
  vf width = one / ring->inverse_width;
  vf middle = ring->start + ring->turns * splat(w->ring_period) + half * width;
  vf count = vfloor(middle * splat(6.2831853f * w->inverse_cell_width) + half, &n);
  count = vmax(count, splat(3.0f));
  vf turn = (place_has_turn(w) ? p->turn : place_turn(p->c, p->s)) + half;
  vf x = turn * count, in = x - vfloor(x, &file);
  vf arc = splat(6.2831853f) * vmax(p->rho, splat(0.05f)) / count;
  vu seed = hash_mix((vu)ring->ring * splatu(HASH_Z) + wood_seed(w, p->own, SEED_CELLS));

  /* the number of cells from the ring's start, and how deep one is */
  vf early = splat(w->inverse_cell_early);
  vf more = splat(w->inverse_cell_late - w->inverse_cell_early);
  vf cells = width * (ring->phase * early + late_integral(w, ring->phase) * more);
  vf deep = one / (early + late * more);

  /* walls of the thickness that leaves the lumina their share */
  vf share = mix(splat(w->wall_early), splat(w->wall_late), late);
  vf open = (one - share) * splat(1.0f / CELL_MEAN);
  vf sum = arc + deep, four = splat(4.0f) * arc * deep * (one - open);
  vf wall = (sum - vsqrt(vmax(sum * sum - four, zero))) * splat(0.25f);
  vf across = one - (wall + wall) / arc, along = one - (wall + wall) / deep;

  /* how a square lies that the footprint stands for is not known: from a cell's
   * size on, regular detail is gone */
  vf ex = vmax(vsqrt(p->f.aa) / arc, splat(CELL_SHARP));
  vf er = vmax(vsqrt(p->f.bb) / deep, splat(CELL_SHARP));
  vf plain_x = smooth_step(splat(0.7f), splat(1.3f), ex);
  vf plain_r = smooth_step(splat(0.7f), splat(1.3f), er), wide = clamp01(er - half);
  vf low = in - half * ex, high = in + half * ex, lumen = zero;
  for (int d = -2; d <= 2; d++) {
    /* what of the file lies within the footprint */
    vf left = splat((float)d), right = splat((float)d + 1.0f);
    vf whole = vmax(vmin(high, right) - vmax(low, left), zero);
    if (d && !any(gt(whole, zero))) continue;
    vi which = file + splati(d);
    vu h = hash_mix((vu)which * splatu(HASH_X) + seed);
    /* files are offset by golden parts of a cell, so that few of them are alike;
     * and a little at random */
    vf golden = to_float((vi)((vu)which * splatu(0x9e3779b9u) >> 8)) * splat(1.0f / 16777216.0f);
    vf c = cells + golden + to_float((vi)(h >> 16)) * splat(0.2f / 65536.0f);
    vi cell, unused2;
    vfloor(c, &cell);
    /* ends taper; neighbours' do not lie side by side */
    vf offset = to_float((vi)(hash_upper(h + (vu)cell * splatu(HASH_Y)) >> 8));
    vf rows = y * splat(w->inverse_cell_length) + offset * splat(1.0f / 16777216.0f);
    vf at = rows - vfloor(rows, &unused2);
    vf taper = clamp01(vmin(at, one - at) * splat(1.0f / CELL_TAPER));
    taper = splat(CELL_TIP) + splat(1.0f - CELL_TIP) * taper;
    vf on = across * mix(taper, splat(CELL_MEAN), wide);
    vf edge = half * (one - on);
    vf x1 = vmax(vmin(high, right - edge) - vmax(low, left + edge), zero);
    x1 = mix(x1, whole * on, plain_x);
    lumen = lumen + x1 * mix(cell_pulse(c, er, along), along, plain_r);
  }
  lumen = lumen / ex;
  vf gone2 = splat(w->cell_gone * w->cell_gone);
  vf keep = one - smooth_step(splat(0.25f) * gone2, gone2, e2);
  *contrast = mix(splat(w->cell_side), splat(w->cell_end), end);
  return keep * (one - share - lumen);
}

/* The contrast that a colour has room for: no wall is brighter than white. */
INLINE vf cells_room(const wood_constants *w, vf colour) {
  vf room = splat(w->cell_white) / vmax(colour, splat(0.01f)) - splat(w->cell_open);
  return vmax(room, splat(0.0f));
}

#define TYLOSE_EDGE 0.08f   /* of its size, half a membrane's width */
#define TYLOSE_MEAN 0.1324f /* of the membranes' cover, measured */
#define RIM_WIDTH 0.12f     /* of an element's length */

/* What is seen within the earlywood's vessels, and within all: relative to
 * their colour, mean zero. (x, z), y: the fibre's place and height. s: footprint. */
INLINE vf cells_tyloses(const wood_constants *w, vu own, vf x, vf y, vf z, vf s) {
  vf one = splat(1.0f), zero = splat(0.0f), k = splat(w->inverse_tylose);
  vf keep = one - smooth_step(splat(0.5f), splat(1.6f), s * k);
  if (w->tyloses <= 0.0f || !any(gt(keep, zero))) return zero;
  vf g[3],
      n = noise_gradient3(x * k, y * splat(0.6f) * k, z * k, wood_seed(w, own, SEED_TYLOSES), g);
  vf steep = vsqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) + splat(1e-3f);
  /* blurred: wider, and lower by as much */
  vf blur = splat(0.5f) * s * k;
  vf thin = splat(TYLOSE_EDGE) * inverse_root(splat(TYLOSE_EDGE * TYLOSE_EDGE) + blur * blur);
  vf cover = clamp01(one - vabs(n) * thin / (steep * splat(TYLOSE_EDGE))) * thin;
  return splat(w->tyloses) * keep * (cover - splat(TYLOSE_MEAN));
}

INLINE vf cells_rims(const wood_constants *w, vu own, vf x, vf y, vf z, vf s, vf extent) {
  vf one = splat(1.0f), zero = splat(0.0f), k = splat(w->inverse_element), dx, dz;
  vf e = vmax(extent * k, splat(0.03f));
  vf keep = (one - smooth_step(splat(0.7f), splat(1.4f), e)) *
            (one - smooth_step(splat(0.1f), splat(0.3f), s));
  if (!any(gt(keep, zero))) return zero;
  /* each vessel's begin elsewhere, and its rims lie oblique */
  noise_axis ax = noise_split_cubic(x * splat(3.0f), HASH_X);
  noise_axis az = noise_split_cubic(z * splat(3.0f), HASH_Z);
  vf shift =
      noise_value2(&ax, &az, wood_seed(w, own, SEED_RIMS), &dx, &dz) * splat(1.0f / HASH_ONE);
  vf rim = cell_pulse(y * k + splat(1.5f) * shift, e, splat(RIM_WIDTH));
  return splat(w->cell_side) * keep * (rim - splat(RIM_WIDTH));
}

#endif
