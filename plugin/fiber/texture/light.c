/* SPDX-License-Identifier: Apache-2.0
 *
 * Light among strands: what one of them does, and what many do together. Of the latter the
 * shape is physics, the amounts are fitted to rays followed through grown strands
 * (fiber.radiance; docs/fiber-texture.md says what was fitted, and how well).
 */
#include "light.h"

#include <string.h>

#include "../../core/colour.h"
#include "../../core/scalar.h"
#include "cloth_light.h"
#include "fitted.h"
#include "parameters.h"

/* ---- amounts ----------------------------------------------------------- */

/* The i-th of VIEWS by VIEWS rays, even over the hemisphere as a surface has them; how broad a
 * pile's strands look by it, over what they are squarely: pile.h. steep2, lean: 0 of what lies
 * flat. */
#define VIEWS 12
static double pile_look(int i, double steep2, double lean) {
  double sine2 = (i % VIEWS + 0.5) / VIEWS, round = 2.0 * PI * (i / VIEWS + 0.5) / VIEWS;
  double t2 = sine2 / (1.0 - sine2), a = scalar_root(t2) * scalar_cos(round), b2 = t2 - a * a;
  return scalar_root(scalar_most(1.0 + a * (a * steep2 - 2.0 * lean) + b2 * (1.0 + steep2), 0.05));
}

double fibertex_pile_met(const fibertex_constants *w) {
  double pile = 0.0, flat = 0.0;
  for (int i = 0; i < VIEWS * VIEWS; i++) {
    pile += pile_look(i, (double)w->steep2, (double)w->lean);
    flat += pile_look(i, 0.0, 0.0);
  }
  return pile / flat;
}

/* What of the light from around reaches what is seen, where strands look so broad. */
static double ambient_at(const fibertex_constants *w, double wide) {
  double left = 1.0, sum = 0.0;
  for (int l = 0; l < w->layers; l++) {
    double mean = (double)w->layer[l].mean;
    if (w->pile)
      mean = scalar_least(mean * scalar_least(wide, (double)w->layer[l].widen_most), 0.97);
    double share = left * mean;
    sum += share * (double)w->layer[l].ambient;
    left -= share;
  }
  double under = left * (double)w->deep;
  return (sum + under * (double)w->deep_ambient) / scalar_most(1.0 - left + under, 1e-3);
}

/* The mean: of what is seen squarely, of a pile from all sides. */
double fibertex_ambient(const fibertex_constants *w) {
  if (!w->pile) return ambient_at(w, 1.0);
  double sum = 0.0;
  for (int i = 0; i < VIEWS * VIEWS; i++) {
    sum += ambient_at(w, pile_look(i, (double)w->steep2, (double)w->lean));
  }
  return sum / (VIEWS * VIEWS);
}

/* Optical depth for what is scattered often: the clearer strands are, the more of them
 * light meets before it has turned. */
static double slow_depth(double clear, double depth) {
  double dull = scalar_most(1.0 - clear, 0.15) / (1.0 - CLEAR);
  return depth * scalar_exp(2.07 * scalar_log(dull));
}

/* What part of TT goes on at each strand. */
double fibertex_passed(double clear) { return clear / (clear + 0.25) * (CLEAR + 0.25) / CLEAR; }

static double bulk_of(const fibertex_constants *w, const settings *s, double depth, int which) {
  const double feature[BULK_FEATURES] = {
      [BULK_ONE] = 1.0,
      [BULK_THIN] = 1.0 / (1.0 + 0.25 * depth),
      [BULK_DULL] = scalar_log(scalar_most(1.0 - number_at(s, P_TRANSMISSION), 0.05)),
      [BULK_ROUGH] = scalar_log(number_at(s, P_ROUGHNESS) * RADIANS),
      [BULK_RISE] = (double)w->rise};
  const fibertex_fitted *fit = fibertex_fit(feature);
  return scalar_exp(fitted_sum(fit->bulk[which], feature, fit->bulk_least, fit->bulk_most,
                               fit->bulk_middle, BULK_FEATURES));
}

