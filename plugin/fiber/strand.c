/* SPDX-License-Identifier: Apache-2.0 */
#include "strand.h"

#include "../core/hash1.h"
#include "../core/scalar.h"

double strand_random(uint32_t seed, uint32_t strand, uint32_t purpose, uint32_t k) {
  uint32_t own = hash1(hash1(seed + 0x9e3779b9u * purpose) ^ strand);
  uint32_t high = hash1(own + 0x85ebca6bu * k), low = hash1(high ^ 0x5bd1e995u);
  /* 53 bits: 32 would lay a million middles on a lattice that can be seen */
  return ((double)high * 2097152.0 + (double)(low >> 11)) * 0x1p-53;
}

double strand_normal(uint32_t seed, uint32_t strand, uint32_t purpose, uint32_t k) {
  double sum = 0;
  for (uint32_t i = 0; i < 12; i++) sum += strand_random(seed, strand, purpose, 12 * k + i);
  double x = sum - 6;
  return x > 3.47 ? 3.47 : x < -3.47 ? -3.47 : x;
}

double strand_length(const strand_shape *s, uint32_t strand) {
  double l = s->length;
  if (s->length_spread > 0)
    l *= 1 + s->length_spread * strand_normal(s->seed, strand, STRAND_SIZE, 0);
  return l < 0.1 * s->length ? 0.1 * s->length : l;
}

void strand_sine_cosine(double x, double *sine, double *cosine) {
  double quarters = x * (2 / PI) + 0.5;
  int64_t k = (int64_t)quarters;
  if ((double)k > quarters) k--;
  double n = (double)k;
  /* pi/2 in two parts, the first with zeros at its end so that n * part is exact */
  double r = x - n * 1.57079632673412561417;
  r -= n * 6.07710050650619224932e-11;
  double z = r * r;
  double s =
      r * (1 + z * (-1.0 / 6 +
                    z * (1.0 / 120 + z * (-1.0 / 5040 +
                                          z * (1.0 / 362880 + z * (-1.0 / 39916800 +
                                                                   z * (1.0 / 6227020800 -
                                                                        z / 1307674368000.0)))))));
  double c =
      1 + z * (-0.5 + z * (1.0 / 24 + z * (-1.0 / 720 +
                                           z * (1.0 / 40320 +
                                                z * (-1.0 / 3628800 +
                                                     z * (1.0 / 479001600 - z / 87178291200.0))))));
  double a = k & 1 ? c : s, b = k & 1 ? s : c;
  *sine = k & 2 ? -a : a;
  *cosine = (k + 1) & 2 ? -b : b;
}

/* The frame m (columns: the segment, the two axes it carries) times
 * Rx(phi) Ry(theta): the twist first, then the bend. */
static void turn(double m[9], double phi, double theta) {
  double sp, cp, st, ct;
  strand_sine_cosine(phi * (PI / 180), &sp, &cp);
  strand_sine_cosine(theta * (PI / 180), &st, &ct);
  for (int r = 0; r < 3; r++) {
    double x = m[3 * r], y = m[3 * r + 1], z = m[3 * r + 2];
    double ty = y * cp + z * sp, tz = z * cp - y * sp;
    m[3 * r] = x * ct - tz * st;
    m[3 * r + 1] = ty;
    m[3 * r + 2] = x * st + tz * ct;
  }
}

void strand_make(const strand_shape *s, uint32_t strand, double *out) {
  double m[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  double step = strand_length(s, strand) / (s->vertices - 1);
  out[0] = out[1] = out[2] = 0;
  for (uint32_t i = 1; i < s->vertices; i++) {
    if (i > 1) {
      uint32_t joint = 2 * (i - 2);
      double p = strand_random(s->seed, strand, STRAND_JOINTS, joint);
      double t = strand_random(s->seed, strand, STRAND_JOINTS, joint + 1);
      turn(m, s->phi_min + p * (s->phi_max - s->phi_min),
           s->theta_min + t * (s->theta_max - s->theta_min));
    }
    /* rounding of a thousand products would show in the segments' lengths */
    double square = m[0] * m[0] + m[3] * m[3] + m[6] * m[6], unit = step / scalar_root(square);
    for (uint32_t c = 0; c < 3; c++) out[3 * i + c] = out[3 * i - 3 + c] + unit * m[3 * c];
  }
}

/* Shoemake's: a quaternion of three uniform numbers. */
void strand_rotation(uint32_t seed, uint32_t strand, double out[9]) {
  double u = strand_random(seed, strand, STRAND_TURN, 0), s1, c1, s2, c2;
  strand_sine_cosine(2 * PI * strand_random(seed, strand, STRAND_TURN, 1), &s1, &c1);
  strand_sine_cosine(2 * PI * strand_random(seed, strand, STRAND_TURN, 2), &s2, &c2);
  double a = scalar_root(1 - u), b = scalar_root(u);
  double x = a * s1, y = a * c1, z = b * s2, w = b * c2;
  out[0] = 1 - 2 * (y * y + z * z), out[1] = 2 * (x * y - z * w), out[2] = 2 * (x * z + y * w);
  out[3] = 2 * (x * y + z * w), out[4] = 1 - 2 * (x * x + z * z), out[5] = 2 * (y * z - x * w);
  out[6] = 2 * (x * z - y * w), out[7] = 2 * (y * z + x * w), out[8] = 1 - 2 * (x * x + y * y);
}
