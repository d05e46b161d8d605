/* SPDX-License-Identifier: Apache-2.0 */
#include "spaces.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- the config's own name --------------------------------------------- */

static const char *listed(const sozai_display_1 *d, uint32_t list, const char *name) {
  const char *item = NULL, *detail = NULL;
  for (uint32_t i = 0; i < d->count(d->self, list, NULL); i++)
    if (d->item(d->self, list, NULL, i, &item, &detail) == SOZAI_OK && strcasecmp(item, name) == 0)
      return list == SOZAI_LIST_ROLES ? detail : item;
  return NULL;
}

/* The contract lists no aliases: the listed space that converts as this one
 * does, to the bit, is what an alias stands for. */
static const char *same_space(const colour *c, const char *name) {
  const float probe[6] = {0.02f, 0.3f, 0.9f, 0.7f, 0.11f, 0.45f};
  float wanted[6], got[6];
  memcpy(wanted, probe, sizeof probe);
  if (c->service->to_working(c->service->self, name, wanted, 2, NULL, 0) != SOZAI_OK) return NULL;
  const sozai_display_1 *d = c->display;
  const char *item = NULL;
  for (uint32_t i = 0; i < d->count(d->self, SOZAI_LIST_SPACES, NULL); i++) {
    memcpy(got, probe, sizeof probe);
    if (d->item(d->self, SOZAI_LIST_SPACES, NULL, i, &item, NULL) == SOZAI_OK &&
        c->service->to_working(c->service->self, item, got, 2, NULL, 0) == SOZAI_OK &&
        memcmp(wanted, got, sizeof got) == 0)
      return item;
  }
  return NULL;
}

/* fallback: what to return for a name that the config has but does not list. */
static const char *resolve(const colour *c, const char *name, const char *fallback) {
  if (!c->service || !c->display) return strcasecmp(name, "sRGB") == 0 ? "sRGB" : NULL;
  if (c->service->has_space(c->service->self, name) != 1) return NULL;
  const char *own = listed(c->display, SOZAI_LIST_SPACES, name);
  if (!own) own = listed(c->display, SOZAI_LIST_ROLES, name);
  if (!own) own = same_space(c, name);
  return own ? own : fallback;
}

/* ---- collecting ---------------------------------------------------------- */

static bool append(char **text, const char *more, failure *why) {
  size_t used = strlen(*text);
  char *longer = realloc(*text, used + strlen(more) + 3);
  if (!longer) return fail(why, EXIT_FAILURE, "out of memory");
  *text = longer;
  strcpy(longer + used, ", ");
  strcpy(longer + used + 2, more);
  return true;
}

/* Whether `where` is the last of the list, which is made in order. */
static bool ends_with(const char *list, const char *where) {
  size_t length = strlen(list), tail = strlen(where);
  return length >= tail && strcmp(list + length - tail, where) == 0 &&
         (length == tail || list[length - tail - 1] == ' ');
}

static bool add(space_uses *u, const char *name, const char *where, const colour *c, failure *why) {
  for (size_t i = 0; i < u->count; i++)
    if (strcmp(u->items[i].name, name) == 0)
      return ends_with(u->items[i].where, where) || append(&u->items[i].where, where, why);
  space_use *more = realloc(u->items, (u->count + 1) * sizeof *more);
  if (!more) return fail(why, EXIT_FAILURE, "out of memory");
  u->items = more;
  space_use *use = &u->items[u->count++];
  *use = (space_use){.name = strdup(name), .where = strdup(where)};
  if (!use->name || !use->where) return fail(why, EXIT_FAILURE, "out of memory");
  use->resolved = resolve(c, name, use->name);
  return true;
}

void spaces_free(space_uses *u) {
  for (size_t i = 0; i < u->count; i++) {
    free(u->items[i].name);
    free(u->items[i].where);
  }
  free(u->items);
  memset(u, 0, sizeof *u);
}

/* ---- values ---------------------------------------------------------------- */

