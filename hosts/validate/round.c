/* SPDX-License-Identifier: Apache-2.0 */
#include "round.h"

#include <string.h>

#include "batch.h"
#include "geometry.h"
#include "make.h"

static kind kinds[KINDS_MOST];

static void texture_calls(subject *s, const kind *k, const char *preset, watcher *watch) {
  sozai_texture *t = NULL, *none = NULL;
  const sozai_texture_info *info = k->texture;
  batch *b = batch_new(s, info, preset, 300);
  doing("create of %s", texture_name(info, preset));
  int32_t r = s->textures->create(NULL, info->id, preset, NULL, 0, &t);
  watch("create");
  if (!b || r != SOZAI_OK) return batch_free(b);
  doing("evaluate of %s", b->name);
  s->textures->evaluate(t, &b->abi);
  watch("evaluate");
  batch_from(b, 0, 1);
  s->textures->evaluate(t, &b->abi);
  watch("evaluate of one point");
  batch_give(b, 0);
  s->textures->evaluate(t, &b->abi);
  watch("evaluate without inputs");
  s->textures->last_error();
  watch("last_error");
  sozai_value v;
  for (uint32_t p = 0; p < k->parameter_count; p++) s->textures->value(t, k->parameters[p]->id, &v);
  watch("value");
  s->textures->value(t, "validate_none", &v);
  watch("value of an unknown parameter");
  s->textures->info_of(t);
  s->textures->bytes(t);
  s->textures->instruction_set(t);
  watch("info_of, bytes, instruction_set");
  if (s->wood && b) {
    float x[2] = {1, 2}, y[2] = {0, 0}, z[2] = {0, 0}, out[2];
    s->wood->ring_radius(t, 2, x, y, z, out);
    s->wood->pith(t, 2, x, y, out);
    watch("ring_radius, pith");
  }
  doing("destroy of %s", b->name);
  s->textures->destroy(t);
  watch("destroy");
  s->textures->create(NULL, info->id, "validate: none", NULL, 0, &none);
  watch("create of an unknown preset");
  batch_free(b);
}

/* Values as numbers, as text, and wrong ones: reading and writing of numbers. */
static void value_calls(subject *s, const kind *k, watcher *watch) {
  static bad wrong[BAD_MOST];
  for (uint32_t p = 0; p < k->parameter_count; p++) {
    sozai_value v;
    given text;
    made m;
    if (k->texture && p % 8 == 0 && make_good(s, k->parameters[p], &v) &&
        make_text(k->parameters[p], &v, &text)) {
      if (make(s, k, NULL, NULL, &text.value, 1, &m) == SOZAI_OK) unmake(s, &m);
      watch("create with a value as text");
    }
    uint32_t n = make_bad(k->parameters[p], wrong);
    for (uint32_t i = 0; i < n; i++)
      if (strcmp(wrong[i].what, "text that is NULL") == 0)
        continue; /* the business of refuse.null-text */
      else if (make(s, k, NULL, NULL, &wrong[i].value, 1, &m) == SOZAI_OK)
        unmake(s, &m);
    watch("refused values");
  }
}

void every_call(subject *s, bool grow, watcher *watch) {
  doing("init");
  if (s->entry->init(s->path) != SOZAI_OK) return failed("init failed");
  watch("init");
  subject_tables(s);
  watch("get_factory");
  uint32_t n = subject_kinds(s, kinds);
  if (s->textures) s->textures->find("validate: none");
  if (s->geometry) s->geometry->find("validate: none");
  watch("count, info, find");
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    if (k->texture) {
      texture_calls(s, k, NULL, watch);
      if (k->preset_count)
        texture_calls(s, k, k->presets[chance_below(s, k->preset_count)]->id, watch);
    } else if (grow) {
      grown g;
      if (grow_plain(s, k->generator, NULL, &g) == SOZAI_OK) {
        const sozai_detail coarse = {.size = sizeof coarse, .level = 3};
        const sozai_mesh *mesh = NULL;
        const sozai_curves *curves = NULL;
        watch("grow");
        s->geometry->mesh(g.geometry, &coarse, &mesh);
        watch("mesh");
        s->geometry->curves(g.geometry, NULL, &curves);
        watch("curves");
        s->geometry->release_mesh(mesh);
        s->geometry->release_curves(curves);
        s->geometry->release(g.geometry);
        watch("release");
      }
    }
    value_calls(s, k, watch);
  }
  doing("deinit");
  s->entry->deinit();
  watch("deinit");
  s->textures = NULL;
  s->geometry = NULL;
  s->wood = NULL;
}
