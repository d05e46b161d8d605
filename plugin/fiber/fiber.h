/* SPDX-License-Identifier: Apache-2.0
 *
 * An aggregate of staple fibres, and the order in which it is made:
 *   hull     the surface (hull.h), and a field of distances to it (grid.h)
 *   strand   each strand's shape (strand.h)
 *   place    a random turn, the middle vertex somewhere inside
 *   fit      moved, rigid, until it lies inside or finds no better place
 *   contact  pushed apart
 * A strand's way depends on its number and the seed, never on other strands,
 * until contact; there all move at once from where all were.
 */
#ifndef SOZAI_FIBER_FIBER_H
#define SOZAI_FIBER_FIBER_H

#include "../core/params.h"
#include "grid.h"
#include "hull.h"
#include "strand.h"

/* How a strand's fitting ended. */
#define END_INSIDE 0  /* no vertex is outside */
#define END_BEST 1    /* none of the moves is a gain */
#define END_VISITED 2 /* it would stand as it stood before */
#define END_BOUND 3   /* the most iterations were made */
#define END_NOWHERE 4 /* no place inside was found */

typedef struct fiber_plan {
  strand_shape shape;
  int mode, contact;
  uint32_t count, halvings, iterations, attempts, rounds, cells;
  double packing, diameter, diameter_spread, taper; /* mm */
  double step, turn;                                /* mm, radians */
  double clearance;                                 /* mm */
  double spacing;
  double share_2;
  float colour[2][3];
} fiber_plan;

typedef struct strand_result {
  float first, last; /* C, the sum of distances of the vertices, before and after */
  uint32_t moves, tries;
  uint16_t end;    /* END_* */
  uint16_t inside; /* vertices inside the hull itself, after */
  uint16_t inside_first;
  uint16_t reserved;
} strand_result;

typedef struct fiber_contacts {
  double first, last;            /* pairs of segments that overlap, before and after */
  double deepest_first, deepest; /* mm */
  double rounds;
  double strands; /* that overlap another, after */
} fiber_contacts;

enum { TABLE_STATISTICS, TABLE_STRANDS, FIBER_TABLES };

typedef struct fiber_table {
  float *data;
  uint64_t rows, room;
} fiber_table;

typedef struct fiber {
  fiber_plan plan;
  hull hull;
  grid grid;
  uint32_t strands, vertices;
  float *points; /* about the hull's centre: strand by strand */
  float *radii;  /* of each strand's middle */
  strand_result *results;
  fiber_contacts contacts;
  fiber_table tables[FIBER_TABLES];
} fiber;

void plan_fiber(fiber_plan *p, const settings *s);
/* Bytes of what there is of each strand: its points, its radius, how its fitting ended. Arrays that
 * may be empty have an element more. */
uint64_t fiber_strand_bytes(const fiber *f);
/* How many strands; RANGE, LIMIT. */
int32_t plan_count(fiber *f, const sozai_host *host);
double fiber_strand_volume(const fiber_plan *p, double length, double radius);
/* Radius at a place along the strand, 0 to 1, over its middle's. */
double fiber_profile(const fiber_plan *p, double t);

/* Places and fits every strand. CANCELLED, RANGE. */
int32_t fiber_place(fiber *f, const sozai_host *host);
int32_t fiber_keep_apart(fiber *f, const sozai_host *host);
int32_t fiber_report(fiber *f, const sozai_host *host);

extern const sozai_table_info *const fiber_table_infos[FIBER_TABLES];

#endif
