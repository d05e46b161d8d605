/* SPDX-License-Identifier: Apache-2.0
 *
 * Single cells, for footprints of some hundredths of a millimetre: in conifers
 * radial files of tracheids, flattening from early- to latewood while their walls
 * thicken; in broadleaved wood fibres; the cells of rays; tyloses and the rims of elements within
 * vessels.
 *
 * What they add to a colour has mean zero: a lumen is darker than its tissue's
 * mean by the share of walls, a wall brighter by the share of lumina. Over a box
 * the pattern of each file is integrated exactly, and those of five files at most are
 * summed; from four cells on nothing is left and nothing computed.
 *
 *   cells_tissue.h    tracheids or fibres, file by file
 *   cells_fine_ray.h  rays of one cell's width between the files
 *   cells_ray.h       within the rays of many
 *   cells_vessel.h    within vessels
 */
#ifndef SOZAI_WOOD_CELLS_H
#define SOZAI_WOOD_CELLS_H

#include "../core/filter.h"
#include "wood.h"

#define CELL_SHARP 0.12f /* of a cell: no wall's edge is sharper */

/* The mean over x - e/2 .. x + e/2 of a pulse that repeats with 1: 1 over the
 * middle `on` of each unit, else 0. */
INLINE vf cell_pulse_integral(vf x, vf on) {
  vi unused;
  vf whole = vfloor(x, &unused);
  return whole * on + clamp(x - whole - splat(0.5f) * (splat(1.0f) - on), splat(0.0f), on);
}

INLINE vf cell_pulse(vf x, vf e, vf on) {
  vf half = splat(0.5f) * e;
  return (cell_pulse_integral(x + half, on) - cell_pulse_integral(x - half, on)) / e;
}

/* Regular detail is gone from a cell's size on, since how a square lies that the footprint stands
 * for is not known. e: of the footprint, in cells; across: see cell_face. */
INLINE vf cell_plain(vf e, vf across) {
  return vmax(smooth_step(splat(0.7f), splat(1.3f), e), across);
}

/* Rays' procumbent cells, of the size usual in wood (Carlquist, Comparative Wood Anatomy, 2001;
 * IAWA lists, 1989 and 2004). */
#define RAY_CELL 0.11f /* mm: along the radius; RAY_ROW along the fibre */

/* How far a face lies across the arc, the fibre and the radius: squares of its normal. A wall
 * that the face is parallel to looks as the far wall of a lumen does, so what is drawn of walls
 * across a direction goes with what is left of 1. */
typedef struct {
  vf arc, fibre, radius;
} cell_face;

/* The contrast that a colour has room for: no wall is brighter than white. */
INLINE vf cells_room(const wood_constants *w, vf colour) {
  vf room = splat(w->cell_white) / vmax(colour, splat(0.01f)) - splat(w->cell_open);
  return vmax(room, splat(0.0f));
}

#endif
