/* SPDX-License-Identifier: Apache-2.0
 *
 * The layouts: what they are called, how large their pieces usually are (length,
 * width and joint, mm), and what they are. An id never changes.
 */
#ifndef SOZAI_LAYOUT_CATALOGUE_H
#define SOZAI_LAYOUT_CATALOGUE_H

/* clang-format off */
#define LAYOUT_CATALOGUE(X) \
  X(LAYOUT_NONE, "none", 1000, 100, 0, "one piece, without end") \
  X(LAYOUT_STRIP, "strip", 1200, 90, 0.4, "strip floor: courses of boards whose ends lie at random, those of neighbouring courses apart") \
  X(LAYOUT_STACK, "stack", 400, 400, 3, "stack bond: all joints run through") \
  X(LAYOUT_RUNNING, "running", 1200, 90, 0.4, "running bond: each course is shifted by `stagger` of the length") \
  X(LAYOUT_CHIDORI, "chidori", 200, 100, 3, "chidori, staggered by half: each course is shifted by half the length") \
  X(LAYOUT_ENGLISH, "english", 210, 65, 10, "English bond: a course of stretchers, a course of headers of half their length") \
  X(LAYOUT_FLEMISH, "flemish", 210, 65, 10, "Flemish bond: stretcher and header by turns in each course, the header over the stretcher's middle") \
  X(LAYOUT_HERRINGBONE, "herringbone", 420, 70, 0.4, "herringbone, the blocks at 45 degrees to the room") \
  X(LAYOUT_HERRINGBONE_90, "herringbone_90", 420, 70, 0.4, "herringbone, the blocks along and across the room") \
  X(LAYOUT_HERRINGBONE_DOUBLE, "herringbone_double", 420, 70, 0.4, "herringbone of pairs of blocks, at 45 degrees to the room") \
  X(LAYOUT_CHEVRON, "chevron", 500, 80, 0.4, "chevron: ends mitred at `chevron_angle`, so that the blocks meet in straight lines") \
  X(LAYOUT_BASKET, "basket", 300, 75, 0.4, "basket weave: squares of blocks side by side, by turns along and across; the width is rounded to fit") \
  X(LAYOUT_WINDMILL, "windmill", 300, 100, 0.4, "windmill: four blocks about a square, turning") \
  X(LAYOUT_IGETA, "igeta", 300, 150, 6, "igeta (well curb): a square in the middle, halves and quarters round it, four different units to a tile") \
  X(LAYOUT_VERSAILLES, "versailles", 1000, 90, 0.4, "parquet de Versailles: framed square panels of laths woven on the diagonal; length is the panel's side, width the laths'") \
  X(LAYOUT_HEXAGON, "hexagon", 200, 200, 3, "regular hexagons, width across their flats") \
  X(LAYOUT_OCTAGON, "octagon", 200, 200, 3, "octagon and dot: regular octagons, width across their flats, and squares between them") \
  X(LAYOUT_END_GRAIN, "end_grain", 80, 80, 0.5, "end-grain blocks, staggered by half") \
  X(LAYOUT_BUTCHER, "butcher", 450, 42, 0.05, "butcher block: staves of random length glued side by side") \
  X(LAYOUT_ASHLAR, "ashlar", 500, 150, 8, "random ashlar: courses broken into blocks of different sizes") \
  X(LAYOUT_CRAZY, "crazy", 350, 350, 12, "crazy paving: irregular polygons") \
  X(LAYOUT_ARCS, "arcs", 100, 100, 10, "segmental arcs: setts in stacked arcs, in bays of ten widths") \
  X(LAYOUT_CIRCLES, "circles", 100, 100, 10, "rings of setts about the origin") \
  X(LAYOUT_FAN, "fan", 90, 90, 8, "European fan: setts in rings about the tips of fans that overlap as scales do, ten rings to a fan")
/* clang-format on */

#endif
