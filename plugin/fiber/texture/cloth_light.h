/* SPDX-License-Identifier: Apache-2.0
 *
 * Light on cloth: amounts and colours.
 */
#ifndef SOZAI_FIBERTEX_CLOTH_LIGHT_H
#define SOZAI_FIBERTEX_CLOTH_LIGHT_H

#include "../../core/params.h"
#include "texture.h"

#define CLEAR 0.454 /* transmission of the fibre that amounts are given for */

/* What of the light from around reaches what is seen squarely, the mean (light.c). */
double fibertex_ambient(const fibertex_constants *w);
/* What part of TT goes on at each strand. */
double fibertex_passed(double clear);
/* After Kubelka and Munk (1931): what a slab over black sends back, of what is without end of that
 * colour; slab: their S X. */
double fibertex_over_black(double slab, double colour);

/* The yarns are known. */
void fibertex_cloth_amounts(fibertex_constants *w, const settings *s);
/* What the cloth sends back of what is without end of that colour: how a colour looks by light
 * that is scattered often, over white's. */
double fibertex_cloth_back(const fibertex_constants *w, const settings *s, double colour);
/* What that takes for the mean albedo to be the cloth's: a factor. */
double fibertex_cloth_albedo(const fibertex_constants *w, const settings *s);

#endif
