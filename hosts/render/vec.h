/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_RENDER_VEC_H
#define SOZAI_RENDER_VEC_H

#include <math.h>

typedef struct vec {
  float x, y, z;
} vec;

static inline vec vec_of(double x, double y, double z) {
  return (vec){(float)x, (float)y, (float)z};
}
static inline vec vec_add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vec vec_sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vec vec_mul(vec a, vec b) { return (vec){a.x * b.x, a.y * b.y, a.z * b.z}; }
static inline vec vec_scale(float s, vec a) { return (vec){s * a.x, s * a.y, s * a.z}; }
/* a + s b */
static inline vec vec_along(vec a, float s, vec b) { return vec_add(a, vec_scale(s, b)); }
static inline float vec_dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline float vec_length(vec a) { return sqrtf(vec_dot(a, a)); }
static inline vec vec_cross(vec a, vec b) {
  return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/* Of length 1; of length 0 stays. */
static inline vec vec_unit(vec a) {
  float length = vec_length(a);
  return length > 0 ? vec_scale(1 / length, a) : a;
}
static inline vec vec_mix(vec a, vec b, float t) { return vec_along(a, t, vec_sub(b, a)); }

/* Two unit vectors square to the unit vector n and to one another. */
static inline void vec_frame(vec n, vec *s, vec *t) {
  vec other = fabsf(n.x) < 0.7f ? (vec){1, 0, 0} : (vec){0, 1, 0};
  *s = vec_unit(vec_cross(other, n));
  *t = vec_cross(n, *s);
}

#endif