static void amounts_of_bulk(fibertex_constants *w, const settings *s, double depth) {
  double clear = number_at(s, P_TRANSMISSION), passed = fibertex_passed(clear);
  double slow = slow_depth(clear, depth), ambient = fibertex_ambient(w);
  w->gloss[0] = (float)(bulk_of(w, s, depth, BULK_GLANCE) * PI / 4.0);
  w->gloss[1] = (float)(bulk_of(w, s, depth, BULK_THROUGH) * passed);
  w->single = (float)bulk_of(w, s, depth, BULK_SINGLE);
  w->multiple = (float)(bulk_of(w, s, depth, BULK_OFTEN) / ambient);
  double chain = bulk_of(w, s, depth, BULK_CHAIN) * passed;
  w->chain = (float)(chain * depth / (depth + 0.92) / ambient);
  w->slab = (float)(0.5 * slow);
  w->slab_linear = (float)bulk_of(w, s, depth, BULK_LINEAR);
  w->slab_square = (float)bulk_of(w, s, depth, BULK_SQUARE);
  w->graze = (float)bulk_of(w, s, depth, BULK_GRAZE);
  w->graze_both = (float)bulk_of(w, s, depth, BULK_GRAZE_BOTH);
  /* strands shade what is behind them within an angle of their thickness over the way
   * between two */
  double angle = scalar_most(4.0 / PI * number_at(s, P_PACKING), 0.05);
  w->opposition = 0.9f;
  w->opposition_sharp = (float)(2.0 / (angle * angle));
}

/* Amounts: docs/fiber-texture.md. property.fiber_light prints what all of it
 * reflects, which is to stay below what comes in. */
static void amounts(fibertex_constants *w, const settings *s, double depth) {
  double n = number_at(s, P_IOR), f = (n - 1.0) / (n + 1.0);
  double beta = 2.0 * number_at(s, P_ROUGHNESS) * RADIANS, tilt = number_at(s, P_TILT) * RADIANS;
  double clear = number_at(s, P_TRANSMISSION);
  double reflected = 1.9 * f * f; /* a cylinder's mean over its width, about twice its crest's */
  static const double width[3] = {1.0, 1.2, 1.7}, shift[3] = {-2.0, 1.0, 3.0};
  const double amount[3] = {reflected, 0.55 * clear * (1.0 - reflected),
                            0.12 * clear * (1.0 - reflected)};
  for (int i = 0; i < 3; i++) {
    double b = scalar_most(beta * width[i], 0.05);
    w->gloss[i] = (float)amount[i];
    w->sharp[i] = (float)(1.0 / width[i]);
    if (i == 0) w->beta2 = (float)(b * b);
    w->tilt[i] = (float)(shift[i] * tilt);
  }
  w->single = (float)(0.52 * (1.0 - 0.45 * clear));
  w->multiple = (float)(0.42 + 0.1 * clear);
  w->mirror = (float)(f * f);
  double alpha = scalar_least(scalar_most(2.0 * number_at(s, P_ROUGHNESS) * RADIANS, 0.08), 1.0);
  w->strand_alpha2 = (float)(alpha * alpha);
  if (w->structure == STRUCTURE_WOVEN)
    fibertex_cloth_amounts(w, s);
  else
    amounts_of_bulk(w, s, depth);
}

/* ---- colours ----------------------------------------------------------- */

/* How a colour looks by light that has met several strands. */
typedef struct {
  double fit;  /* of absorption to colour */
  double more; /* strands that light goes on through beyond the first, the mean */
  double slab; /* Kubelka and Munk's S X */
} crossings;

static crossings crossings_of(const fibertex_constants *w, const settings *s, double depth) {
  double clear = number_at(s, P_TRANSMISSION);
  /* how rough a fibre is around, as presets make their transmission of it */
  double b = scalar_least(scalar_most((1.0 - (clear - 0.08) / 0.55) / 0.8, 0.0), 1.0), b2 = b * b;
  return (crossings){.fit = 5.969 - 0.215 * b + 2.532 * b2 - 10.73 * b2 * b + 5.574 * b2 * b2 +
                            0.245 * b2 * b2 * b,
                     .more = bulk_of(w, s, depth, BULK_MORE) * depth / (depth + 2.19),
                     .slab = bulk_of(w, s, depth, BULK_SLAB) * slow_depth(clear, depth)};
}

