/* SPDX-License-Identifier: Apache-2.0
 * The pixels of a unit. */
#ifndef SOZAI_BAKE_UNITS_H
#define SOZAI_BAKE_UNITS_H

#include "outputs.h"
#include "plan.h"
#include "ground.h"

typedef struct bake_source {
  const sozai_textures_1 *textures;
  const sozai_texture *texture;
  const bake_ground *ground;
  const bake_outputs *outputs;
  uint32_t threads;
} bake_source;

/* Bytes of a unit's pixels: file after file, each row by row. */
uint64_t bake_unit_bytes(const bake_outputs *o, const bake_unit *u);

/* Fills pixels[i], which has room, for each unit; they share the threads. A
 * request to cancel ends it soon, as a failure. */
bool bake_evaluate(const bake_source *s, const bake_unit *units, uint32_t count,
                   uint8_t *const *pixels, failure *why);

#endif
