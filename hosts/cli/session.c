/* SPDX-License-Identifier: Apache-2.0 */
#include "session.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "parallel.h"

#define MOST_HERE 4096 /* of this folder's path */

bool session_options_init(session_options *o, int argc, failure *why) {
  memset(o, 0, sizeof *o);
  o->params.items = calloc((size_t)argc + 1, sizeof *o->params.items);
  return o->params.items ? true : fail(why, EXIT_FAILURE, "out of memory");
}

void session_options_free(session_options *o) {
  free(o->params.items);
  memset(o, 0, sizeof *o);
}

/* c: NULL, or open. */
static bool open_host(session *s, const session_options *o, const colour *c, failure *why) {
  uint32_t threads = o->threads ? o->threads : parallel_default_threads();
  host_init(&s->host, threads, o->verbose, c, c ? o->config : NULL);
  if (limits_give(s->plugin.entry, &s->host.abi, why)) return true;
  session_close(s);
  return false;
}

bool session_open(session *s, const session_options *o, failure *why) {
  memset(s, 0, sizeof *s);
  if (!plugin_open(&s->plugin, why)) return false;
  if (!colour_open(&s->colour, s->plugin.path, o->config, why)) {
    plugin_close(&s->plugin);
    return false;
  }
  s->shown = o->shown;
  bool asked = s->shown.display || s->shown.view || s->shown.look;
  if (asked && !display_check(&s->colour, &s->shown, why)) {
    session_close(s);
    return false;
  }
  return open_host(s, o, &s->colour, why);
}

bool session_open_without_colour(session *s, const session_options *o, failure *why) {
  memset(s, 0, sizeof *s);
  return plugin_open(&s->plugin, why) && open_host(s, o, NULL, why);
}

void session_close(session *s) {
  colour_close(&s->colour);
  plugin_close(&s->plugin);
}

bool session_recipe(recipe *r, const char *name, const session_options *o, failure *why) {
  if (!recipe_open(r, name, why)) return false;
  bool ok = !o->preset || recipe_set_preset(r, o->preset, why);
  for (size_t i = 0; ok && i < o->params.count; i++)
    ok = recipe_set_pair(r, o->params.items[i], why);
  if (!ok) recipe_free(r);
  return ok;
}

bool session_saw(recipe *r, const sozai_texture_info *info, const char *shape, failure *why) {
  bool face = strcmp(shape, "board") == 0 || strcmp(shape, "plane") == 0;
  if (!face || r->file || recipe_sets(r, "cut") || !parameter_of(info, "cut")) return true;
  bool far = !recipe_sets(r, "cut_distance") && parameter_of(info, "cut_distance");
  if (far && !recipe_set(r, "cut_distance", BOARD_FROM_PITH, 0, why)) return false;
  return recipe_set(r, "cut", "flat", 0, why);
}

bool session_params_here(recipe *r, const option_texts *params, failure *why) {
  char here[MOST_HERE + 8];
  if (params->count == 0) return true;
  if (!getcwd(here, MOST_HERE)) return fail(why, EXIT_FAILURE, "this folder has no name");
  strcat(here, "/-p");
  for (size_t i = 0; i < params->count; i++) {
    const char *pair = params->items[i], *equals = strchr(pair, '=');
    char id[128];
    if (!equals || equals == pair || equals - pair >= (ptrdiff_t)sizeof id)
      return fail(why, EXIT_BAD_INPUT, "-p %.80s: not NAME=VALUE", pair);
    memcpy(id, pair, (size_t)(equals - pair));
    id[equals - pair] = '\0';
    if (!recipe_set_from(r, id, equals + 1, here, 0, why)) return false;
  }
  return true;
}

static bool unknown_channel(const sozai_texture_info *info, const char *name, failure *why) {
  char known[512] = "";
  for (uint32_t i = 0; i < info->channel_count; i++) {
    size_t used = strlen(known);
    snprintf(known + used, sizeof known - used, "%s%s", i ? ", " : "", info->channels[i]->id);
  }
  return fail(why, EXIT_BAD_INPUT, "unknown channel '%s' of %s; there is %s", name, info->id,
              known);
}

static bool add_channel(const sozai_texture_info *info, const char *name, uint32_t *indices,
                        uint32_t most, uint32_t *count, failure *why) {
  uint32_t i = 0;
  while (i < info->channel_count && strcmp(info->channels[i]->id, name) != 0) i++;
  if (i == info->channel_count) return unknown_channel(info, name, why);
  for (uint32_t k = 0; k < *count; k++)
    if (indices[k] == i) return fail(why, EXIT_BAD_INPUT, "channel '%s' stands twice", name);
  if (*count == most) return fail(why, EXIT_BAD_INPUT, "more than %u channels", most);
  indices[(*count)++] = i;
  return true;
}

bool session_channels(const sozai_texture_info *info, const char *names, uint32_t *indices,
                      uint32_t most, uint32_t *count, failure *why) {
  char *copy = strdup(names);
  if (!copy) return fail(why, EXIT_FAILURE, "out of memory");
  *count = 0;
  bool ok = true;
  char *rest = copy;
  for (char *name; ok && (name = strsep(&rest, ","));)
    ok = add_channel(info, name, indices, most, count, why);
  free(copy);
  return ok;
}
