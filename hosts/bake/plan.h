/* SPDX-License-Identifier: Apache-2.0
 * How a bake is divided: pictures (UDIM tiles), their mipmap levels, and
 * bands of rows. A band is the unit of work: what is kept, resumed and shared
 * out. The division depends on the job alone, never on who works on it. */
#ifndef SOZAI_BAKE_PLAN_H
#define SOZAI_BAKE_PLAN_H

#include <stdbool.h>
#include <stdint.h>

typedef struct bake_plan {
  uint32_t width, height; /* of each picture's level 0 */
  uint32_t picture_count;
  uint32_t level_count; /* 1: no mipmaps */
  uint32_t band;        /* rows; the last band of a level may have fewer */
} bake_plan;

typedef struct bake_unit {
  uint32_t picture, level;
  uint32_t width, height; /* of the level */
  uint32_t row, rows;     /* of the band */
} bake_unit;

/* Down to 1 x 1, each side halved and rounded down, as EXR has it. */
uint32_t bake_plan_levels(uint32_t width, uint32_t height);
void bake_plan_level_size(const bake_plan *p, uint32_t level, uint32_t *width, uint32_t *height);
/* Picture by picture, level by level, from the top down. */
uint64_t bake_plan_units(const bake_plan *p);
bake_unit bake_plan_unit(const bake_plan *p, uint64_t index);

#endif
