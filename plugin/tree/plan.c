/* SPDX-License-Identifier: Apache-2.0 */
#include "plan.h"

#include "../core/scalar.h"
#include "parameters.h"

double tree_power(double x, double e) {
  if (!(x > 0.0)) return 0.0;
  if (e == 0.0) return 1.0;
  if (e == 0.5) return scalar_root(x);
  if (e == 1.0) return x;
  return scalar_exp(e * scalar_log(x));
}

static tree_side side_at(const settings *s, int first) {
  /* the ten values of an order stand in this order in parameters.h */
  tree_side o;
  double a = number_at(s, first + (T_ANGLE_2 - T_SPACING_2)) * RADIANS;
  o.spacing = (float)number_at(s, first);
  o.length = (float)number_at(s, first + (T_LENGTH_2 - T_SPACING_2));
  o.share = (float)number_at(s, first + (T_SHARE_2 - T_SPACING_2));
  o.taper = (float)number_at(s, first + (T_TAPER_2 - T_SPACING_2));
  o.angle = (float)a;
  o.sine = (float)scalar_sin(a);
  o.cosine = (float)scalar_cos(a);
  o.arrangement = choice_at(s, first + (T_ROUND_2 - T_SPACING_2));
  o.bare = (float)number_at(s, first + (T_BARE_2 - T_SPACING_2));
  o.zone = (float)number_at(s, first + (T_ZONE_2 - T_SPACING_2));
  o.bend = (float)(number_at(s, first + (T_BEND_2 - T_SPACING_2)) * RADIANS);
  o.jitter = (float)number_at(s, first + (T_JITTER_2 - T_SPACING_2));
  return o;
}

static tree_side leaves_at(const settings *s) {
  double a = number_at(s, T_LEAF_ANGLE) * RADIANS;
  return (tree_side){.spacing = (float)number_at(s, T_LEAF_SPACING),
                     .length = (float)number_at(s, T_LEAF_LENGTH),
                     .taper = (float)number_at(s, T_LEAF_TAPER),
                     .angle = (float)a,
                     .sine = (float)scalar_sin(a),
                     .cosine = (float)scalar_cos(a),
                     .zone = (float)number_at(s, T_LEAF_ZONE),
                     .arrangement = choice_at(s, T_LEAF_ROUND)};
}

static void take_growth(tree_plan *p, const settings *s) {
  p->height_max = number_at(s, T_HEIGHT_MAX) * 1000.0;
  p->height_rate = number_at(s, T_HEIGHT_RATE);
  p->height_shape = number_at(s, T_HEIGHT_SHAPE);
  p->girth_max = number_at(s, T_GIRTH_MAX);
  p->girth_rate = number_at(s, T_GIRTH_RATE);
  p->girth_shape = number_at(s, T_GIRTH_SHAPE);
  p->stem_form = number_at(s, T_STEM_FORM);
  p->butt = number_at(s, T_BUTT);
  p->sway = number_at(s, T_SWAY);
  p->turns = number_at(s, T_TURNS);
  p->branches = number_at(s, T_BRANCHES);
  p->turn_spread = number_at(s, T_TURN_SPREAD);
  p->divergence_sd = number_at(s, T_DIVERGENCE_SD);
  p->divergence_min = number_at(s, T_DIVERGENCE_MIN);
  p->divergence_max = number_at(s, T_DIVERGENCE_MAX);
  p->flush = number_at(s, T_FLUSH);
  p->random = choice_at(s, T_AZIMUTH) == AZIMUTH_RANDOM;
  p->whorls = choice_at(s, T_WHORL) == WHORL_WHORLS;
}

static void take_crown(tree_plan *p, const settings *s) {
  p->crown_a = number_at(s, T_CROWN_A);
  p->crown_a_down = number_at(s, T_CROWN_A_DOWN);
  if (p->crown_a_down <= 0.0) p->crown_a_down = p->crown_a;
  p->crown_b = number_at(s, T_CROWN_B);
  p->crown_b_old = number_at(s, T_CROWN_B_OLD);
  if (p->crown_b_old > p->crown_b) p->crown_b_old = p->crown_b;
  p->crown_height = number_at(s, T_CROWN_HEIGHT) * 1000.0;
  p->crown_narrowing = number_at(s, T_CROWN_NARROWING);
  p->crown_scatter = number_at(s, T_CROWN_SCATTER);
  p->crown_ratio = number_at(s, T_CROWN_RATIO);
  p->crown_age = number_at(s, T_CROWN_AGE);
  p->shedding = number_at(s, T_SHEDDING);
  p->angle_top = number_at(s, T_ANGLE_TOP);
  p->angle_low = number_at(s, T_ANGLE_LOW);
  p->droop = number_at(s, T_DROOP);
  p->droop_length = number_at(s, T_DROOP_LENGTH);
  p->upturn = number_at(s, T_UPTURN);
  p->wander = number_at(s, T_WANDER);
  p->slender = number_at(s, T_SLENDER);
  p->thickest = number_at(s, T_THICKEST);
  p->fork_spacing = number_at(s, T_FORK_SPACING);
  p->fork_from = number_at(s, T_FORK_FROM);
  p->fork_share = number_at(s, T_FORK_SHARE);
  p->fork_sine = (float)scalar_sin(number_at(s, T_FORK_ANGLE) * RADIANS);
  p->fork_cosine = (float)scalar_cos(number_at(s, T_FORK_ANGLE) * RADIANS);
  p->angle_from = 0.0;
  p->angle_to = 1.0;
  p->angle_spread = 0.5 * p->wander;
  p->angle_chord = 0;
}

