/* SPDX-License-Identifier: Apache-2.0 */
#include "recipe.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "numbers.h"
#include "utf8.h"
#include "ceilings.h"

#define ENDING ".sozai"
static bool out_of_memory(failure *why) { return fail(why, EXIT_FAILURE, "out of memory"); }

static bool set_string(char **slot, const char *text, failure *why) {
  char *copy = strdup(text);
  if (!copy) return out_of_memory(why);
  free(*slot);
  *slot = copy;
  return true;
}

static recipe_param *find_param(const recipe *r, const char *id) {
  for (size_t i = 0; i < r->param_count; i++)
    if (strcmp(r->params[i].id, id) == 0) return &r->params[i];
  return NULL;
}

bool recipe_sets(const recipe *r, const char *id) { return find_param(r, id) != NULL; }

const sozai_parameter *parameter_of(const sozai_texture_info *info, const char *id) {
  for (uint32_t i = 0; i < info->parameter_count; i++)
    if (strcmp(info->parameters[i]->id, id) == 0) return info->parameters[i];
  return NULL;
}

/* file: that asks for it, NULL: none does. */
static recipe_param *slot_for(recipe *r, const char *id, const char *file, int line, failure *why) {
  recipe_param *there = find_param(r, id);
  if (there) return there;
  char asks[sizeof why->text] = "parameters";
  if (file) snprintf(asks, sizeof asks, "%s:%d", file, line);
  if (!limits_check(HOST_LIMIT_RECIPE_PARAMETERS, r->param_count + 1, asks, why)) return NULL;
  recipe_param *more = realloc(r->params, (r->param_count + 1) * sizeof *more);
  if (more) r->params = more;
  char *copy = more ? strdup(id) : NULL;
  if (!copy) {
    out_of_memory(why);
    return NULL;
  }
  recipe_param *p = &r->params[r->param_count++];
  *p = (recipe_param){.id = copy};
  return p;
}

bool recipe_set_from(recipe *r, const char *id, const char *text, const char *file, int line,
                     failure *why) {
  recipe_param *p = slot_for(r, id, file, line, why);
  if (!p) return false;
  p->line = line;
  p->settled = false;
  if (!file) {
    free(p->file);
    p->file = NULL;
  } else if (!set_string(&p->file, file, why))
    return false;
  return set_string(&p->text, text, why);
}

bool recipe_set(recipe *r, const char *id, const char *text, int line, failure *why) {
  return recipe_set_from(r, id, text, NULL, line, why);
}

bool recipe_set_pair(recipe *r, const char *pair, failure *why) {
  const char *equals = strchr(pair, '=');
  if (!equals || equals == pair) return fail(why, EXIT_BAD_INPUT, "'%s' is not name=value", pair);
  char *id = strndup(pair, (size_t)(equals - pair));
  if (!id) return out_of_memory(why);
  bool ok = recipe_set(r, id, equals + 1, 0, why);
  free(id);
  return ok;
}

bool recipe_set_preset(recipe *r, const char *preset, failure *why) {
  return set_string(&r->preset, preset, why);
}

static int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  c = (char)tolower((unsigned char)c);
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* %41 for A and + for a space, in place, as in any address. */
static void decode(char *text) {
  char *to = text;
  for (const char *from = text; *from; from++) {
    int high = from[0] == '%' ? hex_digit(from[1]) : -1;
    int low = high >= 0 ? hex_digit(from[2]) : -1;
    if (low >= 0 && high + low > 0) {
      *to++ = (char)(16 * high + low);
      from += 2;
    } else
      *to++ = *from == '+' ? ' ' : *from;
  }
  *to = '\0';
}

static bool apply_override(recipe *r, char *pair, failure *why) {
  decode(pair);
  size_t length = strcspn(pair, "=");
  if (pair[length] && length > 0) {
    pair[length] = '\0';
    int key = recipe_image_key(strcmp(pair, "res") == 0 ? "resolution" : pair);
    pair[length] = '=';
    if (key >= 0)
      return recipe_image_set(&r->image, key, pair + length + 1, why) ||
             fail(why, why->exit_code, "%s?%.60s: %s", r->file, pair, why->text);
  }
  if (strncmp(pair, "preset=", 7) == 0) return recipe_set_preset(r, pair + 7, why);
  if (!recipe_set_pair(r, pair, why)) return false;
  for (size_t i = 0; i < r->param_count; i++)
    if (strlen(r->params[i].id) == length && strncmp(r->params[i].id, pair, length) == 0)
      return set_string(&r->params[i].file, r->file, why);
  return true;
}

