/* SPDX-License-Identifier: Apache-2.0
 *
 * Parameters as the generator takes them, and the curves of growth by years.
 * Every curve only rises with the year, so that rings never cut one another
 * and knots never shrink.
 */
#ifndef SOZAI_TREE_PLAN_H
#define SOZAI_TREE_PLAN_H

#include "../core/params.h"

/* How shoots, or leaves, stand on the axis that bears them. */
typedef struct {
  float spacing, length, share, taper, sine, cosine, angle, bare, zone, bend, jitter;
  int arrangement; /* ROUND_* */
} tree_side;

/* Of plan.colours; the first three are those of parts, in mesh.h. */
#define COLOUR_BARK 0
#define COLOUR_SHOOT 1
#define COLOUR_LEAF 2
#define COLOUR_RHYTIDOME 3
#define COLOURS 4

typedef struct {
  uint32_t seed;
  double age;
  int years; /* shoots: age rounded up */
  int orders, foliage, leaf, leaf_from, leaf_site, whorls, random;
  double leaves_most, upslope;
  double height_max, height_rate, height_shape;
  double girth_max, girth_rate, girth_shape, stem_form, butt, sway;
  double turns, branches, turn_spread, divergence_sd, divergence_min, divergence_max, flush;
  double crown_a, crown_a_down, crown_b, crown_b_old, crown_height, crown_narrowing;
  double crown_scatter, crown_ratio, crown_age, shedding;
  double angle_top, angle_low; /* of branches at the crown's top and base: */
  double angle_from, angle_to; /* a line between these shares of it, level beyond */
  double angle_spread;         /* the width of how far they stray from it */
  int angle_chord;             /* of their tips seen from their bases, and not at the base */
  double droop, droop_length, upturn, wander, slender, thickest;
  double fork_spacing, fork_from, fork_share; /* arms.h */
  float fork_sine, fork_cosine;
  tree_side side[4]; /* [2], [3]: of shoots; [0]: of leaves */
  float leaf_width, leaf_stalk;
  float colours[COLOURS][3];
  float leaf_variation;
  float periderm_age, rhytidome_from, rhytidome_age;
  float bark_depth, bark_width, bark_length, bark_plates, bark_shade, bark_reach; /* furrows.h */
  float bark_joined, bark_ridges, bark_scales, bark_variation;                    /* likewise */
  float bark_turning;                                                       /* bark_surface.h */
  float lenticel_density, lenticel_length, lenticel_height, lenticel_shade; /* lenticels.h */
  float scar_width, scar_droop, scar_shade;                                 /* scars.h */
  float round[1024][2]; /* cosine and sine all round, for random angles */
} tree_plan;

void plan_make(tree_plan *p, const settings *s);

double tree_power(double x, double exponent); /* x > 0; 0 of what is not */

/* All lengths in mm; t in years. */
double plan_height(const tree_plan *p, double t);
/* Of the stem under bark, at height h. */
double plan_radius(const tree_plan *p, double h, double t);
/* What a branch at height z reaches in year t, before scatter; down: on the
 * downslope side. */
double plan_reach(const tree_plan *p, double z, double t, int down);
/* Below it branches are dead. */
double plan_crown_base(const tree_plan *p, double t);
/* crown_b of that year. */
double plan_crown_b(const tree_plan *p, double t);

#endif
