/* SPDX-License-Identifier: Apache-2.0 */
#include "direct.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "colour.h"
#include "host.h"
#include "plugin.h"
#include "recipe.h"

#define COMPONENTS 128 /* of a texture, at most */

struct direct {
  plugin plugin;
  colour colour;
  host host;
  sozai_texture *texture;
  const sozai_texture_info *info;
};

_Noreturn static void stop(const failure *why) {
  fprintf(stderr, "direct: %s\n", why->text);
  abort();
}

direct *direct_open(const char *name) {
  failure why = {0};
  recipe r;
  direct *d = calloc(1, sizeof *d);
  setenv("SOZAI_PLUGIN", SOZAI_TEST_PLUGIN, 1);
  if (!d || !plugin_open(&d->plugin, &why) || !recipe_open(&r, name, &why)) stop(&why);
  if (!colour_open(&d->colour, d->plugin.path, NULL, &why)) stop(&why);
  host_init(&d->host, 1, false, &d->colour, NULL);
  if (!recipe_create(&r, d->plugin.textures, &d->host.abi, &d->texture, &why)) stop(&why);
  recipe_free(&r);
  d->info = d->plugin.textures->info_of(d->texture);
  return d;
}

void direct_close(direct *d) {
  d->plugin.textures->destroy(d->texture);
  colour_close(&d->colour);
  plugin_close(&d->plugin);
  free(d);
}

void direct_at(const direct *d, const char *channel, const float point[3], const float *normal,
               float footprint, float *out) {
  float *to[COMPONENTS] = {NULL};
  uint32_t i = 0;
  while (i < d->info->channel_count && strcmp(d->info->channels[i]->id, channel) != 0) i++;
  if (i == d->info->channel_count || d->info->component_count > COMPONENTS) {
    fprintf(stderr, "direct: no channel %s among the first %d numbers\n", channel, COMPONENTS);
    abort();
  }
  const sozai_channel *wanted = d->info->channels[i];
  for (uint32_t k = 0; k < wanted->components; k++) to[wanted->first + k] = out + k;
  sozai_batch b = {
      .size = sizeof b, .count = 1, .footprint = &footprint, .out = to, .out_count = COMPONENTS};
  for (int c = 0; c < 3; c++) {
    b.point[c] = point + c;
    b.normal[c] = normal ? normal + c : NULL;
  }
  if (d->plugin.textures->evaluate(d->texture, &b) != SOZAI_OK) abort();
}

float direct_middle(uint32_t i, uint32_t n, double size) {
  return (float)((((double)i + 0.5) / n - 0.5) * size);
}

/* What has been written: the names, for whoever still has them, and to be removed. */
typedef struct written {
  struct written *before;
  char path[];
} written;

static written *last;
static char folder[] = "/tmp/sozai-oiio-XXXXXX";

static void remove_all(void) {
  while (last) {
    written *w = last;
    last = w->before;
    remove(w->path);
    free(w);
  }
  rmdir(folder);
}

const char *direct_folder(void) {
  static const char *made;
  if (made) return made;
  made = mkdtemp(folder);
  if (!made || atexit(remove_all) != 0) abort();
  return made;
}

const char *direct_path(const char *name) {
  size_t room = strlen(direct_folder()) + strlen(name) + 2;
  written *w = malloc(sizeof *w + room);
  if (!w) abort();
  snprintf(w->path, room, "%s/%s", direct_folder(), name);
  w->before = last;
  last = w;
  return w->path;
}

const char *direct_write(const char *name, const char *text) {
  const char *path = direct_path(name);
  FILE *file = fopen(path, "w");
  if (!file || fputs(text, file) < 0 || fclose(file) != 0) abort();
  return path;
}

uint32_t direct_random(uint64_t *state) {
  uint64_t h = *state += 0x9e3779b97f4a7c15u;
  h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9u;
  h = (h ^ h >> 27) * 0x94d049bb133111ebu;
  return (uint32_t)(h >> 32);
}
