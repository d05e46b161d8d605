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
#include "rays.h"
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

/* Uniseriate rays, which stand between files: procumbent cells of the size usual in wood
 * (Carlquist, Comparative Wood Anatomy, 2001; IAWA lists, 1989 and 2004). */
#define RAY_CELL 0.11f       /* mm: a ray's cell along the radius; RAY_ROW along the fibre, */
#define RAY_CELL_WIDE 0.012f /* and across, in rays of many */
#define RAY_CELL_SHADE 0.7f  /* by which cells are brighter and darker, in the contrast of walls */
#define FINE_RAY_PART 0.47f  /* of a file's width, that a ray takes from the file beside it, */
#define FINE_RAY_RAGGED 0.3f /* of that: by which its rows begin later, and end sooner or later */
#define FINE_RAY_FILLED (1.0f - 0.5f * FINE_RAY_RAGGED)
#define FINE_RAY_SHADE 0.5f /* by which it is brighter, in the contrast of walls */
#define CELL_BEND 24.0f     /* files' widths over which they bend */
#define CELL_BEND_LONG 2.0f /* cells' lengths, along the fibre */

/* How far files are bent aside, in files, and by how much that moves with arc and rho, to the mm:
 * they go round rays, and cambial cells are lost and gained. */
INLINE vf cells_bent(const wood_constants *w, const vessel_place *p, vf y, vf *along_arc,
                     vf *along_rho) {
  vf k = splat(w->inverse_cell_width * (1.0f / CELL_BEND)), by = splat(w->cell_bend), g[3];
  vf n = noise_gradient3(p->rho * p->c * k, y * splat(w->inverse_cell_length / CELL_BEND_LONG),
                         p->rho * p->s * k, wood_seed(w, p->own, SEED_CELL_BEND), g);
  k = k * by;
  *along_arc = (g[2] * p->c - g[0] * p->s) * k;
  *along_rho = (g[0] * p->c + g[2] * p->s) * k;
  return n * by;
}

/* A fine ray at a file's side: how much of the footprint's height it covers. h: the file's. */
typedef struct {
  vf cover;
  vu hash;
} fine_ray;

INLINE fine_ray fine_ray_of(const wood_constants *w, vf y, vf extent, vu h) {
  fine_ray r;
  vi row;
  vf pitch = splat(w->inverse_fine_pitch), one = splat(1.0f), half = splat(0.5f);
  vf start = to_float((vi)(hash_upper(h) >> 8)) * splat(1.0f / 16777216.0f);
  vf rows = y * pitch + start, at = rows - vfloor(rows, &row) - half;
  r.hash = hash_mix(h + (vu)row * splatu(HASH_Y));
  vf tall = to_float((vi)(r.hash >> 16)) * splat(1.0f / 65536.0f) + half;
  vf reach = half * tall * splat(w->fine_tall);
  vf e = half * vmax(extent * pitch, splat(1e-3f));
  vf in = vmin(at + e, reach) - vmax(at - e, splat(0.0f) - reach);
  r.cover = vmin(vmax(in, splat(0.0f)) / (e + e), one);
  return r;
}

/* How far a face lies across the arc, the fibre and the radius: squares of its normal. A wall
 * that the face is parallel to looks as the far wall of a lumen does, so what is drawn of walls
 * across a direction goes with what is left of 1. */
typedef struct {
  vf arc, fibre, radius;
} cell_face;

/* What cells add to a tissue's colour, relative, before the contrast. late: how far
 * towards latewood; extent: mm, of the footprint along y. */
