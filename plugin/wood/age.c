/* SPDX-License-Identifier: Apache-2.0
 *
 * Ageing: light breaks the lignin down into what is yellow and brown, and in
 * the dark woods bleaches the extractives. Measured changes are fast at first
 * and level off as an exponential does (Oltean et al., Holz als Roh- und
 * Werkstoff 66, 2008; Schnabel et al., European Journal of Wood 67, 2009).
 * Every channel x becomes x^p with p = 1 + (p_end - 1) (1 - exp(-years / time)),
 * where p_end takes earlywood to aged_colour: all stay within 0 to 1, and what
 * was darker stays so. Sapwood is pale, and always darkens.
 */
#include "age.h"

#include "../core/scalar.h"
#include "parameters.h"

static double within(double x) { return x < 1e-4 ? 1e-4 : x > 0.98 ? 0.98 : x; }

void age_build(wood_constants *w, const settings *s, const float (*colours)[3]) {
  double years = number_at(s, P_AGE_YEARS);
  if (years <= 0.0) return;
  double done = 1.0 - scalar_exp(-years / number_at(s, P_AGEING_YEARS));
  float *heart[] = {w->late,        w->vessel,           w->ray,       w->streak,
                    w->pigment,     w->knot_early,       w->knot_late, w->canal_colour,
                    w->canal_lumen, w->parenchyma.colour},
        *sap[] = {w->sap_early, w->sap_late, w->ray_sap, w->vessel_sap, w->parenchyma.sap};
  for (int c = 0; c < 3; c++) {
    double from = within((double)w->early[c]), to = within((double)colours[P_AGED_COLOUR][c]);
    double end = scalar_log(to) / scalar_log(from);
    /* near white or black a power would run away */
    end = end < 0.4 ? 0.4 : end > 4.0 ? 4.0 : end;
    double p = 1.0 + (end - 1.0) * done, pale = end < 1.0 ? 1.0 + 0.5 * (1.0 - end) * done : p;
    for (size_t i = 0; i < sizeof heart / sizeof *heart; i++) {
      heart[i][c] = (float)scalar_exp(p * scalar_log(within((double)heart[i][c])));
    }
    for (size_t i = 0; i < sizeof sap / sizeof *sap; i++) {
      sap[i][c] = (float)scalar_exp(pale * scalar_log(within((double)sap[i][c])));
    }
    w->early[c] = (float)scalar_exp(p * scalar_log(from));
  }
}
