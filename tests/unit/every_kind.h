/* SPDX-License-Identifier: Apache-2.0
 *
 * A kind of texture with a parameter of every kind, for the tests of params.c.
 */
#ifndef SOZAI_TESTS_EVERY_KIND_H
#define SOZAI_TESTS_EVERY_KIND_H

#include "core/params.h"

enum {
  K_FLOAT,
  K_INT,
  K_BOOL,
  K_CHOICE,
  K_FLOAT3,
  K_COLOUR,
  K_TEXT,
  K_PATH,
  K_TABLE,
  K_IMAGE,
  K_MESH,
  K_POINTS,
  K_PICTURE,
  K_COUNT
};

extern const sozai_texture_info every_kind;

#endif
