/* SPDX-License-Identifier: Apache-2.0
 * The subimages of a .sozai file: one for each channel of the material that is
 * a property of the surface, whatever the light. */
#ifndef SOZAI_OIIO_OUTPUT_H
#define SOZAI_OIIO_OUTPUT_H

#include "recipe.h"
#include "sozai.h"

#ifdef __cplusplus
extern "C" {
#endif

#define OUTPUT_MOST_COMPONENTS 3

typedef struct output {
  const char *id;                         /* the channel's */
  uint32_t first, components;             /* of sozai_batch.out */
  char names[OUTPUT_MOST_COMPONENTS][64]; /* "R", "normal.x", "height" */
  bool colour;                            /* in the working space; else data */
  bool half;
  bool encoded; /* 0.5 + 0.5 of the value */
} output;

/* Those that the recipe asks for, in its order, else all in the order: albedo,
 * normal, height, roughness, specular, fiber, the rest as described. solid: of
 * a volume, where there is no normal to be had. *out is to be freed. */
bool outputs_make(output **out, uint32_t *count, const recipe *r, const sozai_texture_info *info,
                  bool solid, failure *why);

#ifdef __cplusplus
}
#endif

#endif
