/* SPDX-License-Identifier: Apache-2.0
 *
 * The knots of a stem as the kernel reads them: a list, a grid of cells that
 * says which are near a place, and the share of knots in larger and larger
 * cells. The stem repeats after its period.
 */
#ifndef SOZAI_WOOD_KNOT_TABLE_H
#define SOZAI_WOOD_KNOT_TABLE_H

#include <stddef.h>
#include <stdint.h>

#include "../../api/sozai.h"

#define KNOT_NEAR 12.0f  /* mm: footprints up to twice this see single knots */
#define KNOT_FAR 100.0f  /* mm: likewise, without their effects */
#define KNOT_CLOSE 2.0f  /* mm: up to which the cells' parts say whether a knot is near */
#define KNOT_NODES 45.0f /* mm: up to which rings about a knot are looked up at nodes */
#define KNOT_WINDOW 5.0f /* (radii)^2 to the side within which fibres part; */
#define KNOT_STREAM 2.0f /* along the stem this many times as far */
/* Width of the collar to the sides, in radii, and what is more above and below. */
#define KNOT_WIDE 0.8f
#define KNOT_WIDE_RISING 2.4f
/* How a stub's end is rounded over its radius, and how far aslant. */
#define KNOT_ROUND 0.5f
#define KNOT_SLANT 0.45f
/* Along the axis, over its radius: the width of an even spread with the variance that both
 * have over the end, 12 (KNOT_SLANT^2 / 4 + KNOT_ROUND^2 / 12). */
#define KNOT_ASLANT 0.926f
/* How far the wood about a knot is full of resin, in radii, falling off as the square
 * of what is left; and the area of it over the knot's. The square's fall is that of
 * discs of all sizes; two of them, by Gauss and Jacobi's rule, have its volume exactly. */
#define KNOT_HALO 0.9f
#define KNOT_HALO_SHARE 0.735f
#define KNOT_HALO_NEAR 1.139592f /* their radii over the knot's, */
#define KNOT_HALO_FAR 1.580408f
#define KNOT_HALO_OF_NEAR 0.636083f /* and the nearer one's weight */
#define KNOT_TONE 0.8f /* by which knots differ, of how far the heart is darker than the edge */
#define KNOT_LEVELS 5
#define KNOT_COARSE 2 /* the level whose cells say what wide footprints see */

/* Lengths in mm; K and e as in knots.h; rho is the stem's radius as its rings
 * are reckoned. */
typedef struct {
  float c, s;               /* direction from the pith: x, z */
  float height, slope;      /* of its axis: where it leaves the pith; rise over run */
  float cosine;             /* of its inclination */
  float squash, lean;       /* p^2 = a^2 + squash h^2 + 2 lean a h, */
  float upright;            /* (a + lean h)^2 + (upright h)^2; */
  float pith_a, pith_h;     /* d = p + pith_a a + pith_h h: the pith is a focus of its rings */
  float pith_x, pith_y;     /* likewise, in the section stretched so that p is round: there */
  float middle_x, middle_y; /* a ring's middle is, over its d, and it is about a circle, */
  float round;              /* of so much of d */
  float born;               /* rho at which it begins */
  float length;             /* in rho, until it grew no more */
  float inverse_length;
  float radius; /* at that time */
  float inverse_radius;
  float q;                 /* 0..1: how much its growth slowed down */
  float high, high_rising; /* of the collar, likewise, over the branch's radius */
  float death;             /* rho */
  float end;               /* rho at which it had been shed */
  float reach;             /* along u: how far it has any effect, */
  float bends;             /* likewise to its side and along it, */
  float near;              /* mm^2: more closely, where a^2 + h^2 / 4 is below it; */
  float sees;              /* and p of what a point sees */
  float check_c, check_s;  /* across the check, in its section; */
  float split_c, split_s;  /* and across one that runs from the pith to one side */
  float tone;              /* by which it is darker or lighter than others, as its heart is */
  float apart;             /* its section is looked up so far from the stem's */
} wood_knot;

typedef struct {
  wood_knot *list;
  /* of each cell in index, a cell without any comes last; and then of the coarse cells,
   * those within KNOT_FAR */
  int32_t *first;
  int32_t *index; /* of list; rising within a cell */
  /* of each cell, and of the one without any: of its 4 x 2 x 4 parts those that hold a
   * point which some knot has to do with, under footprints up to KNOT_CLOSE, and up to
   * 2 KNOT_NEAR; bit x + 4 z + 16 y */
  int32_t *parts[2];
  float *far;   /* shares of knots, level by level */
  size_t bytes; /* of the one block that all of them are in, this included */
  uint32_t count;
  int32_t across, tall, cells, coarse;
  float low, inverse_cell;      /* of the cells across the stem */
  float period, inverse_period; /* along it */
  float grain, bark, check;     /* share; mm; of the radius */
  int32_t far_first[KNOT_LEVELS], far_across[KNOT_LEVELS], far_tall[KNOT_LEVELS];
  float far_scale[KNOT_LEVELS];
} wood_knots;

#endif
