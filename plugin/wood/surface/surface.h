/* SPDX-License-Identifier: Apache-2.0
 *
 * A wood's surface: what tools, brush, fire and weather leave of it, as a
 * height in mm over the sawn or planed face with its exact gradient. Numbers
 * that never change once a wood is created; surface/build.c works them out.
 *
 *   marks.h    what tools leave: board space, along and across the face
 *   wear.h     earlywood worn away against latewood, fibres: log space
 *   grooves.h  vessels cut open, and checks: log space
 *   cracks.h   the cells of charred wood: log space
 *   splits.h   checks of end grain: the reference section
 *   shade.h    what of the light comes past it
 *   relief.h   all of them together, for ../stages/surface.h
 */
#ifndef SOZAI_WOOD_SURFACE_SURFACE_H
#define SOZAI_WOOD_SURFACE_SURFACE_H

#include <stdint.h>

#include "../tube_layer.h"

/* What marks the tool leaves. */
enum { MARKS_NONE, MARKS_BAND, MARKS_CIRCULAR, MARKS_KNIVES, MARKS_STROKES };

#define SURFACE_OCTAVES 2
#define SURFACE_WEAR_STEPS 24 /* of the table of slopes that a footprint leaves */

/* A layer of noise: value noise of two axes. */
typedef struct {
  float height;       /* mm, over HASH_ONE; 0: there is none */
  float frequency[2]; /* 1/mm, along each axis */
  float size;         /* mm, across the finer */
  float slope2[2];    /* mean square slope along each axis */
  float rank;         /* of HASH_ONE, in sd; less where there are others, by what slopes it has */
} surface_noise;

/* Paraboloid troughs in a lattice of tubes along the fibre. */
typedef struct {
  float depth;  /* mm, of a trough; 0: there are none */
  float slope2; /* mean square of its gradient over the section, whole */
  float mean;   /* mm: expected depth */
} surface_grooves;

#define SPLIT_LAYERS 2
#define SPLIT_SHOULDER 1.6f /* to the gap's width: of what falls away to it */
#define SPLIT_NARROW 0.2f   /* of its cell, half a check's width at most */
#define SPLIT_CHANCE 0.8f   /* of cells, those that have one */
/* Over a cell, of checks as splits.h draws them: the part of its area to the widest half width
 * and its width; the mean depth to that; and of the slope's square, by the same widest half width.
 */
#define SPLIT_MEAN (2.0f * SPLIT_CHANCE * 0.675f * 0.433f)
#define SPLIT_DEEP 0.31f
#define SPLIT_STEEP2 (8.0f / (6.0f * SPLIT_SHOULDER))

typedef struct {
  int32_t relief; /* 0: the surface is smooth, and nothing below is looked at */
  int32_t stains; /* checks or cracks darken the albedo */

  /* tool marks */
  int32_t marks;
  float pitch, inverse_pitch, depth; /* mm */
  float radius;                      /* mm, of the circular saw */
  float turn_c, turn_s;              /* of the marks in the face */
  float second;                      /* height of the circular saw's trailing arcs, of the first */
  float slope2;                      /* mean square slope along the feed, over |grad t|^2 */
  surface_noise washboard;           /* along the feed, and across */
  surface_noise scratch[SURFACE_OCTAVES];

  /* wear */
  surface_noise fibre[SURFACE_OCTAVES]; /* over the reference section */
  float fibre_late;                     /* share of that which latewood has too */
  float fibre_stain; /* 1/mm: of the albedo, that fibres which lie low are darker by */
  float erosion;     /* mm that earlywood lies below the densest latewood */
  float soft;        /* mm: the width over which a ring's edge is rounded */
  float wear_slope2[SURFACE_WEAR_STEPS]; /* 1/mm^2: by log2(extent / soft), 2 steps to a unit */
  float wear_share;                      /* of the face, what is at rings' edges */

  /* vessels cut open */
  surface_grooves pores, rows;

  /* checks */
  float check_depth; /* mm; 0: there are none */
  float check_dark;  /* of the albedo where one is deepest */
  wood_tubes checks;

  /* checks of end grain */
  float split_depth;          /* mm; 0: there are none */
  float split_half;           /* mm: half the width of the widest */
  float inverse_split_length; /* 1/mm: of a shell */
  float split_cells;          /* round the pith, to a shell's middle in shells */
  float split_mean;           /* mm: of a cell's width, what is split */
  float split_steep2;         /* mean square slope of a shoulder, over split_depth's square */

  /* cracks of charred wood */
  float crack_frequency[2]; /* 1/mm: of the cells, across and along the fibre */
  float crack_depth;        /* mm; 0: there are none */
  float crack_width;        /* mm: half of a crack with its rounded shoulders */
  float plate_tilt;         /* over crack_depth: a plate's slope, at most, each way */
  float crack_stain;        /* share of the albedo that a crack's core takes */
  float crack_dark, crack_mean;
  float crack_slope2, crack_share; /* within the cracks; of the face, what they take */
  float crack_gentle2;             /* mean square slope of the plates between */
} wood_surface;

#endif
