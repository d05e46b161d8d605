/* SPDX-License-Identifier: Apache-2.0
 *
 * Bird's eyes: dimples of the growth front, dark about the edge and in the middle, one to a cell
 * or none. Their place in figure, and their shape, are told in figure.h.
 */
#ifndef SOZAI_WOOD_FIGURE_EYES_H
#define SOZAI_WOOD_FIGURE_EYES_H

#include "stem.h"

#define EYE_SECTORS 16
#define EYE_LAYERS 4
#define EYE_SHARE 0.62f /* of the cells that have one, the mean */
#define EYE_SWARM 0.38f /* how far the share departs from it: eyes swarm */

/* An eye's outline: how much its square of the radius is bent, as two lobes and three, and that it
 * is darker on one side, or open there. x, y: across and along the stem, over the radius. */
typedef struct {
  vf square, side;
} eye_shape;

INLINE eye_shape eye_shape_of(vu h, vf x, vf y) {
  const vf k = splat(0.7f / HASH_ONE), one = splat(1.0f), most = splat(0.95f);
  vf ux = to_float((vi)h) * k, uy = to_float((vi)(h << 10)) * k;
  vf bend = to_float((vi)(h << 20)) * splat(0.16f / HASH_ONE);
  vf square = x * x + y * y, inverse = inverse_root(vmax(square, splat(1e-6f)));
  /* the sine and cosine of twice the angle, and of three times, lobes turned as the side is */
  vf c = x * inverse, s = y * inverse, c2 = c * c - s * s, s2 = (c + c) * s;
  vf c3 = c2 * c - s2 * s, s3 = s2 * c + c2 * s;
  vf lobes = splat(0.22f) * (ux * c2 + uy * s2) + bend * (uy * c3 - ux * s3);
  eye_shape e = {square * (one + lobes), one + clamp(c * ux + s * uy, splat(0.0f) - most, most)};
  return e;
}

/* Its radius' square as a footprint widens it. */
INLINE vf eye_widened(vf r2, vf s2) { return r2 + splat(0.6667f) * s2; }

/* How dark an eye is, 0 to 1: an outline, half a radius off, and a pin in the middle. square: of
 * the distance from the middle; side: of the outline, a factor, mean 1; r2: that radius', which is
 * less than the dimple's; s2: the footprint's side's. A small footprint widens the outline, a wide
 * one fills it: a disc of the outline's variance, which is an eighth of the radius' square, and a
 * square's twelfth. What it has in all stays. */
INLINE vf eye_outline(vf square, vf side, vf r2, vf s2) {
  vf one = splat(1.0f), zero = splat(0.0f);
  vf wide = eye_widened(r2, s2), q = square / wide;
  vf t = vmin(q + q, one), ring = splat(4.0f) * t * (one - t);
  vf pin = splat(WOOD_EYE_PIN) * vmax(one - splat(10.0f) * q, zero);
  vf dark = (ring * ring * side + pin) * (r2 / wide);
  vf filled = clamp01((s2 - splat(0.06f) * r2) / (splat(0.5f) * r2));
  if (!any(gt(filled, zero))) return dark;
  wide = splat(1.5f) * r2 + s2;
  vf left = vmax(one - splat(1.5f) * square / wide, zero);
  return mix(dark, splat(4.5f * WOOD_EYE_MEAN) * (r2 / wide) * left * left, filled);
}

/* How much each eye tells of what a footprint has of them, beside the mean: outlines are spread
 * over it, so that it is several times as wide before neighbours matter. */
#define EYES_TOLD 5.0f /* radii: up to half of that all, from twice on nothing */
INLINE vf eyes_told(const wood_constants *w, vf footprint) {
  if (!filter_touches(footprint, EYES_TOLD * w->eye_radius)) return splat(1.0f);
  return filter_keep(footprint, EYES_TOLD * w->eye_radius);
}

/* The cell that a point is in, of (theta, y) within a shell of r. */
typedef struct {
  vu seed;                        /* of the layer's sector */
  vi shell, column, row;          /* of those */
  vu h, g;                        /* its random bits */
  vf angle;                       /* radians, that it spans */
  vf from_left, from_low, within; /* 0..1: how far round, up, and out in it the point is */
  vf inside;                      /* mm: the shell's inner radius */
  vf bottom, shift;               /* cells: its lower end, and how far those of its column are */
} eye_cell;

