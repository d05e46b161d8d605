/* SPDX-License-Identifier: Apache-2.0
 * Which colour spaces materials and .sozai files name, and what the config in
 * force makes of each name. */
#ifndef SOZAI_CLI_SPACES_H
#define SOZAI_CLI_SPACES_H

#include <stddef.h>
#include "colour.h"
#include "recipe.h"

typedef struct space_use {
  char *name;           /* as it is written there */
  char *where;          /* "defaults, keyaki" or "earlywood_colour" */
  const char *resolved; /* the config's own name, or NULL: it has none such */
} space_use;

typedef struct space_uses {
  space_use *items;
  size_t count;
} space_uses;

/* What a texture's parameters and presets name. */
bool spaces_of_texture(space_uses *u, const sozai_texture_info *info, const colour *c,
                       failure *why);
/* What the values of a recipe name; its preset's and defaults among them where
 * it does not set them itself. */
bool spaces_of_recipe(space_uses *u, const recipe *r, const sozai_texture_info *info,
                      const colour *c, failure *why);
void spaces_free(space_uses *u);

#endif
