/* SPDX-License-Identifier: Apache-2.0
 *
 * Light on cloth. Its strands lie side by side in yarns, which light goes through, glances off and
 * is scattered in; how many of them it meets is the cloth's thickness, place by place. The
 * shape is physics, six figures are fitted to rays followed through the strands of every preset
 * (fiber.cloth; docs/fiber-texture.md says how well).
 */
#include "cloth_light.h"

#include "../../core/scalar.h"
#include "parameters.h"

#define PI 3.14159265358979324
#define RADIANS (PI / 180.0)
#define YARN_PACKING 0.5 /* share of a yarn that is fibre: 0.4 to 0.6, Morton & Hearle 2008 */
#define PLACES 16        /* over a crossing, either way */

/* ---- fitted ------------------------------------------------------------ */

#define SLAB 0.17    /* Kubelka and Munk's S, over the optical depth */
#define ALBEDO 0.91  /* of light from all around, to an eye above: over what is beyond the first */
#define NARROW 0.62  /* width of a lobe along the strand, over the roughness */
#define BROAD 1.26   /* variance of what is scattered often, over twice the roughness squared */
#define GLANCE 0.45  /* reflected */
#define THROUGH 1.52 /* transmitted, of a yarn; and of single strands over it */
#define FLOWN 2.17
#define HAIR 6.4   /* single strands that stand off a yarn, over their slope's variance */
#define SHADED 0.5 /* how far they shade one another, over what of the cloth they cover */
#define OFTEN 1.19 /* scattered often */

static double most(double a, double b) { return a > b ? a : b; }

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

double fibertex_over_black(double slab, double c) {
  double k = (1.0 - c) * (1.0 - c) / (2.0 * c), a = 1.0 + k, b = scalar_root(k * (k + 2.0));
  if (b * slab < 1e-4) return slab / (1.0 + a * slab);
  double e = scalar_exp(-2.0 * b * slab);
  return (1.0 - e) / (a * (1.0 - e) + b * (1.0 + e));
}

/* The same of a cloth: over its thickness from place to place, where there is any. Clearer
 * strands turn light later. */
double fibertex_cloth_back(const fibertex_constants *w, const settings *s, double c) {
  double dull = most(1.0 - number_at(s, P_TRANSMISSION), 0.15) / (1.0 - CLEAR);
  double per_mm = SLAB * dull * YARN_PACKING / (0.001 * number_at(s, P_DIAMETER) * PI / 4.0);
  double thick[2][PLACES], sum = 0.0, covered = 0.0;
  for (int i = 0; i < 2 * PLACES; i++) {
    thick[i / PLACES][i % PLACES] =
        thickness_at(&w->yarn[i / PLACES], (i % PLACES + 0.5) / PLACES - 0.5);
  }
  for (int i = 0; i < PLACES * PLACES; i++) {
    double slab = per_mm * (thick[0][i / PLACES] + thick[1][i % PLACES]);
    if (slab <= 0.0) continue;
    covered += 1.0;
    sum += fibertex_over_black(slab, most(c, 1e-8));
  }
  return sum / most(covered, 1.0);
}

/* ---- amounts and colours ----------------------------------------------- */

/* Mean over the hemisphere of a bell over the sine of the inclination. */
static double bell_mean(double variance) {
  double sum = 0.0, k = 1.0 / scalar_root(variance);
  for (int i = 0; i < 256; i++) {
    double z2 = (i % 16 + 0.5) / 16.0, a = PI * (i / 16 + 0.5) / 16.0;
    double x = scalar_root(1.0 - z2) * scalar_cos(a) * k, q = most(1.0 - x * x / 16.0, 0.0);
    q *= q;
    q *= q;
    q *= q;
    sum += q * k / 2.39628;
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
  double n = number_at(s, P_IOR), f = (n - 1.0) / (n + 1.0),
         clear = fibertex_passed(number_at(s, P_TRANSMISSION));
  double beta = number_at(s, P_ROUGHNESS) * RADIANS;
  w->mirror = (float)(f * f);
  w->beta2 = (float)(NARROW * NARROW * beta * beta);
  w->even2 = (float)(BROAD * 4.0 * beta * beta + 0.02);
  w->even = (float)(1.0 / bell_mean((double)w->even2 + (double)w->scatter + (double)w->scatter_up));
  w->gloss[0] = (float)(GLANCE * PI / 4.0);
  w->gloss[1] = (float)(THROUGH * clear);
  w->flown_gloss = (float)(FLOWN * clear);
  w->hair = (float)HAIR * w->rise2;
  w->flown_deep = (float)SHADED * (w->flown + w->hair);
  w->multiple = (float)(OFTEN / shade_of(w));
  double white = fibertex_cloth_back(w, s, 1.0);
  w->slab_linear = (float)(1.0 / SLAB);
  w->slab = (float)(0.5 * white / (1.0 - white) / SLAB);
  w->opposition = 0.9f;
  w->opposition_sharp = 20.0f;
}

double fibertex_cloth_albedo(const fibertex_constants *w) { return ALBEDO / shade_of(w); }
