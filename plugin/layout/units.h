/* SPDX-License-Identifier: Apache-2.0
 *
 * From a place in the plane to the unit (board, block, stone) that covers it.
 *
 * Every place has exactly one unit: of a tile's pieces the one that the place
 * lies deepest in, of a function's the one it names. The cell is split off as
 * a whole number first; everything after is small.
 */
#ifndef SOZAI_LAYOUT_UNITS_H
#define SOZAI_LAYOUT_UNITS_H

#include "../core/hash.h"
#include "cover.h"

typedef struct {
  vu id;            /* different for each; to be hashed */
  vf u, v;          /* mm: place in the unit, from its own corner */
  vf length, width; /* mm: along u and v */
  vf c, s;          /* direction of u in the plane */
  vf edge;          /* mm to the unit's edge, positive inside */
  vf inx, iny;      /* unit, in the plane: from the nearest edge inwards */
  vf joint;         /* share of the footprint that is joint */
  vf own;           /* share of it that lies in the unit's own cell */
} layout_unit;

/* A multiplier whose lattice has no short vectors modulo 2^17 to 2^24 and 2^32
 * (at least 0.86 of the root of the modulus, found by search): so far apart
 * are the nearest two cells of one number. */
#define LAYOUT_SPREAD 0x0606656bu

INLINE vu layout_id(const layout *l, vi i, vi j, vi k) {
  return ((vu)i + (vu)j * splatu(LAYOUT_SPREAD)) * splatu((uint32_t)l->numbers) + (vu)k;
}

/* The id as a number that a float holds. */
INLINE vf layout_number(vu id) { return to_float((vi)(id & splatu(0xffffffu))); }

/* 0..1 from a hash. */
INLINE vf layout_random(vu h) { return to_float((vi)(h >> 8)) * splat(1.0f / 16777216.0f); }

/* The frame and id; the distances have gone into the cover. */
INLINE void unit_frame(layout_unit *p, vu id, vf u, vf v, vf length, vf width, vf c, vf s) {
  p->id = id;
  p->u = u;
  p->v = v;
  p->length = length;
  p->width = width;
  p->c = c;
  p->s = s;
}

/* ---- tiles ------------------------------------------------------------ */

INLINE void unit_of_table(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  vi i, j;
  vf fi = vfloor(splat(l->to_i[0]) * x + splat(l->to_i[1]) * y, &i);
  vf fj = vfloor(splat(l->to_j[0]) * x + splat(l->to_j[1]) * y, &j);
  x = x - fi * splat(l->a[0]) - fj * splat(l->b[0]);
  y = y - fi * splat(l->a[1]) - fj * splat(l->b[1]);
  vf deepest = splat(-1e30f);
  vi k = splati(0);
  for (int32_t n = 0; n < l->pieces; n++) {
    vf depth = splat(l->nx[0][n]) * x + splat(l->ny[0][n]) * y + splat(l->d[0][n]);
    for (int32_t s = 1; s < l->sides; s++) {
      vf d = splat(l->nx[s][n]) * x + splat(l->ny[s][n]) * y + splat(l->d[s][n]);
      depth = vmin(depth, d);
    }
    vm deeper = gt(depth, deepest);
    deepest = sel(deeper, depth, deepest);
    k = seli(deeper, splati(n), k);
  }
  vf d[LAYOUT_SIDES], nx[LAYOUT_SIDES], ny[LAYOUT_SIDES];
  for (int32_t s = 0; s < l->sides; s++) {
    nx[s] = gather(l->nx[s], k);
    ny[s] = gather(l->ny[s], k);
    d[s] = nx[s] * x + ny[s] * y + gather(l->d[s], k);
  }
  if (l->quads) {
    cover_pair(c, d[0], d[2], nx[0], ny[0], l->joint, e);
    cover_pair(c, d[1], d[3], nx[1], ny[1], l->joint, e);
  } else {
    for (int32_t s = 0; s < l->sides; s++) {
      /* a piece of fewer sides has its last one again, which counts once */
      vm again = s ? and_(eq(d[s], d[s - (s > 0)]), eq(nx[s], nx[s - (s > 0)])) : lt(e, e);
      cover_one(c, sel(again, splat(1e9f), d[s]), nx[s], ny[s], l->joint, e);
    }
  }
  vf cx = gather(l->along_x, k), cy = gather(l->along_y, k);
  x = x - gather(l->corner_x, k);
  y = y - gather(l->corner_y, k);
  vu id = layout_id(l, i + gatheri(l->cell_i, k), j + gatheri(l->cell_j, k), gatheri(l->number, k));
  unit_frame(p, id, x * cx + y * cy, y * cx - x * cy, gather(l->piece_length, k),
             gather(l->piece_width, k), cx, cy);
}

