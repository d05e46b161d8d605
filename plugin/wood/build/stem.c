/* SPDX-License-Identifier: Apache-2.0
 *
 * The pith's wander, the section's outline, and how the growth front undulates.
 */
#include "parts.h"

#include "../../core/scalar.h"
#include "../../core/status.h"
#include "../parameters.h"

int32_t wood_build_stem(wood_constants *w, const settings *s) {
  w->pith_amplitude = (float)(2.0 * number_at(s, P_PITH_WANDER)); /* the noise stays within half */
  w->pith_frequency = (float)(1.0 / 900.0);
  w->taper = (float)(number_at(s, P_TAPER) / (1000.0 * 100.0));

  /* harmonics fall off as 1/k, and their sum stays within the wobble */
  double total = 0.0;
  for (int k = 1; k <= WOOD_HARMONICS; k++) total += 1.0 / k;
  for (int k = 1; k <= WOOD_HARMONICS; k++) {
    double a = number_at(s, P_OUTLINE) / (k * total);
    double t = TWO_PI * wood_uniform(w->seed, STREAM_OUTLINE, (uint32_t)k);
    w->outline_cos[k - 1] = (float)(a * scalar_cos(t));
    w->outline_sin[k - 1] = (float)(a * scalar_sin(t));
  }

  double u = number_at(s, P_UNDULATION), size = number_at(s, P_UNDULATION_SIZE);
  if (u > 0.0900001 * size) {
    return fail(
        SOZAI_ERROR_RANGE,
        "undulation: %.9g mm is above 0.09 of undulation_size (%.9g mm): rings would cross; "
        "0 to %.9g mm",
        u, size, 0.09 * size);
  }
  static const double weight[2] = {1.0, 0.3}, scale[2] = {1.0, 0.31};
  for (int o = 0; o < 2; o++) {
    w->undulation[o] = (float)(2.0 * u * weight[o]);
    w->undulation_frequency_axis[o] = (float)(1.0 / (3.0 * size * scale[o]));
    w->undulation_size[o] = (float)(size * scale[o]);
    w->undulation_frequency_section[o] = (float)(1.0 / (size * scale[o]));
  }
  w->undulation_core = (float)(0.5 / size);
  return SOZAI_OK;
}
