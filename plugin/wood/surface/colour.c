/* SPDX-License-Identifier: Apache-2.0
 *
 * What surface and finish make of a wood's colours and gloss: once, at
 * creation, so that a point costs nothing more and averages stay exact.
 */
#include "../../core/scalar.h"
#include "build.h"
#include "finishes.h"

/* A colour c that grew out of base, where base has become `to`: darker by what
 * it was, by the power `by` of it. */
static double follow(double c, double base, double to, double by) {
  double ratio = base > 1e-3 ? c / base : 1.0;
  if (ratio < 1e-3) ratio = 1e-3;
  double x = to * scalar_exp(by * scalar_log(ratio));
  return x > 1.0 ? 1.0 : x;
}

/* Kubelka and Munk's reflectance of a thick layer whose scattering has fallen to
 * 1/f: oil's index of refraction is nearer to the cell walls' than air's is. */
static double wetted(double r, double f) {
  if (r < 1e-4) return r;
  double x = f * (1.0 - r) * (1.0 - r) / (2.0 * r);
  return 1.0 + x - scalar_root(x * x + 2.0 * x);
}

/* Toasted, then soot over it. Heat darkens wood by far more than it deepens the hue (wood modified
 * at 220 degrees is a dark brown of the chroma that it had): the grey y goes with a high power,
 * the channel c's share of it with a low one. */
static double charred(double c, double y, double how) {
  const double black = 0.022;
  if (c < black || how <= 0.0) return c;
  double deeper = 2.2 * how * scalar_log(y) + 0.7 * how * scalar_log(c / y);
  double toasted = c * scalar_exp(deeper);
  double soot = black * scalar_exp(0.2 * scalar_log(c / black));
  double x = toasted + how * how * (soot - toasted);
  return x < c ? x : c;
}

static double grey_of(const float c[3]) {
  return 0.3 * (double)c[0] + 0.6 * (double)c[1] + 0.1 * (double)c[2];
}

static void treat(float colour[3], const settings *s, const float early[3], const float grey[3]) {
  static const double wet[] = {1.0, 2.4, 2.0};
  int surface = choice_at(s, P_SURFACE);
  double f = wet[choice_at(s, P_FINISH)], own = grey_of(colour), base = grey_of(early);
  for (int c = 0; c < 3; c++) {
    double x = (double)colour[c];
    if (surface == SURFACE_CHARRED) x = charred(x, own, number_at(s, P_CHARRING));
    if (surface == SURFACE_WEATHERED) {
      double g = number_at(s, P_GREYING);
      x += g * (follow(own, base, (double)grey[c], 0.6) - x);
    }
    if (f > 1.0) x = wetted(x, f);
    colour[c] = (float)x;
  }
}

#define SATIN 0.45 /* roughness of what is not a film: oil in the fibres, char */

void surface_build_colour(wood_constants *w, const settings *s, const float (*colours)[3]) {
  int surface = choice_at(s, P_SURFACE), finish = choice_at(s, P_FINISH);
  const surface_finish *f = &surface_finishes[surface];
  float *each[] = {w->late,         w->vessel,      w->ray,
                   w->sap_early,    w->sap_late,    w->pigment,
                   w->streak,       w->early,       w->knot_early,
                   w->knot_late,    w->knot_bark,   w->parenchyma.colour,
                   w->canal_colour, w->canal_lumen, w->parenchyma.sap,
                   w->spalt_pale,   w->ray_sap,     w->vessel_sap};
  float early[3];
  for (int c = 0; c < 3; c++) early[c] = w->early[c];
  if (surface == SURFACE_CHARRED || surface == SURFACE_WEATHERED || finish != FINISH_RAW) {
    for (size_t i = 0; i < sizeof each / sizeof *each; i++)
      treat(each[i], s, early, colours[P_GREY_COLOUR]);
  }
  double specular = (double)w->specular * f->specular;
  double shininess = (double)w->shininess * f->shininess, coat = f->coat;
  if (finish != FINISH_RAW) {
    specular *= 1.2;
    shininess *= 1.5;
    coat = finish == FINISH_LACQUERED ? 1.0 : coat > 0.3 ? coat : 0.3;
  }
  if (surface == SURFACE_CHARRED) {
    /* char shines like graphite, without hue, and hides the fibres */
    double how = number_at(s, P_CHARRING), shine = 0.1;
    specular += how * (shine - specular);
    for (int c = 0; c < 3; c++) {
      w->tint_colour[c] = (float)((double)w->tint_colour[c] * (1.0 - how) + how);
    }
    coat *= how;
  }
  w->specular = (float)(specular > 1.0 ? 1.0 : specular);
  w->shininess = (float)(shininess < 1.0 ? 1.0 : shininess);
  w->roughness = __builtin_sqrtf(2.0f / (w->shininess + 2.0f));
  double asked = number_at(s, P_COAT), rough = number_at(s, P_COAT_ROUGHNESS);
  /* only a film is glossy */
  if (coat > asked && finish != FINISH_LACQUERED && rough < SATIN) rough = SATIN;
  w->coat_alpha = (float)(rough * rough);
  w->coat = (float)(asked > coat ? asked : coat);
}

double surface_fibres(const settings *s) {
  int surface = choice_at(s, P_SURFACE);
  double share = surface_finishes[surface].specular;
  if (share > 1.0) share = 1.0;
  return surface == SURFACE_CHARRED ? share * (1.0 - number_at(s, P_CHARRING)) : share;
}
