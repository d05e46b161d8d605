/* SPDX-License-Identifier: Apache-2.0
 *
 * What the grain does along the stem: spirals, waves, interlocks, strays.
 */
#include "parts.h"

#include "../parameters.h"

/* Irregularity 0..1 of waves of a length. The noises' lattices are no multiples of
 * the wave's, nor of each other's: where they are zero nothing lines up. The phase
 * strays by 0.5 * 1.5 turns at most over 6.3 lengths: its slope stays within 1.3472 *
 * 1.5 / 6.3 = 0.32 of a turn a length, so that waves never run backwards. The
 * variance is 1/3 times 26/35 for each axis. */
wood_irregular wood_irregular_of(double amount, double length, double variance) {
  double steady = 1.0 - 0.75 * amount, swell = 1.3 * amount;
  return (wood_irregular){
      .steady = (float)steady,
      .swell = (float)swell,
      .power = (float)(steady * steady + 2.0 * variance * swell * swell),
      .stray = (float)(1.5 * amount),
      .stray_frequency = (float)(1.0 / (6.3 * length)),
      .swell_frequency = (float)(1.0 / (2.7 * length)),
  };
}

/* Tangent of the angle by which what is round, or runs along a radius, leans at a bolt's ends. */
#define BOLT_SHEAR 0.6
#define BOLT_NEAR 25.0     /* mm: nearer to the pith spirals part more than that */
#define BOLT_LEAST 12.0    /* mm */
#define BOLT_MOST 100000.0 /* mm: longer than any tree */
#define BOLT_UNEVEN 20.0   /* mm: how far a bolt's end strays to either side, */
#define BOLT_STRAYS 0.7    /* and of its length at most: what is next to it, too */

/* See bolt.h: how far fibres part, per mm of height and of radius. */
static void build_bolts(wood_constants *w) {
  double parts = (double)w->spiral / BOLT_NEAR;
  if (parts < 0.0) parts = -parts;
  if (w->has_interlocked) {
    double years = 1.0 / (double)w->interlocked_frequency;
    parts += (double)w->interlocked_slope * TWO_PI / (years * (double)w->ring_width);
  }
  if (parts * BOLT_MOST < 2.0 * BOLT_SHEAR) return;
  double length = 2.0 * BOLT_SHEAR / parts;
  if (length < BOLT_LEAST) length = BOLT_LEAST;
  w->bolt = (float)length;
  w->bolt_uneven = (float)(BOLT_UNEVEN < BOLT_STRAYS * length ? BOLT_UNEVEN / length : BOLT_STRAYS);
  w->inverse_bolt = (float)(1.0 / length);
}

void wood_build_grain(wood_constants *w, const settings *s) {
  int grain = choice_at(s, P_GRAIN), all = grain == GRAIN_COMPOUND;
  if (all || grain == GRAIN_SPIRAL) w->spiral = (float)number_at(s, P_SPIRAL_SLOPE);
  if (all || grain == GRAIN_WAVY) {
    double a = number_at(s, P_WAVE_SLOPE), l = number_at(s, P_WAVE_LENGTH);
    w->has_wave = a > 0.0;
    w->wave_slope = (float)a;
    w->wave_displacement = (float)(a * l / TWO_PI);
    w->wave_frequency = (float)(1.0 / l);
    w->wave_number = (float)(TWO_PI / l);
    double u = number_at(s, P_WAVE_IRREGULARITY);
    w->has_wave_irregularity = u > 0.0;
    w->wave = wood_irregular_of(u, l, 0.184);
    w->wave_inverse_reach = (float)((double)w->ring_width / number_at(s, P_WAVE_REACH));
  }
  if (all || grain == GRAIN_INTERLOCKED) {
    w->has_interlocked = number_at(s, P_INTERLOCKED_SLOPE) > 0.0;
    w->interlocked_slope = (float)number_at(s, P_INTERLOCKED_SLOPE);
    w->interlocked_frequency = (float)(1.0 / number_at(s, P_INTERLOCKED_YEARS));
    w->interlocked_length = (float)number_at(s, P_INTERLOCKED_LENGTH);
    w->interlocked_irregularity = (float)number_at(s, P_INTERLOCKED_IRREGULARITY);
  }
  build_bolts(w);
  static const double weight[2] = {0.65, 0.35}, scale[2] = {1.0, 0.37};
  double most = number_at(s, P_SLOPE_NOISE), length = number_at(s, P_SLOPE_NOISE_LENGTH);
  w->has_slope_noise = most > 0.0;
  for (int o = 0; o < 2; o++) {
    double l = length * scale[o];
    /* 1.3472 is AXIAL_SLOPE_BOUND: the sum's slope stays within `most` */
    w->slope_noise[o] = (float)(most * weight[o] * l / 1.3472);
    w->slope_noise_size[o] = (float)l;
    w->slope_noise_frequency[o] = (float)(1.0 / l);
  }
  w->slope_noise_years = 1.0f / 9.0f;
}
