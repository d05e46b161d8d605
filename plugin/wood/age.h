/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_AGE_H
#define SOZAI_WOOD_AGE_H

#include "../core/params.h"
#include "wood.h"

/* What years of light and air have made of the colours, which are built. */
void age_build(wood_constants *w, const settings *s, const float (*colours)[3]);

#endif
