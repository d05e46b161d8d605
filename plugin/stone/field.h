/* SPDX-License-Identifier: Apache-2.0
 *
 * A number that varies over space, with its gradient: so that what is made of
 * several keeps an exact slope.
 */
#ifndef SOZAI_STONE_FIELD_H
#define SOZAI_STONE_FIELD_H

#include "../core/maths.h"

typedef struct {
  vf v, g[3];
} field;

INLINE field field_of(vf v) {
  vf zero = splat(0.0f);
  return (field){v, {zero, zero, zero}};
}
INLINE field field_add(field a, field b) {
  a.v = a.v + b.v;
  for (int k = 0; k < 3; k++) a.g[k] = a.g[k] + b.g[k];
  return a;
}
INLINE field field_scale(field a, vf k) {
  a.v = a.v * k;
  for (int c = 0; c < 3; c++) a.g[c] = a.g[c] * k;
  return a;
}
INLINE field field_mul(field a, field b) {
  field r;
  r.v = a.v * b.v;
  for (int k = 0; k < 3; k++) r.g[k] = a.v * b.g[k] + b.v * a.g[k];
  return r;
}
/* A function of a field, from its value and its derivative there. */
INLINE field field_through(field a, vf value, vf derivative) {
  field r = field_scale(a, derivative);
  r.v = value;
  return r;
}
/* 1 - a */
INLINE field field_rest(field a) {
  field r = field_scale(a, splat(-1.0f));
  r.v = splat(1.0f) - a.v;
  return r;
}
/* 0 below `low`, 1 above `high`, smooth between. */
INLINE field field_step(field a, vf low, vf high) {
  vf inverse = splat(1.0f) / (high - low), t = clamp01((a.v - low) * inverse);
  return field_through(a, t * t * (splat(3.0f) - t - t),
                       splat(6.0f) * t * (splat(1.0f) - t) * inverse);
}

#endif