INLINE eye_cell eye_cell_of(const wood_constants *w, vu own, int layer, vf y, const stem_place *p) {
  eye_cell q;
  vf one = splat(1.0f), zero = splat(0.0f);
  /* the sectors of each are turned another way */
  static const float turns[EYE_LAYERS][2] = {
      {1.0f, 0.0f}, {0.96f, 0.28f}, {0.8f, 0.6f}, {0.6f, 0.8f}};
  vf tc = splat(turns[layer][0]), ts = splat(turns[layer][1]);
  vf c = tc * p->c - ts * p->s, s = ts * p->c + tc * p->s;
  vf turn = arctan2(s, c) * splat(0.15915494f);
  vi unused, sector;
  turn = turn - vfloor(turn, &unused);
  vf round = turn * splat((float)EYE_SECTORS), x = round - vfloor(round, &sector);
  q.seed = wood_seed(w, own, SEED_EYES + ((uint32_t)layer & 1u)) + (vu)sector * splatu(HASH_Y);
  q.seed += splatu((uint32_t)(layer >> 1) * HASH_Z);
  /* each sector's shells begin at radii of their own */
  vf offset = to_float((vi)(hash_upper(q.seed) >> 8)) * splat(1.0f / 16777216.0f);
  vf shells = p->r * splat(w->inverse_eye_length) + offset, low = vfloor(shells, &q.shell);
  q.within = shells - low;
  q.inside = vmax(low - offset, zero) * splat(w->eye_length);
  vf sector_arc = splat(6.2831853f / EYE_SECTORS);
  vf middle = (low + splat(0.5f) - offset) * splat(w->eye_length);
  vf count =
      vmax(vfloor(middle * sector_arc * splat(w->inverse_eye_cell) + splat(0.5f), &unused), one);
  x = x * count;
  q.from_left = x - vfloor(x, &q.column);
  q.angle = sector_arc / count;

  vu root = hash_mix((vu)q.column * splatu(HASH_X) + (vu)q.shell * splatu(HASH_Z) + q.seed);
  q.shift = to_float((vi)(root >> 16)) * splat(1.0f / 65536.0f);
  vf rows = y * splat(w->inverse_eye_cell) + q.shift;
  q.bottom = vfloor(rows, &q.row);
  q.from_low = rows - q.bottom;
  q.h = hash_mix((vu)q.row * splatu(HASH_Y) + root);
  q.g = hash_mix(q.h + splatu(HASH_Z));
  return q;
}

/* The eye that may stand there. */
typedef struct {
  vf radius, r2; /* mm; its square */
  vf turned;     /* radians: the point from its middle, */
  vf a, b;       /* mm: and along its axes, the second as if eyes were no longer than wide, */
  vf q;          /* and the square of that, over the radius' */
  vf lean;       /* of its length, across the stem */
  vf centre;     /* mm: its height on the stem */
} eye_place;

INLINE eye_place eye_place_of(const wood_constants *w, const eye_cell *cell, int layer, vf r) {
  eye_place e;
  vf one = splat(1.0f), k16 = splat(1.0f / 65536.0f), wide = cell->angle * cell->inside;
  /* the large ones in the first layer, of all sizes in the last */
  static const float sizes[EYE_LAYERS][2] = {
      {1.0f, 0.5f}, {0.75f, 0.6f}, {0.55f, 0.7f}, {0.35f, 0.9f}};
  vf least = splat(sizes[layer][0]), spread = splat(sizes[layer][1] / 1023.0f);
  vf radius = splat(w->eye_radius) * (least + spread * to_float((vi)(cell->g & splatu(1023u))));
  radius = vmin(radius, splat(0.42f) * cell->angle * cell->inside);
  e.radius = radius;
  e.r2 = vmax(radius * radius, splat(1e-6f));

  /* its middle keeps clear of the cell's edges, where the cell is narrowest; a
   * leaning one is a little wider */
  vf edge = splat(1.08f) * radius / vmax(wide, splat(1e-3f));
  vf place = edge + (one - edge - edge) * to_float((vi)(cell->h >> 16)) * k16;
  vf tall = radius * splat(WOOD_EYE_LONG * w->inverse_eye_cell);
  vf height = tall + (one - tall - tall) * to_float((vi)(cell->h & splatu(0xffffu))) * k16;
  e.turned = (cell->from_left - place) * cell->angle;
  e.b = (cell->from_low - height) * splat(w->eye_cell / WOOD_EYE_LONG);
  e.lean = splat(0.4f / 512.0f) * (to_float((vi)(cell->h & splatu(1023u))) - splat(512.0f));
  e.a = e.turned * r + e.lean * e.b;
  e.q = (e.a * e.a + e.b * e.b) / e.r2;
  e.centre = (cell->bottom + height - cell->shift) * splat(w->eye_cell);
  return e;
}

