/* SPDX-License-Identifier: Apache-2.0
 * What a grown tree's tables say of a log from it: how thick it is, and where
 * knots may cross a board's face. */
#ifndef SOZAI_SAW_STEM_H
#define SOZAI_SAW_STEM_H

#include "growth.h"
#include "plan.h"

/* Lives as long as the geometry it was read from. */
typedef struct saw_stem {
  sozai_table rings, knots, radii; /* the generator's tables of these names */
  uint64_t heights;                /* rows of rings in a year */
  double age;
} saw_stem;

#define SAW_PITH 257 /* heights at which a log's pith is known */

/* A log of it. */
typedef struct saw_log {
  const saw_stem *stem;
  double base, length;     /* mm: of its lower end above the ground */
  double knot_size;        /* wood's factor of the knots' radii */
  float pith[2][SAW_PITH]; /* mm: x and z of the pith, evenly from end to end */
} saw_log;

bool saw_stem_read(saw_stem *s, const sozai_geometry_1 *table, const sozai_geometry *g,
                   failure *why);

/* Radius of the wood at a height above the ground at the end of a year, mm. */
double saw_stem_radius(const saw_stem *s, double height, double year);
double saw_stem_height(const saw_stem *s);
/* Of the log under its bark, mm^3. */
double saw_log_volume(const saw_log *log);

/* Places in the log, mm, where a knot, a row of the table, may come through a
 * board's face; all of one knot follow one another. A knot is taken for a cone
 * about the pith, as wide in each year as its branch was and as long as the
 * stem was thick, and a little longer: whether it is there the wood must say. */
typedef void (*saw_knot_seen)(void *context, uint32_t knot, const double point[3]);
void saw_knot_places(const saw_log *log, const saw_board *b, saw_knot_seen seen, void *context);

#endif