/* ---- courses of random lengths ---------------------------------------- */

/* Where the n-th end of a course strays to, of the length. */
INLINE vf strip_end(const layout *l, vi n, vu course) {
  vf r = layout_random(hash_mix((vu)n * splatu(HASH_X) + course));
  return (r + r - splat(1.0f)) * splat(l->jitter);
}

typedef struct {
  vi i, j;
  vf u, v, length;
} strip_place;

/* Even courses begin within 0 .. 1/2 - stagger of a length, odd ones half a
 * length on: ends of neighbours are `stagger` apart less what they stray. */
INLINE strip_place strip_at(const layout *l, vf x, vf y) {
  strip_place p;
  vf one = splat(1.0f), q = y * splat(l->inverse_width);
  vf row = vfloor(q, &p.j);
  p.v = y - row * splat(l->width);
  vu course = hash_mix((vu)p.j * splatu(HASH_Y) + splatu(HASH_Z));
  vf half = to_float(p.j & splati(1)) * splat(0.5f);
  vf shift = half + layout_random(course) * splat(0.5f - l->stagger);
  vf f = x * splat(l->inverse_length) - shift;
  vi n;
  f = f - vfloor(f, &n);
  vf low = strip_end(l, n, course), high = one + strip_end(l, n + splati(1), course);
  vm before = lt(f, low), after = le(high, f);
  vf first = strip_end(l, n - splati(1), course) - one;
  vf last = splat(2.0f) + strip_end(l, n + splati(2), course);
  vf start = sel(before, first, sel(after, high, low));
  vf end = sel(before, low, sel(after, last, high));
  p.i = seli(before, n - splati(1), seli(after, n + splati(1), n));
  p.u = (f - start) * splat(l->length);
  p.length = (end - start) * splat(l->length);
  return p;
}

INLINE void unit_of_strip(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  strip_place at = strip_at(l, x, y);
  vf one = splat(1.0f), zero = splat(0.0f), width = splat(l->width);
  cover_pair(c, at.v, width - at.v, zero, one, l->joint, e);
  cover_pair(c, at.u, at.length - at.u, one, zero, l->joint, e);
  unit_frame(p, layout_id(l, at.i, at.j, splati(0)), at.u, at.v, at.length, width, one, zero);
}

/* A course's blocks, each broken upright or not, and each part across or not. */
INLINE void unit_of_ashlar(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  strip_place at = strip_at(l, x, y);
  vf one = splat(1.0f), zero = splat(0.0f), width = splat(l->width);
  vi id = (vi)layout_id(l, at.i, at.j, splati(0));
  vu h = hash_mix((vu)id + splatu(HASH_X));
  vf upright = (splat(0.35f) + splat(0.3f) * layout_random(h)) * at.length;
  upright = sel(lti((vi)(h & splatu(255u)), splati(128)), at.length, upright);
  vm right = lt(upright, at.u);
  vf x0 = sel(right, upright, zero), length = sel(right, at.length - upright, upright);
  id = seli(right, id + splati(1), id);
  vu g = hash_mix((vu)id + splatu(HASH_Y));
  vf across = (splat(0.35f) + splat(0.3f) * layout_random(g)) * width;
  across = sel(lti((vi)(g & splatu(255u)), splati(128)), width, across);
  vm upper = lt(across, at.v);
  vf y0 = sel(upper, across, zero), high = sel(upper, width - across, across);
  vf u = at.u - x0, v = at.v - y0;
  cover_pair(c, v, high - v, zero, one, l->joint, e);
  cover_pair(c, u, length - u, one, zero, l->joint, e);
  unit_frame(p, (vu)seli(upper, id + splati(2), id), u, v, length, high, one, zero);
}

/* ---- irregular polygons ----------------------------------------------- */

/* The point of cell (i, j), in cells from its middle. At 0.3 a place's nearest
 * point is never two cells off, nor its nearest edge's third. */