INLINE vf cells_tissue(const wood_constants *w, const vessel_place *p, const cell_face *face, vf y,
                       vf extent, vf late, vf *contrast) {
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
  vf arc = splat(6.2831853f) * vmax(p->rho, splat(0.05f)) / count;
  vf x = turn * count, files_arc = one / arc, files_rho = zero;
  if (w->cell_bend > 0.0f) {
    vf more_arc;
    x = x + cells_bent(w, p, y, &more_arc, &files_rho);
    files_arc = files_arc + more_arc;
  }
  vf in = x - vfloor(x, &file);
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
  vf fx2 = files_arc * (files_arc * p->f.aa + splat(2.0f) * files_rho * p->f.ab) +
           files_rho * files_rho * p->f.bb;
  vf ex = vmax(vsqrt(vmax(fx2, zero)), splat(CELL_SHARP));
  vf er = vmax(vsqrt(p->f.bb) / deep, splat(CELL_SHARP));
  vf plain_x = vmax(smooth_step(splat(0.7f), splat(1.3f), ex), face->arc);
  vf plain_r = vmax(smooth_step(splat(0.7f), splat(1.3f), er), face->radius);
  vf wide = vmax(clamp01(er - half), face->arc);
  vf low = in - half * ex, high = in + half * ex, lumen = zero, rays = zero;

  /* fine rays: their cells along y and rho, the same for all files but for where they begin */
  int fine = w->fine_tall > 0.0f;
  vf ray_y = zero, ray_r = zero, ray_ey = zero, ray_er = zero, ray_keep = zero;
  if (fine) {
    ray_y = y * splat(1.0f / RAY_ROW);
    ray_r = p->rho * splat(1.0f / RAY_CELL);
    ray_ey = vmax(extent * splat(1.0f / RAY_ROW), splat(CELL_SHARP));
    ray_keep = filter_keep(extent, RAY_ROW);
    ray_er = vmax(vsqrt(p->f.bb) * splat(1.0f / RAY_CELL), splat(CELL_SHARP));
  }
  for (int d = -2; d <= 2; d++) {
    /* what of the file lies within the footprint */
    vf left = splat((float)d), right = splat((float)d + 1.0f);
    vf whole = vmax(vmin(high, right) - vmax(low, left), zero);
    if (d && !any(gt(whole, zero))) continue;
    vi which = file + splati(d);
    vu h = hash_mix((vu)which * splatu(HASH_X) + seed);
    if (fine) {
      fine_ray ray = fine_ray_of(w, y, extent, h);
      vi row;
      vfloor(ray_y, &row);
      vu r = hash_mix(ray.hash + (vu)row * splatu(HASH_Z));
      vf uneven = to_float((vi)(r >> 16)) * splat(2.0f / 65535.0f) - one;
      vf part = splat(FINE_RAY_PART) * ray.cover;
      vf ragged = splat(FINE_RAY_RAGGED) * part;
      vf begins = to_float((vi)(r & splatu(0xffu))) * splat(1.0f / 255.0f);
      vf from = left + ragged * mix(half, begins, ray_keep);
      vf to = left + part + ragged * uneven * ray_keep;
      vf covers = vmax(vmin(high, to) - vmax(low, left), zero);
      if (any(gt(covers, zero))) {
        vf in_ray = vmax(vmin(high, to) - vmax(low, from), zero);
        vf on = splat(w->fine_open), edge = half * (one - on) * (to - from);
        vf x1 = vmax(vmin(high, to - edge) - vmax(low, from + edge), zero);
        vf shift = to_float((vi)(r >> 8 & splatu(0xffu))) * splat(1.0f / 256.0f);
        vf plain = vmax(smooth_step(splat(0.7f), splat(1.3f), ray_ey), face->fibre);
        vf rows = mix(cell_pulse(ray_y, ray_ey, on), on, plain);
        plain = vmax(smooth_step(splat(0.7f), splat(1.3f), ray_er), face->radius);
        vf columns = mix(cell_pulse(ray_r + shift, ray_er, on), on, plain);
        /* its cells' lumina against their mean, and how bright it is */
        rays = rays + in_ray * (on * on * on + splat(FINE_RAY_SHADE)) -
               mix(x1, in_ray * on, plain_x) * rows * columns;
        lumen = lumen + covers * (one - share);
      }
      left = to;
      whole = whole - covers;
    }
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
    vf edge = half * (one - on) * (right - left);
    vf x1 = vmax(vmin(high, right - edge) - vmax(low, left + edge), zero);
    x1 = mix(x1, whole * on, plain_x);
    lumen = lumen + x1 * mix(cell_pulse(c, er, along), along, plain_r);
  }
  lumen = lumen / ex;
  if (fine)
    rays =
        rays / ex - splat(FINE_RAY_SHADE * FINE_RAY_PART * FINE_RAY_FILLED) * splat(w->fine_tall);
  vf gone2 = splat(w->cell_gone * w->cell_gone);
  vf keep = one - smooth_step(splat(0.25f) * gone2, gone2, e2);
  *contrast = mix(splat(w->cell_side), splat(w->cell_end), face->fibre);
  return keep * (one - share - lumen + rays);
}

