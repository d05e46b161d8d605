/* SPDX-License-Identifier: Apache-2.0 */
#include "outputs.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "channel.h"
#include "ending.h"
#include "evaluate.h"

#define SEEN_BY (SOZAI_INPUT_LIGHT | SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW)

static bool out_of_memory(failure *why) { return fail(why, EXIT_FAILURE, "out of memory"); }

/* ---- what a channel is ------------------------------------------------------- */

static bool is_colour(const sozai_channel *c) {
  return c->components == 3 && strcmp(c->suffixes, "rgb") == 0;
}

/* Integers stand for 0 to 1: colours, shares and directions fit, lengths and ids do not. */
static bool fits_integers(const sozai_channel *c) {
  return is_colour(c) || channel_is_axis(c) ||
         (c->components == 1 && !*c->unit && !channel_is_id(c));
}

/* ---- the format ----------------------------------------------------------------- */

static bool choose_format(bake_outputs *o, const bake_choice *choice, failure *why) {
  static const struct {
    const char *ending;
    int format;
  } known[] = {{".exr", BAKE_EXR}, {".tif", BAKE_TIFF}, {".tiff", BAKE_TIFF}, {".png", BAKE_PNG}};
  for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
    if (ends_in(choice->path, known[i].ending)) {
      o->format = known[i].format;
      uint32_t b = choice->bits;
      if (b == 0 || b == 16 || (b == 8 && o->format != BAKE_EXR) ||
          (b == 32 && o->format != BAKE_PNG))
        return true;
      return fail(why, EXIT_BAD_INPUT, "--bits: %u is not %s", b,
                  o->format == BAKE_EXR   ? "16 or 32, which EXR has"
                  : o->format == BAKE_PNG ? "8 or 16, which PNG has"
                                          : "8, 16 or 32, which TIFF has");
    }
  return fail(why, EXIT_BAD_INPUT, "--output: '%s' does not end in .exr, .tif or .png",
              choice->path);
}

static bool integers_asked(const bake_outputs *o, const bake_choice *choice) {
  return o->format != BAKE_EXR && choice->bits != 32;
}

/* What goes past a half stays float, whatever is asked of an EXR. */
static int type_of(const bake_outputs *o, const bake_choice *choice, const sozai_channel *c) {
  if (o->format == BAKE_EXR) {
    bool half = choice->bits == 16 ? channel_fits_half(c) : choice->bits == 0 && is_colour(c);
    return half ? IMAGE_HALF : IMAGE_FLOAT;
  }
  if (choice->bits == 32) return IMAGE_FLOAT;
  if (choice->bits == 16 || (choice->bits == 0 && o->format == BAKE_TIFF)) return IMAGE_UINT16;
  return IMAGE_UINT8;
}

static bool integers(int type) { return type == IMAGE_UINT8 || type == IMAGE_UINT16; }

uint32_t bake_type_bytes(int type) { return type == IMAGE_UINT8 ? 1 : type == IMAGE_FLOAT ? 4 : 2; }

/* ---- which channels --------------------------------------------------------------- */

static const sozai_channel *find(const sozai_texture_info *info, const char *name, failure *why) {
  char known[512] = "";
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *c = info->channels[i];
    if (strcmp(c->id, name) == 0) return c;
    size_t used = strlen(known);
    if (!(c->needs & SEEN_BY))
      snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", c->id);
  }
  fail(why, EXIT_BAD_INPUT, "--outputs: %s has no output '%.80s'; there is %s", info->id, name,
       known);
  return NULL;
}

static bool check(const sozai_channel *c, bool whole, failure *why) {
  if (c->needs & SEEN_BY)
    return fail(why, EXIT_BAD_INPUT,
                "--outputs: '%s' depends on light or view, and cannot be baked", c->id);
  if (c->first + c->components > SURFACE_COMPONENTS)
    return fail(why, EXIT_FAILURE, "--outputs: '%s' is past the %d numbers that can be baked",
                c->id, SURFACE_COMPONENTS);
  if (whole && !fits_integers(c))
    return fail(why, EXIT_BAD_INPUT,
                "--outputs: '%s'%s%s does not lie between 0 and 1; bake it to an EXR, or a TIFF of "
                "--bits 32",
                c->id, *c->unit ? ", in " : "", c->unit);
  return true;
}

