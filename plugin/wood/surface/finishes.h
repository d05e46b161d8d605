/* SPDX-License-Identifier: Apache-2.0
 *
 * Surfaces as data: what is usual of each, in mm where nothing else is said.
 * Figures: tooth pitches, feeds and knife marks are those of common machines
 * (USDA Forest Products Laboratory, Wood Handbook, FPL-GTR-190, chapter 5 and
 * 20; Koch P., Wood machining processes, 1964: a planer's wave height is pitch^2
 * over four times the cutting circle's diameter). Depths of wear are those of
 * brushed boards and of boards outdoors for years (erosion of 5 to 6 mm in a
 * century: Feist, Hon, Chemistry of weathering and protection, 1984).
 */
#ifndef SOZAI_WOOD_SURFACE_FINISHES_H
#define SOZAI_WOOD_SURFACE_FINISHES_H

#include "../parameters.h"
#include "surface.h"

typedef struct {
  int marks;
  double pitch, depth;
  double second;                      /* the crossing arcs' depth, of the first's */
  double board, board_a, board_b;     /* washboard: height, and sizes along and across */
  double fibre, fibre_size, latewood; /* fibres: height, width; share that latewood has */
  double torn;        /* fibres: height of those that a saw has torn up, a few mm long */
  double fibre_stain; /* share of the albedo, at most */
  double erosion, soft;
  double vessels;            /* radii */
  double checks, end_checks; /* to 100 mm */
  double check_depth, crack_depth;
  double specular, shininess, coat; /* factors of the parameters; the least coat */
} surface_finish;

static const surface_finish surface_finishes[SURFACES] = {
    [SURFACE_SMOOTH] = {.specular = 1, .shininess = 1},
    [SURFACE_BAND_SAWN] = {.marks = MARKS_BAND,
                           .pitch = 2.4,
                           .depth = 0.15,
                           .board = 0.05,
                           .board_a = 34,
                           .board_b = 150,
                           .torn = 0.035,
                           .vessels = 1,
                           .specular = 0.4,
                           .shininess = 0.6},
    [SURFACE_CIRCULAR_SAWN] = {.marks = MARKS_CIRCULAR,
                               .pitch = 4.6,
                               .depth = 0.3,
                               .second = 0.2,
                               .board = 0.07,
                               .board_a = 60,
                               .board_b = 200,
                               .torn = 0.045,
                               .vessels = 1,
                               .specular = 0.4,
                               .shininess = 0.6},
    [SURFACE_PLANED] = {.marks = MARKS_KNIVES,
                        .pitch = 1.6,
                        .depth = 0.0064, /* a cutting circle of 100 mm */
                        .vessels = 0.7,
                        .specular = 1,
                        .shininess = 1},
    [SURFACE_HAND_PLANED] = {.marks = MARKS_STROKES,
                             .pitch = 38,
                             .depth = 0.12,
                             .vessels = 0.7,
                             .specular = 1.3,
                             .shininess = 1.6},
    [SURFACE_SANDED] = {.vessels = 0.7, .specular = 0.9, .shininess = 0.9},
    [SURFACE_BRUSHED] = {.erosion = 0.35,
                         .soft = 0.22,
                         .fibre = 0.035,
                         .fibre_size = 0.4,
                         .latewood = 0.15,
                         .vessels = 1.2,
                         .specular = 0.9,
                         .shininess = 1},
    [SURFACE_CHARRED] = {.erosion = 0.6,
                         .soft = 0.35,
                         .fibre = 0.03,
                         .fibre_size = 0.5,
                         .latewood = 0.4,
                         .vessels = 1,
                         .crack_depth = 0.75,
                         .specular = 1.2,
                         .shininess = 2.5,
                         .coat = 0.5},
    [SURFACE_WEATHERED] = {.erosion = 0.5,
                           .soft = 0.3,
                           .fibre = 0.07,
                           .fibre_stain = 0.1,
                           .fibre_size = 0.5,
                           .latewood = 0.5,
                           .vessels = 1.2,
                           .checks = 7,
                           .end_checks = 4,
                           .check_depth = 0.8,
                           .specular = 0.25,
                           .shininess = 0.6},
};

#endif
