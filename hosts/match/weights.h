/* SPDX-License-Identifier: Apache-2.0
 * How much of each colour of a material shows at each point of a face. */
#ifndef SOZAI_MATCH_WEIGHTS_H
#define SOZAI_MATCH_WEIGHTS_H

#include "board.h"
#include "colour.h"
#include "recipe.h"
#include "roles.h"

/* A colour of less weight than this on the whole cannot be told. */
#define LEAST_WEIGHT 0.001

typedef struct weighing {
  const board *board;
  const colour *colour;
  const match_material *material;
  size_t roles;
  double most_brightness;
} weighing;

/* To a point the roles' weights without brightness, then what a unit of it adds
 * to each. */
typedef struct weights {
  float *of;
  size_t stride;
  uint64_t points;
} weights;

bool weights_take(weights *w, const weighing *q, const recipe *r, failure *why);
void weights_free(weights *w);

/* Both parts get the colour, so that it does not matter where they meet. */
bool weights_set_role(recipe *r, const match_role *role, const char *text, failure *why);
bool weights_copy_recipe(recipe *to, const recipe *from, failure *why);

#endif