INLINE void crazy_point(vi i, vi j, vf *x, vf *y) {
  vu h = hash_mix((vu)i * splatu(HASH_X) + (vu)j * splatu(HASH_Y));
  vf k = splat(0.6f / 65536.0f), half = splat(0.3f);
  *x = to_float((vi)(h >> 16)) * k - half;
  *y = to_float((vi)(h & splatu(0xffffu))) * k - half;
}

INLINE void unit_of_crazy(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  vi i, j, ni = splati(0), nj = ni;
  vf size = splat(l->length), inverse = splat(l->inverse_length), least = splat(1e9f);
  x = x * inverse;
  y = y * inverse;
  x = x - vfloor(x, &i) - splat(0.5f);
  y = y - vfloor(y, &j) - splat(0.5f);
  vf px = splat(0.0f), py = px, sx, sy;
  for (int n = 0; n < 9; n++) {
    int a = n % 3 - 1, b = n / 3 - 1;
    crazy_point(i + splati(a), j + splati(b), &sx, &sy);
    vf dx = sx + splat((float)a) - x, dy = sy + splat((float)b) - y, d = dx * dx + dy * dy;
    vm nearer = lt(d, least);
    least = sel(nearer, d, least);
    px = sel(nearer, dx, px);
    py = sel(nearer, dy, py);
    ni = seli(nearer, splati(a), ni);
    nj = seli(nearer, splati(b), nj);
  }
  for (int n = 0; n < 25; n++) {
    int a = n % 5 - 2, b = n / 5 - 2;
    crazy_point(i + splati(a), j + splati(b), &sx, &sy);
    /* to the line half way between the two points */
    vf dx = px - (sx + splat((float)a) - x), dy = py - (sy + splat((float)b) - y);
    vf square = dx * dx + dy * dy;
    vm itself = and_(eqi(ni, splati(a)), eqi(nj, splati(b)));
    vf k = inverse_root(vmax(square, splat(1e-6f)));
    vf ax = dx * k, ay = dy * k; /* from the other point to the own */
    vf middle_x = px - splat(0.5f) * dx, middle_y = py - splat(0.5f) * dy;
    vf d = splat(0.0f) - (middle_x * ax + middle_y * ay);
    cover_one(c, sel(itself, splat(1e9f), d * size), ax, ay, l->joint, e);
  }
  vu id = layout_id(l, i + ni, j + nj, splati(0));
  vf s, co, u = splat(0.0f) - px * size, v = splat(0.0f) - py * size;
  sine_cosine_turns(layout_random(hash_mix(id + splatu(HASH_Z))), &s, &co);
  vf half = splat(0.5f) * size;
  unit_frame(p, id, u * co + v * s + half, v * co - u * s + half, size, size, co, s);
}

/* ---- round about ------------------------------------------------------ */

#define TWO_PI_ 6.2831853f
#define UNIT_FAR                                                                                   \
  16.0f /* widths: to a side that is not there; much more would not tell footprints */

/* Distance from radius r to the ray `turns` away. */
INLINE vf ray_distance(vf r, vf turns) {
  vf s, c;
  sine_cosine_turns(vmin(turns, splat(0.25f)), &s, &c);
  return r * s;
}

INLINE void unit_of_circles(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  vf one = splat(1.0f), zero = splat(0.0f), far = splat(1e9f), width = splat(l->width);
  vf r = vsqrt(vmax(x * x + y * y, splat(1e-12f)));
  vi ring, m;
  vf in = vfloor(r * splat(l->inverse_width), &ring) * width;
  vm middle = eqi(ring, splati(0));
  vf round = splat(TWO_PI_) * (in + splat(0.5f) * width);
  vf count = vmax(vfloor(round * splat(l->inverse_length) + splat(0.5f), &m), splat(4.0f));
  count = sel(middle, one, count);
  vu h = hash_mix((vu)ring * splatu(HASH_Y) + splatu(HASH_X));
  vf turns = arctan2(y, x) * splat(1.0f / TWO_PI_) + splat(0.5f) + layout_random(h);
  vi unused;
  turns = turns - vfloor(turns, &unused);
  vf place = turns * count;
  vf f = place - vfloor(place, &m);
  vi last = to_int(count) - splati(1);
  m = seli(lti(last, m), last, m);
  vf inverse = one / r, cx = x * inverse, cy = y * inverse;
  vf v = r - in;
  cover_pair(c, sel(middle, far, v), width - v, cx, cy, l->joint, e);
  vf low = ray_distance(r, f / count), high = ray_distance(r, (one - f) / count);
  cover_pair(c, sel(middle, far, low), sel(middle, far, high), zero - cy, cx, l->joint, e);
  vf length = sel(middle, width + width, round / count);
  /* the stone in the middle has a frame that does not turn */
  vf u = sel(middle, x + width, f * length);
  vf inwards = sel(middle, y + width, width - v);
  unit_frame(p, layout_id(l, m, ring, splati(0)), u, inwards, length,
             sel(middle, width + width, width), sel(middle, one, zero - cy), sel(middle, zero, cx));
}

