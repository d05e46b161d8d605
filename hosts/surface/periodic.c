/* SPDX-License-Identifier: Apache-2.0 */
#include "periodic.h"

#include <math.h>
#include <string.h>

#define MARGIN 0.25 /* of the shorter side */
#define OCTAVES 4
#define WIDEST 0.1 /* of the margin: how far a texel's edge smooths the line */

bool periodic_fits(const char *material) {
  /* Wood's rings lie about one pith, and its boards each have a log. */
  static const char *const stationary[] = {"stone"};
  for (size_t i = 0; i < sizeof stationary / sizeof stationary[0]; i++)
    if (strcmp(material, stationary[i]) == 0) return true;
  return false;
}

periodic periodic_make(const double size[2]) {
  return (periodic){{size[0], size[1]}, MARGIN * fmin(size[0], size[1])};
}

/* ---- the ragged line -------------------------------------------------- */

static double lattice(int64_t i, int64_t j, uint32_t seed) {
  uint64_t h = (uint64_t)i * 0x9e3779b97f4a7c15u ^ (uint64_t)j * 0xc2b2ae3d27d4eb4fu ^ seed;
  h = (h ^ h >> 31) * 0xbf58476d1ce4e5b9u;
  h = (h ^ h >> 29) * 0x94d049bb133111ebu;
  return (double)(h >> 40) / (double)(1u << 23) - 1; /* -1 to 1 */
}

static double smooth(double t) { return t * t * (3 - 2 * t); }

/* Noise of -1 to 1 that repeats after n[0] and n[1] cells. */
static double noise(double u, double v, const int64_t n[2], uint32_t seed) {
  double fu = floor(u), fv = floor(v);
  int64_t i0 = (int64_t)fu % n[0], j0 = (int64_t)fv % n[1];
  if (i0 < 0) i0 += n[0];
  if (j0 < 0) j0 += n[1];
  int64_t i1 = (i0 + 1) % n[0], j1 = (j0 + 1) % n[1];
  double a = smooth(u - fu), b = smooth(v - fv);
  double low = lattice(i0, j0, seed) + a * (lattice(i1, j0, seed) - lattice(i0, j0, seed));
  double high = lattice(i0, j1, seed) + a * (lattice(i1, j1, seed) - lattice(i0, j1, seed));
  return low + b * (high - low);
}

/* -1 to 1; at 0 to 1 of the width and the height. */
static double ragged(const periodic *p, double s, double t, uint32_t seed) {
  double sum = 0, most = 0, share = 1, cell = p->margin / 2;
  for (int octave = 0; octave < OCTAVES; octave++, share *= 0.5, cell *= 0.4) {
    int64_t n[2];
    for (int c = 0; c < 2; c++) n[c] = (int64_t)fmax(1, floor(p->size[c] / cell + 0.5));
    sum += share * noise(s * (double)n[0], t * (double)n[1], n, seed + (uint32_t)octave);
    most += share;
  }
  return sum / most;
}

/* ---- weights ---------------------------------------------------------- */

static double clamped(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

/* The further copy's share at a distance from the edge; line: -1 to 1. The line
 * keeps off the margin's ends by more than half the widest transition. */
static double across(const periodic *p, double distance, double line, double footprint) {
  double wide = fmin(fmax(footprint, 1e-9), WIDEST * p->margin);
  double cut = 0.5 * p->margin * (1 + (1 - 2 * WIDEST) * line);
  return clamped(0.5 + (cut - distance) / wide);
}

bool periodic_weights(const periodic *p, double x, double y, double footprint,
                      float share[PERIODIC_COPIES]) {
  double from[2] = {x + 0.5 * p->size[0], y + 0.5 * p->size[1]};
  double s = from[0] / p->size[0], t = from[1] / p->size[1];
  double f[2] = {0, 0};
  for (uint32_t k = 0; k < 2; k++)
    if (from[k] < p->margin) f[k] = across(p, from[k], ragged(p, s, t, 0x51u + 16 * k), footprint);
  for (int k = 0; k < PERIODIC_COPIES; k++)
    share[k] = (float)((k & 1 ? f[0] : 1 - f[0]) * (k & 2 ? f[1] : 1 - f[1]));
  return share[0] < 1;
}
