/* SPDX-License-Identifier: Apache-2.0
 *
 * Elementary functions on lanes, the same bits everywhere.
 *
 * The polynomials are interpolations at Chebyshev nodes of the function over
 * the reduced range; the errors stated are the largest found over the range
 * named, against the C library in double (tests/kernels prints them).
 */
#ifndef SOZAI_CORE_MATHS_H
#define SOZAI_CORE_MATHS_H

#include "simd.h"

/* 1 / sqrt(x) for positive x, relative error below 1.2e-7. */
INLINE vf inverse_root(vf x) { return splat(1.0f) / vsqrt(x); }

/* Sine and cosine of r within +-pi/4 turned by k quarters. */
INLINE void quarter_turns(vf r, vi k, vf *sine, vf *cosine) {
  vf z = r * r;
  vf s = r * (splat(0.99999999692f) +
              z * (splat(-0.16666650674f) +
                   z * (splat(0.0083320357856f) + z * splat(-0.00019503904251f))));
  vf c = splat(0.99999999995f) +
         z * (splat(-0.49999999615f) +
              z * (splat(0.041666616693f) +
                   z * (splat(-0.0013886617999f) + z * splat(2.4379831235e-5f))));
  vf a = sel_odd(k, c, s), b = sel_odd(k, s, c);
  *sine = flip_by_bit(a, k, 1);
  *cosine = flip_by_bit(b, k + splati(1), 1);
}

/* Sine and cosine. |x| < 20,000: absolute error below 2e-7 for |x| < 8, and
 * growing with the spacing of floats beyond. */
INLINE void sine_cosine(vf x, vf *sine, vf *cosine) {
#if LANES == 1
  /* of the first quarter the nearest is 0, and nothing is taken off: a point alone does not
   * wait for that */
  if (vabs(x) < 0.78f) {
    quarter_turns(x, 0, sine, cosine);
    return;
  }
#endif
  vi k;
  vf n = vnearest(x * splat(0.63661977f), &k);
  /* pi/2 in three parts, the first two short enough for n * part to be exact */
  vf r = x - n * splat(1.5703125f);
  r = r - n * splat(4.837512969970703e-4f);
  r = r - n * splat(7.549789948768648e-8f);
  quarter_turns(r, k, sine, cosine);
}

/* Sine and cosine of 2 pi x: whole turns go without loss. |x| < 2^21. */
INLINE void sine_cosine_turns(vf x, vf *sine, vf *cosine) {
  vi k;
  vf quarters = x * splat(4.0f);
  vf n = vnearest(quarters, &k);
  quarter_turns((quarters - n) * splat(1.57079633f), k, sine, cosine);
}

/* The angle of (x, y) in -pi..pi, absolute error below 3e-7; 0 at the origin. */
INLINE vf arctan2(vf y, vf x) {
  vf ax = vabs(x), ay = vabs(y);
  vf small = vmin(ax, ay), large = vmax(ax, ay);
  /* beyond tan(pi/8) turn by pi/4, so that one division serves both */
  vf flat = large * splat(0.41421356f);
  vf num = sel_lt(flat, small, small - large, small);
  vf den = sel_lt(flat, small, small + large, large);
  vf t = num / vmax(den, splat(1e-30f));
  vf z = t * t;
  vf a = t * (splat(0.99999998126f) +
              z * (splat(-0.33332785772f) +
                   z * (splat(0.19974082416f) +
                        z * (splat(-0.13848490212f) + z * splat(0.079762918074f)))));
  a = sel_lt(flat, small, a + splat(0.78539816f), a);
  a = sel_lt(ax, ay, splat(1.57079633f) - a, a);
  a = sel_lt(x, splat(0.0f), splat(3.14159265f) - a, a);
  return signed_as(a, y);
}

/* The arc sine of x, clamped to -1..1; absolute error below 5e-7. */
INLINE vf arcsin(vf x) {
  vf a = vmin(vabs(x), splat(1.0f));
  vm large = gt(a, splat(0.5f));
  vf z = a * a, t = a;
  if (any(large)) {
    z = sel(large, (splat(1.0f) - a) * splat(0.5f), z);
    t = sel(large, vsqrt(z), t);
  }
  vf p = t * (splat(0.99999999598f) +
              z * (splat(0.16666782006f) +
                   z * (splat(0.074946966874f) +
                        z * (splat(0.045520635636f) +
                             z * (splat(0.023993999637f) + z * splat(0.042417373785f))))));
  vf r = sel(large, splat(1.57079633f) - (p + p), p);
  return signed_as(r, x);
}

/* Base-two logarithm of a normal positive x, relative error below 3e-7. */
INLINE vf log2_(vf x) {
  vi b = bits_of(x);
  /* the mantissa lands in sqrt(1/2)..sqrt(2): near 1 nothing cancels */
  vi e = (b - splati(0x3f3504f3)) >> 23;
  vf m = float_of(b - (e << 23));
  vf t = (m - splat(1.0f)) / (m + splat(1.0f));
  vf z = t * t;
  vf p = t * (splat(2.8853900798f) + z * (splat(0.96179883882f) +
                                          z * (splat(0.57671518602f) + z * splat(0.43171769744f))));
  return to_float(e) + p;
}

/* Two to the power x, relative error below 3e-7; 0 below -126. x < 127.5. */
INLINE vf exp2_(vf x) {
  vm tiny = lt(x, splat(-126.0f));
  vf y = vmax(x, splat(-126.0f));
  vi i;
  vf n = vnearest(y, &i);
  vf f = y - n;
  vf p = splat(1.0f) +
         f * (splat(0.69314720670f) +
              f * (splat(0.24022650922f) +
                   f * (splat(0.055503272267f) +
                        f * (splat(0.0096180566785f) +
                             f * (splat(0.0013400428177f) + f * splat(0.00015461444696f))))));
  vf r = p * float_of((i + splati(127)) << 23);
  return sel(tiny, splat(0.0f), r);
}

/* x to the power n for 0 <= x <= 1, n >= 1, absolute error below 4e-7; below 1e-30
 * where x is. In two halves: exp2_ of the first. */
INLINE vf power01_log2(vf x, vf n) { return n * log2_(vmax(x, splat(1e-30f))); }

/* t^3 (10 - 15 t + 6 t^2): 0 to 1 with two vanishing derivatives at each end. */
INLINE vf fade(vf t) { return t * t * t * (splat(10.0f) + t * (splat(-15.0f) + t * splat(6.0f))); }
INLINE vf fade_slope(vf t) {
  vf u = t * (splat(1.0f) - t);
  return splat(30.0f) * u * u;
}
/* t^2 (3 - 2 t) for 0 <= t <= 1: to the bit no more than 1, which rounding would make of it, for
 * what is left of 1 is asked for its sign. */
INLINE vf smooth_of(vf t) { return vmin(t * t * (splat(3.0f) - splat(2.0f) * t), splat(1.0f)); }
/* 0 below a, 1 above b, with a smooth rise between; a < b. */
INLINE vf smooth_step(vf a, vf b, vf x) { return smooth_of(clamp01((x - a) / (b - a))); }

#endif