INLINE void unit_of_arcs(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  vf one = splat(1.0f), zero = splat(0.0f), width = splat(l->width), half = splat(0.5f);
  vf radius = splat(l->radius), bay = splat(10.0f * l->width);
  vi i, j, m;
  vf q = x * splat(0.1f * l->inverse_width);
  vf across = (q - vfloor(q, &i) - half) * bay;
  vf rise = vsqrt(vmax(radius * radius - across * across, zero));
  vf row = vfloor((y - rise) * splat(l->inverse_width), &j);
  /* about the middle of the arc below, and of that above */
  vf up = y - row * width, up1 = up - width, square = across * across;
  vf r = vsqrt(square + up * up), r1 = vsqrt(square + up1 * up1);
  vf low = r - radius, high = radius - r1;
  vf inverse = one / vmax(r, splat(1e-3f)), cx = across * inverse, cy = up * inverse;
  /* As many setts as fit the bay's middle height. Every other row is half a sett on, and begins
   * and ends with one and a half, as paviours have it, for halves would be slivers. What the bay
   * is wider or narrower by, below and above, is the end setts' too. */
  vf odd = to_float(j & splati(1)), far = splat(UNIT_FAR * l->width), count = splat(l->around);
  vf place = (arctan2(across, up) * splat(1.0f / LAYOUT_ARC) + one) * half * count + odd * half;
  vf f = clamp(vfloor(place, &m), odd, count - one);
  vm first = le(f, odd), last = le(count - one, f);
  m = to_int(f);
  f = place - f;
  vf turns = splat(2.0f * LAYOUT_ARC / TWO_PI_) / count;
  vf length = splat(LAYOUT_ARC_LONG * l->width) / count;
  cover_pair(c, low, high, cx, cy, l->joint, e);
  cover_pair(c, sel(first, far, ray_distance(r, vmax(f, zero) * turns)),
             sel(last, far, ray_distance(r, vmax(one - f, zero) * turns)), cy, zero - cx, l->joint,
             e);
  cover_pair(c, across + half * bay, half * bay - across, one, zero, l->joint, e);
  vi n = i * splati(64) + (m & splati(63));
  unit_frame(p, layout_id(l, n, j, splati(0)), f * length, low, length, width, cy, zero - cx);
}

/* Fans that overlap as scales do: each a quarter of a disc about its tip, the
 * rows half a fan apart, the lower over the upper. */
