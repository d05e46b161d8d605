/* SPDX-License-Identifier: Apache-2.0
 *
 * Footprint filtering.
 *
 * A footprint is a square of side s on the surface. Seen through a linear map
 * onto coordinates (a, b) of the material it is a parallelogram; its extents
 * are kept as the three products of the map's rows projected on the surface,
 * which do not depend on how the square is turned.
 */
#ifndef SOZAI_CORE_FILTER_H
#define SOZAI_CORE_FILTER_H

#include "maths.h"

/* aa, ab, bb: products of the projected rows, times s squared. The footprint
 * has variances aa/12 and bb/12 and covariance ab/12. */
typedef struct {
  vf aa, ab, bb;
} footprint2;

/* The square of a row a[3] of the map, projected; an: what of the row lies along the normal. */
INLINE vf footprint_along(const vf a[3], const vf n[3], int ball, vf *an) {
  vf aa = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
  *an = splat(0.0f);
  if (ball) return aa;
  *an = a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
  return vmax(aa - *an * *an, splat(0.0f));
}

/* a[3], b[3]: rows of the map. n[3]: unit normal; `ball`: no normal is known,
 * nothing is projected out. */
INLINE footprint2 footprint_through(const vf a[3], const vf b[3], const vf n[3], int ball, vf s) {
  footprint2 f;
  vf an, bn;
  f.aa = footprint_along(a, n, ball, &an);
  f.bb = footprint_along(b, n, ball, &bn);
  f.ab = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  if (!ball) f.ab = f.ab - an * bn;
  vf q = s * s;
  f.aa = f.aa * q;
  f.ab = f.ab * q;
  f.bb = f.bb * q;
  return f;
}

/* Whether filter_keep is below 1 for anyone. */
INLINE int filter_touches(vf e, float size) { return any(gt(e, splat(0.5f * size))); }

/* How much of a detail of the given size outlives a footprint of extent e:
 * 1 while e is below half the size, 0 from twice the size. */
INLINE vf filter_keep(vf e, float size) {
  return splat(1.0f) - smooth_step(splat(0.5f * size), splat(2.0f * size), e);
}

/* The mean of sin or cos of 2 pi y / wavelength over a box of side e is its
 * value at the centre times this: sin(x)/x, x = pi e / wavelength, taken as
 * zero from its first zero on, and as 1 below a fiftieth of the wave, which is
 * off by less than 7e-4. */
INLINE vf filter_wave(vf e, float inverse_wavelength) {
  vf x = vmin(e * splat(inverse_wavelength), splat(1.0f));
  vm some = gt(x, splat(0.02f));
  if (!any(some)) return splat(1.0f);
  vf z = x * x;
  /* sin(pi x)/(pi x) on 0..1 to 2e-4, and exactly zero at 1 */
  vf keep =
      (splat(1.0f) - z) *
      (splat(1.0f) + z * (splat(-0.6449341f) + z * (splat(0.1663f) + z * splat(-0.0213659f))));
  return sel(some, keep, splat(1.0f));
}

#endif
