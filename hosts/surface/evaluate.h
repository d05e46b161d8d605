/* SPDX-License-Identifier: Apache-2.0
 * What a material looks like at a surface's texels. */
#ifndef SOZAI_SURFACE_EVALUATE_H
#define SOZAI_SURFACE_EVALUATE_H

#include "surface.h"

#define SURFACE_BLOCK 1024u   /* texels at once, at most */
#define SURFACE_COMPONENTS 64 /* outputs past them are not looked at */
#define SURFACE_ROOM 8192u    /* numbers at once: they fit the processor's nearest caches */

/* How many texels of so many components that is room for: SURFACE_BLOCK, or
 * whole `unit`s. */
static inline uint32_t surface_fit(uint32_t components, uint32_t unit) {
  uint32_t fit = components ? SURFACE_ROOM / components : SURFACE_BLOCK;
  return fit < SURFACE_BLOCK ? fit / unit * unit : SURFACE_BLOCK;
}

typedef struct surface_material {
  const sozai_textures_1 *textures;
  const sozai_texture *texture;
} surface_material;

/* The texels x to x+w, y to y+h of slice z of a level, at most SURFACE_BLOCK of
 * them: out as in sozai_batch, row by row. Of a seamless picture, which a batch
 * alone does not give, too. covered: see surface_room, or NULL. No light.
 * Allocates nothing. [thread-safe] */
bool surface_evaluate(const surface *s, const surface_material *m, uint32_t level, uint32_t x,
                      uint32_t y, uint32_t z, uint32_t w, uint32_t h, float *const *out,
                      uint32_t out_count, uint8_t *covered, failure *why);

#endif