INLINE void unit_of_fan(const layout *l, vf x, vf y, vf e, layout_unit *p, cover *c) {
  vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f), width = splat(l->width);
  const float rho = l->radius, d = 0.70710678f * rho;
  vf radius = splat(rho), side = splat(d);
  vi i, j, upper_i, k, m;
  vf row = vfloor(y * splat(1.0f / d), &j);
  vf ly = y - row * side;
  /* the tips of odd rows stand half a fan on: in its own row, and one below */
  vf own = to_float(j & splati(1)), other = one - own;
  vf q = x * splat(0.5f / d) - half * own + half, q1 = x * splat(0.5f / d) - half * other + half;
  vf lx = (q - vfloor(q, &upper_i) - half) * (side + side);
  vf lx1 = (q1 - vfloor(q1, &i) - half) * (side + side);
  vf ly1 = ly + side;
  vm lower = lt(lx1 * lx1 + ly1 * ly1, radius * radius);
  lx = sel(lower, lx1, lx);
  ly = sel(lower, ly1, ly);
  i = seli(lower, i, upper_i);
  j = seli(lower, j - splati(1), j);
  vf r = vsqrt(vmax(lx * lx + ly * ly, splat(1e-6f))), inverse = one / r;
  vf ring = vmin(vfloor(r * splat(l->inverse_width), &k), splat(rho * l->inverse_width - 0.5f));
  vi unused;
  ring = vfloor(ring, &unused);
  k = to_int(ring);
  vf in = ring * width, low = r - in;
  vf cx = lx * inverse, cy = ly * inverse, far = splat(UNIT_FAR * l->width);
  cover_pair(c, sel(eqi(k, splati(0)), far, low), width - low, cx, cy, l->joint, e);
  /* the fans below, to the left and right, and those beside */
  for (int s = -1; s <= 1; s += 2) {
    vf ax = lx - splat((float)s * d), ay = ly + side;
    vf ra = vsqrt(ax * ax + ay * ay), ia = one / ra;
    cover_one(c, ra - radius, ax * ia, ay * ia, l->joint, e);
    cover_one(c, side - splat((float)s) * lx, splat((float)-s), zero, l->joint, e);
  }
  /* how far the ring opens to either side, at its middle */
  vf rm = in + half * width, t = vmin(rm * splat(1.0f / rho), one);
  vf open = sel(lt(t, splat(0.76536686f)), splat(0.78539816f) + arcsin(half * t),
                arcsin(splat(0.70710678f) / vmax(t, splat(0.70710678f))));
  vf count = vfloor((open + open) * rm * splat(l->inverse_length) + half, &unused);
  const int32_t most = l->numbers / 10; /* setts that a ring has numbers for */
  count = clamp(count, one, splat((float)most));
  vf place = (arctan2(lx, ly) / open + one) * half * count;
  vf f = clamp(vfloor(place, &m), zero, count - one);
  m = to_int(f);
  f = place - f;
  vf turns = open / (count * splat(0.5f * TWO_PI_));
  vm first = eqi(m, splati(0)), last = eqi(m + splati(1), to_int(count));
  vf before = ray_distance(r, vmax(f, zero) * turns),
     after = ray_distance(r, vmax(one - f, zero) * turns);
  cover_pair(c, sel(first, far, before), sel(last, far, after), cy, zero - cx, l->joint, e);
  vf length = (open + open) * rm / count;
  vi n = k * splati(most) + m;
  unit_frame(p, layout_id(l, i, j, n), f * length, low, length, width, cy, zero - cx);
}

/* ---- which ------------------------------------------------------------ */

/* The unit at (x, y) of the plane, mm, under a footprint of side e; below
 * 1e6 mm. What its sides told the cover is in *at. */
INLINE layout_unit layout_find(const layout *l, vf x, vf y, const vf face[2], vf e, cover *at) {
  layout_unit p;
  vf co = splat(l->cosine), si = splat(l->sine);
  cover c = cover_begin(face);
  if (face) {
    c.face[0] = face[0] * co + face[1] * si;
    c.face[1] = face[1] * co - face[0] * si;
  }
  vf u = x * co + y * si, v = y * co - x * si;
  e = vmax(e, splat(COVER_LEAST));
  if (l->pieces) {
    unit_of_table(l, u, v, e, &p, &c);
  } else if (l->kind == LAYOUT_ASHLAR) {
    unit_of_ashlar(l, u, v, e, &p, &c);
  } else if (l->kind == LAYOUT_CRAZY) {
    unit_of_crazy(l, u, v, e, &p, &c);
  } else if (l->kind == LAYOUT_CIRCLES) {
    unit_of_circles(l, u, v, e, &p, &c);
  } else if (l->kind == LAYOUT_ARCS) {
    unit_of_arcs(l, u, v, e, &p, &c);
  } else if (l->kind == LAYOUT_FAN) {
    unit_of_fan(l, u, v, e, &p, &c);
  } else {
    unit_of_strip(l, u, v, e, &p, &c);
  }
  p.edge = c.nearest - splat(0.5f * l->joint);
  p.inx = c.nx * co - c.ny * si;
  p.iny = c.nx * si + c.ny * co;
  vf pc = p.c, ps = p.s;
  p.c = pc * co - ps * si;
  p.s = pc * si + ps * co;
  p.own = c.own;
  p.joint = cover_joint(l, &c, p.length, p.width, e);
  *at = c;
  return p;
}

INLINE layout_unit layout_at(const layout *l, vf x, vf y, vf e) {
  cover unused;
  return layout_find(l, x, y, NULL, e, &unused);
}

#endif
