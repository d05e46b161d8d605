/* SPDX-License-Identifier: Apache-2.0
 *
 * Vectors of three components, a lane each.
 */
#ifndef SOZAI_CORE_VECTORS_H
#define SOZAI_CORE_VECTORS_H

#include "maths.h"

INLINE vf dot3(const vf a[3], const vf b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

INLINE void cross3(const vf a[3], const vf b[3], vf out[3]) {
  for (int k = 0; k < 3; k++)
    out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

#endif
