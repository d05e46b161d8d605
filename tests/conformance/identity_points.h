/* SPDX-License-Identifier: Apache-2.0
 *
 * The points on which the plugin must give the same bits everywhere, made of
 * whole numbers and exact operations: every compiler and machine makes the
 * same ones.
 */
#ifndef SOZAI_TESTS_IDENTITY_POINTS_H
#define SOZAI_TESTS_IDENTITY_POINTS_H

#include "plugin.h"

#define BLOCK 4096u /* points that share a texture and a set of inputs */

enum {
  IN_POINT,
  IN_NORMAL = 3,
  IN_LIGHT = 6,
  IN_LIGHT_COLOUR = 9,
  IN_VIEW = 12,
  IN_FOOTPRINT = 15,
  IN_COUNT
};

/* Which inputs a block has, as SOZAI_INPUT_* bits. */
uint32_t points_inputs(uint64_t block);
/* All inputs of a block's points. */
void points_make(uint64_t block, float (*in)[BLOCK]);

#endif
