/* SPDX-License-Identifier: Apache-2.0
 *
 * A texture's whole life as a renderer sees it: load, check the version, make
 * a wood, ask four points for their colour and grain, let go.
 *
 *   cc -std=c99 -Iapi docs/example/embed.c -o embed -ldl
 *   ./embed build/lib/sozai.so
 */
#include "sozai.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 4, COMPONENTS = 64 };

/* Have the three components of a channel written to to[]. */
static int want(const sozai_texture_info *info, const char *id, float *out[], float to[3][POINTS]) {
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *channel = info->channels[i];
    if (strcmp(channel->id, id) != 0) continue;
    if (channel->components != 3 || channel->first + 3 > COMPONENTS) break;
    for (uint32_t k = 0; k < 3; k++) out[channel->first + k] = to[k];
    return 1;
  }
  fprintf(stderr, "%s: no channel %s\n", info->id, id);
  return 0;
}

static int shade(const sozai_textures_1 *textures) {
  /* Structures of arrays: four points up the face of a board, in mm. */
  const float px[POINTS] = {40, 41, 42, 43}, py[POINTS] = {0, 10, 20, 30};
  const float zero[POINTS] = {0, 0, 0, 0}, one[POINTS] = {1, 1, 1, 1};
  const float footprint[POINTS] = {0.1f, 0.1f, 0.1f, 0.1f}; /* a pixel's side on the face */
  float albedo[3][POINTS], fiber[3][POINTS];
  float *out[COMPONENTS] = {NULL}; /* NULL: not wanted, so not computed */
  sozai_batch batch = {.size = sizeof batch,
                       .count = POINTS,
                       .point = {px, py, zero},
                       .normal = {zero, zero, one},
                       .light = {one, zero, one},
                       .footprint = footprint,
                       .out = out,
                       .out_count = COMPONENTS};
  sozai_texture *wood = NULL;
  int done = 0;

  if (textures->create(NULL, "wood", "keyaki", NULL, 0, &wood) != SOZAI_OK)
    fprintf(stderr, "create: %s\n", textures->last_error());
  else if (want(textures->info_of(wood), "albedo", out, albedo) &&
           want(textures->info_of(wood), "fiber", out, fiber)) {
    done = textures->evaluate(wood, &batch) == SOZAI_OK;
    if (!done) fprintf(stderr, "evaluate: %s\n", textures->last_error());
  }
  for (int i = 0; done && i < POINTS; i++)
    printf("%g %g: albedo %.4f %.4f %.4f fiber %.4f %.4f %.4f\n", px[i], py[i], albedo[0][i],
           albedo[1][i], albedo[2][i], fiber[0][i], fiber[1][i], fiber[2][i]);
  textures->destroy(wood);
  return done;
}

int main(int argc, char **argv) {
  void *library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
  const sozai_entry_v1 *entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  int done = 0;
  if (argc != 2)
    fprintf(stderr, "usage: embed PATH/sozai.so\n");
  else if (!entry)
    fprintf(stderr, "%s\n", dlerror());
  else if (entry->abi_major != SOZAI_ABI_MAJOR)
    fprintf(stderr, "%s: wrong ABI\n", argv[1]);
  else if (entry->init(argv[1]) != SOZAI_OK)
    fprintf(stderr, "%s: init failed\n", argv[1]);
  else {
    const sozai_textures_1 *textures = entry->get_factory(SOZAI_TEXTURES_1);
    if (textures)
      done = shade(textures);
    else
      fprintf(stderr, "%s: no %s\n", argv[1], SOZAI_TEXTURES_1);
    entry->deinit();
  }
  if (library) dlclose(library);
  return done ? 0 : 1;
}
