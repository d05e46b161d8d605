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
 *          h (1 - q)^3, where that is positive, q the square
 *          of the distance from a radial line, over R^2, in an oblique ellipse.
 *          They stand in cells of (theta, y) within shells of r, as rays do.
 */
#ifndef SOZAI_WOOD_FIGURE_H
#define SOZAI_WOOD_FIGURE_H

#include "figure_eyes.h"
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
  p.pith = pith_at(w, own, y, NULL);
  p.lost = p.lost_slope = p.eye = zero;
  stem_about(x, z, &p);
  for (int o = 0; o < 2; o++) {
    undulation_octave octave = undulation_octave_of(w, o);
    undulation_add(&octave, own, y, zero, NULL, &p, &u);
  }
  figure_add(w, own, y, zero, zero, &p, &u);
  stem_rho(w, y, &u, &p);
  return p;
}

#endif
