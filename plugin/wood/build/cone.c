/* SPDX-License-Identifier: Apache-2.0
 *
 * The fibres' cone of reflection.
 */
#include "parts.h"

#include "../cone_table.h"
#include "../parameters.h"
#include "../surface/build.h"

void wood_build_cone(wood_constants *w, const settings *s) {
  w->cone = choice_at(s, P_REFLECTION) == REFLECTION_CONE;
  w->ior = (float)number_at(s, P_IOR);
  w->inverse_ior = 1.0f / w->ior;
  w->cone_width = (float)(number_at(s, P_CONE_WIDTH) * TWO_PI / 360.0);
  double brightest = number_at(s, P_FIBRE_REFLECTANCE) * surface_fibres(s);
  w->fibre_brightest = (float)brightest;
  for (int c = 0; c < 3; c++) {
    double k = brightest * (double)w->tint_colour[c];
    w->fibre_colour[c] = (float)(k > 0.0 ? k : 0.0);
  }
  w->ray_lustre = w->cone ? (float)number_at(s, P_RAY_LUSTRE) : 0.0f;
  w->inverse_ray_lustre = w->ray_lustre > 0.0f ? 1.0f / w->ray_lustre : 0.0f;
  if (w->cone) cone_table_build(w, number_at(s, P_RAY_LUSTRE));
}
