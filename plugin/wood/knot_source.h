/* SPDX-License-Identifier: Apache-2.0
 *
 * Where knots come from: a tree grown for them, a measured one, or tables
 * that the host hands over. In any case the tables of the generator `tree`
 * (../tree/tables.h).
 */
#ifndef SOZAI_WOOD_KNOT_SOURCE_H
#define SOZAI_WOOD_KNOT_SOURCE_H

#include "../core/params.h"

/* Columns of the tables. */
enum {
  KNOT_BRANCH,
  KNOT_BIRTH,
  KNOT_DEATH,
  KNOT_SHED,
  KNOT_AZIMUTH,
  KNOT_INCLINATION,
  KNOT_HEIGHT,
  KNOT_RADIUS,
  KNOT_FIRST,
  KNOT_COUNT,
  KNOT_COLUMNS
};
enum { RADIUS_KNOT, RADIUS_YEAR, RADIUS_RADIUS, RADIUS_COLUMNS };
enum { RING_YEAR, RING_HEIGHT, RING_RADIUS, RING_COLUMNS };

typedef struct {
  const float *rows;
  uint64_t count;
} knot_rows;

typedef struct {
  knot_rows knots, radii, rings;
  uint64_t ring_heights; /* rows of rings to a year */
  double age;            /* years: the last that anything is known of */
  double height;         /* mm: of the stem; 0: not known */
  /* what it holds */
  void *tree;
  settings given;
} knot_source;

/* None of them asked for: no knots. On failure nothing is held. */
int32_t knot_source_open(knot_source *k, const sozai_host *host, const settings *s);
void knot_source_close(knot_source *k, const sozai_host *host);

/* mm: the stem's radius under bark at a height in a year; 0 above its tip.
 * Only where there are rings. */
double knot_source_radius(const knot_source *k, double height, double year);

#endif