/* A strand lets through T, by the absorption that Chiang et al. (2016) fitted to colours in
 * bulk; one after the other the sum of a geometric series. */
static double onward(const crossings *n, double c) {
  double ln = scalar_log(scalar_most(c, 1e-8)) / n->fit, t = scalar_exp(-2.0 * ln * ln);
  return t / (1.0 + n->more * (1.0 - t));
}

/* What comes back of what is scattered often. */
static double back_of(const fibertex_constants *w, const settings *s, const crossings *n,
                      double c) {
  if (w->structure == STRUCTURE_WOVEN) return fibertex_cloth_back(w, s, c);
  return fibertex_over_black(n->slab, scalar_most(c, 1e-8));
}

/* 3x3, columns; false where it has no inverse to speak of. */
static int invert(const double m[3][3], double out[3][3]) {
  for (int i = 0; i < 3; i++) {
    const double *p = m[(i + 1) % 3], *q = m[(i + 2) % 3];
    for (int k = 0; k < 3; k++) {
      out[k][i] = p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3];
    }
  }
  double det = m[0][0] * out[0][0] + m[0][1] * out[1][0] + m[0][2] * out[2][0];
  if (!(det > 1e-6 || det < -1e-6)) return 0;
  for (int i = 0; i < 9; i++) out[i / 3][i % 3] /= det;
  return 1;
}

static void transform(const double m[3][3], const double v[3], double out[3]) {
  for (int i = 0; i < 3; i++) out[i] = m[0][i] * v[0] + m[1][i] * v[1] + m[2][i] * v[2];
}

/* What is not linear in the colour is done in linear Rec.709, whatever the working space is:
 * else another working space would be another fibre. What lies outside stays outside. */
static int32_t colours(fibertex_constants *w, const sozai_host *host, const settings *s,
                       double depth) {
  memcpy(w->glow, w->colour, sizeof w->glow);
  memcpy(w->bulk, w->colour, sizeof w->bulk);
  float primaries[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  int32_t r = colour_list(host, "sRGB", primaries, 3);
  if (r) return r;
  double to[3][3], from[3][3];
  for (int i = 0; i < 9; i++) to[i / 3][i % 3] = (double)primaries[i / 3][i % 3];
  if (!invert((const double(*)[3])to, from)) return SOZAI_OK;
  crossings n = crossings_of(w, s, depth);
  int woven = w->structure == STRUCTURE_WOVEN;
  if (woven) n.more = 0.0; /* side by side: what went through one goes out */
  double white = back_of(w, s, &n, 1.0);
  double to_albedo = woven ? fibertex_cloth_albedo(w, s) : 0.0;
  for (int i = 0; i < FIBERTEX_COLOURS; i++) {
    double c[3], glow[3], bulk[3], albedo[3], out[3][3];
    for (int k = 0; k < 3; k++) c[k] = (double)w->colour[i][k];
    transform((const double(*)[3])from, c, out[0]);
    for (int k = 0; k < 3; k++) {
      double x = scalar_least(scalar_most(out[0][k], 0.0), 1.0), outside = out[0][k] - x;
      glow[k] = onward(&n, x) + outside;
      double back = back_of(w, s, &n, x);
      bulk[k] = back / white + outside;
      albedo[k] = to_albedo * back + outside;
    }
    transform((const double(*)[3])to, glow, out[0]);
    transform((const double(*)[3])to, bulk, out[1]);
    transform((const double(*)[3])to, albedo, out[2]);
    for (int k = 0; k < 3; k++) {
      if (woven) w->colour[i][k] = (float)out[2][k];
      w->glow[i][k] = (float)out[0][k];
      w->bulk[i][k] = (float)out[1][k];
    }
  }
  return SOZAI_OK;
}

int32_t fibertex_build_light(fibertex_constants *w, const sozai_host *host, const settings *s,
                             double depth) {
  amounts(w, s, depth);
  return colours(w, host, s, depth);
}
