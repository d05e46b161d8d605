/* SPDX-License-Identifier: Apache-2.0
 *
 * Axial parenchyma.
 */
#include "parts.h"

#include <string.h>

#include "../../core/scalar.h"
#include "../parameters.h"
#include "late.h"

/* How far the noise takes a band's width, of it; and the most of their spacing that bands take. */
#define UNEVEN 0.9
#define BANDS_MOST 0.9
#define SHEATH_ROOM 0.42 /* of a cell: the longest semi-axis of a vessel of the mean radius */
#define SOFT_PART 0.4    /* of the bundles' size */
#define SHEATH_CLEAR 0.6 /* of a cell, as parts of footprints may reach */
#define SOFT_BETWEEN 0.5 /* of a band of vessels' spacing: the pale tissue's width */

enum { ANGLES = 3, PLACES = 5, RINGS = 4, ROUND = 12 };

/* Places all over a disc of radius 1, in rings of equal area: how far out, and which way. */
typedef struct {
  double out[RINGS], cosine[ROUND], sine[ROUND];
} disc_places;

static disc_places all_over_a_disc(void) {
  disc_places q;
  for (int i = 0; i < RINGS; i++) q.out[i] = __builtin_sqrt((i + 0.5) / RINGS);
  for (int i = 0; i < ROUND; i++) {
    q.cosine[i] = scalar_cos(TWO_PI * i / ROUND);
    q.sine[i] = scalar_sin(TWO_PI * i / ROUND);
  }
  return q;
}

/* Shares of an ellipse about a place in the middle one of 3 x 3 cells that lie in each, of their
 * area; the mean over vessels of all sizes. Lengths in cells. */
static void shares_of_cells(const wood_vessels *v, const disc_places *q, double a, double b,
                            double turn, const double at[2], double share[9]) {
  double c = scalar_cos(turn), s = scalar_sin(turn);
  for (int i = 0; i < 9; i++) share[i] = 0.0;
  for (int n = 0; n < WOOD_RADII; n++) {
    double size = 1.0 / __builtin_sqrt((double)v->inverse_square[n]);
    double part = 0.5 * TWO_PI * a * b * size * size / (WOOD_RADII * RINGS * ROUND);
    for (int k = 0; k < RINGS * ROUND; k++) {
      double out = size * q->out[k / ROUND];
      double x = out * a * q->cosine[k % ROUND], y = out * b * q->sine[k % ROUND];
      double px = at[0] + c * x - s * y, py = at[1] + s * x + c * y;
      int ix = px < 0.0 ? 0 : px < 1.0 ? 1 : 2, iy = py < 0.0 ? 0 : py < 1.0 ? 1 : 2;
      share[3 * iy + ix] += part;
    }
  }
}

double wood_paired_cover(const wood_vessels *v, double a, double b, double cell) {
  const disc_places q = all_over_a_disc();
  double bare = 0.0;
  for (int k = 0; k < ANGLES * PLACES * PLACES; k++) {
    double turn = TWO_PI / 8.0 * (k / (PLACES * PLACES)) / (ANGLES - 1), share[9], left = 1.0;
    double at[2] = {(k % PLACES + 0.5) / PLACES, (k / PLACES % PLACES + 0.5) / PLACES};
    shares_of_cells(v, &q, a / cell, b / cell, turn, at, share);
    for (int i = 0; i < 9; i++) {
      double out = limited(1.0 - share[i], 0.0, 1.0);
      left *= out * out;
    }
    bare += left / (ANGLES * PLACES * PLACES);
  }
  return 1.0 - bare;
}

int wood_has_sheaths(const wood_constants *w, const settings *s) {
  return w->has_pores && number_at(s, P_SHEATH) > 0.0;
}

/* Where pores shrink along a ring, so do their sheaths. The mean of what they cover, over what they
 * would cover at their mean size; and what they take of latewood, over their mean cover. */
static void build_grown(wood_constants *w, double c, double met) {
  wood_parenchyma *m = &w->parenchyma;
  double cover = 0.0, square = 0.0, late = 0.0, taken = 0.0;
  for (int i = 0; i < 64; i++) {
    double size = (double)w->pore_early + (double)w->pore_growth * (i + 0.5) / 64.0;
    double here = c * size * size / (1.0 + met * c * size * size);
    double part = late_profile_integral(w, (i + 1.0) / 64.0) - late_profile_integral(w, i / 64.0);
    square += size * size / 64.0;
    cover += here / 64.0;
    late += part;
    taken += part * here;
  }
  m->sheath_grown = (float)(cover * (1.0 + met * c * square) / (c * square));
  m->sheath_late = (float)(late > 0.0 ? taken / (late * cover) : 1.0);
}

