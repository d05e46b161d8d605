/* SPDX-License-Identifier: Apache-2.0
 *
 * Checks of end grain: wood shrinks more along its rings than across them, so that a cut end
 * splits along its rays. Two layers of sectors round the pith, each with shells of its own; a
 * shell of a sector has cells side by side, and most cells a check, which begins in the inner part
 * of its shell and ends in the outer one, widest between. They keep clear of their cells' edges, so
 * that a point looks into one cell of each layer; from a quarter of a cell on what is to be
 * expected takes over. What is expected is that of the cell: cells are wider outwards.
 *
 * The share of wood that is split is exact for a straight check and a square along the radius. Its
 * shoulders' height is a parabola of the distance, that a footprint widens.
 */
#ifndef SOZAI_WOOD_SURFACE_SPLITS_H
#define SOZAI_WOOD_SURFACE_SPLITS_H

#include "../rays.h"

typedef struct {
  vf open;            /* share of the footprint that is split */
  vf depth, arc, rho; /* over split_depth; slopes per mm */
  vf share, lost;     /* of the face, what slopes on the whole; and of that, what is not seen */
} split_place;

#define SPLIT_WANDER 0.35f /* mm, to either side, over SPLIT_WANDER_OVER */
#define SPLIT_WANDER_OVER 6.0f

/* One layer's check at (turn, rho); reach: mm to either side. */
INLINE split_place split_layer(const wood_surface *m, vu seed, int layer, vf turn, vf rho,
                               vf reach) {
  static const float sectors[SPLIT_LAYERS] = {5.0f, 7.0f};
  vf zero = splat(0.0f), one = splat(1.0f), k16 = splat(1.0f / 65536.0f);
  vi sector, shell, column;
  vf round = turn * splat(sectors[layer]), x = round - vfloor(round, &sector);
  seed = seed + splatu(HASH_X * (uint32_t)layer);
  vu own = hash_mix(seed + (vu)sector * splatu(HASH_Y));
  vf offset = to_float((vi)(own >> 16)) * k16;
  vf shells = rho * splat(m->inverse_split_length) + offset, low = vfloor(shells, &shell);
  vf within = shells - low;
  /* cells of a mean width in the shell's middle */
  vf middle = vmax(low - offset + splat(0.5f), splat(0.3f));
  vi unused;
  vf count = vfloor(middle * splat(m->split_cells / sectors[layer]) +
                        to_float((vi)(own & splatu(0xffffu))) * k16,
                    &unused);
  vm cells = gt(count, splat(0.5f));
  count = vmax(count, one);
  x = x * count;
  x = x - vfloor(x, &column);
  vf arc = vmax(rho, splat(0.5f)) * splat(6.2831853f / sectors[layer]) / count;

  vu h = hash_mix((vu)column * splatu(HASH_X) + (vu)shell * splatu(HASH_Z) + own);
  vu g = hash_upper(h + splatu(HASH_Z));
  vm some = and_(cells, lti((vi)(h & splatu(255u)), splati((int32_t)(256.0f * SPLIT_CHANCE))));
  vf place = splat(0.3f) + splat(0.4f / 255.0f) * to_float((vi)(h >> 8 & splatu(255u)));
  vf starts = splat(0.3f / 255.0f) * to_float((vi)(h >> 16 & splatu(255u)));
  vf ends = one - splat(0.4f / 255.0f) * to_float((vi)(h >> 24));
  vf plump = splat(0.35f) + splat(0.65f / 255.0f) * to_float((vi)(g & splatu(255u)));

  vf bend, up, per = splat(1.0f / SPLIT_WANDER_OVER), sway = splat(SPLIT_WANDER / HASH_ONE);
  noise_axis out = noise_split_cubic(rho * per, HASH_X), flat = noise_split_cubic(zero, HASH_Y);
  vf stray = noise_value2(&out, &flat, g, &bend, &up) * sway;
  bend = bend * sway * per;

  vf span = ends - starts, t = (within - starts) / span, lens = splat(4.0f) * t * (one - t);
  vf half = splat(m->split_half) * plump * vmax(lens, zero);
  /* at the pith the cells end in a point */
  half = sel(some, vmin(half, splat(SPLIT_NARROW) * arc), zero);
  vf a = (x - place) * arc + stray;
  split_place q;
  q.open = ray_overlap(a - reach, a + reach, half);
  vf gap = splat(SPLIT_SHOULDER) * half, wide = gap + reach, inverse = one / wide;
  vf share = gap * inverse, over = vmax(one - vabs(a) * inverse, zero);
  vf size = half * splat(1.0f / m->split_half);
  q.depth = size * share * over * over;
  vf slope = splat(-2.0f) * size * share * over * inverse;
  q.arc = sel(lt(a, zero), zero - slope, slope);
  q.rho = q.arc * bend;
  vf left = share * share * share;

  vf faded = smooth_step(splat(0.25f), splat(0.7f), reach / arc);
  vf keep = one - faded, mean = vmin(splat(m->split_mean) / arc, splat(SPLIT_MEAN * SPLIT_NARROW));
  mean = sel(cells, mean, zero);
  q.open = q.open * keep + faded * mean;
  q.depth = q.depth * keep + faded * mean * splat(SPLIT_DEEP);
  q.arc = q.arc * keep;
  q.rho = q.rho * keep;
  q.share = mean * splat(SPLIT_SHOULDER);
  q.lost = one - left * keep * keep;
  return q;
}

#endif
