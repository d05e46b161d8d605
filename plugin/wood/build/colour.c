/* SPDX-License-Identifier: Apache-2.0
 *
 * Colours, heartwood's edge, and gloss.
 */
#include "parts.h"

#include <string.h>

#include "../../core/colour.h"
#include "../../core/scalar.h"
#include "../parameters.h"

#define RAY_SAP 0.2 /* of rays in sapwood: how much they are as in heartwood */

/* Where heartwood ends, which is not the same all round. */
static void build_heart(wood_constants *w, const settings *s) {
  w->heart_years = (float)number_at(s, P_HEART_YEARS);
  w->heart_edge = (float)number_at(s, P_HEART_EDGE);
  w->heart_stray = (float)number_at(s, P_HEART_STRAY);
  for (int k = 1; k <= 3; k++) {
    double t = TWO_PI * wood_uniform(w->seed, STREAM_HEART, (uint32_t)k);
    double a = number_at(s, P_HEART_STRAY) / (k * (1.0 + 1.0 / 2.0 + 1.0 / 3.0));
    w->heart_cos[k - 1] = (float)(a * scalar_cos(t));
    w->heart_sin[k - 1] = (float)(a * scalar_sin(t));
  }
}

int32_t wood_build_colour(wood_constants *w, const sozai_host *host, const settings *s,
                          const float (*colours)[3]) {
  memcpy(w->early, colours[P_EARLY_COLOUR], sizeof w->early);
  memcpy(w->late, colours[P_LATE_COLOUR], sizeof w->late);
  memcpy(w->vessel, colours[P_VESSEL_COLOUR], sizeof w->vessel);
  memcpy(w->ray, colours[P_RAY_COLOUR], sizeof w->ray);
  memcpy(w->sap_early, colours[P_SAP_EARLY], sizeof w->sap_early);
  memcpy(w->sap_late, colours[P_SAP_LATE], sizeof w->sap_late);
  memcpy(w->vessel_sap, colours[P_SAP_VESSEL], sizeof w->vessel_sap);
  for (int c = 0; c < 3; c++) {
    double own = RAY_SAP * (double)w->ray[c];
    w->ray_sap[c] = (float)(own + (1.0 - RAY_SAP) * (double)w->sap_early[c]);
  }
  memcpy(w->pigment, colours[P_PIGMENT_COLOUR], sizeof w->pigment);
  pigment_build(w, s);
  memcpy(w->streak, colours[P_STREAK_COLOUR], sizeof w->streak);
  double streaks = number_at(s, P_STREAK_SHARE);
  if (streaks > 0.0) {
    tubes_filling(&w->streaks, 0.5 * number_at(s, P_STREAK_WIDTH), number_at(s, P_STREAK_LENGTH),
                  0.75, streaks / (double)WOOD_STREAK);
  }
  build_heart(w, s);
  w->diffuse = (float)number_at(s, P_DIFFUSE);
  w->specular = (float)number_at(s, P_SPECULAR);
  w->shininess = (float)number_at(s, P_SHININESS);
  /* the kernel's own operations, in its own precision */
  w->roughness = __builtin_sqrtf(2.0f / (w->shininess + 2.0f));
  float hue[3];
  int32_t r = colour_hue(host, wood_parameters[P_EARLY_COLOUR], &s->list[P_EARLY_COLOUR], hue);
  if (r) return r;
  double tint = number_at(s, P_TINT);
  for (int c = 0; c < 3; c++) w->tint_colour[c] = (float)(1.0 + tint * ((double)hue[c] - 1.0));
  return SOZAI_OK;
}
