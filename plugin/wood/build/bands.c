/* SPDX-License-Identifier: Apache-2.0
 *
 * Bands of the field's pores.
 */
#include "parts.h"

#include "../../core/scalar.h"
#include "../parameters.h"

#define BAND_WIDE 0.42    /* of the spacing, between where a band is half as dense as within */
#define BAND_EDGE 0.12    /* of the spacing, over which it ends */
#define BAND_FORKED 0.25  /* of the spacing: how far a flame's arms part over a ring */
#define BAND_OBLIQUE 0.84 /* the tangent of diagonal files' angle to the rays, 40 degrees */
#define BAND_CELL 2.0     /* radii of the largest pore to a cell, at least */
#define BAND_ROOM 0.25    /* of the rings, far from their ends: with less, pores are even */

enum { SAMPLES = 128 }; /* over a band, and over a ring */

/* How many of the cells hold their pore within a band, between bands, and in the mean. */
typedef struct {
  double most, least, mean;
} band_shares;

/* in_bands: share of the pores. least: of the cells, so that a cell has room for its pore: where
 * pores are that many, fewer can be in bands. Where they are not all in bands chance has a part. */
static band_shares shares_of(double in_bands, double least) {
  band_shares b;
  double narrow = 1.0 / BAND_WIDE - 1.0;
  b.mean = limited(1.0 / (1.0 + in_bands * narrow), 0.0, 0.5);
  if (b.mean < least) b.mean = scalar_least(least, 1.0);
  in_bands = scalar_least(in_bands, (1.0 / b.mean - 1.0) / narrow);
  b.least = (1.0 - in_bands) * b.mean;
  b.most = b.least + in_bands * b.mean / BAND_WIDE;
  return b;
}

/* The share of cells that hold theirs at t of the spacing from a band's middle. */
static double share_at(const band_shares *b, double t) {
  double in = limited((0.5 * BAND_WIDE - t) / BAND_EDGE + 0.5, 0.0, 1.0);
  return b->least + (b->most - b->least) * in;
}

/* The i-th level of cells reaches as far as it does on average over them. */
static void build_within(wood_bands *m, const band_shares *b) {
  for (int i = 0; i < WOOD_RADII; i++) {
    double reach = 0.0;
    for (int k = 0; k < SAMPLES; k++) {
      double held = share_at(b, 0.5 * (k + 0.5) / SAMPLES) * WOOD_RADII - i;
      reach += 0.5 / SAMPLES * limited(held, 0.0, 1.0);
    }
    m->within[i] = (float)reach;
    if (reach > 0.4999) m->within[i] = 2.0f; /* everywhere */
    if (reach < 1e-6) m->within[i] = -1.0f;
  }
}

/* The same of the levels, in bands that have parted by fork. */
static double held_at(const wood_bands *m, double t, double fork) {
  double half = scalar_least(fork, (double)m->fork_most), away = __builtin_fabs(t - fork) + half;
  int held = 0;
  for (int i = 0; i < WOOD_RADII; i++) held += away < (double)m->within[i];
  return held / (double)WOOD_RADII;
}

/* The mean over a band, at a ring's phase f, of that share; or, c being positive, of what is
 * covered by discs strewn so that they cover c times that share where none overlaps. */
static double mean_over_band(const wood_bands *m, double f, double c) {
  double sum = 0.0;
  for (int k = 0; k < SAMPLES; k++) {
    double held = held_at(m, 0.5 * (k + 0.5) / SAMPLES, f * (double)m->fork);
    sum += c > 0.0 ? 1.0 - scalar_exp(-c * held) : held;
  }
  return sum / SAMPLES;
}

static double mean_over_ring(const wood_bands *m, double c) {
  if (m->fork == 0.0f) return mean_over_band(m, 0.0, c);
  double sum = 0.0;
  for (int k = 0; k < SAMPLES; k++) sum += mean_over_band(m, (k + 0.5) / SAMPLES, c);
  return sum / SAMPLES;
}

/* Share of all rings that lies farther than `margin` from their ends, mm. */
static double within_margins(const wood_constants *w, double margin) {
  double within = 0.0, all = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    double width = 1.0 / (double)w->inverse_width[j];
    all += width;
    if (width > 2.0 * margin) within += width - 2.0 * margin;
  }
  return within / all;
}

/* Two pores are in two cells, and so meet less often than if they stood anywhere: of those that
 * would, by how far discs that overlap are apart along an axis in the mean, in radii. */
#define BAND_APART 0.57

double wood_banded_cover(const wood_bands *m, double c, double radius, double cell) {
  double away = 1.0 - BAND_APART * scalar_least(radius / cell, 1.0), met = 1.0 - away * away;
  double within = (double)m->share / mean_over_ring(m, 0.0); /* of a ring, but for its margins */
  return within * mean_over_ring(m, met * c / (double)m->share) / met;
}

double wood_bands_denser(const wood_bands *m, double half) {
  double held = 0.0, area = 0.0;
  for (int i = 0; i < SAMPLES; i++) {
    double fork = (double)m->fork * (i + 0.5) / SAMPLES;
    double arm = half - scalar_least(fork, (double)m->fork_most);
    for (int k = 0; k < SAMPLES; k++) {
      double t = 0.5 * (k + 0.5) / SAMPLES;
      if (__builtin_fabs(t - fork) > arm) continue;
      held += held_at(m, t, fork);
      area += 1.0;
    }
  }
  return held / area / mean_over_ring(m, 0.0);
}

static void build_swing(wood_bands *m) {
  double swing = 0.0;
  for (int i = 0; i < WOOD_RADII; i++) {
    double reach = limited((double)m->within[i], 0.0, 0.5);
    swing += 4.0 / TWO_PI * scalar_sin(TWO_PI * reach) / WOOD_RADII;
  }
  m->swing = (float)(swing / (double)m->share);
}

void wood_build_bands(wood_constants *w, const settings *s, double largest) {
  wood_bands *m = &w->bands;
  int arrangement = choice_at(s, P_ARRANGEMENT);
  double spacing = number_at(s, P_BAND_SPACING), in_bands = number_at(s, P_BANDS);
  double cell = BAND_CELL * largest;
  int along_arc = arrangement != ARRANGEMENT_TANGENTIAL;
  float margin = (float)(along_arc ? largest : 0.0);
  double room = within_margins(w, (double)margin);
  m->on = w->has_pores && arrangement != ARRANGEMENT_EVEN && in_bands > 0.0 && !(room < BAND_ROOM);
  if (!m->on) return;
  m->along_arc = along_arc;
  m->often = (float)((m->along_arc ? TWO_PI : 1.0) / spacing);
  if (arrangement == ARRANGEMENT_DIAGONAL) m->slant = (float)(BAND_OBLIQUE / spacing);
  if (arrangement == ARRANGEMENT_DENDRITIC) m->fork = (float)BAND_FORKED;
  m->fork_most = (float)(0.25 * BAND_WIDE);
  m->margin = margin;
  m->stray = (float)(number_at(s, P_BAND_STRAY) / NOISE_BOUND);
  m->stray_size = (float)(number_at(s, P_FIBRE_WIDTH) * WOOD_BUNDLE);
  band_shares shares = shares_of(in_bands, number_at(s, P_PORE_DENSITY) * cell * cell);
  build_within(m, &shares);
  m->share = (float)(mean_over_ring(m, 0.0) * room);
  build_swing(m);
}
