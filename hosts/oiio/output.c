/* SPDX-License-Identifier: Apache-2.0 */
#include "output.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "channel.h"
#include "evaluate.h"

#define LIGHTING (SOZAI_INPUT_LIGHT | SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW)

static const char *const first_of_all[] = {"albedo",    "normal",   "height",
                                           "roughness", "specular", "fiber"};
#define FIRST_OF_ALL (sizeof first_of_all / sizeof first_of_all[0])

static bool is_colour(const sozai_channel *c) { return strcmp(c->suffixes, "rgb") == 0; }

static bool usable(const sozai_channel *c, bool solid) {
  return c->components <= OUTPUT_MOST_COMPONENTS &&
         c->first + c->components <= SURFACE_COMPONENTS && !(c->needs & LIGHTING) &&
         !(solid && c->needs & SOZAI_INPUT_NORMAL);
}

/* The names EXR files have: colours' suffixes upper case, vectors' lower; the
 * layer's name before them but for the plain ones. */
static void set_names(output *o, const sozai_channel *c, bool plain) {
  for (uint32_t k = 0; k < c->components; k++) {
    int suffix = (unsigned char)(c->components > 1 ? c->suffixes[k] : '\0');
    if (is_colour(c)) suffix = toupper(suffix);
    if (plain && is_colour(c))
      snprintf(o->names[k], sizeof o->names[k], "%c", suffix);
    else if (suffix)
      snprintf(o->names[k], sizeof o->names[k], "%.40s.%c", c->id, suffix);
    else
      snprintf(o->names[k], sizeof o->names[k], "%.60s", c->id);
  }
}

static void set(output *o, const sozai_channel *c, const recipe_image *image) {
  *o = (output){.id = c->id, .first = c->first, .components = c->components};
  o->colour = is_colour(c);
  o->half = image->format == RECIPE_FORMAT_HALF ? channel_fits_half(c)
                                                : image->format == RECIPE_FORMAT_AUTO && o->colour;
  o->encoded = image->normals == RECIPE_NORMALS_TANGENT && strcmp(c->id, "normal") == 0;
}

static const sozai_channel *find(const sozai_texture_info *info, const char *id, size_t length) {
  for (uint32_t i = 0; i < info->channel_count; i++)
    if (strlen(info->channels[i]->id) == length && strncmp(info->channels[i]->id, id, length) == 0)
      return info->channels[i];
  return NULL;
}

static bool refuse(const recipe *r, const char *id, size_t length, const char *what,
                   const sozai_texture_info *info, bool solid, failure *why) {
  char known[640] = "";
  for (uint32_t i = 0; i < info->channel_count; i++) {
    size_t used = strlen(known);
    if (usable(info->channels[i], solid))
      snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", info->channels[i]->id);
  }
  return fail(why, EXIT_BAD_INPUT, "%s: image: outputs: %s '%.*s'; there is %s", r->file, what,
              (int)(length < 40 ? length : 40), id, known);
}

static bool take_asked(output *out, uint32_t *count, const recipe *r,
                       const sozai_texture_info *info, bool solid, failure *why) {
  for (const char *at = r->image.outputs; *at;) {
    size_t length = strcspn(at, ",");
    const sozai_channel *c = find(info, at, length);
    if (!c) return refuse(r, at, length, "unknown output", info, solid, why);
    if (!usable(c, solid))
      return refuse(r, at, length,
                    c->needs & LIGHTING ? "a picture has no light for"
                                        : "a volume has no normal for",
                    info, solid, why);
    for (uint32_t k = 0; k < *count; k++)
      if (out[k].id == c->id) return refuse(r, at, length, "asked for twice:", info, solid, why);
    set(&out[*count], c, &r->image);
    (*count)++;
    at += length + (at[length] == ',');
  }
  return true;
}

static void take_all(output *out, uint32_t *count, const recipe *r, const sozai_texture_info *info,
                     bool solid) {
  for (size_t i = 0; i < FIRST_OF_ALL + info->channel_count; i++) {
    const char *id = i < FIRST_OF_ALL ? first_of_all[i] : info->channels[i - FIRST_OF_ALL]->id;
    const sozai_channel *c = find(info, id, strlen(id));
    if (!c || !usable(c, solid)) continue;
    uint32_t k = 0;
    while (k < *count && out[k].id != c->id) k++;
    if (k == *count) set(&out[(*count)++], c, &r->image);
  }
}

/* R, G, B, then what has no layer, then the layers. `depth` is what EXR files
 * also call Z, which stands before other names. */
static int group_of(const output *o) {
  if (strchr(o->names[0], '.')) return 3;
  return strlen(o->names[0]) == 1 ? 0 : strcmp(o->id, "depth") == 0 ? 1 : 2;
}

static int compare(const void *a, const void *b) {
  int x = group_of(a), y = group_of(b);
  return x != y ? x - y : strcmp(((const output *)a)->id, ((const output *)b)->id);
}

/* Plain R, G, B is what any program shows of a file: what stands first, and of
 * many in one subimage the albedo, wherever it stands, as `sozai bake` writes
 * it. There they stand as OpenImageIO's reader of EXR gives them, so that a
 * channel has the same number here and in a file baked of it. */
static void name_all(output *out, uint32_t count, const sozai_texture_info *info, bool single) {
  uint32_t plain = 0;
  for (uint32_t k = 0; single && k < count; k++)
    if (strcmp(out[k].id, "albedo") == 0) plain = k;
  for (uint32_t k = 0; k < count; k++)
    set_names(&out[k], find(info, out[k].id, strlen(out[k].id)), k == plain);
  if (single) qsort(out, count, sizeof *out, compare);
}

bool outputs_make(output **out, uint32_t *count, const recipe *r, const sozai_texture_info *info,
                  bool solid, failure *why) {
  *count = 0;
  *out = calloc(info->channel_count + 1, sizeof **out);
  if (!*out) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = true;
  if (r->image.outputs)
    ok = take_asked(*out, count, r, info, solid, why);
  else
    take_all(*out, count, r, info, solid);
  if (ok && *count == 0)
    ok = fail(why, EXIT_BAD_INPUT, "%s: the material has no output for a picture", r->file);
  if (ok) name_all(*out, *count, info, r->image.subimages == RECIPE_SUBIMAGES_SINGLE);
  if (!ok) {
    free(*out);
    *out = NULL;
  }
  return ok;
}

bool subimages_make(subimage **out, uint32_t *count, const output *outputs, uint32_t output_count,
                    bool single, failure *why) {
  *count = single ? 1 : output_count;
  *out = calloc(*count, sizeof **out);
  if (!*out) return fail(why, EXIT_FAILURE, "out of memory");
  for (uint32_t i = 0; i < *count; i++) {
    subimage *s = &(*out)[i];
    *s = (subimage){.outputs = outputs + i, .output_count = single ? output_count : 1};
    uint32_t halves = 0;
    for (uint32_t k = 0; k < s->output_count; k++) {
      s->components += s->outputs[k].components;
      halves += s->outputs[k].half;
    }
    s->half = halves == s->output_count;
    s->mixed = halves > 0 && !s->half;
  }
  return true;
}
