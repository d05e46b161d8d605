/* SPDX-License-Identifier: Apache-2.0
 *
 * The table of pigment's bands: when each begins, how wide and how deep it is.
 */
#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "build.h"
#include "parameters.h"

enum { STEPS = WOOD_RINGS * PIGMENT_STEPS };

static double uniform(uint32_t seed, uint32_t k) {
  return (hash1(seed + k * 0x9e3779b9u) + 0.5) / 4294967296.0;
}

/* A band that deepens over `wide` years up to its outer edge. It begins anew where the
 * table does. */
static void add_band(double *depth, double edge, double wide, double deep) {
  int first = (int)((edge - wide) * PIGMENT_STEPS), last = (int)(edge * PIGMENT_STEPS);
  for (int i = first; i <= last; i++) {
    double x = ((double)i / PIGMENT_STEPS - (edge - wide)) / wide;
    if (x <= 0.0 || x > 1.0) continue;
    double d = deep * x * x * (3.0 - 2.0 * x) * (0.45 + 0.55 * x);
    double *at = &depth[((i % STEPS) + STEPS) % STEPS];
    if (d > *at) *at = d;
  }
}

/* Depth at each sample, 0..1: broad drifts, and bands upon them. */
static void depths(const wood_constants *w, double spacing, double width, double *depth) {
  uint32_t seed = w->seeds[SEED_PIGMENT], k = 0;
  double edge = 0.0;
  memset(depth, 0, STEPS * sizeof *depth);
  while (edge < WOOD_RINGS) {
    /* gaps of a Poisson process, but for the narrowest */
    edge += spacing * (0.3 - 0.7 * scalar_log(uniform(seed, k)));
    double wide = spacing * width * (0.4 + 1.2 * uniform(seed, k + 1));
    double u = uniform(seed, k + 2);
    k += 3;
    if (edge < WOOD_RINGS) add_band(depth, edge, wide, 0.25 + 0.75 * u * u);
  }
  int drifts = (int)(WOOD_RINGS / (2.5 * spacing));
  if (drifts < 1) drifts = 1;
  for (int i = 0; i < STEPS; i++) {
    double at = (double)i * drifts / STEPS, f = at - (int)at;
    uint32_t a = (uint32_t)at, b = (a + 1) % (uint32_t)drifts;
    double low = uniform(~seed, a), high = uniform(~seed, b);
    double slow = low + (high - low) * f * f * (3.0 - 2.0 * f);
    depth[i] = 1.0 - (1.0 - depth[i]) * (1.0 - 0.35 * slow);
  }
}

void pigment_build(wood_constants *w, const settings *s) {
  double strength = number_at(s, P_PIGMENT), reach = number_at(s, P_PIGMENT_REACH);
  w->has_pigment = strength > 0.0;
  if (!w->has_pigment) return;
  double depth[STEPS];
  depths(w, number_at(s, P_PIGMENT_SPACING), number_at(s, P_PIGMENT_WIDTH), depth);
  double sum = 0.0;
  for (int i = 0; i < STEPS; i++) {
    double here = strength * depth[i], next = strength * depth[(i + 1) % STEPS];
    const float row[4] = {(float)sum, (float)(here / PIGMENT_STEPS),
                          (float)(0.5 * (next - here) / PIGMENT_STEPS), 0.0f};
    memcpy(w->pigment_row[i], row, sizeof row);
    sum += 0.5 * (here + next) / PIGMENT_STEPS;
  }
  w->pigment_period = (float)sum;
  w->pigment_stray = (float)number_at(s, P_PIGMENT_STRAY);
  w->pigment_frequency = (float)(1.0 / reach);
  w->pigment_near = (float)(0.25 * reach * reach);
}
