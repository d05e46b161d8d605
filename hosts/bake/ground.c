/* SPDX-License-Identifier: Apache-2.0 */
#include "ground.h"

#include <stdlib.h>
#include <string.h>
#include "numbers.h"

static bool has_tile(const atlas *a, int tile) {
  for (uint32_t k = 0; k < atlas_udim_count(a); k++)
    if (atlas_udim(a, k) == tile) return true;
  return false;
}

static bool add_tile(bake_ground *g, double number, failure *why) {
  int tile = number >= 1001 && number <= 9999 ? (int)number : 0;
  if (tile != number || !has_tile(g->atlas, tile))
    return fail(why, EXIT_BAD_INPUT, "--udim: the mesh has no tile %g; it has %u, the first %d",
                number, atlas_udim_count(g->atlas), atlas_udim(g->atlas, 0));
  for (uint32_t i = 0; i < g->count; i++)
    if (g->tiles[i] == tile) return fail(why, EXIT_BAD_INPUT, "--udim: tile %d stands twice", tile);
  g->tiles[g->count++] = tile;
  return true;
}

static bool choose_tiles(bake_ground *g, const char *tiles, int own, failure *why) {
  uint32_t most = atlas_udim_count(g->atlas);
  g->tiles = malloc((most + (size_t)1) * sizeof *g->tiles);
  double *asked = malloc((most + (size_t)1) * sizeof *asked);
  bool ok = (g->tiles && asked) || fail(why, EXIT_FAILURE, "out of memory");
  size_t count = ok && tiles ? numbers_read(tiles, ',', asked, most + (size_t)1) : 0;
  if (ok && tiles && count == 0)
    ok = fail(why, EXIT_BAD_INPUT, "--udim: '%.80s' is not tiles of the mesh's %u, as 1001,1002",
              tiles, most);
  for (size_t i = 0; ok && i < count; i++) ok = add_tile(g, asked[i], why);
  if (ok && !tiles && own) ok = add_tile(g, own, why);
  for (uint32_t k = 0; ok && !tiles && !own && k < most; k++)
    g->tiles[g->count++] = atlas_udim(g->atlas, k);
  free(asked);
  return ok;
}

bool bake_ground_open(bake_ground *g, const recipe *r, const sozai_textures_1 *textures,
                      const sozai_texture *texture, const char *tiles, failure *why) {
  memset(g, 0, sizeof *g);
  if (!surface_open(&g->surface, r, textures, texture, why)) return false;
  g->atlas = surface_atlas(g->surface);
  bool ok = true;
  if (g->atlas)
    ok = choose_tiles(g, tiles, r->image.udim, why);
  else if (surface_shape_of(g->surface)->kind == SURFACE_VOLUME)
    ok = fail(
        why, EXIT_BAD_INPUT,
        "bake: a volume cannot be baked: resolution and size of image have at most two numbers");
  else if (tiles)
    ok = fail(why, EXIT_BAD_INPUT, "--udim: only a mesh has tiles");
  else
    g->count = 1;
  if (!ok) bake_ground_close(g);
  return ok;
}

void bake_ground_close(bake_ground *g) {
  surface_close(g->surface);
  free(g->tiles);
  memset(g, 0, sizeof *g);
}
