/* SPDX-License-Identifier: Apache-2.0
 *
 * Figure of the growth front: displacements of the rings that fibres follow in
 * and out, so that they dive where the surface runs flat. They are added to the
 * undulation, and like it are zero at y = 0, smooth, with exact derivatives.
 *
 *   curl   waves along the stem: u = a (p (1 - cos 2 pi psi) + q sin 2 pi psi), psi
 *          = y / lambda + a stray that differs from place to place, as the amplitude
 *          p + i q does. Bars fork and end where that is zero
 *   quilt  pillows with creases between them: u = a (sqrt(n^2 + e^2) - e), n a
 *          gradient noise; the creases are where it changes sign
 *   eyes   dimples that go on through the years: towards the pith by
 *          h ((1 - q)^3 + (1 - 4 q)^3) / 2, where these are positive, q the square
 *          of the distance from a radial line, over R^2, in an oblique ellipse.
 *          They stand in cells of (theta, y) within shells of r, as rays do.
 */
#ifndef SOZAI_WOOD_FIGURE_H
#define SOZAI_WOOD_FIGURE_H

#include "stem.h"

/* Two value noises of one lattice, from the halves of one hash, within +-1. */
typedef struct {
  vf n[2], x[2], y[2], z[2];
} figure_swell;

INLINE figure_swell figure_swell_at(vf px, vf py, vf pz, vu seed) {
  noise_axis x = noise_split_cubic(px, HASH_X), y = noise_split_cubic(py, HASH_Y),
             z = noise_split_cubic(pz, HASH_Z);
  vf v[2][8], k = splat(1.0f / 32768.0f);
  for (int c = 0; c < 8; c++) {
    vu h = hash_upper(seed + (c & 1 ? x.high : x.low) + (c & 2 ? z.high : z.low) +
                      (c & 4 ? y.high : y.low));
    v[0][c] = to_float((vi)h >> 16) * k;
    v[1][c] = to_float((vi)(h << 11) >> 16) * k;
  }
  figure_swell s;
  for (int j = 0; j < 2; j++) {
    vf e[4], d[4];
    for (int c = 0; c < 4; c++) {
      d[c] = v[j][2 * c + 1] - v[j][2 * c];
      e[c] = v[j][2 * c] + d[c] * x.w;
    }
    vf low = e[0] + (e[1] - e[0]) * z.w, high = e[2] + (e[3] - e[2]) * z.w;
    s.n[j] = low + (high - low) * y.w;
    s.y[j] = (high - low) * y.dw;
    s.x[j] = mix(mix(d[0], d[1], z.w), mix(d[2], d[3], z.w), y.w) * x.dw;
    s.z[j] = mix(e[1] - e[0], e[3] - e[2], y.w) * z.dw;
  }
  return s;
}

