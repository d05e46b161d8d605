/* SPDX-License-Identifier: Apache-2.0 */
#include "subject.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include "verdict.h"

bool subject_load(subject *s) {
  doing("dlopen");
  s->library = dlopen(s->path, RTLD_NOW | RTLD_LOCAL);
  if (!s->library) return failed("dlopen: %s", dlerror()), false;
  s->entry = dlsym(s->library, SOZAI_ENTRY_SYMBOL);
  if (!s->entry) return failed("it exports no " SOZAI_ENTRY_SYMBOL), false;
  if (s->entry->abi_major != SOZAI_ABI_MAJOR)
    return failed("its ABI is %u, not %u", s->entry->abi_major, SOZAI_ABI_MAJOR), false;
  return true;
}

void subject_tables(subject *s) {
  doing("get_factory");
  s->textures = s->entry->get_factory(SOZAI_TEXTURES_1);
  s->geometry = s->entry->get_factory(SOZAI_GEOMETRY_1);
  s->wood = s->entry->get_factory(SOZAI_WOOD_1);
}

bool subject_start(subject *s) {
  if (!subject_load(s)) return false;
  doing("init");
  int32_t r = s->entry->init(s->path);
  if (r != SOZAI_OK) return failed("init gave %s", result_name(r)), false;
  subject_tables(s);
  doing("the check itself");
  return true;
}

void subject_stop(subject *s) {
  if (s->textures || s->geometry) {
    doing("deinit");
    s->entry->deinit();
  }
  s->textures = NULL;
  s->geometry = NULL;
  s->wood = NULL;
  doing("dlclose");
  if (s->library) dlclose(s->library);
  s->library = NULL;
  s->entry = NULL;
}

bool subject_wants(const subject *s, const char *id) {
  return !s->texture || (id && strcmp(s->texture, id) == 0);
}

/* SplitMix64. */
uint64_t chance_bits(subject *s) {
  verdict_chance();
  uint64_t z = s->chance += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

uint32_t chance_below(subject *s, uint32_t n) {
  return n ? (uint32_t)((chance_bits(s) >> 32) * n >> 32) : 0;
}

double chance_between(subject *s, double low, double high) {
  return low + (high - low) * ((double)(chance_bits(s) >> 11) * 0x1p-53);
}

uint32_t subject_kinds(const subject *s, kind *out) {
  uint32_t n = 0;
  uint32_t textures = s->textures ? s->textures->count() : 0;
  for (uint32_t i = 0; i < textures && n < KINDS_MOST; i++) {
    const sozai_texture_info *t = s->textures->info(i);
    if (!t || !subject_wants(s, t->id)) continue;
    out[n++] = (kind){.id = t->id,
                      .what = "texture",
                      .size = t->size,
                      .size_known = sizeof *t,
                      .revision = t->revision,
                      .label = t->label,
                      .doc = t->doc,
                      .parameters = t->parameters,
                      .presets = t->presets,
                      .parameter_count = t->parameter_count,
                      .preset_count = t->preset_count,
                      .texture = t};
  }
  uint32_t generators = s->geometry ? s->geometry->count() : 0;
  for (uint32_t i = 0; i < generators && n < KINDS_MOST; i++) {
    const sozai_generator_info *g = s->geometry->info(i);
    if (!g || !subject_wants(s, g->id)) continue;
    out[n++] = (kind){.id = g->id,
                      .what = "generator",
                      .size = g->size,
                      .size_known = sizeof *g,
                      .revision = g->revision,
                      .label = g->label,
                      .doc = g->doc,
                      .parameters = g->parameters,
                      .presets = g->presets,
                      .parameter_count = g->parameter_count,
                      .preset_count = g->preset_count,
                      .generator = g};
  }
  return n;
}

uint32_t subject_all(subject *s, kind *out) { return subject_start(s) ? subject_kinds(s, out) : 0; }

uint32_t subject_textures(subject *s, kind *out) {
  if (!subject_start(s)) return 0;
  uint32_t n = subject_kinds(s, out), kept = 0;
  for (uint32_t i = 0; i < n; i++)
    if (out[i].texture) out[kept++] = out[i];
  if (!kept) skipped("it has no texture");
  return kept;
}

const char *last_error(const subject *s) {
  const char *text = s->textures ? s->textures->last_error() : s->geometry->last_error();
  return text ? text : "(last_error gave NULL)";
}

const char *result_name(int32_t result) {
  static const char *const names[] = {"SOZAI_OK",
                                      "SOZAI_ERROR_ARGUMENT (-1)",
                                      "SOZAI_ERROR_UNKNOWN (-2)",
                                      "SOZAI_ERROR_KIND (-3)",
                                      "SOZAI_ERROR_RANGE (-4)",
                                      "SOZAI_ERROR_MEMORY (-5)",
                                      "SOZAI_ERROR_UNSUPPORTED (-6)",
                                      "SOZAI_ERROR_CANCELLED (-7)",
                                      "SOZAI_ERROR_FILE (-8)",
                                      "SOZAI_ERROR_COLOUR (-9)",
                                      "SOZAI_ERROR_STATE (-10)",
                                      "SOZAI_ERROR_LIMIT (-11)"};
  if (result <= 0 && result > -(int32_t)COUNT_OF(names)) return names[-result];
  static _Thread_local char text[40];
  snprintf(text, sizeof text, "the unknown result %d", (int)result);
  return text;
}

const char *kind_name(uint32_t kind) {
  static const char *const names[] = {"STRING", "FLOAT", "INT",  "BOOL",   "CHOICE", "FLOAT3",
                                      "COLOUR", "TEXT",  "PATH", "BUFFER", "IMAGE"};
  return kind < COUNT_OF(names) ? names[kind] : "unknown";
}

const char *texture_name(const sozai_texture_info *info, const char *preset) {
  static _Thread_local char text[200];
  if (preset)
    snprintf(text, sizeof text, "%s, preset %s", info->id, preset);
  else
    snprintf(text, sizeof text, "%s", info->id);
  return text;
}

static void one_texture(subject *s, const sozai_texture_info *info, const char *preset,
                        texture_test *test) {
  sozai_texture *t = NULL;
  doing("create of %s", texture_name(info, preset));
  /* What cannot be made is the business of create.default and values.presets. */
  if (s->textures->create(NULL, info->id, preset, NULL, 0, &t) != SOZAI_OK || !t) return;
  doing("%s", texture_name(info, preset));
  test(s, info, preset, t);
  doing("destroy of %s", texture_name(info, preset));
  s->textures->destroy(t);
}

void each_texture(subject *s, uint32_t presets, texture_test *test) {
  if (!s->textures) {
    skipped("it has no " SOZAI_TEXTURES_1);
    return;
  }
  uint32_t n = s->textures->count();
  for (uint32_t i = 0; i < n && !enough(); i++) {
    const sozai_texture_info *info = s->textures->info(i);
    if (!info || !subject_wants(s, info->id)) continue;
    one_texture(s, info, NULL, test);
    bool all = s->thorough || presets >= info->preset_count;
    uint32_t count = all ? info->preset_count : presets;
    for (uint32_t k = 0; k < count && !enough(); k++) {
      uint32_t p = all ? k : chance_below(s, info->preset_count);
      one_texture(s, info, info->presets[p]->id, test);
    }
  }
}

void start_each_texture(subject *s, uint32_t presets, texture_test *test) {
  if (subject_start(s)) each_texture(s, presets, test);
}
