/* SPDX-License-Identifier: Apache-2.0
 * Texels that are each the mean of parts of them. A material filters what it
 * shows to a texel by itself, with an error; of side x side parts, each filtered
 * to itself, little of that error is left. */
#ifndef SOZAI_SURFACE_TEXEL_PARTS_H
#define SOZAI_SURFACE_TEXEL_PARTS_H

#include "evaluate.h"

typedef struct texel_parts {
  uint32_t side;                    /* parts across a texel, and down: 1, 2, 4 or 8 */
  const periodic *repeat;           /* of a seamless plane, else NULL */
  const float *across[3], *down[3]; /* of each point: surface_room's */
} texel_parts;

/* As evaluate(), for at most SURFACE_COMPONENTS outputs, with footprints, without light, view or
 * mask. Colours, directions, shares, heights and depths are means; directions of length 1, of which
 * a fibre's has two ends, and counts by the one that is on its neighbours' side. All else is the
 * whole texel's: names, places, ages, and roughness, which counts how what is within its footprint
 * scatters. */
int32_t texel_parts_evaluate(const texel_parts *s, const surface_material *m,
                             const sozai_batch *batch);

#endif