/* extent: mm, of the footprint along y. */
INLINE void figure_curl(const wood_constants *w, vu own, vf y, vf extent, stem_place *p,
                        undulation_sum *u) {
  const wood_irregular *r = &w->curl;
  vf one = splat(1.0f), tau = splat(6.2831853f), zero = splat(0.0f);
  vf psi = y * splat(w->curl_frequency), psi_y = splat(w->curl_frequency);
  vf psi_x = zero, psi_z = zero, gone = one, power = splat(r->power);
  /* the phase's slope is 0.68 of the mean at least: past this no wave is left */
  int some = any(lt(extent * psi_y, splat(1.5f)));
  if (some) {
    vf a = splat(w->curl_height), in = one, out = zero, keep = one, sine, cosine;
    vf in_x = zero, in_y = zero, in_z = zero, out_x = zero, out_y = zero, out_z = zero;
    if (r->stray > 0.0f) {
      /* turned by atan(3/4) and by atan(7/24), so that neither the cuts nor the two
       * lattices line up */
      float k = w->curl_inverse_reach;
      vf f = splat(k / CURL_STRAY_REACH), fy = splat(r->stray_frequency), stray = splat(r->stray);
      vf tx = splat(0.8f) * p->x - splat(0.6f) * p->z, tz = splat(0.6f) * p->x + splat(0.8f) * p->z;
      noise_stem ay = noise_split_axial(y * fy, HASH_Y);
      noise_axis ax = noise_split_cubic(tx * f, HASH_X), az = noise_split_cubic(tz * f, HASH_Z);
      vf gx, gy, gz;
      psi = psi + stray * noise_axial3(&ax, &ay, &az, wood_seed(w, own, SEED_CURL), &gx, &gy, &gz);
      gx = gx * (stray * f);
      gz = gz * (stray * f);
      psi_y = psi_y + stray * fy * gy;
      psi_x = splat(0.8f) * gx + splat(0.6f) * gz;
      psi_z = splat(0.8f) * gz - splat(0.6f) * gx;

      vf g = splat(k), swell = splat(r->swell), sy = splat(r->swell_frequency);
      vf vx = splat(0.96f) * p->x - splat(0.28f) * p->z;
      vf vz = splat(0.28f) * p->x + splat(0.96f) * p->z;
      figure_swell s = figure_swell_at(vx * g, y * sy, vz * g, wood_seed(w, own, SEED_CURL_SWELL));
      in = splat(r->steady) + swell * s.n[0];
      out = swell * s.n[1];
      vf sg = swell * g;
      in_x = sg * (splat(0.96f) * s.x[0] + splat(0.28f) * s.z[0]);
      in_z = sg * (splat(0.96f) * s.z[0] - splat(0.28f) * s.x[0]);
      out_x = sg * (splat(0.96f) * s.x[1] + splat(0.28f) * s.z[1]);
      out_z = sg * (splat(0.96f) * s.z[1] - splat(0.28f) * s.x[1]);
      in_y = swell * sy * s.y[0];
      out_y = swell * sy * s.y[1];
    }
    keep = filter_wave(extent * psi_y, 1.0f);
    gone = one - keep * keep;
    power = power + (in * in + out * out - power) * keep;
    sine_cosine_turns(psi, &sine, &cosine);
    a = a * keep;
    vf lift = one - cosine, slope = a * tau * (in * sine + out * cosine);
    u->n = u->n + a * (in * lift + out * sine);
    u->nx = u->nx + (slope * psi_x + a * (in_x * lift + out_x * sine));
    u->ny = u->ny + (slope * psi_y + a * (in_y * lift + out_y * sine));
    u->nz = u->nz + (slope * psi_z + a * (in_z * lift + out_z * sine));
  }
  gone = gone * power;
  p->lost = p->lost + splat(0.5f * w->curl_height * w->curl_height) * gone;
  p->lost_slope = p->lost_slope + splat(0.5f * w->curl_slope * w->curl_slope) * gone;
}

/* Of gradient noise n, measured: variance of sqrt(n^2 + e^2). */
#define QUILT_CREASE 0.06f
#define QUILT_VARIANCE 0.0106f

INLINE void figure_quilt(const wood_constants *w, vu own, vf y, vf footprint, stem_place *p,
                         undulation_sum *u) {
  vf one = splat(1.0f), zero = splat(0.0f);
  vf f = splat(w->quilt_frequency), fy = splat(w->quilt_frequency_axis);
  vf keep = one;
  if (filter_touches(footprint, w->quilt_size)) {
    keep = filter_keep(footprint, w->quilt_size);
    vf gone = one - keep * keep;
    float a2 = w->quilt_height * w->quilt_height;
    p->lost = p->lost + splat(QUILT_VARIANCE * a2) * gone;
    p->lost_slope = p->lost_slope + splat(w->quilt_slope * w->quilt_slope) * gone;
    if (!any(gt(keep, zero))) return;
  }
  /* turned by atan(3/4), so that the lattice does not line up with the cuts */
  vf x = splat(0.8f) * p->x - splat(0.6f) * p->z, z = splat(0.6f) * p->x + splat(0.8f) * p->z;
  vf g[3], n = noise_gradient3(x * f, y * fy, z * f, wood_seed(w, own, SEED_QUILT), g);
  vf inverse = inverse_root(n * n + splat(QUILT_CREASE * QUILT_CREASE));
  vf pillow = (n * n + splat(QUILT_CREASE * QUILT_CREASE)) * inverse - splat(QUILT_CREASE);
  vf steep = n * inverse;
  /* dies out at y = 0 */
  vf t = vmin(vabs(y) * fy, one), ease = t * t * (splat(3.0f) - t - t);
  vf rise = splat(6.0f) * t * (one - t) * fy * sel(lt(y, zero), splat(-1.0f), one);
  vf a = splat(w->quilt_height) * keep, k = a * ease * steep;
  vf gx = k * f * g[0], gz = k * f * g[2];
  u->n = u->n + a * ease * pillow;
  u->nx = u->nx + (splat(0.8f) * gx + splat(0.6f) * gz);
  u->ny = u->ny + (k * fy * g[1] + a * rise * pillow);
  u->nz = u->nz + (splat(0.8f) * gz - splat(0.6f) * gx);
}

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
 * the distance from the middle; side: of the outline, a factor, mean 1; r2: the radius'; s2: the
 * footprint's side's. A small footprint widens the outline, a wide one fills it: a disc of the
 * outline's variance, which is an eighth of the radius' square, and a square's twelfth. What it
 * has in all stays. */
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

