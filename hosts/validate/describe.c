/* SPDX-License-Identifier: Apache-2.0
 * What it says of itself: kinds and their names. Descriptions that stay are judged
 * in describe_stable.c, parameters, presets and what is made in files of theirs. */
#include "describe.h"

#include <stdio.h>
#include <string.h>

#include "groups.h"
#include "text.h"

static kind kinds[KINDS_MOST];

/* ---- kinds ---------------------------------------------------------------- */

/* "The index-th kind, or NULL." */
static void listed(subject *s) {
  if (!subject_start(s)) return;
  static const uint32_t past[] = {0, 1, 1000, INT32_MAX, UINT32_MAX - 1};
  if (s->textures) {
    uint32_t n = s->textures->count();
    EXPECT(n > 0, "count() of textures is 0");
    for (uint32_t i = 0; i < n; i++)
      EXPECT(s->textures->info(i), "info(%u) of textures is NULL, of %u", i, n);
    for (uint32_t i = 0; i < COUNT_OF(past); i++) {
      doing("info(%u) of %u textures", n + past[i], n);
      if (past[i] <= UINT32_MAX - n)
        EXPECT(!s->textures->info(n + past[i]), "info(%u) of %u textures is not NULL", n + past[i],
               n);
    }
  }
  if (s->geometry) {
    uint32_t n = s->geometry->count();
    EXPECT(n > 0, "count() of generators is 0");
    for (uint32_t i = 0; i < n; i++)
      EXPECT(s->geometry->info(i), "info(%u) of generators is NULL, of %u", i, n);
    for (uint32_t i = 0; i < COUNT_OF(past); i++) {
      doing("info(%u) of %u generators", n + past[i], n);
      if (past[i] <= UINT32_MAX - n)
        EXPECT(!s->geometry->info(n + past[i]), "info(%u) of %u generators is not NULL",
               n + past[i], n);
    }
  }
}

static const void *find_kind(const subject *s, const kind *k, const char *id) {
  return k->texture ? (const void *)s->textures->find(id) : (const void *)s->geometry->find(id);
}

/* "The kind of that id, or NULL." */
static void found(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    const void *info = k->texture ? (const void *)k->texture : (const void *)k->generator;
    EXPECT(find_kind(s, k, k->id) == info, "find(\"%s\") is not the %s of that id", k->id, k->what);
    static const char *const around[][2] = {{"", " "}, {" ", ""}, {"", "~"}, {"", "/"}, {"~", ""}};
    for (uint32_t f = 0; f < COUNT_OF(around); f++) {
      char other[300];
      snprintf(other, sizeof other, "%s%.200s%s", around[f][0], k->id, around[f][1]);
      doing("find(\"%s\")", other);
      EXPECT(!find_kind(s, k, other), "find(\"%s\") is not NULL", other);
    }
    EXPECT(!find_kind(s, k, ""), "find(\"\") of a %s is not NULL", k->what);
  }
}

void described_text(const char *where, const char *id, const char *what, const char *text,
                    bool may_be_empty) {
  if (!EXPECT(text, "%s %s: its %s is NULL", where, id, what)) return;
  EXPECT(may_be_empty || *text, "%s %s: its %s is empty", where, id, what);
  EXPECT(utf8_valid(text), "%s %s: its %s is not UTF-8", where, id, what);
}

static void strings(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    described_text(k->what, k->id ? k->id : "?", "id", k->id, false);
    described_text(k->what, k->id, "label", k->label, false);
    described_text(k->what, k->id, "doc", k->doc, false);
    EXPECT(k->revision > 0, "%s %s: revision is 0", k->what, k->id);
    for (uint32_t p = 0; p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      if (!EXPECT(q, "%s %s: parameter %u is NULL", k->what, k->id, p)) continue;
      described_text("parameter", q->id ? q->id : "?", "id", q->id, false);
      described_text("parameter", q->id, "label", q->label, false);
      described_text("parameter", q->id, "group", q->group, true);
      described_text("parameter", q->id, "unit", q->unit, true);
      described_text("parameter", q->id, "doc", q->doc, false);
    }
    for (uint32_t p = 0; p < k->preset_count; p++) {
      const sozai_preset *q = k->presets[p];
      if (!EXPECT(q, "%s %s: preset %u is NULL", k->what, k->id, p)) continue;
      described_text("preset", q->id ? q->id : "?", "id", q->id, false);
      described_text("preset", q->id, "label", q->label, false);
      described_text("preset", q->id, "doc", q->doc, true);
      described_text("preset", q->id, "source", q->source, true);
    }
    for (uint32_t c = 0; k->texture && c < k->texture->channel_count; c++) {
      const sozai_channel *h = k->texture->channels[c];
      if (!EXPECT(h, "%s %s: channel %u is NULL", k->what, k->id, c)) continue;
      described_text("channel", h->id ? h->id : "?", "id", h->id, false);
      described_text("channel", h->id, "unit", h->unit, true);
      described_text("channel", h->id, "suffixes", h->suffixes, true);
      described_text("channel", h->id, "doc", h->doc, false);
    }
  }
}

