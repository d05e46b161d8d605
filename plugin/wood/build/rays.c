/* SPDX-License-Identifier: Apache-2.0
 *
 * Rays: how many, how large, and what a footprint is to expect of them.
 */
#include "parts.h"

#include "../parameters.h"

/* mm from the pith at which a sector has one ray; farther in, some have none. Broad rays show which
 * of them begin together. */
#define RAYS_ONE 20.0
#define RAYS_ONE_BROAD 40.0

/* Of a cell's arc, that a ray's middle keeps from its edge. */
#define RAY_ROOM 0.329

/* Rays that are so many times as thick as has room in one layer of cells stand in two. */
#define RAY_CROWDED 1.25

/* mm: most of a cell's width, by which its rows begin and end unevenly */
#define RAY_RAGGED 0.009

/* By how much the rows of its cells make a ray thicker and thinner. */
static double ragged_of(double half) { return limited(RAY_RAGGED / half, 0.0, 0.35); }

/* The thickest over the mean. */
static double thickest_of(double half, double uneven) {
  return 1.3 * (1.0 + uneven) * (1.0 + ragged_of(half));
}

/* Half the mean thickness that has room in a cell of `arc`. */
static double thickness_most(double half, double arc, double uneven) {
  double room = RAY_ROOM / thickest_of(half, uneven);
  return (room < 0.2 ? room : 0.2) * arc;
}

/* How thick they are: no more than has room. Returns half the mean, mm. */
static double build_thickness(wood_constants *w, double half, double arc, double uneven) {
  double most = thickness_most(half, arc, uneven), thickest = thickest_of(half, uneven);
  w->ray_ragged = (float)ragged_of(half);
  if (half > most) half = most;
  w->ray_half = (float)half;
  w->ray_room = (float)RAY_ROOM;
  w->ray_thickest = (float)(thickest * half);
  w->ray_softer = (float)(1.0 + uneven);
  return half;
}

/* Sheets sway along the fibre: fine ones little, broad ones by slopes of some degrees over more
 * than their height, for which a cut along them shows ribbons. Along the radius they are nearly
 * straight, or a flake would be the crescent about a wave's crest. Broad ones follow single bundles
 * of fibres, too: by that, what lies flat in a cut is no blot but ribbons that part and meet. Our
 * figures, by eye. */
static void build_sway(wood_constants *w, double height, double broad) {
  double along = (0.4 + 0.7 * broad) * height, slope = 0.05 + 0.02 * broad;
  w->ray_stray = (float)(slope * along / NOISE_BOUND);
  double out = (8.0 + 3.5 * height) * (1.0 + 2.0 * broad);
  w->ray_wave_radial = (float)(1.0 / out);
  w->ray_wave_along = (float)(1.0 / along);
  double ripple = 0.22 * along;
  w->ray_ripple = (float)(0.05 * broad * ripple / NOISE_BOUND);
  w->ray_ripple_along = (float)(1.0 / ripple);
  w->ray_ripple_radial = (float)(1.0 / (4.0 * ripple));
}

void wood_build_rays(wood_constants *w, const settings *s) {
  double density = number_at(s, P_RAY_DENSITY), height = number_at(s, P_RAY_HEIGHT);
  double width = 1e-3 * number_at(s, P_RAY_WIDTH), length = number_at(s, P_RAY_LENGTH);
  w->has_rays = density > 0.0;
  if (!w->has_rays) return;
  /* broad rays are uneven: fibres pass between their cells */
  double broad = limited((height - 3.0) / 9.0, 0.0, 1.0), uneven = 0.55 * broad;
  /* a cell holds the tallest, one and a half times the mean, with some to spare;
   * a radius meets three quarters of the rays */
  double cell = 1.65 * height, arc = 0.75 / (density * cell);
  w->ray_layers = 0.5 * width > RAY_CROWDED * thickness_most(0.5 * width, arc, uneven) ? 2 : 1;
  density /= w->ray_layers;
  arc *= w->ray_layers;
  w->ray_length = (float)length;
  w->inverse_ray_length = (float)(1.0 / length);
  w->inverse_ray_arc = (float)(1.0 / arc);
  w->inverse_ray_cell = (float)(1.0 / cell);
  w->ray_tall = (float)(0.5 * height / cell);
  w->ray_uneven = (float)uneven;
  /* a footprint with few of them in it is not one with their mean */
  w->ray_sides = broad > 0.5 ? 2 : 1;
  double one = RAYS_ONE + (RAYS_ONE_BROAD - RAYS_ONE) * broad;
  double sectors = (int)limited(TWO_PI * one / arc, 8.0, 4096.0);
  w->ray_sectors = (float)sectors;
  w->ray_sector_turn = (float)(TWO_PI / sectors);
  w->ray_per_radius = (float)(TWO_PI / (arc * sectors));
  w->ray_blunt = (float)broad;
  double half = build_thickness(w, 0.5 * width, arc, uneven);
  build_sway(w, height, broad);
  /* light goes round the edges of a broad ray, which a cut along it leaves wedges of */
  double sharp = limited(0.2 * broad * half, 0.01, 1.0);
  w->ray_sharp2 = (float)(sharp * sharp);
  /* two thirds of a lens's height and width, less what the ends' taper takes; and the mean
   * of thickness times density */
  w->ray_cover = (float)(density * height * 2.0 * half * (2.0 / 3.0 + 2.0 / 15.0 * broad) * 11.0 /
                         12.0 * 0.82);
}
