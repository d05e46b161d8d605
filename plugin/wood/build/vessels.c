/* SPDX-License-Identifier: Apache-2.0
 *
 * Pores of the field, and which kinds of vessels there are; rows.c has the earlywood's.
 */
#include "parts.h"

#include "../../core/scalar.h"
#include "../parameters.h"
#include "late.h"

/* Discs thrown at random over an area leave exp(-c) of it free, c being the
 * sum of their areas over it. */
static void build_overlap(const wood_constants *w, wood_vessels *v) {
  double c = (double)v->coverage, cell = (double)w->pore_cell;
  double radius = (double)v->radius, covered = 1.0 - scalar_exp(-c);
  if (w->bands.on) covered = wood_banded_cover(&w->bands, c, radius, cell);
  if (w->pores_each) covered = wood_paired_cover(v, radius, radius, cell);
  v->overlap = c > 1e-6 ? (float)(1.0 - covered / c) : 0.0f;
  v->coverage = (float)covered;
}

/* Parts may be longer than reach: what they cut off is tails of the largest pores, where a
 * footprint's middle lies between the cells looked at and the next. */
#define PART_CLEAR 0.7 /* of a cell */

/* late: the pores' size at a ring's end, over that at its start. */
static void build_pores(wood_constants *w, const settings *s, double late) {
  double d = number_at(s, P_PORE_DIAMETER), spread = number_at(s, P_PORE_SPREAD);
  double density = number_at(s, P_PORE_DENSITY);
  double square = wood_build_radii(&w->pores, d, spread);
  double largest = (double)w->pores.radius * (1.0 + 2.5 * spread) * (late > 1.0 ? late : 1.0);
  wood_build_bands(w, s, largest);
  w->pore_cell = (float)(1.0 / __builtin_sqrt(density));
  if (w->bands.on) w->pore_cell = (float)__builtin_sqrt((double)w->bands.share / density);
  if (wood_has_sheaths(w, s) && !w->bands.on) {
    w->pores_each = 0x80000000u;
    w->pore_cell = (float)__builtin_sqrt(2.0 / density);
  }
  w->inverse_pore_cell = 1.0f / w->pore_cell;
  w->pore_step = w->pore_cell / 4294967296.0f;
  w->pores.reach = wood_longest_footprint(0.5 * (double)w->pore_cell, largest, END_SHARP);
  double usual = (double)w->pores.radius * (1.0 + spread) * (late > 1.0 ? late : 1.0);
  w->pores.part = wood_longest_footprint(PART_CLEAR * (double)w->pore_cell, usual, END_SHARP);
  w->pores.third = wood_longest_footprint(PART_CLEAR * (double)w->pore_cell, usual, END_CONE);
  w->pores.coverage =
      (float)(0.5 * TWO_PI * (double)w->pores.radius * (double)w->pores.radius * square * density);
  if (!w->has_pores) w->pores.coverage = 0.0f;
  build_overlap(w, &w->pores);
  w->pore_early = 1.0f;
  w->pore_growth = (float)(late - 1.0);
  double g = late - 1.0;
  w->pore_ring_mean = (float)(1.0 + g + g * g / 3.0);
  if (wood_has_sheaths(w, s)) wood_build_sheaths(w, s, square);
}

/* What the pores are expected to take of latewood, over what they do where they are full size: the
 * mean of size^2 over the profile, by the midpoint rule. late: as of build_pores. */
static double late_among_pores(const wood_constants *w, double late) {
  double taken = 0.0, tissue = 0.0, g = late - 1.0;
  for (int i = 0; i < 256; i++) {
    double f = (i + 0.5) / 256.0;
    double l = late_profile_integral(w, (i + 1.0) / 256.0) - late_profile_integral(w, i / 256.0);
    double size = 1.0 + g * f;
    taken += l * size * size;
    tissue += l;
  }
  return tissue > 0.0 ? taken / tissue : 1.0;
}

void wood_build_vessels(wood_constants *w, const settings *s) {
  int porosity = choice_at(s, P_POROSITY);
  w->has_pores = porosity != POROSITY_NONE;
  w->rows = porosity == POROSITY_RING ? (int32_t)number_at(s, P_ROWS) : 0;
  double late = porosity == POROSITY_SEMI_RING
                    ? number_at(s, P_PORE_DIAMETER_LATE) / number_at(s, P_PORE_DIAMETER)
                    : 1.0;
  build_pores(w, s, late);
  wood_build_rows(w, s);
  w->late_vessel = (float)((double)w->pores.coverage * late_among_pores(w, late));
}
