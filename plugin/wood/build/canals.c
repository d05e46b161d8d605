/* SPDX-License-Identifier: Apache-2.0
 *
 * Resin canals.
 */
#include "parts.h"

#include "../parameters.h"
#include "late.h"

/* Latewood's share where canals stand, which are the more the later in the ring: the
 * profile's mean over the phases that canals_at gives them, in a ring of the mean width. */
static double late_of_canals(const wood_constants *w) {
  enum { PARTS = 64 };
  double margin = (double)CANAL_MARGIN * (double)w->canal.radius / (double)w->ring_width;
  double low = limited((double)CANAL_LOW, margin, 0.5), high = limited(1.0 - margin, 0.5, 1.0);
  double mean = 0.0, before = low, late = late_profile_integral(w, low);
  for (int i = 1; i <= PARTS; i++) {
    double at = low + (high - low) * i / PARTS, next = late_profile_integral(w, at);
    mean += (next - late) / (at - before) * (2.0 * i - 1.0) / (PARTS * PARTS);
    before = at;
    late = next;
  }
  double whole = late_profile_integral(w, 1.0) * (double)w->ring_period;
  return mean * (whole > 0.0 ? (double)w->late_period / whole : 0.0);
}

void wood_build_canals(wood_constants *w, const settings *s, const float (*colours)[3]) {
  double density = number_at(s, P_CANAL_DENSITY), diameter = number_at(s, P_CANAL_DIAMETER);
  w->has_canals = density > 0.0;
  w->canal_density = (float)density;
  /* so that neighbours in a row stand farther apart than they are wide */
  int rows = (int)(2.5e-3 * diameter * density * (double)w->ring_width) + 1;
  w->canal_rows = rows < 4 ? rows : 4;
  double square = wood_build_radii(&w->canal, diameter, 0.18), r = (double)w->canal.radius;
  double covered = 0.5 * TWO_PI * r * r * square * density;
  w->canal.coverage = (float)(covered < 1.0 ? covered : 1.0);
  w->canal_late = (float)late_of_canals(w);
  for (int c = 0; c < 3; c++) {
    w->canal_colour[c] = colours[P_CANAL_COLOUR][c];
    w->canal_lumen[c] = 0.55f * colours[P_CANAL_COLOUR][c];
  }
}
