/* SPDX-License-Identifier: Apache-2.0
 * The outputs of a .sozai file: the channels of the material that are properties
 * of the surface, whatever the light; and its subimages, each one of them or
 * all. */
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

typedef struct subimage {
  const output *outputs; /* whose numbers lie side by side */
  uint32_t output_count;
  uint32_t components; /* of all of them */
  bool half, mixed;    /* all are halves; some are and some are not */
} subimage;

/* Those that the recipe asks for, in its order, else all in the order: albedo,
 * normal, height, roughness, specular, fiber, the rest as described. solid: of
 * a volume, where there is no normal to be had. *out is to be freed. */
bool outputs_make(output **out, uint32_t *count, const recipe *r, const sozai_texture_info *info,
                  bool solid, failure *why);
/* One of each output, or one of all. *out is to be freed. */
bool subimages_make(subimage **out, uint32_t *count, const output *outputs, uint32_t output_count,
                    bool single, failure *why);

#ifdef __cplusplus
}
#endif

#endif