/* What its cells add to a ray's colour, likewise. */
INLINE vf cells_ray(const wood_constants *w, const ray_place *p, vu h, const ray_body *r,
                    const cell_face *face) {
  vf zero = splat(0.0f), one = splat(1.0f), on = splat(w->fine_open);
  vf e2 = p->aa + p->bb, gone2 = splat(w->cell_gone * w->cell_gone);
  vf keep = one - smooth_step(splat(0.25f) * gone2, gone2, e2);
  if (!any(gt(keep, zero))) return zero;
  const float size[3] = {RAY_ROW, RAY_CELL_WIDE, RAY_CELL};
  vf at[3] = {p->y, r->a, p->rho};
  vf e[3] = {p->along, vsqrt(p->aa), vsqrt(p->bb)};
  vf across[3] = {face->fibre, face->arc, face->radius};
  vf lumen = one, shade = one;
  vi i[3];
  for (int k = 0; k < 3; k++) {
    /* the cells of a row, of one layer, begin where they like along the radius */
    vf x = at[k] * splat(1.0f / size[k]);
    if (k) x = x + to_float((vi)(h >> 16)) * splat(1.0f / 65536.0f);
    vf extent = vmax(e[k] * splat(1.0f / size[k]), splat(CELL_SHARP));
    vf gone = smooth_step(splat(0.7f), splat(1.3f), extent);
    lumen = lumen * mix(cell_pulse(x, extent, on), on, vmax(gone, across[k]));
    shade = shade * (one - gone);
    vfloor(x, &i[k]);
    h = hash_mix(h + (vu)i[k] * splatu(HASH_X));
  }
  vf part = to_float((vi)(h >> 16)) * splat(2.0f / 65535.0f) - one;
  return keep * (on * on * on - lumen + splat(RAY_CELL_SHADE) * shade * part);
}

/* The contrast that a colour has room for: no wall is brighter than white. */
INLINE vf cells_room(const wood_constants *w, vf colour) {
  vf room = splat(w->cell_white) / vmax(colour, splat(0.01f)) - splat(w->cell_open);
  return vmax(room, splat(0.0f));
}

#define TYLOSE_EDGE 0.05f   /* of a tylose's size, half a membrane's width */
#define TYLOSE_STRAY 0.5f   /* of its cell, within which a tylose's middle lies */
#define TYLOSE_MEAN 0.1339f /* of the membranes' cover, measured */
#define RIM_WIDTH 0.12f     /* of an element's length */
#define RIM_SLOPE 1.2f      /* at most, across the fibre, each way */

/* What is seen within the earlywood's vessels, and within all: relative to
 * their colour, mean zero. (x, z), y: the fibre's place and height. s: footprint. */