static bool apply_overrides(recipe *r, const char *query, failure *why) {
  char *copy = strdup(query);
  if (!copy) return out_of_memory(why);
  bool ok = true;
  char *rest = copy;
  for (char *pair; ok && (pair = strsep(&rest, "&"));)
    if (*pair) ok = apply_override(r, pair, why);
  free(copy);
  return ok;
}

size_t recipe_file_length(const char *name) {
  size_t tail = strlen(ENDING), length = strlen(name);
  for (const char *at = name; (at = strchr(at, ENDING[0])); at++)
    if (strncasecmp(at, ENDING, tail) == 0 && at[tail] == '?') return (size_t)(at - name) + tail;
  return length >= tail && strcasecmp(name + length - tail, ENDING) == 0 ? length : 0;
}

bool recipe_open(recipe *r, const char *name, failure *why) {
  memset(r, 0, sizeof *r);
  size_t length = recipe_file_length(name);
  bool ok;
  if (length > 0) {
    r->file = strndup(name, length);
    ok = r->file ? recipe_read_file(r, r->file, why) : out_of_memory(why);
    if (ok && name[length]) ok = apply_overrides(r, name + length + 1, why);
  } else
    ok = set_string(&r->material, name, why);
  if (!ok) recipe_free(r);
  return ok;
}

void recipe_free(recipe *r) {
  for (size_t i = 0; i < r->param_count; i++) {
    free(r->params[i].id);
    free(r->params[i].text);
    free(r->params[i].file);
  }
  free(r->params);
  free(r->file);
  free(r->material);
  free(r->preset);
  free(r->surface.mesh);
  recipe_image_free(&r->image);
  memset(r, 0, sizeof *r);
}

/* The material that has a preset of that name, or NULL. */
static const sozai_texture_info *preset_owner(const sozai_textures_1 *textures, const char *name) {
  for (uint32_t i = 0; i < textures->count(); i++) {
    const sozai_texture_info *info = textures->info(i);
    for (uint32_t k = 0; k < info->preset_count; k++)
      if (strcmp(info->presets[k]->id, name) == 0) return info;
  }
  return NULL;
}

static bool has_preset(const sozai_generator_info *g, const char *name) {
  for (uint32_t k = 0; k < g->preset_count; k++)
    if (strcmp(g->presets[k]->id, name) == 0) return true;
  return false;
}

/* What the name is of, where it is no material's. */
static void add_hint(char hint[200], const recipe *r, const sozai_textures_1 *textures,
                     const sozai_geometry_1 *geometry) {
  const char *name = r->material;
  const sozai_texture_info *of = preset_owner(textures, name);
  if (of)
    snprintf(hint, 200,
             r->file ? ", which is a preset: material: %s, preset: %.80s"
                     : ", which is a preset: %s --preset %.80s",
             of->id, name);
  for (uint32_t i = 0; !of && geometry && i < geometry->count(); i++) {
    const sozai_generator_info *g = geometry->info(i);
    if (strcmp(g->id, name) == 0)
      snprintf(hint, 200, ", which is grown: sozai grow %.80s", name);
    else if (has_preset(g, name))
      snprintf(hint, 200, ", which is grown: sozai grow %.80s --preset %.80s", g->id, name);
  }
}

const sozai_texture_info *recipe_info(const recipe *r, const sozai_textures_1 *textures,
                                      const sozai_geometry_1 *geometry, failure *why) {
  const sozai_texture_info *info = textures->find(r->material);
  if (info) return info;
  char known[512] = "";
  for (uint32_t i = 0; i < textures->count(); i++) {
    size_t used = strlen(known);
    snprintf(known + used, sizeof known - used, "%s%s", i ? ", " : "", textures->info(i)->id);
  }
  char hint[200] = "";
  add_hint(hint, r, textures, geometry);
  fail(why, EXIT_BAD_INPUT, "%s%sunknown material '%s'%s; there is %s", r->file ? r->file : "",
       r->file ? ": " : "", r->material, hint, known);
  return NULL;
}

static sozai_value value_of(const recipe_param *p) {
  return (sozai_value){.id = p->id, .kind = SOZAI_KIND_STRING, .text = p->text};
}

static bool is_path(const sozai_texture_info *info, const char *id) {
  const sozai_parameter *p = parameter_of(info, id);
  return p && (p->kind == SOZAI_KIND_PATH || p->kind == SOZAI_KIND_IMAGE);
}

