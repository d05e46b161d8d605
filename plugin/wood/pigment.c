/* SPDX-License-Identifier: Apache-2.0
 *
 * The table of pigment's bands: when each begins, how wide and how deep it is.
 */
#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "build.h"
#include "parameters.h"

static double uniform(uint32_t seed, uint32_t k) {
  return (hash1(seed + k * 0x9e3779b9u) + 0.5) / 4294967296.0;
}

/* Depth at each sample. */
typedef struct {
  double depth[PIGMENT_SAMPLES];
  const wood_constants *w;
} bands;

/* The radius at which a year begins, mm; the table of rings again beyond its ends. */
static double radius_at(const wood_constants *w, double year) {
  double turn = 0.0;
  while (year < 0.0) year += WOOD_RINGS, turn -= 1.0;
  while (year >= WOOD_RINGS) year -= WOOD_RINGS, turn += 1.0;
  int j = (int)year;
  double low = (double)w->start[j], high = (double)w->start[j + 1];
  return turn * (double)w->ring_period + low + (high - low) * (year - j);
}

/* A band that deepens over `wide` years up to its outer edge. It goes on where the
 * table begins anew. */
static void add_band(bands *b, double edge, double wide, double deep) {
  double per_mm = PIGMENT_SAMPLES / (double)b->w->ring_period;
  double from = radius_at(b->w, edge - wide), to = radius_at(b->w, edge);
  for (int i = (int)(from * per_mm) - 1; i <= (int)(to * per_mm); i++) {
    double x = (i / per_mm - from) / (to - from);
    if (!(x > 0.0 && x <= 1.0)) continue;
    double d = deep * x * x * (3.0 - 2.0 * x) * (0.45 + 0.55 * x);
    double *at = &b->depth[((i % PIGMENT_SAMPLES) + PIGMENT_SAMPLES) % PIGMENT_SAMPLES];
    if (d > *at) *at = d;
  }
}

/* Broad drifts, and bands upon them; 0..1. */
static void fill(bands *b, double spacing, double width) {
  uint32_t seed = b->w->seeds[SEED_PIGMENT], k = 0;
  double edge = 0.0;
  while (edge < WOOD_RINGS) {
    /* gaps of a Poisson process, but for the narrowest */
    edge += spacing * (0.3 - 0.7 * scalar_log(uniform(seed, k)));
    double wide = spacing * width * (0.4 + 1.2 * uniform(seed, k + 1));
    double u = uniform(seed, k + 2);
    k += 3;
    if (edge < WOOD_RINGS) add_band(b, edge, wide, 0.25 + 0.75 * u * u);
  }
  uint32_t drifts = (uint32_t)(WOOD_RINGS / (2.5 * spacing));
  if (drifts < 1) drifts = 1;
  for (int i = 0; i < PIGMENT_SAMPLES; i++) {
    double at = (double)i * drifts / PIGMENT_SAMPLES, f = at - (int)at;
    uint32_t a = (uint32_t)at, next = (a + 1) % drifts;
    double low = uniform(~seed, a), high = uniform(~seed, next);
    double slow = low + (high - low) * f * f * (3.0 - 2.0 * f);
    b->depth[i] = 1.0 - (1.0 - b->depth[i]) * (1.0 - 0.35 * slow);
  }
}

void pigment_build(wood_constants *w, const settings *s) {
  double strength = number_at(s, P_PIGMENT), reach = number_at(s, P_PIGMENT_REACH);
  w->has_pigment = strength > 0.0;
  if (!w->has_pigment) return;
  bands b = {.w = w};
  fill(&b, number_at(s, P_PIGMENT_SPACING), number_at(s, P_PIGMENT_WIDTH));
  double sum = 0.0, step = (double)w->ring_period / PIGMENT_SAMPLES;
  for (int i = 0; i < PIGMENT_SAMPLES; i++) {
    double here = strength * b.depth[i], next = strength * b.depth[(i + 1) % PIGMENT_SAMPLES];
    const float row[4] = {(float)sum, (float)(here * step), (float)(0.5 * (next - here) * step),
                          0.0f};
    memcpy(w->pigment_row[i], row, sizeof row);
    sum += 0.5 * (here + next) * step;
  }
  w->pigment_period = (float)sum;
  w->pigment_per_mm = (float)(1.0 / step);
  w->pigment_stray = (float)(number_at(s, P_PIGMENT_STRAY) * (double)w->ring_width);
  w->pigment_frequency = (float)(1.0 / reach);
  w->pigment_near = (float)(0.25 * reach * reach);
}
