/* SPDX-License-Identifier: Apache-2.0
 *
 * The fibres' cone in double, from the paper (Marschner, Westin, Arbree and Moon 2005), above a
 * face whose normal is +z.
 */
#ifndef SOZAI_TEST_CONE_FORMULA_H
#define SOZAI_TEST_CONE_FORMULA_H

#include <math.h>

#define PI 3.14159265358979
#define CONE "reflection=fibre_cone; fibre_brightness=0; porosity=none; "
#define BLACK                                                                                      \
  "earlywood_colour=0 0 0 @ lin_rec709; latewood_colour=0 0 0 @ lin_rec709; "                      \
  "sapwood_earlywood_colour=0 0 0; sapwood_latewood_colour=0 0 0; "

static inline void direction(double cosine, double around, double out[3]) {
  double s = sqrt(fmax(1 - cosine * cosine, 0));
  out[0] = s * cos(around);
  out[1] = s * sin(around);
  out[2] = cosine;
}

static inline double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double fresnel_of(double ci, double eta) {
  double ct = sqrt(1 - (1 - ci * ci) / (eta * eta));
  double p = (eta * ci - ct) / (eta * ci + ct), s = (ci - eta * ct) / (ci + eta * ct);
  return 0.5 * (p * p + s * s);
}

static inline double inclination(const double d[3], const double f[3], double eta) {
  double c = d[2], ct = sqrt(1 - (1 - c * c) / (eta * eta));
  double s[3] = {d[0] / eta, d[1] / eta, ct};
  return asin(dot(s, f));
}

/* Times pi cos: radiance for light_colour 1. */
static inline double lobe_of(const double l[3], const double v[3], const double f[3], double eta,
                             double width, double coat) {
  double pi_ = inclination(l, f, eta), pr = inclination(v, f, eta);
  double half = cos((pr - pi_) / 2);
  double g = exp(-(pr + pi_) * (pr + pi_) / (2 * width * width)) / (width * sqrt(2 * PI));
  double through = (1 - coat * fresnel_of(l[2], eta)) * (1 - coat * fresnel_of(v[2], eta));
  return PI * l[2] * through * g / fmax(half * half, 0.05);
}

#endif
