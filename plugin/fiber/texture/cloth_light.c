/* SPDX-License-Identifier: Apache-2.0
 *
 * Light on cloth. Its strands lie side by side in yarns, which light goes through, glances off and
 * is scattered in; how many of them it meets is the cloth's thickness, place by place. The
 * shape is physics, its figures (fitted.h) are fitted to rays followed through the strands of every
 * preset (fiber.cloth; docs/fiber-texture.md says how well).
 */
#include "cloth_light.h"

#include "../../core/scalar.h"
#include "fitted.h"
#include "parameters.h"

#define YARN_PACKING 0.5 /* share of a yarn that is fibre: 0.4 to 0.6, Morton & Hearle 2008 */
#define PLACES 16        /* over a crossing, either way */

/* ---- thickness --------------------------------------------------------- */

/* How thick the yarns of one direction are at a place from one's middle, in spacings. */
static double thickness_at(const fibertex_yarn *y, double at) {
  double sum = 0.0;
  for (int k = -1; k <= 1; k++) {
    double e = (at - k) * (double)y->spacing * (double)y->inverse_half;
    if (e > -1.0 && e < 1.0) sum += 2.0 * (double)y->height * scalar_root(1.0 - e * e);
  }
  return sum;
}

/* What of a fibre's depth is met of a crossing's yarns, the mean. */
static double yarns_depth(const fibertex_constants *w, const settings *s) {
  double sum = 0.0, per_mm = YARN_PACKING / (0.001 * number_at(s, P_DIAMETER) * PI / 4.0);
  for (int i = 0; i < 2; i++) {
    const fibertex_yarn *y = &w->yarn[i];
    sum += per_mm * PI * (double)y->half * (double)y->height * (double)y->inverse_spacing;
  }
  return sum;
}

static double amount_of(const fibertex_constants *w, const settings *s, int which) {
  const double feature[CLOTH_FEATURES] = {
      [CLOTH_ONE] = 1.0,
      [CLOTH_DEPTH] = scalar_log(scalar_most(yarns_depth(w, s), 1e-3)),
      [CLOTH_DULL] = scalar_log(scalar_most(1.0 - number_at(s, P_TRANSMISSION), 0.05)),
      [CLOTH_ROUGH] = scalar_log(number_at(s, P_ROUGHNESS) * RADIANS),
      [CLOTH_RISE] = (double)w->rise,
      [CLOTH_FLOWN] = (double)w->flown,
      [CLOTH_LEAN] = (double)w->lean_rms,
      [CLOTH_SLOPE] = (double)w->slope_rms,
      [CLOTH_TWIST] = scalar_root(1.0 - (double)w->below[0] * (double)w->below[0]),
      [CLOTH_SLUB] = number_at(s, P_SLUB),
      [CLOTH_COARSE] = 0.0005 * number_at(s, P_DIAMETER) / (double)w->yarn[0].height};
  const fibertex_fitted *fit = fibertex_fit(feature);
  double log =
      fitted_sum(fit->amount[which], feature, fit->least, fit->most, fit->middle, CLOTH_FEATURES);
  return scalar_exp(scalar_least(scalar_most(log, fit->low[which]), fit->high[which]));
}

double fibertex_over_black(double slab, double c) {
  double k = (1.0 - c) * (1.0 - c) / (2.0 * c), a = 1.0 + k, b = scalar_root(k * (k + 2.0));
  if (b * slab < 1e-4) return slab / (1.0 + a * slab);
  double e = scalar_exp(-2.0 * b * slab);
  return (1.0 - e) / (a * (1.0 - e) + b * (1.0 + e));
}

/* The same of a cloth: over its thickness from place to place, where there is any. Clearer
 * strands turn light later. */
double fibertex_cloth_back(const fibertex_constants *w, const settings *s, double c) {
  double dull = scalar_most(1.0 - number_at(s, P_TRANSMISSION), 0.15) / (1.0 - CLEAR);
  double per_mm = amount_of(w, s, FIT_SLAB) * dull * YARN_PACKING /
                  (0.001 * number_at(s, P_DIAMETER) * PI / 4.0);
  double thick[2][PLACES], sum = 0.0, covered = 0.0;
  c = scalar_exp(amount_of(w, s, FIT_COLOUR) * scalar_log(scalar_most(c, 1e-8)));
  for (int i = 0; i < 2 * PLACES; i++) {
    thick[i / PLACES][i % PLACES] =
        thickness_at(&w->yarn[i / PLACES], (i % PLACES + 0.5) / PLACES - 0.5);
  }
  for (int i = 0; i < PLACES * PLACES; i++) {
    double slab = per_mm * (thick[0][i / PLACES] + thick[1][i % PLACES]);
    if (slab <= 0.0) continue;
    covered += 1.0;
    sum += fibertex_over_black(slab, c);
  }
  return sum / scalar_most(covered, 1.0);
}

/* ---- amounts and colours ----------------------------------------------- */

/* Mean over the hemisphere of a bell over the sine of the inclination. */
static double bell_mean(double variance) {
  double sum = 0.0, k = 1.0 / scalar_root(variance);
  for (int i = 0; i < 256; i++) {
    double z2 = (i % 16 + 0.5) / 16.0, a = PI * (i / 16 + 0.5) / 16.0;
    double x = scalar_root(1.0 - z2) * scalar_cos(a) * k, q = scalar_most(1.0 - x * x / 16.0, 0.0);
    q *= q;
    q *= q;
    q *= q;
    sum += q * k / FIBERTEX_BELL;
  }
  return sum / 256.0;
}

/* The mean of the furrows' shade, and of the layers'. */
static double shade_of(const fibertex_constants *w) {
  double sum = 0.0;
  for (int m = 0; m < w->looks; m++) sum += (double)w->look[m].lit;
  return sum * fibertex_ambient(w);
}

void fibertex_cloth_amounts(fibertex_constants *w, const settings *s) {
  double clear = fibertex_passed(number_at(s, P_TRANSMISSION));
  double beta = number_at(s, P_ROUGHNESS) * RADIANS, narrow = amount_of(w, s, FIT_NARROW);
  w->beta2 = (float)(narrow * narrow * beta * beta);
  w->even2 = (float)(amount_of(w, s, FIT_BROAD) * 4.0 * beta * beta + 0.02);
  w->even = (float)(1.0 / bell_mean((double)w->even2 + (double)w->scatter + (double)w->scatter_up));
  w->gloss[0] = (float)(amount_of(w, s, FIT_GLANCE) * PI / 4.0);
  w->gloss[1] = (float)(amount_of(w, s, FIT_THROUGH) * clear);
  w->flown_gloss = (float)(amount_of(w, s, FIT_FLOWN) * clear);
  w->hair = (float)amount_of(w, s, FIT_HAIR) * w->rise2;
  w->flown_deep = (float)amount_of(w, s, FIT_SHADED) * (w->flown + w->hair);
  w->multiple = (float)(amount_of(w, s, FIT_OFTEN) / shade_of(w));
  double white = fibertex_cloth_back(w, s, 1.0);
  double slab = amount_of(w, s, FIT_SLAB);
  w->slab_linear = (float)(1.0 / slab);
  w->slab = (float)(0.5 * white / (1.0 - white) / slab);
  w->opposition = 0.9f;
  w->opposition_sharp = 20.0f;
}

double fibertex_cloth_albedo(const fibertex_constants *w, const settings *s) {
  return amount_of(w, s, FIT_ALBEDO) / shade_of(w);
}