/* Whether it stands there, and the footprint has any of it. s2: its side's square. */
INLINE vm eye_there(const eye_cell *cell, const eye_place *e, vf s2) {
  /* one that would reach y = 0 is not there */
  vm there = gt(vabs(e->centre), e->radius * splat(WOOD_EYE_LONG));
  noise_axis x = noise_split_cubic(to_float(cell->column) * splat(0.31f), HASH_X);
  noise_axis y = noise_split_cubic(to_float(cell->row) * splat(0.23f), HASH_Y);
  vf unused_x, unused_y;
  vf swarm =
      noise_value2(&x, &y, cell->seed + (vu)cell->shell * splatu(HASH_Z), &unused_x, &unused_y);
  vf share = splat(EYE_SHARE) + splat(EYE_SWARM / HASH_ONE) * swarm;
  there = and_(there, lt(to_float((vi)(cell->g >> 22)), share * splat(1024.0f)));
  there = and_(there, gt(e->radius, splat(1e-2f)));
  /* a wide footprint sees it from further away */
  return and_(there, lt(e->q * e->r2, eye_widened(e->r2, s2)));
}

/* How far grown it is, 0 to 1, and the slope of that along the radius: it begins in the shell's
 * inner quarter and ends in its outer. */
INLINE vf eye_grown(const wood_constants *w, const eye_cell *cell, vf *slope) {
  vf one = splat(1.0f);
  vf starts = splat(0.25f / 63.0f) * to_float((vi)(cell->g >> 10 & splatu(63u)));
  vf ends = one - splat(0.25f / 63.0f) * to_float((vi)(cell->g >> 16 & splatu(63u)));
  vf in = clamp01((cell->within - starts) * splat(10.0f));
  vf out = clamp01((ends - cell->within) * splat(10.0f));
  vf ein = in * in * (splat(3.0f) - in - in), eout = out * out * (splat(3.0f) - out - out);
  *slope =
      splat(60.0f * w->inverse_eye_length) * (in * (one - in) * eout - out * (one - out) * ein);
  return ein * eout;
}

/* How dark the footprint sees it. */
INLINE vf eye_dark(const wood_constants *w, const eye_cell *cell, const eye_place *e, vf grown,
                   vf footprint, vf s2) {
  vf own = splat(WOOD_EYE_DARK - WOOD_EYE_DARKS) +
           splat(2.0f * WOOD_EYE_DARKS / 255.0f) * to_float((vi)(cell->g >> 2 & splatu(255u)));
  vf per = inverse_root(e->r2);
  eye_shape shape = eye_shape_of(hash_mix(cell->g ^ splatu(HASH_Y)), e->a * per, e->b * per);
  vf dark = eye_outline(shape.square * e->r2, shape.side, splat(WOOD_EYE_RIM) * e->r2, s2);
  return vmin(eyes_told(w, footprint) * dark * grown * own, splat(1.0f));
}

/* One of the layers, each with as many of them: together they line up less. Seldom
 * is one alone. */
INLINE void figure_eyes(const wood_constants *w, vu own, int layer, vf y, vf footprint,
                        stem_place *p, undulation_sum *u) {
  vf one = splat(1.0f), zero = splat(0.0f), s2 = footprint * footprint;
  eye_cell cell = eye_cell_of(w, own, layer, y, p);
  eye_place e = eye_place_of(w, &cell, layer, p->r);
  vm there = eye_there(&cell, &e, s2);
  if (!any(there)) return;
  vf age_r, age = eye_grown(w, &cell, &age_r), keep = one;
  if (filter_touches(footprint, 2.0f * w->eye_radius)) {
    keep = filter_keep(footprint, 2.0f * w->eye_radius);
  }
  vf depth = sel(there, splat(w->eye_depth) * e.radius * keep, zero);
  vf left = vmax(one - e.q, zero), left2 = left * left;
  vf dent = depth * left2 * left;
  vf fall = splat(6.0f) * depth * left2 * age / e.r2;
  vf along = fall * e.a, out_r = along * e.turned - dent * age_r;
  vf dark = eye_dark(w, &cell, &e, age, footprint, s2);
  p->eye = vmax(p->eye, sel(there, dark, zero));
  u->n = u->n - dent * age;
  u->nx = u->nx + (out_r * p->c - along * p->s);
  u->nz = u->nz + (out_r * p->s + along * p->c);
  u->ny = u->ny + fall * (e.b + e.a * e.lean) * splat(1.0f / WOOD_EYE_LONG);
}

#endif
