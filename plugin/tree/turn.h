/* SPDX-License-Identifier: Apache-2.0
 *
 * Turning about any axis (Hayashi & Takahashi 1997, section 4.2 (2), where it
 * is cited from Nakamae & Nishita 1991).
 *
 * The paper prints the axis as N = (w, u, v) and v w in the z-term of X and in
 * the x-term of Z. Its diagonal, u^2, v^2, w^2 for X, Y, Z, belongs to
 * N = (u, v, w), and with v w the matrix is no rotation: those two products are
 * u w. So mended it is Rodrigues' formula, which tests/tree/turn.c holds it to.
 */
#ifndef SOZAI_TREE_TURN_H
#define SOZAI_TREE_TURN_H

/* out = p turned about the unit axis n by the angle of that cosine and sine,
 * right-handed. out may be p. */
static inline void turn_about(const float n[3], float cosine, float sine, const float p[3],
                              float out[3]) {
  const float u = n[0], v = n[1], w = n[2], k = 1.0f - cosine;
  const float x = p[0], y = p[1], z = p[2];
  out[0] = (u * u + (1.0f - u * u) * cosine) * x + (u * v * k - w * sine) * y +
           (u * w * k + v * sine) * z;
  out[1] = (u * v * k + w * sine) * x + (v * v + (1.0f - v * v) * cosine) * y +
           (v * w * k - u * sine) * z;
  out[2] = (u * w * k - v * sine) * x + (v * w * k + u * sine) * y +
           (w * w + (1.0f - w * w) * cosine) * z;
}

/* A unit vector square to the unit vector t, level where it can be. */
static inline void turn_level(const float t[3], float side[3]) {
  /* t x up */
  float x = -t[2], z = t[0], length = x * x + z * z;
  if (length < 1e-6f) {
    side[0] = 1.0f, side[1] = 0.0f, side[2] = 0.0f;
    /* square to a nearly upright t */
    float d = t[0];
    side[0] -= d * t[0], side[1] -= d * t[1], side[2] -= d * t[2];
    length = side[0] * side[0] + side[1] * side[1] + side[2] * side[2];
    float s = 1.0f / __builtin_sqrtf(length);
    side[0] *= s, side[1] *= s, side[2] *= s;
    return;
  }
  float s = 1.0f / __builtin_sqrtf(length);
  side[0] = x * s, side[1] = 0.0f, side[2] = z * s;
}

/* t leaning by alpha (its sine and cosine) away, in the direction beta (its
 * cosine and sine) round t from `level`: the paper's two turns, alpha from the
 * parent and then beta about it. */
static inline void turn_side(const float t[3], const float level[3], float alpha_cosine,
                             float alpha_sine, float beta_cosine, float beta_sine, float out[3]) {
  float leaned[3];
  for (int c = 0; c < 3; c++) leaned[c] = alpha_cosine * t[c] + alpha_sine * level[c];
  turn_about(t, beta_cosine, beta_sine, leaned, out);
}

#endif