static void unique_in(const char *where, const char *what, uint32_t n,
                      const char *(*id)(const kind *k, uint32_t i), const kind *k) {
  asked();
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t j = 0; j < i; j++)
      if (id(k, i) && id(k, j) && strcmp(id(k, i), id(k, j)) == 0)
        failed("%s: %s %u and %u are both called %s", where, what, j, i, id(k, i));
}

static const char *parameter_id(const kind *k, uint32_t i) { return k->parameters[i]->id; }
static const char *preset_id(const kind *k, uint32_t i) { return k->presets[i]->id; }
static const char *channel_id(const kind *k, uint32_t i) { return k->texture->channels[i]->id; }

/* Ids are what recipes and scene files name (docs/abi.md): each names one thing. */
static void unique(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    for (uint32_t j = 0; j < i; j++)
      if (!kinds[j].texture == !k->texture)
        EXPECT(strcmp(kinds[j].id, k->id) != 0, "two of a kind are called %s", k->id);
    unique_in(k->id, "parameters", k->parameter_count, parameter_id, k);
    unique_in(k->id, "presets", k->preset_count, preset_id, k);
    if (k->texture) unique_in(k->id, "channels", k->texture->channel_count, channel_id, k);
    for (uint32_t p = 0; p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      for (uint32_t a = 0; q->choices && a < q->choice_count; a++)
        for (uint32_t b = 0; b < a; b++)
          if (strcmp(q->choices[a], q->choices[b]) == 0)
            failed("%s: %s has two choices %s", k->id, q->id, q->choices[a]);
    }
  }
}

/* "lower_case, stable for ever" of a parameter's id. Of others: they stand in files, and on
 * command lines. */
static void ids(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    EXPECT(id_valid(k->id, "-."), "%s '%s' is not lower_case", k->what, k->id);
    for (uint32_t p = 0; p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      EXPECT(id_valid(q->id, ""), "%s: parameter '%s' is not lower_case", k->id, q->id);
      for (uint32_t c = 0; q->choices && c < q->choice_count; c++)
        EXPECT(*q->choices[c] && one_line(q->choices[c]) && utf8_valid(q->choices[c]),
               "%s: %s has a choice '%s'", k->id, q->id, q->choices[c]);
    }
    for (uint32_t p = 0; p < k->preset_count; p++)
      EXPECT(*k->presets[p]->id && one_line(k->presets[p]->id) &&
                 !strpbrk(k->presets[p]->id, " \t"),
             "%s: preset '%s' has blanks", k->id, k->presets[p]->id);
    for (uint32_t c = 0; k->texture && c < k->texture->channel_count; c++)
      EXPECT(id_valid(k->texture->channels[c]->id, ""), "%s: channel '%s' is not lower_case", k->id,
             k->texture->channels[c]->id);
  }
}

CHECKS(describe, //
       {"describe.listed", "version.complete",
        "there are as many kinds as count() says, and NULL past them", listed},
       {"describe.found", "describe.listed",
        "find() gives a kind by its id, and nothing by another", found},
       {"describe.strings", "describe.listed",
        "no text is NULL, none but units, groups, presets' docs empty, all UTF-8", strings},
       {"describe.unique", "describe.strings", "no id is given twice", unique},
       {"describe.ids", "describe.strings",
        "ids are lower_case and fit for files and command lines", ids},
       {"describe.stable", "create.default", "descriptions keep their address and content",
        describe_stable},
       {"describe.parameter-kinds", "describe.strings", "parameters are of known kinds",
        describe_parameter_kinds},
       {"describe.ranges", "describe.strings", "ranges are ordered, sliders within them",
        describe_ranges},
       {"describe.defaults", "describe.strings",
        "defaults are within their ranges and of their kind", describe_defaults},
       {"describe.choices", "describe.strings",
        "choices have ids, phrases and a default among them", describe_choices},
       {"describe.buffers", "describe.strings",
        "buffer_kind is set where a buffer is taken, and only there", describe_buffers},
       {"describe.groups", "describe.strings", "parameters of a group stand together",
        describe_groups},
       {"describe.presets", "describe.strings",
        "presets give known parameters values of their kind and range", describe_presets},
       {"describe.channels", "describe.strings",
        "channels have 1 to 3 components, suffixes and known inputs", describe_channels},
       {"describe.components", "describe.strings",
        "channels cover the components without overlap or gap", describe_components},
       {"describe.tables", "describe.strings",
        "tables of generators have ids and docs, their columns ids", describe_tables});