/* all[] has room for as many as the texture has. */
static bool choose_named(const sozai_texture_info *info, const char *names,
                         const sozai_channel **all, uint32_t *count, failure *why) {
  char *copy = strdup(names), *rest = copy;
  bool ok = copy || out_of_memory(why);
  for (char *name; ok && (name = strsep(&rest, ","));) {
    const sozai_channel *c = find(info, name, why);
    ok = c != NULL;
    for (uint32_t i = 0; ok && i < *count; i++)
      if (all[i] == c) ok = fail(why, EXIT_BAD_INPUT, "--outputs: '%s' stands twice", name);
    if (ok) all[(*count)++] = c;
  }
  free(copy);
  return ok;
}

static void choose_usual(const bake_outputs *o, const sozai_texture_info *info, bool whole,
                         bool set, const sozai_channel **all, uint32_t *count) {
  for (uint32_t i = 0; i < info->channel_count; i++) {
    const sozai_channel *c = info->channels[i];
    if (c->needs & SEEN_BY || (whole && !fits_integers(c))) continue;
    if (o->format != BAKE_EXR && !set && *count == 1) continue;
    all[(*count)++] = c;
  }
}

/* ---- files ------------------------------------------------------------------------- */

/* In one file of several: albedo is what any program shows as its colours, the
 * others are layers. In a file of its own a channel is its grey or its colours. */
static void name_layer(bake_layer *l, const sozai_channel *c, uint32_t k, bool alone) {
  static const char *const rgb[3] = {"R", "G", "B"};
  bool main = strcmp(c->id, "albedo") == 0 && is_colour(c);
  int suffix = (unsigned char)c->suffixes[c->components > 1 ? k : 0];
  if (main || (alone && c->components > 1))
    snprintf(l->name, sizeof l->name, "%s", rgb[k]);
  else if (alone)
    snprintf(l->name, sizeof l->name, "Y");
  else if (c->components == 1)
    snprintf(l->name, sizeof l->name, "%s", c->id);
  else
    snprintf(l->name, sizeof l->name, "%.60s.%c", c->id, is_colour(c) ? toupper(suffix) : suffix);
}

static void add_layers(bake_outputs *o, bake_file *f, const sozai_channel *c,
                       const bake_choice *choice, bool alone) {
  for (uint32_t k = 0; k < c->components; k++) {
    bake_layer *l = &f->layers[f->layer_count++];
    name_layer(l, c, k, alone);
    l->component = c->first + k;
    l->type = type_of(o, choice, c);
    bool tangent = choice->tangent && strcmp(c->id, "normal") == 0;
    l->code = is_colour(c)                                           ? BAKE_COLOUR
              : channel_is_axis(c) && (integers(l->type) || tangent) ? BAKE_DIRECTION
                                                                     : BAKE_PLAIN;
    f->pixel_bytes += bake_type_bytes(l->type);
    f->colours = f->colours || is_colour(c);
  }
}

static bool make_files(bake_outputs *o, const sozai_channel *const *all, uint32_t count,
                       const bake_choice *choice, bool set, failure *why) {
  if (!set && count > 1 && o->format != BAKE_EXR)
    return fail(why, EXIT_BAD_INPUT,
                "--output: '%s' holds one output; put <output> into the name for a file of each",
                choice->path);
  o->file_count = set ? count : 1;
  o->files = calloc(o->file_count, sizeof *o->files);
  for (uint32_t i = 0; o->files && i < o->file_count; i++) {
    bake_file *f = &o->files[i];
    f->layers = calloc(set ? 3 : 3 * (size_t)count, sizeof *f->layers);
    if (!f->layers) return out_of_memory(why);
    if (set || count == 1) f->output = set ? all[i]->id : NULL;
    if (set)
      add_layers(o, f, all[i], choice, true);
    else
      for (uint32_t k = 0; k < count; k++) add_layers(o, f, all[k], choice, count == 1);
    o->pixel_bytes += f->pixel_bytes;
  }
  return o->files || out_of_memory(why);
}

