/* SPDX-License-Identifier: Apache-2.0 */
#include "plan.h"

static uint32_t halved(uint32_t side, uint32_t times) {
  uint32_t s = times < 32 ? side >> times : 0;
  return s > 0 ? s : 1;
}

uint32_t bake_plan_levels(uint32_t width, uint32_t height) {
  uint32_t levels = 1;
  for (uint32_t side = width > height ? width : height; side > 1; side /= 2) levels++;
  return levels;
}

void bake_plan_level_size(const bake_plan *p, uint32_t level, uint32_t *width, uint32_t *height) {
  *width = halved(p->width, level);
  *height = halved(p->height, level);
}

static uint32_t bands(const bake_plan *p, uint32_t level) {
  return (halved(p->height, level) + p->band - 1) / p->band;
}

static uint64_t units_of_picture(const bake_plan *p) {
  uint64_t count = 0;
  for (uint32_t level = 0; level < p->level_count; level++) count += bands(p, level);
  return count;
}

uint64_t bake_plan_units(const bake_plan *p) { return p->picture_count * units_of_picture(p); }

bake_unit bake_plan_unit(const bake_plan *p, uint64_t index) {
  uint64_t each = units_of_picture(p), rest = index % each;
  bake_unit u = {.picture = (uint32_t)(index / each)};
  while (rest >= bands(p, u.level)) rest -= bands(p, u.level++);
  bake_plan_level_size(p, u.level, &u.width, &u.height);
  u.row = (uint32_t)rest * p->band;
  u.rows = u.height - u.row < p->band ? u.height - u.row : p->band;
  return u;
}
