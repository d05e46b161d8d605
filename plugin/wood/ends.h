/* SPDX-License-Identifier: Apache-2.0
 *
 * End grain: cells are open at their ends, and a face that cuts them across looks into them.
 */
#ifndef SOZAI_WOOD_ENDS_H
#define SOZAI_WOOD_ENDS_H

#include "../core/maths.h"

/* How far a face looks into the open ends of the cells along the stem, or of the rays': the
 * square of the normal's part along them, from 0.1 of the normal on. Without normals nothing. */
#define ENDS_FROM 0.01f
INLINE vf ends_seen(vf along2) {
  return vmax(along2 - splat(ENDS_FROM), splat(0.0f)) * splat(1.0f / (1.0f - ENDS_FROM));
}

#endif
