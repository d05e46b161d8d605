/* SPDX-License-Identifier: Apache-2.0
 * In the place of plugin/fiber/texture/fitted.c, in the library that fit-fiber-light loads: what
 * is fitted, at first the last fit, can be changed, and what the last texture is made of be read.
 */
#include <string.h>

#define fibertex_fit last_fit
#include "fiber/texture/fitted.c"
#undef fibertex_fit

#define SEEN __attribute__((visibility("default")))
extern fibertex_fitted fiber_fitting;
extern double fiber_made_of[CLOTH_FEATURES];
SEEN fibertex_fitted fiber_fitting;
SEEN double fiber_made_of[CLOTH_FEATURES];

const fibertex_fitted *fibertex_fit(const double *made_of);
const fibertex_fitted *fibertex_fit(const double *made_of) {
  memcpy(fiber_made_of, made_of, sizeof fiber_made_of);
  return &fiber_fitting;
}

__attribute__((constructor)) static void begin(void) { fiber_fitting = *last_fit(fiber_made_of); }