/* One of the layers, each with as many of them: together they line up less. Seldom
 * is one alone. */
INLINE void figure_eyes(const wood_constants *w, vu own, int layer, vf y, vf footprint,
                        stem_place *p, undulation_sum *u) {
  vf one = splat(1.0f), zero = splat(0.0f), k16 = splat(1.0f / 65536.0f);
  /* the sectors of each are turned another way */
  static const float turns[EYE_LAYERS][2] = {
      {1.0f, 0.0f}, {0.96f, 0.28f}, {0.8f, 0.6f}, {0.6f, 0.8f}};
  vf tc = splat(turns[layer][0]), ts = splat(turns[layer][1]);
  vf c = tc * p->c - ts * p->s, s = ts * p->c + tc * p->s;
  vf turn = arctan2(s, c) * splat(0.15915494f);
  vi unused, sector, shell, column, row;
  turn = turn - vfloor(turn, &unused);
  vf round = turn * splat((float)EYE_SECTORS), x = round - vfloor(round, &sector);
  vu seed = wood_seed(w, own, SEED_EYES + ((uint32_t)layer & 1u)) + (vu)sector * splatu(HASH_Y);
  seed += splatu((uint32_t)(layer >> 1) * HASH_Z);
  /* each sector's shells begin at radii of their own */
  vf offset = to_float((vi)(hash_upper(seed) >> 8)) * splat(1.0f / 16777216.0f);
  vf shells = p->r * splat(w->inverse_eye_length) + offset, low = vfloor(shells, &shell);
  vf within = shells - low, inside = vmax(low - offset, zero) * splat(w->eye_length);
  vf sector_arc = splat(6.2831853f / EYE_SECTORS);
  vf middle = (low + splat(0.5f) - offset) * splat(w->eye_length);
  vf count =
      vmax(vfloor(middle * sector_arc * splat(w->inverse_eye_cell) + splat(0.5f), &unused), one);
  x = x * count;
  vf from_left = x - vfloor(x, &column), angle = sector_arc / count;

  vu root = hash_mix((vu)column * splatu(HASH_X) + (vu)shell * splatu(HASH_Z) + seed);
  vf shift = to_float((vi)(root >> 16)) * k16;
  vf rows = y * splat(w->inverse_eye_cell) + shift, bottom = vfloor(rows, &row);
  vu h = hash_mix((vu)row * splatu(HASH_Y) + root), g = hash_mix(h + splatu(HASH_Z));
  /* the large ones in the first layer, of all sizes in the last */
  static const float sizes[EYE_LAYERS][2] = {
      {1.0f, 0.5f}, {0.75f, 0.6f}, {0.55f, 0.7f}, {0.35f, 0.9f}};
  vf least = splat(sizes[layer][0]), spread = splat(sizes[layer][1] / 1023.0f);
  vf radius = splat(w->eye_radius) * (least + spread * to_float((vi)(g & splatu(1023u))));
  radius = vmin(radius, splat(0.42f) * angle * inside);
  vf r2 = vmax(radius * radius, splat(1e-6f));

  /* its middle keeps clear of the cell's edges, where the cell is narrowest; a
   * leaning one is a little wider */
  vf edge = splat(1.08f) * radius / vmax(angle * inside, splat(1e-3f));
  vf place = edge + (one - edge - edge) * to_float((vi)(h >> 16)) * k16;
  vf tall = radius * splat(WOOD_EYE_LONG * w->inverse_eye_cell);
  vf height = tall + (one - tall - tall) * to_float((vi)(h & splatu(0xffffu))) * k16;
  vf turned = (from_left - place) * angle; /* radians */
  vf b = (rows - bottom - height) * splat(w->eye_cell / WOOD_EYE_LONG);
  vf lean = splat(0.4f / 512.0f) * (to_float((vi)(h & splatu(1023u))) - splat(512.0f));
  vf a = turned * p->r + lean * b;
  vf q = (a * a + b * b) / r2;
  /* one that would reach y = 0 is not there */
  vf centre = (bottom + height - shift) * splat(w->eye_cell);
  vm there = gt(vabs(centre), radius * splat(WOOD_EYE_LONG));
  noise_axis swarm_x = noise_split_cubic(to_float(column) * splat(0.31f), HASH_X);
  noise_axis swarm_y = noise_split_cubic(to_float(row) * splat(0.23f), HASH_Y);
  vf unused_x, unused_y,
      swarm =
          noise_value2(&swarm_x, &swarm_y, seed + (vu)shell * splatu(HASH_Z), &unused_x, &unused_y);
  vf share = splat(EYE_SHARE) + splat(EYE_SWARM / HASH_ONE) * swarm;
  there = and_(there, lt(to_float((vi)(g >> 22)), share * splat(1024.0f)));
  there = and_(there, gt(radius, splat(1e-2f)));
  /* a wide footprint sees it from further away */
  vf s2 = footprint * footprint;
  there = and_(there, lt(q * r2, eye_widened(r2, s2)));
  if (!any(there)) return;

  /* it begins in the shell's inner quarter and ends in its outer */
  vf starts = splat(0.25f / 63.0f) * to_float((vi)(g >> 10 & splatu(63u)));
  vf ends = one - splat(0.25f / 63.0f) * to_float((vi)(g >> 16 & splatu(63u)));
  vf in = clamp01((within - starts) * splat(10.0f)), out = clamp01((ends - within) * splat(10.0f));
  vf ein = in * in * (splat(3.0f) - in - in), eout = out * out * (splat(3.0f) - out - out);
  vf age = ein * eout;
  vf age_r =
      splat(60.0f * w->inverse_eye_length) * (in * (one - in) * eout - out * (one - out) * ein);
  vf keep = one;
  if (filter_touches(footprint, 2.0f * w->eye_radius)) {
    keep = filter_keep(footprint, 2.0f * w->eye_radius);
  }
  vf depth = sel(there, splat(w->eye_depth) * radius * keep, zero);
  vf left = vmax(one - q, zero), core = vmax(one - splat(4.0f) * q, zero), half = splat(0.5f);
  vf left2 = left * left, core2 = core * core;
  vf dent = depth * half * (left2 * left + core2 * core);
  vf fall = splat(3.0f) * depth * (left2 + splat(4.0f) * core2) * age / r2;
  vf along = fall * a, out_r = along * turned - dent * age_r;
  vf own_dark = splat(WOOD_EYE_DARK - WOOD_EYE_DARKS) +
                splat(2.0f * WOOD_EYE_DARKS / 255.0f) * to_float((vi)(g >> 2 & splatu(255u)));
  vf per = inverse_root(r2);
  eye_shape shape = eye_shape_of(hash_mix(g ^ splatu(HASH_Y)), a * per, b * per);
  vf dark = eye_outline(shape.square * r2, shape.side, r2, s2);
  dark = vmin(eyes_told(w, footprint) * dark * age * own_dark, one);
  p->eye = vmax(p->eye, sel(there, dark, zero));
  u->n = u->n - dent * age;
  u->nx = u->nx + (out_r * p->c - along * p->s);
  u->nz = u->nz + (out_r * p->s + along * p->c);
  u->ny = u->ny + fall * (b + a * lean) * splat(1.0f / WOOD_EYE_LONG);
}

