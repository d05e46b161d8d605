/* SPDX-License-Identifier: Apache-2.0
 * How colours of the working space look: sRGB, CIE Lab and the difference
 * CIEDE2000. */
#ifndef SOZAI_MATCH_APPEARANCE_H
#define SOZAI_MATCH_APPEARANCE_H

#include <stddef.h>
#include "colour.h"

/* count colours in place; sRGB may be outside 0 to 1. */
bool appearance_srgb(const colour *c, float *rgb, size_t count, failure *why);
/* From a space by its name; without a service there is only "sRGB". */
bool appearance_to_working(const colour *c, const char *space, float *rgb, size_t count,
                           failure *why);
/* Lab under D65, in place. */
bool appearance_lab(const colour *c, float *rgb, size_t count, failure *why);

double ciede2000(const double a[3], const double b[3]);

#endif
