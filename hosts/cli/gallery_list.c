/* SPDX-License-Identifier: Apache-2.0 */
#include "gallery_list.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "recipe.h"

const char *shot_material(const shot *s) { return s->material ? s->material : "wood"; }

static bool gives(const sozai_preset *preset, const char *id) {
  for (uint32_t i = 0; i < preset->value_count; i++)
    if (strcmp(preset->values[i].id, id) == 0) return true;
  return false;
}

static bool is_of(const shot *s, const sozai_preset *preset) {
  if (s->with && !gives(preset, s->with)) return false;
  return !s->without || !gives(preset, s->without);
}

static void add_param(shot *s, const char *param) {
  for (int k = 0; k < SHOT_PARAMS; k++) {
    if (s->params[k]) continue;
    s->params[k] = param;
    return;
  }
}

/* The next one; where there is no room yet, it is only counted. */
static picture *add(picture_list *list, const shot *s, const shot *section) {
  uint32_t own = list->count++;
  if (!list->pictures) return NULL;
  picture *p = &list->pictures[own];
  p->shot = *s;
  p->section = section;
  p->preset = s->preset;
  snprintf(p->name, sizeof p->name, "%s", s->name);
  snprintf(p->title, sizeof p->title, "%s", s->title);
  return p;
}

static void make_own(picture *p, const shot *s, const sozai_texture_info *info, uint32_t i) {
  const sozai_preset *preset = info->presets[i];
  p->preset = preset->id;
  snprintf(p->name, sizeof p->name, "%s-%s", s->name, preset->id);
  snprintf(p->title, sizeof p->title, "%s, %s", preset->label, s->title);
  if (s->own_log && parameter_of(info, "seed")) {
    snprintf(p->seed, sizeof p->seed, "seed=%u", i + 1);
    add_param(&p->shot, p->seed);
  }
  if (s->aside > 0.0 && parameter_of(info, "cut_offset")) {
    /* as many to the left as to the right, and none after its like */
    double place = fmod(0.618034 * (i + 1), 1.0) * 2.0 - 1.0;
    snprintf(p->offset, sizeof p->offset, "cut_offset=%.1f 0 0", place * s->aside);
    add_param(&p->shot, p->offset);
  }
}

/* The `count` shots that every preset of a material has, of one preset after
 * another. */
static void add_of_each(picture_list *list, const shot *shots, uint32_t count, const shot *section,
                        const sozai_textures_1 *textures) {
  const sozai_texture_info *info = textures->find(shot_material(shots));
  for (uint32_t i = 0; info && i < info->preset_count; i++)
    for (const shot *s = shots; s < shots + count; s++) {
      if (!is_of(s, info->presets[i])) continue;
      picture *p = add(list, s, section);
      if (p) make_own(p, s, info, i);
    }
}

static void walk(picture_list *list, const sozai_textures_1 *textures, bool all) {
  const shot *end = gallery_shots + gallery_shot_count, *section = NULL;
  for (const shot *s = gallery_shots; s < end;) {
    uint32_t each = 0;
    if (s->heading) {
      section = s++;
      continue;
    }
    while (s + each < end && s[each].each_preset && s[each].more == s->more &&
           strcmp(shot_material(s + each), shot_material(s)) == 0)
      each++;
    if (all || !s->more) {
      if (each)
        add_of_each(list, s, each, section, textures);
      else
        add(list, s, section);
    }
    s += each ? each : 1;
  }
}

bool picture_list_make(picture_list *list, const sozai_textures_1 *textures, bool all,
                       failure *why) {
  *list = (picture_list){0};
  walk(list, textures, all);
  list->pictures = calloc(list->count ? list->count : 1, sizeof *list->pictures);
  if (!list->pictures) return fail(why, EXIT_FAILURE, "out of memory");
  list->count = 0;
  walk(list, textures, all);
  return true;
}

void picture_list_free(picture_list *list) {
  free(list->pictures);
  *list = (picture_list){0};
}