void wood_build_sheaths(wood_constants *w, const settings *s, double square) {
  wood_parenchyma *m = &w->parenchyma;
  double radius = (double)w->pores.radius, cell = (double)w->pore_cell;
  double radial = radius + 1e-3 * number_at(s, P_SHEATH);
  double arc = radial * number_at(s, P_WINGS), most = SHEATH_ROOM * cell;
  m->sheaths = 1;
  if (most < radius) most = radius;
  radial = scalar_least(radial, most);
  arc = scalar_least(arc, most);
  m->sheath_arc2 = (float)(arc * arc);
  m->sheath_radial2 = (float)(radial * radial);
  double c = 0.5 * TWO_PI * arc * radial * square * number_at(s, P_PORE_DENSITY), covered;
  if (w->bands.on) {
    covered = wood_banded_cover(&w->bands, c, __builtin_sqrt(arc * radial), cell);
  } else {
    covered = wood_paired_cover(&w->pores, arc, radial, cell);
  }
  m->sheath_cover = (float)covered;
  m->sheath_area = (float)c;
  m->sheath_met = (float)(1.0 / covered - 1.0 / c);
  build_grown(w, c, (double)m->sheath_met);
  double usual = (1.0 + number_at(s, P_PORE_SPREAD)) * __builtin_sqrt(arc * radial);
  double part = (double)wood_longest_footprint(SHEATH_CLEAR * cell, usual, END_CONE);
  if (part < (double)w->pores.part) w->pores.part = (float)part;
}

static void build_margin(wood_constants *w, const settings *s) {
  wood_parenchyma *m = &w->parenchyma;
  double margin = 1e-3 * number_at(s, P_MARGINAL), room = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    m->margin_before[j] = (float)room;
    room += scalar_least(margin, 0.5 / (double)w->inverse_width[j]);
  }
  m->margin_before[WOOD_RINGS] = m->margin_period = (float)room;
  m->margin = (float)margin;
}

static void build_bands(wood_constants *w, const settings *s) {
  wood_parenchyma *m = &w->parenchyma;
  double wide = 1e-3 * number_at(s, P_SOFT_BAND_WIDTH), spacing = number_at(s, P_SOFT_BAND_SPACING);
  if (wide <= 0.0) return;
  double stray = number_at(s, P_SOFT_BAND_STRAY), share = scalar_least(wide / spacing, BANDS_MOST);
  /* the widest still leaves something between */
  double uneven = scalar_least(UNEVEN * scalar_least(stray, 1.0), 1.0 / share - 1.0);
  m->bands_often = (float)(1.0 / spacing);
  m->bands_share = (float)share;
  m->bands_stray = (float)(stray / NOISE_BOUND);
  m->bands_uneven = (float)(uneven / NOISE_BOUND);
  m->bands_lost = (float)(12.0 * stray * stray * FIBRE_VARIANCE);
}

static void build_between(wood_constants *w, const settings *s) {
  wood_parenchyma *m = &w->parenchyma;
  if (!w->bands.on) return;
  double stray = (double)w->bands.stray * NOISE_BOUND;
  m->between = (float)number_at(s, P_BETWEEN);
  m->between_half = (float)(0.5 * SOFT_BETWEEN);
  m->between_lost = (float)(12.0 * stray * stray * FIBRE_VARIANCE);
  m->between_denser = (float)(wood_bands_denser(&w->bands, (double)m->between_half) - 1.0);
}

void wood_build_parenchyma(wood_constants *w, const settings *s, const float (*colours)[3]) {
  wood_parenchyma *m = &w->parenchyma;
  build_margin(w, s);
  build_bands(w, s);
  build_between(w, s);
  m->on = m->sheaths || m->margin > 0.0f || m->bands_often > 0.0f || m->between > 0.0f;
  m->part = (float)(SOFT_PART * WOOD_BUNDLE * number_at(s, P_FIBRE_WIDTH));
  w->has_strays = w->bands.stray > 0.0f || m->bands_stray > 0.0f;
  memcpy(m->colour, colours[P_SOFT_COLOUR], sizeof m->colour);
  memcpy(m->sap, colours[P_SAP_SOFT], sizeof m->sap);
}
