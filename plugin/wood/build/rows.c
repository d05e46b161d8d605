/* SPDX-License-Identifier: Apache-2.0
 *
 * Earlywood vessels, in rows at the ring's start.
 */
#include "parts.h"

#include "../../core/scalar.h"
#include "../parameters.h"
#include "late.h"

/* The earlywood's vessels fill their place along the row, and their shape under longer parts is
 * less exact. */
#define PART_OF_ROW 1.5 /* of a vessel's radius */

/* Vessels along a row, samples across one and down it. */
enum { VESSELS = 24, ACROSS = 6, DEEP = 10 };

/* Whether vessel k of row m lies over a place, mm along the rows and across them. */
static int row_vessel_over(const wood_constants *w, double spacing, int m, int k, double px,
                           double pz) {
  double radius = (double)w->row.radius;
  uint32_t id = (uint32_t)(m * (VESSELS + 2) + k + 1);
  double shift = wood_uniform(1, STREAM_ROW_X, 9999u + (uint32_t)m) - 0.5;
  double jx = (wood_uniform(1, STREAM_ROW_X, id) - 0.5) * (double)w->row_jitter_arc;
  double jz = (wood_uniform(1, STREAM_ROW_Z, id) - 0.5) * (double)w->row_jitter_radial;
  double dx = px - (k + 0.5 + shift + jx) * spacing;
  double dz = pz - jz - m * (double)w->row_spacing;
  double square = (double)w->row.inverse_square[(id * 7) % WOOD_RADII];
  return (dx * dx + dz * dz) * square < radius * radius;
}

/* Vessels of rows overlap their neighbours only: they are laid out as the kernel does, and their
 * covered area is counted on a grid. */
static void build_row_overlap(wood_constants *w, double row_density) {
  double radius = (double)w->row.radius, spacing = 1.0 / row_density;
  double deep = 2.0 * radius / DEEP, across = spacing / ACROSS;
  int rows = w->rows, lines = (int)(((double)w->row_spacing * rows + 2.0 * radius) / deep) + 1;
  long area = 0, covered = 0;
  for (int i = 0; i < VESSELS * ACROSS; i++) {
    for (int j = 0; j < lines; j++) {
      double px = (i + 0.5) * across, pz = (j + 0.5) * deep - radius;
      int hits = 0;
      for (int m = 0; m < rows; m++) {
        for (int k = i / ACROSS - 1; k <= i / ACROSS + 1; k++) {
          hits += row_vessel_over(w, spacing, m, k, px, pz);
        }
      }
      area += hits;
      covered += hits > 0;
    }
  }
  w->row.overlap = area ? (float)(1.0 - (double)covered / (double)area) : 0.0f;
  w->row.coverage *= 1.0f - w->row.overlap;
}

/* How much of all rings' latewood lies within `band` of their starts: in narrow rings the rows
 * reach into it. */
static double late_among_rows(const wood_constants *w, double band) {
  double within = 0.0, all = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    double inverse = (double)w->inverse_width[j], late = (double)w->late_weight[j + 1] / inverse;
    within += late * late_profile_integral(w, scalar_least(band * inverse, 1.0));
    all += late * late_profile_integral(w, 1.0);
  }
  return all > 0.0 ? within / all : 0.0;
}

/* band: mm of all rows; narrow rings have room for a part of them alone. */
static void build_row_band(wood_constants *w, double band) {
  double least = 1e30, room = 0.0, whole = 0.0;
  for (int j = 0; j < WOOD_RINGS; j++) {
    double width = 1.0 / (double)w->inverse_width[j];
    w->row_before[j] = (float)room;
    room += scalar_least(band, width);
    whole += width;
    if (width < least) least = width;
  }
  w->row_before[WOOD_RINGS] = w->row_period = (float)room;
  w->rows_alone = (float)(0.999 * (double)WOOD_ROWS_ALONE * least);
  w->band = (float)band;
  /* of the latewood within the band, over that of all wood */
  if (w->rows) w->late_row = (float)scalar_least(late_among_rows(w, band) * whole / room, 1.0);
}

/* What vessels_row_box.h reads of them. radius: mm, the mean. */
static void build_row_radii(wood_constants *w, double radius) {
  double least_square = 1.0;
  for (int i = 0; i < WOOD_RADII; i++) {
    double inverse_square = (double)w->row.inverse_square[i];
    w->row_inverse[i] = (float)__builtin_sqrt(inverse_square);
    w->row_square[i] = (float)(1.0 / inverse_square);
    if (inverse_square < least_square) least_square = inverse_square;
  }
  w->row_largest = (float)(1.12 * radius / __builtin_sqrt(least_square));
}

void wood_build_rows(wood_constants *w, const settings *s) {
  double d = number_at(s, P_ROW_DIAMETER), density = number_at(s, P_ROW_DENSITY);
  double square = wood_build_radii(&w->row, d, number_at(s, P_ROW_SPREAD));
  double radius = (double)w->row.radius, spacing = 1.05e-3 * d;
  double largest = radius * (1.0 + 2.5 * number_at(s, P_ROW_SPREAD));
  w->row.reach = wood_longest_footprint((1.0 - 0.5 * number_at(s, P_ROW_JITTER)) / density, largest,
                                        END_SHARP);
  w->row.part = (float)(PART_OF_ROW * radius);
  if (w->row.part > w->row.reach) w->row.part = w->row.reach;
  build_row_radii(w, radius);
  w->row_density = (float)density;
  w->row_spacing = (float)spacing;
  w->row_start = (float)(0.55e-3 * d);
  w->row_jitter_arc = (float)number_at(s, P_ROW_JITTER);
  w->row_jitter_radial = (float)(0.4 * radius * number_at(s, P_ROW_JITTER));
  w->row_step_arc = w->row_jitter_arc / 4294967296.0f;
  w->row_step_radial = w->row_jitter_radial / 4294967296.0f;
  build_row_band(w, w->rows * spacing);
  w->row.coverage = 0.0f;
  if (!w->rows) return;
  w->row.coverage = (float)(density * 0.5 * TWO_PI * radius * radius * square / spacing);
  build_row_overlap(w, density);
}
