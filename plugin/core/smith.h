/* SPDX-License-Identifier: Apache-2.0
 *
 * Smith's shadowing of a rough surface (IEEE Trans. Antennas Propag. 15, 1967): an expectation, not
 * a trace.
 */
#ifndef SOZAI_CORE_SMITH_H
#define SOZAI_CORE_SMITH_H

#include "maths.h"

#define SMITH_STEEPER 1.6f /* from there on light is past all that the fit has */

/* Lambda, by Walter et al.'s fit (2007). a: the tangent of the light's elevation, over the root of
 * twice the slopes' variance. */
INLINE vf smith_lambda(vf a) {
  vf one = splat(1.0f), zero = splat(0.0f), low = vmax(a, splat(1e-3f));
  vf l = (one - low * (splat(1.259f) - splat(0.396f) * low)) /
         (low * (splat(3.535f) + splat(2.181f) * low));
  return sel(lt(a, splat(SMITH_STEEPER)), vmax(l, zero), zero);
}

#endif