/* Relative paths from their file's own folder. What is whole stays as it is. */
static bool settle_paths(recipe *r, const sozai_texture_info *info, failure *why) {
  for (size_t i = 0; i < r->param_count; i++) {
    recipe_param *p = &r->params[i];
    const char *slash = p->file ? strrchr(p->file, '/') : NULL;
    if (!slash || !*p->text || *p->text == '/' || p->settled || !is_path(info, p->id)) continue;
    size_t folder = (size_t)(slash + 1 - p->file);
    /* " @ " begins an image's options: one in the folder's name must not */
    const char *end = strstr(p->file, " @ ") && !strstr(p->text, " @ ") ? " @ " : "";
    size_t size = folder + strlen(p->text) + strlen(end) + 1;
    char *path = malloc(size);
    if (!path) return out_of_memory(why);
    snprintf(path, size, "%.*s%s%s", (int)folder, p->file, p->text, end);
    free(p->text);
    p->text = path;
    p->settled = true; /* the folder may be relative itself */
  }
  return true;
}

bool recipe_settle(recipe *r, const sozai_textures_1 *textures, failure *why) {
  const sozai_texture_info *info = recipe_info(r, textures, NULL, why);
  return info && settle_paths(r, info, why);
}

bool recipe_is_text(const recipe *r, failure *why) {
  for (size_t i = 0; i < r->param_count; i++)
    if (!utf8_whole(r->params[i].text))
      return fail(why, EXIT_BAD_INPUT, "%s: not UTF-8, which a .sozai file is", r->params[i].id);
  return true;
}

/* What the user can mend by asking for something else. */
static int exit_code_of(int32_t result) {
  switch (result) {
  case SOZAI_ERROR_UNKNOWN:
  case SOZAI_ERROR_KIND:
  case SOZAI_ERROR_RANGE:
  case SOZAI_ERROR_LIMIT:
  case SOZAI_ERROR_FILE:
  case SOZAI_ERROR_COLOUR:
  case SOZAI_ERROR_UNSUPPORTED: /* an instruction set, by SOZAI_CPU */
    return EXIT_BAD_INPUT;
  default:
    return EXIT_FAILURE;
  }
}

/* create() names the parameter but cannot know its line: try the file's values
 * one by one, and take the first that is refused alone. */
static const recipe_param *find_culprit(const recipe *r, const sozai_textures_1 *textures,
                                        const sozai_host *host, int32_t result) {
  for (size_t i = 0; i < r->param_count; i++) {
    if (r->params[i].line == 0 || !r->params[i].file) continue;
    sozai_value value = value_of(&r->params[i]);
    sozai_texture *texture = NULL;
    int32_t alone = textures->create(host, r->material, NULL, &value, 1, &texture);
    if (alone == SOZAI_OK) textures->destroy(texture);
    if (alone == result) return &r->params[i];
  }
  return NULL;
}

/* Where a colour could not be read: how one is written. */
static void add_colour_forms(const recipe *r, const sozai_textures_1 *textures, failure *why) {
  const sozai_texture_info *info = textures->find(r->material);
  for (size_t i = 0; info && i < r->param_count; i++) {
    const sozai_parameter *p = parameter_of(info, r->params[i].id);
    size_t length = strlen(r->params[i].id);
    if (!p || p->kind != SOZAI_KIND_COLOUR || strncmp(why->text, p->id, length) != 0 ||
        why->text[length] != ':')
      continue;
    fail(why, why->exit_code,
         "%s; a colour is \"#rrggbb\" (in a file in quotes: # begins a comment) or r g b, in %s "
         "unless @ SPACE follows",
         why->text, p->default_text ? p->default_text : "sRGB");
    return;
  }
}

static bool explain(const recipe *r, const sozai_textures_1 *textures, const sozai_host *host,
                    int32_t result, failure *why) {
  const char *reason = textures->last_error();
  fail(why, exit_code_of(result), "%s", reason && *reason ? reason : "the plugin gave no reason");
  if (result == SOZAI_ERROR_KIND) add_colour_forms(r, textures, why);
  if (!r->file || exit_code_of(result) != EXIT_BAD_INPUT) return false;
  char text[sizeof why->text];
  memcpy(text, why->text, sizeof text);
  const recipe_param *culprit = find_culprit(r, textures, host, result);
  if (culprit) return fail(why, EXIT_BAD_INPUT, "%s:%d: %s", culprit->file, culprit->line, text);
  return fail(why, EXIT_BAD_INPUT, "%s: %s", r->file, text);
}

bool recipe_create(recipe *r, const sozai_textures_1 *textures, const sozai_host *host,
                   sozai_texture **out, failure *why) {
  *out = NULL;
  if (!recipe_settle(r, textures, why)) return false;
  sozai_value *values = calloc(r->param_count + 1, sizeof *values);
  if (!values) return out_of_memory(why);
  for (size_t i = 0; i < r->param_count; i++) values[i] = value_of(&r->params[i]);
  int32_t result =
      textures->create(host, r->material, r->preset, values, (uint32_t)r->param_count, out);
  free(values);
  return result == SOZAI_OK || explain(r, textures, host, result, why);
}
