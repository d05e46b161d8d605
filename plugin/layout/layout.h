/* SPDX-License-Identifier: Apache-2.0
 *
 * Layouts: how boards, blocks and stones cover a plane. What a layout is once
 * it is made: numbers and tables that never change. units.h asks them.
 *
 * Two families:
 *   tiles      what repeats: a lattice and the convex pieces of one tile
 *              (tiles.c lays them, build.c makes the table)
 *   functions  what does not: rows of random lengths, arcs, cells about points
 *              (units.h, one small function each)
 *
 * The plane's u runs along the pieces of the first course, v across them, mm.
 */
#ifndef SOZAI_LAYOUT_H
#define SOZAI_LAYOUT_H

#include <stdint.h>

#include "catalogue.h"

#define LAYOUT_ENUM_(kind, ...) kind,
enum { LAYOUT_CATALOGUE(LAYOUT_ENUM_) LAYOUT_COUNT };

#define LAYOUT_SIDES 8    /* of a piece, at most */
#define LAYOUT_PIECES 160 /* of a table */
#define LAYOUT_TILE_PIECES 64

/* What is chosen. */
typedef struct {
  int32_t kind;
  double length, width; /* mm; 0: the layout's usual */
  double joint;         /* mm, between neighbours; below 0: the layout's usual */
  double variation;     /* of length, relative: 0 to 0.9 */
  double stagger;       /* of a course against the last, of the length; see units.h */
  double angle;         /* degrees, of a chevron */
  double turn;          /* degrees, of the whole, from u towards v */
} layout_choice;

/* Arcs: half of what a row turns across its bay, ten widths, at its middle radius of 7.5; and how
 * long it is there, in widths. */
#define LAYOUT_ARC 0.7297277f
#define LAYOUT_ARC_LONG (15.0f * LAYOUT_ARC)

/* A layout, made. Pieces are columns, so that lanes can gather them. */
typedef struct {
  int32_t kind;
  int32_t sides; /* of the piece that has the most; 0: a function */
  int32_t pieces;
  int32_t quads;       /* every piece has two pairs of parallel sides */
  float cosine, sine;  /* of the turn */
  float length, width; /* mm */
  float joint;         /* mm */
  float share;         /* of the plane that is joint */
  float narrowest;     /* mm: of the narrowest unit across */
  float inverse_length, inverse_width;
  float jitter;  /* of a joint along the course, of the length */
  float stagger; /* of the length */
  float radius;  /* mm, of the arcs */
  float around;  /* setts of a row across a bay of them */

  float a[2], b[2];       /* lattice, mm */
  float to_i[2], to_j[2]; /* from the plane to lattice coordinates */
  /* distance to side s of piece k, inside positive: nx x + ny y + d */
  float nx[LAYOUT_SIDES][LAYOUT_PIECES], ny[LAYOUT_SIDES][LAYOUT_PIECES];
  float d[LAYOUT_SIDES][LAYOUT_PIECES];
  float corner_x[LAYOUT_PIECES], corner_y[LAYOUT_PIECES]; /* mm: where u = v = 0 */
  float along_x[LAYOUT_PIECES], along_y[LAYOUT_PIECES];   /* unit, of u */
  float piece_length[LAYOUT_PIECES], piece_width[LAYOUT_PIECES];
  int32_t cell_i[LAYOUT_PIECES], cell_j[LAYOUT_PIECES]; /* added to the cell's */
  int32_t number[LAYOUT_PIECES];                        /* within the tile */
  int32_t numbers;                                      /* of a tile, to a power of two */
} layout;

/* The relief of its units; relief.h evaluates it. */
typedef struct {
  float bevel, slope; /* mm; tangent of its angle */
  float depth;        /* mm, of the joint below the bevel's foot */
  float cup;          /* mm, most that a unit's middle stands off its sides */
  float mean;         /* mm: height of the whole plane on average */
} layout_profile;

/* How far joints wander, mm, and the inverse of the divisions' spacing;
 * wander.h evaluates it. */
typedef struct {
  float amplitude, frequency;
  uint32_t seed;
} layout_wander;

/* A piece of a tile: a convex polygon, anticlockwise, and its frame. */
typedef struct {
  int32_t sides;
  int32_t number;
  double x[LAYOUT_SIDES], y[LAYOUT_SIDES];
  double corner[2], along[2], length, width;
} layout_piece;

typedef struct {
  double a[2], b[2];
  layout_piece piece[LAYOUT_TILE_PIECES];
  int32_t count;
} layout_tile;

/* The tile of a layout that has one, or 0. */
int layout_tile_of(const layout_choice *choice, layout_tile *out);

/* NULL, or which of the numbers is wrong ("length", "width", "joint") and in
 * least and most what it may be. */
const char *layout_build(layout *l, const layout_choice *choice, double *least, double *most);

#endif