/* ---- colour ------------------------------------------------------------------------- */

static bool no_such_space(const colour *c, const char *space, failure *why) {
  char known[640] = "";
  const char *name;
  for (uint32_t i = 0;
       c->display && i < c->display->count(c->display->self, SOZAI_LIST_SPACES, NULL); i++)
    if (c->display->item(c->display->self, SOZAI_LIST_SPACES, NULL, i, &name, NULL) == SOZAI_OK) {
      size_t used = strlen(known);
      snprintf(known + used, sizeof known - used, "%s%s", used ? ", " : "", name);
    }
  return fail(why, EXIT_BAD_INPUT, "--space: the config has no colour space '%.80s'; there is %s",
              space, *known ? known : "none");
}

static bool choose_space(bake_outputs *o, const bake_choice *choice, failure *why) {
  const char *space = choice->space;
  if (!space && integers_asked(o, choice)) space = "sRGB";
  if (!space) return true;
  if (o->services->service && !o->services->service->has_space(o->services->service->self, space))
    return no_such_space(o->services, space, why);
  if (!o->services->service && strcasecmp(space, "sRGB") != 0)
    return fail(why, EXIT_FAILURE, "--space: there is no colour service to look '%.80s' up in",
                space);
  o->space = strdup(space);
  return o->space || out_of_memory(why);
}

bool bake_to_space(const bake_outputs *o, float *const rgb[3], uint32_t count, float *room,
                   failure *why) {
  if (!o->space) return true;
  for (uint32_t i = 0; i < count; i++)
    for (uint32_t k = 0; k < 3; k++) room[3 * (size_t)i + k] = rgb[k][i];
  const sozai_colour_1 *s = o->services->service;
  char message[512] = "";
  if (!s) {
    if (!display_apply(o->services, &(display_choice){0}, room, count, why)) return false;
  } else if (s->from_working(s->self, o->space, room, count, message, sizeof message) != SOZAI_OK)
    return fail(why, EXIT_FAILURE, "colour space '%s': %s", o->space, message);
  for (uint32_t i = 0; i < count; i++)
    for (uint32_t k = 0; k < 3; k++) rgb[k][i] = room[3 * (size_t)i + k];
  return true;
}

/* ---- all of it ------------------------------------------------------------------------ */

bool bake_outputs_open(bake_outputs *o, const sozai_texture_info *info, const bake_choice *choice,
                       const colour *c, failure *why) {
  memset(o, 0, sizeof *o);
  o->services = c;
  if (!choose_format(o, choice, why) || !choose_space(o, choice, why)) {
    bake_outputs_close(o);
    return false;
  }
  const sozai_channel **all = calloc(info->channel_count + 1, sizeof *all);
  uint32_t count = 0;
  bool set = strstr(choice->path, "<output>") != NULL;
  bool whole = integers_asked(o, choice);
  bool ok = all || out_of_memory(why);
  if (ok && choice->names)
    ok = choose_named(info, choice->names, all, &count, why);
  else if (ok)
    choose_usual(o, info, whole, set, all, &count);
  for (uint32_t i = 0; ok && i < count; i++) ok = check(all[i], whole, why);
  if (ok && count == 0) ok = fail(why, EXIT_BAD_INPUT, "%s has nothing to bake", info->id);
  ok = ok && make_files(o, all, count, choice, set, why);
  free(all);
  if (!ok) bake_outputs_close(o);
  return ok;
}

void bake_outputs_close(bake_outputs *o) {
  for (uint32_t i = 0; o->files && i < o->file_count; i++) free(o->files[i].layers);
  free(o->files);
  free(o->space);
  memset(o, 0, sizeof *o);
}