void plan_make(tree_plan *p, const settings *s) {
  p->seed = (uint32_t)number_at(s, T_SEED);
  p->age = number_at(s, T_AGE);
  p->years = (int)p->age + (p->age > (double)(int)p->age);
  p->orders = (int)number_at(s, T_ORDERS);
  p->foliage = choice_at(s, T_FOLIAGE);
  p->leaves_most = number_at(s, T_LEAVES_MOST);
  p->upslope = number_at(s, T_UPSLOPE);
  p->leaf = choice_at(s, T_LEAF);
  p->leaf_from = (int)number_at(s, T_LEAF_FROM);
  p->leaf_site = (int)number_at(s, T_LEAF_SITE);
  p->leaf_width = (float)number_at(s, T_LEAF_WIDTH);
  p->leaf_stalk = (float)number_at(s, T_LEAF_STALK);
  take_growth(p, s);
  take_crown(p, s);
  p->side[0] = leaves_at(s);
  p->side[2] = side_at(s, T_SPACING_2);
  p->side[3] = side_at(s, T_SPACING_3);
  for (int c = 0; c < COLOURS; c++) {
    for (int i = 0; i < 3; i++) {
      p->colours[c][i] = (float)s->list[T_BARK_COLOUR + c].number[i];
    }
  }
  p->leaf_variation = (float)number_at(s, T_LEAF_VARIATION);
  p->periderm_age = (float)number_at(s, T_PERIDERM_AGE);
  p->rhytidome_from = (float)number_at(s, T_RHYTIDOME_FROM);
  p->rhytidome_age = (float)number_at(s, T_RHYTIDOME_AGE);
  p->bark_depth = (float)number_at(s, T_BARK_DEPTH);
  p->bark_width = (float)number_at(s, T_BARK_WIDTH);
  p->bark_length = (float)number_at(s, T_BARK_LENGTH);
  p->bark_plates = (float)number_at(s, T_BARK_PLATES);
  p->bark_joined = (float)number_at(s, T_BARK_JOINED);
  p->bark_ridges = (float)number_at(s, T_BARK_RIDGES);
  p->bark_scales = (float)number_at(s, T_BARK_SCALES);
  p->bark_variation = (float)number_at(s, T_BARK_VARIATION);
  p->bark_shade = (float)number_at(s, T_BARK_SHADE);
  p->bark_turning = (float)number_at(s, T_BARK_TURNING);
  p->lenticel_density = (float)number_at(s, T_LENTICEL_DENSITY);
  p->lenticel_length = (float)number_at(s, T_LENTICEL_LENGTH);
  p->lenticel_height = (float)number_at(s, T_LENTICEL_HEIGHT);
  p->lenticel_shade = (float)number_at(s, T_LENTICEL_SHADE);
  p->scar_width = (float)number_at(s, T_SCAR_WIDTH);
  p->scar_droop = (float)number_at(s, T_SCAR_DROOP);
  p->scar_shade = (float)number_at(s, T_SCAR_SHADE);
  p->bark_reach = (float)(1000.0 * number_at(s, T_BARK_REACH));
  for (int i = 0; i < 1024; i++) {
    double a = (i + 0.5) * (360.0 / 1024.0) * RADIANS;
    p->round[i][0] = (float)scalar_cos(a);
    p->round[i][1] = (float)scalar_sin(a);
  }
}

double plan_height(const tree_plan *p, double t) {
  if (!(t > 0.0)) return 0.0;
  return p->height_max * tree_power(1.0 - scalar_exp(-p->height_rate * t), p->height_shape);
}

double plan_radius(const tree_plan *p, double h, double t) {
  double top = plan_height(p, t);
  if (!(h < top)) return 0.0;
  double ground =
      0.5 * p->girth_max * tree_power(1.0 - scalar_exp(-p->girth_rate * t), p->girth_shape);
  double r = ground * tree_power(1.0 - h / top, p->stem_form);
  /* the swell's extent is the species', not the year's: radii only grow */
  if (p->butt > 0.0) r *= 1.0 + p->butt * scalar_exp(-(h > 0.0 ? h : 0.0) / p->girth_max);
  return r;
}

double plan_crown_b(const tree_plan *p, double t) {
  double young = scalar_exp(-t / p->crown_age);
  return p->crown_b_old + (p->crown_b - p->crown_b_old) * young;
}

double plan_reach(const tree_plan *p, double z, double t, int down) {
  double top = plan_height(p, t);
  if (!(z < top)) return 0.0;
  double a = down ? p->crown_a_down : p->crown_a;
  double narrowing = tree_power(top / p->crown_height, -p->crown_narrowing);
  return a * narrowing * top * tree_power(1.0 - z / top, plan_crown_b(p, t));
}

double plan_crown_base(const tree_plan *p, double t) {
  double s = 1.0 - scalar_exp(-t / p->crown_age);
  return plan_height(p, t) * (1.0 - p->crown_ratio) * s * s;
}
