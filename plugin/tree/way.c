/* SPDX-License-Identifier: Apache-2.0 */
#include "way.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "angle.h"
#include "tree.h"

#define TURNS_MOST 13u
#define TURN_PARTS 3u /* segments in which a turn of the way is taken */
#define KEPT 0.8      /* of what the way has turned aside, from turn to turn: light calls it back */
#define STEEPEST 86.0
#define BASE_STEPS 3 /* to an elevation at the base: it is off by the azimuths' turns alone */

/* How often a branch turns aside along its length. */
static uint32_t branch_turns(double length, double wander) {
  double n = 3.0 + length / (wander > 12.0 ? 180.0 : 300.0);
  return n > TURNS_MOST ? TURNS_MOST : (uint32_t)n;
}

uint32_t way_segments(const tree_plan *p, double length) {
  return branch_turns(length, p->wander) * TURN_PARTS;
}

static void turn_aside(way *w, const tree_plan *p, uint32_t key, uint32_t i) {
  uint32_t h = hash1(key + 0x632be59bu * i);
  w->azimuth[0] = w->azimuth[1];
  w->elevation[0] = w->elevation[1];
  w->azimuth[1] = KEPT * w->azimuth[0] + 2.0 * p->wander * ((double)tree_unit(h) - 0.5);
  w->elevation[1] = KEPT * w->elevation[0] + 1.4 * p->wander * ((double)tree_unit(hash1(h)) - 0.5);
}

/* Down along the first half and up again towards the tip, by the sine of the
 * way along; longer branches bend further. */
static double bent(const tree_plan *p, double length, double share) {
  double bend = length / p->droop_length;
  if (bend > 1.5) bend = 1.5;
  return bend * (p->upturn * share * share - p->droop * scalar_sin(3.14159265 * share));
}

void way_step(way *w, const tree_plan *p, uint32_t key, double length, uint32_t i, double *azimuth,
              double *elevation) {
  uint32_t segments = way_segments(p, length), part = i % TURN_PARTS;
  if (i > 0 && part == 0) turn_aside(w, p, key, i / TURN_PARTS);
  double middle = (double)i / segments + 0.5 / segments, turned = (part + 0.5) / TURN_PARTS;
  double phi = *elevation + bent(p, length, middle < 1.0 ? middle : 1.0) + w->elevation[0] +
               turned * (w->elevation[1] - w->elevation[0]);
  if (phi > STEEPEST) phi = STEEPEST;
  if (phi < -STEEPEST) phi = -STEEPEST;
  *elevation = phi;
  *azimuth = *azimuth + w->azimuth[0] + turned * (w->azimuth[1] - w->azimuth[0]);
}

/* The elevation of its tip, seen from its base. */
static double chord_of(const tree_plan *p, uint32_t key, double length, double base) {
  double x = 0.0, y = 0.0, z = 0.0;
  uint32_t segments = way_segments(p, length);
  way w = {{0.0, 0.0}, {0.0, 0.0}};
  for (uint32_t i = 0; i < segments; i++) {
    double theta = 0.0, phi = base;
    way_step(&w, p, key, length, i, &theta, &phi);
    double level = scalar_cos(phi * RADIANS);
    x += level * scalar_sin(theta * RADIANS);
    y += scalar_sin(phi * RADIANS);
    z += level * scalar_cos(theta * RADIANS);
  }
  return angle_of(y, scalar_root(x * x + z * z));
}

double way_base(const tree_plan *p, uint32_t key, double length, double elevation) {
  double base = elevation;
  for (int i = 0; i < BASE_STEPS; i++) {
    base += elevation - chord_of(p, key, length, base);
    base = scalar_least(STEEPEST, scalar_most(-STEEPEST, base));
  }
  return base;
}
