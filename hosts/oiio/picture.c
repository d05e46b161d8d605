/* SPDX-License-Identifier: Apache-2.0 */
#include "picture_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "texture.h"
#include "ceilings.h"

static const char *wrap_name(int wrap) {
  switch (wrap) {
  case RECIPE_WRAP_BLACK:
    return "black";
  case RECIPE_WRAP_PERIODIC:
    return "periodic";
  case RECIPE_WRAP_MIRROR:
    return "mirror";
  default:
    return "clamp";
  }
}

static void describe(picture *p) {
  picture_about *a = &p->about;
  a->shape = *surface_shape_of(p->surface);
  bool volume = a->shape.kind == SURFACE_VOLUME;
  for (int c = 0; c < 3; c++) a->tile[c] = volume ? PICTURE_VOLUME_TILE : c < 2 ? PICTURE_TILE : 1;
  a->subimages = p->subimages;
  a->material = p->recipe.material;
  a->preset = p->recipe.preset ? p->recipe.preset : "";
  a->working = p->library->working;
  a->wrap = wrap_name(p->recipe.image.wrap);
}

/* Of p->recipe. */
static bool open_parts(picture *p, failure *why) {
  p->library = library_get(why);
  if (!p->library) return false;
  p->texture_use = texture_use(&p->recipe, p->library, why);
  if (!p->texture_use) return false;
  p->texture = shared_object(p->texture_use);
  uint32_t count;
  const sozai_textures_1 *textures = p->library->plugin.textures;
  if (!surface_open(&p->surface, &p->recipe, textures, p->texture, why)) return false;
  bool solid = surface_shape_of(p->surface)->kind == SURFACE_VOLUME;
  const sozai_texture_info *info = textures->info_of(p->texture);
  if (!outputs_make(&p->outputs, &count, &p->recipe, info, solid, why)) return false;
  bool single = p->recipe.image.subimages == RECIPE_SUBIMAGES_SINGLE;
  if (!subimages_make(&p->subimages, &p->about.subimage_count, p->outputs, count, single, why))
    return false;
  describe(p);
  return true;
}

bool picture_open(picture **out, const char *name, failure *why) {
  *out = NULL;
  if (recipe_file_length(name) == 0)
    return fail(why, EXIT_BAD_INPUT, "%.200s: not a .sozai file", name);
  if (!limits_check(HOST_LIMIT_QUERY_BYTES, strlen(name), "a file's name", why)) return false;
  picture *p = calloc(1, sizeof *p);
  if (!p) return fail(why, EXIT_FAILURE, "out of memory");
  if (!recipe_open(&p->recipe, name, why) || !open_parts(p, why)) {
    picture_close(p);
    return false;
  }
  *out = p;
  return true;
}

void picture_close(picture *p) {
  if (!p) return;
  free(p->subimages);
  free(p->outputs);
  surface_close(p->surface);
  shared_release(p->texture_use);
  recipe_free(&p->recipe);
  free(p);
}

const picture_about *picture_about_of(const picture *p) { return &p->about; }

void picture_level(const picture *p, uint32_t level, uint32_t pixels[3]) {
  surface_level(p->surface, level, pixels);
}