INLINE vf cells_tyloses(const wood_constants *w, vu own, vf x, vf y, vf z, vf s) {
  vf one = splat(1.0f), zero = splat(0.0f), half = splat(0.5f), k = splat(w->inverse_tylose);
  vf keep = one - smooth_step(splat(0.5f), splat(1.6f), s * k);
  if (w->tyloses <= 0.0f || !any(gt(keep, zero))) return zero;
  /* Bubbles that have met: a membrane is where two middles are as far. Those of the eight cells
   * about a point's nearest corner hold the two nearest but for some far from every membrane. */
  vf at[3] = {x * k, y * splat(0.6f) * k, z * k};
  vi i[3];
  for (int c = 0; c < 3; c++) at[c] = at[c] - vfloor(at[c] - half, &i[c]) - half;
  vu base = (vu)i[0] * splatu(HASH_X) + (vu)i[1] * splatu(HASH_Y) + (vu)i[2] * splatu(HASH_Z) +
            wood_seed(w, own, SEED_TYLOSES);
  vf near2 = splat(1e9f), near[3] = {zero, zero, zero}, other[8][3], other2[8];
  for (int c = 0; c < 8; c++) {
    vu h = hash_mix(base +
                    splatu((c & 1 ? HASH_X : 0u) + (c & 2 ? HASH_Y : 0u) + (c & 4 ? HASH_Z : 0u)));
    vf d2 = zero;
    for (int a = 0; a < 3; a++) {
      vf stray = to_float((vi)(h >> (22 - 10 * a) & splatu(1023u))) * splat(1.0f / 1023.0f) - half;
      vf centre = splat((float)(c >> a & 1)) + splat(TYLOSE_STRAY) * stray;
      other[c][a] = centre - at[a];
      d2 = d2 + other[c][a] * other[c][a];
    }
    other2[c] = d2;
    vm nearer = lt(d2, near2);
    near2 = vmin(d2, near2);
    for (int a = 0; a < 3; a++) near[a] = sel(nearer, other[c][a], near[a]);
  }
  vf gap = splat(1e9f);
  for (int c = 0; c < 8; c++) {
    vf across2 = zero;
    for (int a = 0; a < 3; a++) {
      vf across = other[c][a] - near[a];
      across2 = across2 + across * across;
    }
    /* to the plane between the two */
    vf to = half * (other2[c] - near2) * inverse_root(vmax(across2, splat(1e-6f)));
    gap = vmin(gap, sel(lt(across2, splat(1e-6f)), splat(1e9f), to));
  }
  /* blurred: wider, and lower by as much */
  vf blur = half * s * k;
  vf thin = splat(TYLOSE_EDGE) * inverse_root(splat(TYLOSE_EDGE * TYLOSE_EDGE) + blur * blur);
  vf cover = clamp01(one - gap * thin * splat(1.0f / TYLOSE_EDGE)) * thin;
  return splat(w->tyloses) * keep * (cover - splat(TYLOSE_MEAN));
}

INLINE vf cells_rims(const wood_constants *w, vu own, vf x, vf y, vf z, vf s, vf extent) {
  vf one = splat(1.0f), zero = splat(0.0f), k = splat(w->inverse_element);
  vf e = vmax(vmax(extent, splat(0.5f * RIM_SLOPE) * s) * k, splat(0.03f));
  vf keep = (one - smooth_step(splat(0.7f), splat(1.4f), e)) *
            (one - smooth_step(splat(0.1f), splat(0.3f), s));
  if (!any(gt(keep, zero))) return zero;
  /* each vessel's begin elsewhere, by where it is in squares that hold about one, and its rims lie
   * oblique */
  vi iz, ix;
  vfloor(z * splat(w->rim_squares), &iz);
  vu h = hash_mix((vu)iz * splatu(HASH_Z) + wood_seed(w, own, SEED_RIMS));
  vfloor(x * splat(w->rim_squares) + to_float((vi)(h >> 16)) * splat(1.0f / 65536.0f), &ix);
  h = hash_mix(h + (vu)ix * splatu(HASH_X));
  const vf k16 = splat(1.0f / 65536.0f), slope = splat(RIM_SLOPE / 32768.0f);
  vf rise = x * (to_float((vi)(h >> 16)) - splat(32768.0f)) +
            z * (to_float((vi)(h & splatu(0xffffu))) - splat(32768.0f));
  vf shift = to_float((vi)(hash_upper(h) >> 16)) * k16;
  vf rim = cell_pulse((y + rise * slope) * k + shift, e, splat(RIM_WIDTH));
  return splat(w->cell_side) * keep * (rim - splat(RIM_WIDTH));
}

#endif