/* All of them. */
INLINE void figure_add(const wood_constants *w, vu own, vf y, vf footprint, vf extent,
                       stem_place *p, undulation_sum *u) {
  if (w->has_curl) figure_curl(w, own, y, extent, p, u);
  if (w->has_quilt) figure_quilt(w, own, y, footprint, p, u);
  if (w->has_eyes) {
    for (int layer = 0; layer < EYE_LAYERS; layer++) figure_eyes(w, own, layer, y, footprint, p, u);
    p->eye = p->eye + splat(w->eye_mean) * (splat(1.0f) - eyes_told(w, footprint));
  }
}

INLINE stem_place stem_with_figure(const wood_constants *w, vf x, vf y, vf z) {
  stem_place p;
  vf zero = splat(0.0f);
  vu own = splatu(0);
  undulation_sum u = undulation_none();
  p.pith = pith_at(w, own, y);
  p.lost = p.lost_slope = p.eye = zero;
  stem_about(x, z, &p);
  for (int o = 0; o < 2; o++) {
    undulation_octave octave = undulation_octave_of(w, o);
    undulation_add(&octave, own, y, zero, &p, &u);
  }
  figure_add(w, own, y, zero, zero, &p, &u);
  stem_rho(w, y, &u, &p);
  return p;
}

#endif