/* The space in "0.2 0.1 0.05 @ ACEScg" or "end.tif @ sRGB, wrap=mirror". */
static bool add_text(space_uses *u, const sozai_parameter *p, const char *text, const char *where,
                     const colour *c, failure *why) {
  const char *at = text ? strrchr(text, '@') : NULL;
  if (!at) /* a picture's space is then the config's file rules' */
    return p->kind != SOZAI_KIND_COLOUR || add(u, p->default_text, where, c, why);
  at += 1 + strspn(at + 1, " \t");
  size_t length = p->kind == SOZAI_KIND_IMAGE ? strcspn(at, ",") : strlen(at);
  while (length > 0 && (at[length - 1] == ' ' || at[length - 1] == '\t')) length--;
  char *name = strndup(at, length);
  if (!name) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = add(u, name, where, c, why);
  free(name);
  return ok;
}

static bool add_value(space_uses *u, const sozai_parameter *p, const sozai_value *v,
                      const char *where, const colour *c, failure *why) {
  if (v->kind == SOZAI_KIND_STRING || v->kind == SOZAI_KIND_IMAGE) {
    if (v->kind == SOZAI_KIND_IMAGE && v->buffer)
      return !v->buffer->colour_space || add(u, v->buffer->colour_space, where, c, why);
    return add_text(u, p, v->text, where, c, why);
  }
  return add(u, v->text && *v->text ? v->text : p->default_text, where, c, why);
}

static bool add_default(space_uses *u, const sozai_parameter *p, const char *where, const colour *c,
                        failure *why) {
  if (p->kind == SOZAI_KIND_COLOUR) return add(u, p->default_text, where, c, why);
  return add_text(u, p, p->default_text, where, c, why);
}

static bool has_space(const sozai_parameter *p) {
  return (p->kind == SOZAI_KIND_COLOUR && p->default_text) || p->kind == SOZAI_KIND_IMAGE;
}

bool spaces_of_texture(space_uses *u, const sozai_texture_info *info, const colour *c,
                       failure *why) {
  bool ok = true;
  for (uint32_t i = 0; ok && i < info->parameter_count; i++)
    if (has_space(info->parameters[i]))
      ok = add_default(u, info->parameters[i], "defaults", c, why);
  for (uint32_t i = 0; ok && i < info->preset_count; i++) {
    const sozai_preset *preset = info->presets[i];
    for (uint32_t k = 0; ok && k < preset->value_count; k++) {
      const sozai_parameter *p = parameter_of(info, preset->values[k].id);
      if (p && has_space(p)) ok = add_value(u, p, &preset->values[k], preset->id, c, why);
    }
  }
  return ok;
}

static const sozai_value *of_preset(const recipe *r, const sozai_texture_info *info,
                                    const char *id) {
  for (uint32_t i = 0; r->preset && i < info->preset_count; i++)
    for (uint32_t k = 0; k < info->presets[i]->value_count; k++)
      if (strcmp(info->presets[i]->id, r->preset) == 0 &&
          strcmp(info->presets[i]->values[k].id, id) == 0)
        return &info->presets[i]->values[k];
  return NULL;
}

bool spaces_of_recipe(space_uses *u, const recipe *r, const sozai_texture_info *info,
                      const colour *c, failure *why) {
  bool ok = true;
  for (uint32_t i = 0; ok && i < info->parameter_count; i++) {
    const sozai_parameter *p = info->parameters[i];
    if (!has_space(p)) continue;
    const recipe_param *given = NULL;
    for (size_t k = 0; k < r->param_count; k++)
      if (strcmp(r->params[k].id, p->id) == 0) given = &r->params[k];
    const sozai_value *preset = of_preset(r, info, p->id);
    if (given)
      ok = add_text(u, p, given->text, p->id, c, why);
    else
      ok = preset ? add_value(u, p, preset, p->id, c, why) : add_default(u, p, p->id, c, why);
  }
  return ok;
}
