/* SPDX-License-Identifier: Apache-2.0
 * Textures, one for all pictures of the same material, preset and parameters. */
#ifndef SOZAI_OIIO_TEXTURE_H
#define SOZAI_OIIO_TEXTURE_H

#include "library.h"
#include "recipe.h"
#include "shared.h"

/* A use of the recipe's texture; NULL: why. */
shared *texture_use(recipe *r, const library *l, failure *why);

#endif
