/* SPDX-License-Identifier: Apache-2.0
 *
 * Single cells: their sizes, their walls, and how they contrast.
 */
#include "parts.h"

#include "../parameters.h"
#include "late.h"

/* Of 0..1. */
static double cube_root(double x) {
  double r = 1.0;
  for (int i = 0; i < 40; i++) r = (2.0 * r + x / (r * r)) / 3.0;
  return r;
}

/* Walls: latewood's are up to twice the mean's share, and the ring's sum is the density's.
 * flat: latewood's cells are, along the radius. */
static void build_walls(wood_constants *w, double density, int flat) {
  double share = limited(density / 1500.0, 0.08, 0.92), part = late_profile_integral(w, 1.0);
  double thick = flat ? 2.0 * share : 1.15 * share;
  thick = limited(thick, share, share > 0.85 ? share : 0.85);
  w->wall_late = (float)thick;
  w->wall_early = (float)limited((share - part * thick) / (1.0 - part + 1e-9), 0.08, share);
}

/* Fine rays. pitch: to a file, one in every so many mm of its height. */
static void build_fine_rays(wood_constants *w, double pitch) {
  pitch = limited(pitch, 0.0, 0.6 / (double)FINE_RAY_TALL);
  w->inverse_fine_pitch = (float)pitch;
  w->fine_tall = (float)(pitch * (double)FINE_RAY_TALL);
  w->fine_open = (float)cube_root(1.0 - (double)w->wall_early);
}

void wood_build_cells(wood_constants *w, const settings *s) {
  double contrast = number_at(s, P_CELL_CONTRAST);
  w->has_cells = contrast > 0.0;
  double width = 1e-3 * number_at(s, P_CELL_WIDTH), early = 1e-3 * number_at(s, P_CELL_DEPTH);
  double late = 1e-3 * number_at(s, P_CELL_DEPTH_LATE);
  w->inverse_cell_width = (float)(1.0 / width);
  w->inverse_cell_early = (float)(1.0 / early);
  w->inverse_cell_late = (float)(1.0 / late);
  w->inverse_cell_length = (float)(1.0 / number_at(s, P_CELL_LENGTH));
  w->cell_gone = (float)(4.0 * (width > early ? width : early));
  build_walls(w, number_at(s, P_BASIC_DENSITY), late < 0.7 * early);
  w->cell_bend = (float)((double)CELL_BEND_BY * number_at(s, P_CELL_IRREGULARITY));
  build_fine_rays(w, number_at(s, P_FINE_RAYS) * width);
  double most = 1.0 / (1.0 - (double)w->wall_early);
  w->cell_white = (float)(0.97 * most / (1.0 + number_at(s, P_FIBRE_BRIGHTNESS)));
  w->cell_open = (float)most;
  w->cell_end = (float)(0.65 * contrast);
  w->cell_side = (float)(0.26 * contrast);
  w->tyloses = (float)(1.1 * number_at(s, P_TYLOSES) * contrast);
  w->inverse_tylose = (float)(1.0 / (0.45e-3 * number_at(s, P_ROW_DIAMETER)));
  double wide = 1.2e-3 * number_at(s, P_ROW_DIAMETER), apart = (double)w->pore_cell;
  w->rim_squares = (float)(1.0 / (w->rows && apart < wide ? wide : apart));
  w->inverse_element = (float)(1.0 / number_at(s, P_ELEMENT_LENGTH));
}
