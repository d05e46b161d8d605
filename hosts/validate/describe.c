/* SPDX-License-Identifier: Apache-2.0
 * What it says of itself: kinds, parameters, presets, channels, tables. */
#include <limits.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "batch.h"
#include "groups.h"
#include "text.h"

static kind kinds[KINDS_MOST];

static uint32_t start_kinds(subject *s) { return subject_start(s) ? subject_kinds(s, kinds) : 0; }

static bool has_range(uint32_t k) {
  return k == SOZAI_KIND_FLOAT || k == SOZAI_KIND_INT || k == SOZAI_KIND_FLOAT3 ||
         k == SOZAI_KIND_COLOUR;
}

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
  uint32_t n = start_kinds(s);
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

/* "Strings of this and the following descriptions are never NULL unless it says so." */
static void text_of(const char *where, const char *id, const char *what, const char *text,
                    bool may_be_empty) {
  if (!EXPECT(text, "%s %s: its %s is NULL", where, id, what)) return;
  EXPECT(may_be_empty || *text, "%s %s: its %s is empty", where, id, what);
  EXPECT(utf8_valid(text), "%s %s: its %s is not UTF-8", where, id, what);
}

static void strings(subject *s) {
  uint32_t n = start_kinds(s);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    text_of(k->what, k->id ? k->id : "?", "id", k->id, false);
    text_of(k->what, k->id, "label", k->label, false);
    text_of(k->what, k->id, "doc", k->doc, false);
    EXPECT(k->revision > 0, "%s %s: revision is 0", k->what, k->id);
    for (uint32_t p = 0; p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      if (!EXPECT(q, "%s %s: parameter %u is NULL", k->what, k->id, p)) continue;
      text_of("parameter", q->id ? q->id : "?", "id", q->id, false);
      text_of("parameter", q->id, "label", q->label, false);
      text_of("parameter", q->id, "group", q->group, true);
      text_of("parameter", q->id, "unit", q->unit, true);
      text_of("parameter", q->id, "doc", q->doc, false);
    }
    for (uint32_t p = 0; p < k->preset_count; p++) {
      const sozai_preset *q = k->presets[p];
      if (!EXPECT(q, "%s %s: preset %u is NULL", k->what, k->id, p)) continue;
      text_of("preset", q->id ? q->id : "?", "id", q->id, false);
      text_of("preset", q->id, "label", q->label, false);
      text_of("preset", q->id, "doc", q->doc, true);
      text_of("preset", q->id, "source", q->source, true);
    }
    for (uint32_t c = 0; k->texture && c < k->texture->channel_count; c++) {
      const sozai_channel *h = k->texture->channels[c];
      if (!EXPECT(h, "%s %s: channel %u is NULL", k->what, k->id, c)) continue;
      text_of("channel", h->id ? h->id : "?", "id", h->id, false);
      text_of("channel", h->id, "unit", h->unit, true);
      text_of("channel", h->id, "suffixes", h->suffixes, true);
      text_of("channel", h->id, "doc", h->doc, false);
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
  uint32_t n = start_kinds(s);
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
  uint32_t n = start_kinds(s);
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

/* A digest of all that is described, by its contents and not its addresses. */
static uint64_t digest(uint64_t h, const void *bytes, size_t n) {
  for (size_t i = 0; i < n; i++) h = (h ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3u;
  return h;
}

static uint64_t digest_text(uint64_t h, const char *text) {
  return text ? digest(h, text, strlen(text) + 1) : digest(h, "", 1) + 1;
}

static uint64_t digest_kind(const kind *k) {
  uint64_t h = 0xcbf29ce484222325u;
  h = digest_text(digest_text(digest_text(h, k->id), k->label), k->doc);
  for (uint32_t i = 0; i < k->parameter_count; i++) {
    const sozai_parameter *p = k->parameters[i];
    h = digest_text(digest_text(digest_text(h, p->id), p->unit), p->doc);
    h = digest_text(digest(h, &p->hard_min, 7 * sizeof(double)), p->default_text);
    h = digest(digest(h, &p->kind, 4), &p->choice_count, 4);
    for (uint32_t c = 0; p->choices && c < p->choice_count; c++) h = digest_text(h, p->choices[c]);
  }
  for (uint32_t i = 0; i < k->preset_count; i++) {
    h = digest_text(h, k->presets[i]->id);
    h = digest(h, &k->presets[i]->value_count, 4);
  }
  for (uint32_t i = 0; k->texture && i < k->texture->channel_count; i++) {
    const sozai_channel *c = k->texture->channels[i];
    h = digest_text(h, c->id);
    h = digest(h, &c->first, 16);
  }
  return h;
}

static void *count_other(void *context) {
  static kind other[KINDS_MOST];
  const subject *s = context;
  uint32_t n = subject_kinds(s, other), differ = 0;
  for (uint32_t i = 0; i < n; i++)
    differ += other[i].texture != kinds[i].texture || other[i].generator != kinds[i].generator;
  return differ ? context : NULL;
}

/* "A kind of texture. Lives until the last deinit." */
static void stable(subject *s) {
  uint32_t n = start_kinds(s);
  static uint64_t before[KINDS_MOST];
  for (uint32_t i = 0; i < n; i++) before[i] = digest_kind(&kinds[i]);
  EXPECT(!count_other(s), "info() gives another address when it is asked again");
  pthread_t thread;
  void *other = NULL;
  if (pthread_create(&thread, NULL, count_other, s) == 0) pthread_join(thread, &other);
  EXPECT(!other, "info() gives another address on another thread");
  for (uint32_t i = 0; i < n; i++) {
    sozai_texture *t = NULL;
    if (!kinds[i].texture) continue;
    doing("create of %s", kinds[i].id);
    s->textures->create(NULL, kinds[i].id, NULL, NULL, 0, &t);
    s->textures->destroy(t);
  }
  EXPECT(!count_other(s), "info() gives another address after create()");
  for (uint32_t i = 0; i < n; i++)
    EXPECT(digest_kind(&kinds[i]) == before[i], "the description of %s changed", kinds[i].id);
}

/* ---- parameters ------------------------------------------------------------ */

#define EACH_PARAMETER(s, k, q)                                                                    \
  uint32_t kind_count_ = start_kinds(s);                                                           \
  for (const kind *k = kinds; k < kinds + kind_count_; k++)                                        \
    for (uint32_t at_ = 0; at_ < k->parameter_count; at_++)                                        \
      for (const sozai_parameter *q = k->parameters[at_]; q; q = NULL)

static void parameter_kinds(subject *s) {
  EACH_PARAMETER(s, k, q) {
    EXPECT(q->size >= sizeof *q, "%s: %s has size %u, less than %u", k->id, q->id, q->size,
           (unsigned)sizeof *q);
    /* "STRING: never a parameter's kind"; a higher minor may have more. */
    bool known = q->kind >= SOZAI_KIND_FLOAT && q->kind <= SOZAI_KIND_IMAGE;
    EXPECT(known || (q->kind && s->entry->abi_minor > SOZAI_ABI_MINOR),
           "%s: %s is of the unknown kind %u", k->id, q->id, q->kind);
  }
}

static bool whole(double x) { return fabs(x) < 0x1p53 && x == (double)(int64_t)x; }

/* "FLOAT, INT, FLOAT3, COLOUR: values outside are refused"; "where a slider should end" */
static void ranges(subject *s) {
  EACH_PARAMETER(s, k, q) {
    if (!has_range(q->kind)) continue;
    EXPECT(q->hard_min <= q->hard_max, "%s: %s has the hard range %g to %g", k->id, q->id,
           q->hard_min, q->hard_max);
    EXPECT(q->soft_min >= q->hard_min && q->soft_max <= q->hard_max && q->soft_min <= q->soft_max,
           "%s: %s has the soft range %g to %g within %g to %g", k->id, q->id, q->soft_min,
           q->soft_max, q->hard_min, q->hard_max);
    EXPECT(isfinite(q->soft_min) && isfinite(q->soft_max), "%s: %s has a soft range without end",
           k->id, q->id);
    if (q->kind == SOZAI_KIND_INT)
      EXPECT(whole(q->hard_min) && whole(q->hard_max),
             "%s: %s is an INT with the range %.17g to %.17g", k->id, q->id, q->hard_min,
             q->hard_max);
  }
}

static void defaults(subject *s) {
  EACH_PARAMETER(s, k, q) {
    uint32_t numbers = q->kind == SOZAI_KIND_FLOAT3 || q->kind == SOZAI_KIND_COLOUR ? 3 : 1;
    for (uint32_t i = 0; has_range(q->kind) && i < numbers; i++)
      EXPECT(q->default_number[i] >= q->hard_min && q->default_number[i] <= q->hard_max,
             "%s: %s has the default %g outside of %g to %g", k->id, q->id, q->default_number[i],
             q->hard_min, q->hard_max);
    if (q->kind == SOZAI_KIND_INT)
      EXPECT(whole(q->default_number[0]), "%s: %s is an INT of default %.17g", k->id, q->id,
             q->default_number[0]);
    if (q->kind == SOZAI_KIND_BOOL)
      EXPECT(q->default_number[0] == 0 || q->default_number[0] == 1,
             "%s: %s is a BOOL of default %g", k->id, q->id, q->default_number[0]);
    if (q->kind == SOZAI_KIND_IMAGE) {
      EXPECT(q->default_number[0] >= 1 && q->default_number[0] <= 4 && whole(q->default_number[0]),
             "%s: %s takes pictures of %g channels", k->id, q->id, q->default_number[0]);
      EXPECT(q->default_number[1] >= 0 && q->default_number[1] <= SOZAI_WRAP_MIRROR &&
                 whole(q->default_number[1]),
             "%s: %s has the wrap %g", k->id, q->id, q->default_number[1]);
    }
    /* "TEXT, PATH, IMAGE: the default. COLOUR: the space ... Other kinds: NULL." */
    bool texts = q->kind == SOZAI_KIND_TEXT || q->kind == SOZAI_KIND_PATH ||
                 q->kind == SOZAI_KIND_IMAGE || q->kind == SOZAI_KIND_COLOUR;
    EXPECT(!texts || q->default_text, "%s: %s has no default_text", k->id, q->id);
    EXPECT(texts || q->kind > SOZAI_KIND_IMAGE || !q->default_text,
           "%s: %s is a %s and has a default_text", k->id, q->id, kind_name(q->kind));
  }
}

/* "CHOICE: ids; else NULL"; "the index of the default in choices" */
static void choices(subject *s) {
  EACH_PARAMETER(s, k, q) {
    if (q->kind != SOZAI_KIND_CHOICE) {
      if (q->kind <= SOZAI_KIND_IMAGE)
        EXPECT(!q->choices && !q->choice_docs && !q->choice_count,
               "%s: %s is no CHOICE and has choices", k->id, q->id);
      continue;
    }
    if (!EXPECT(q->choice_count > 0 && q->choices && q->choice_docs, "%s: %s has no choices", k->id,
                q->id))
      continue;
    for (uint32_t i = 0; i < q->choice_count; i++)
      EXPECT(q->choices[i] && q->choice_docs[i], "%s: %s has a NULL for choice %u or its phrase",
             k->id, q->id, i);
    EXPECT(whole(q->default_number[0]) && q->default_number[0] >= 0 &&
               q->default_number[0] < q->choice_count,
           "%s: %s has the default %g of %u choices", k->id, q->id, q->default_number[0],
           q->choice_count);
  }
}

/* "BUFFER, IMAGE: the SOZAI_BUFFER_* it takes; else 0" */
static void buffers(subject *s) {
  EACH_PARAMETER(s, k, q) {
    bool takes = q->kind == SOZAI_KIND_BUFFER || q->kind == SOZAI_KIND_IMAGE;
    if (q->kind > SOZAI_KIND_IMAGE) continue;
    EXPECT(takes ? q->buffer_kind >= SOZAI_BUFFER_TABLE : q->buffer_kind == 0,
           "%s: %s is a %s of buffer_kind %u", k->id, q->id, kind_name(q->kind), q->buffer_kind);
    if (q->kind == SOZAI_KIND_IMAGE)
      EXPECT(q->buffer_kind == SOZAI_BUFFER_IMAGE, "%s: %s takes no picture's buffer", k->id,
             q->id);
  }
}

/* "parameters of a group stand together in this order" */
static void groups(subject *s) {
  uint32_t n = start_kinds(s);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    asked();
    for (uint32_t p = 1; p < k->parameter_count; p++) {
      const char *g = k->parameters[p]->group;
      if (strcmp(g, k->parameters[p - 1]->group) == 0) continue;
      for (uint32_t q = 0; q + 1 < p; q++)
        if (strcmp(k->parameters[q]->group, g) == 0) {
          failed("%s: group %s begins again at %s", k->id, g, k->parameters[p]->id);
          break;
        }
    }
  }
}

/* ---- presets --------------------------------------------------------------- */

static const sozai_parameter *parameter_of(const kind *k, const char *id) {
  for (uint32_t i = 0; id && i < k->parameter_count; i++)
    if (strcmp(k->parameters[i]->id, id) == 0) return k->parameters[i];
  return NULL;
}

static void preset_value(const kind *k, const sozai_preset *p, const sozai_value *v) {
  const sozai_parameter *q = parameter_of(k, v->id);
  if (!EXPECT(q, "%s: preset %s names the unknown parameter '%s'", k->id, p->id,
              v->id ? v->id : "NULL"))
    return;
  bool fits = v->kind == q->kind || v->kind == SOZAI_KIND_STRING ||
              (v->kind == SOZAI_KIND_INT && q->kind == SOZAI_KIND_FLOAT);
  EXPECT(fits, "%s: preset %s gives a %s for %s, a %s", k->id, p->id, kind_name(v->kind), q->id,
         kind_name(q->kind));
  EXPECT(v->reserved == 0, "%s: preset %s: reserved of %s is not 0", k->id, p->id, q->id);
  uint32_t numbers = q->kind == SOZAI_KIND_FLOAT3 || q->kind == SOZAI_KIND_COLOUR ? 3 : 1;
  for (uint32_t i = 0; v->kind != SOZAI_KIND_STRING && has_range(q->kind) && i < numbers; i++)
    EXPECT(v->number[i] >= q->hard_min && v->number[i] <= q->hard_max,
           "%s: preset %s: %s is %g, outside of %g to %g", k->id, p->id, q->id, v->number[i],
           q->hard_min, q->hard_max);
}

/* "A named set of values" */
static void presets(subject *s) {
  uint32_t n = start_kinds(s);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    for (uint32_t p = 0; p < k->preset_count; p++) {
      const sozai_preset *q = k->presets[p];
      EXPECT(q->size >= sizeof *q, "%s: preset %s has size %u", k->id, q->id, q->size);
      if (!EXPECT(q->values || !q->value_count, "%s: preset %s has no values", k->id, q->id))
        continue;
      for (uint32_t v = 0; v < q->value_count; v++) preset_value(k, q, &q->values[v]);
    }
  }
}

/* ---- channels --------------------------------------------------------------- */

#define ALL_INPUTS 0x3fu

static void channels(subject *s) {
  uint32_t n = start_kinds(s);
  for (uint32_t i = 0; i < n; i++) {
    const sozai_texture_info *t = kinds[i].texture;
    if (t) EXPECT(t->channel_count > 0, "%s: it has no channel", t->id);
    for (uint32_t c = 0; t && c < t->channel_count; c++) {
      const sozai_channel *h = t->channels[c];
      EXPECT(h->size >= sizeof *h, "%s: channel %s has size %u", t->id, h->id, h->size);
      EXPECT(h->components >= 1 && h->components <= 3, "%s: channel %s has %u components", t->id,
             h->id, h->components);
      /* "a letter for each component ... "" for one" */
      EXPECT(strlen(h->suffixes) == (h->components == 1 ? 0 : h->components),
             "%s: channel %s of %u components has the suffixes '%s'", t->id, h->id, h->components,
             h->suffixes);
      for (const char *a = h->suffixes; *a; a++)
        EXPECT(!strchr(a + 1, *a), "%s: channel %s has the suffix %c twice", t->id, h->id, *a);
      if (s->entry->abi_minor <= SOZAI_ABI_MINOR)
        EXPECT(((h->needs | h->uses) & ~ALL_INPUTS) == 0, "%s: channel %s has unknown input bits",
               t->id, h->id);
      EXPECT((h->needs & h->uses) == 0, "%s: channel %s both needs and uses %s", t->id, h->id,
             input_name(h->needs & h->uses));
      EXPECT(h->reserved == 0, "%s: channel %s: reserved is not 0", t->id, h->id);
    }
  }
}

/* "Component k of the channel is written to sozai_batch.out[first + k]"; component_count:
 * "of all channels together" */
static void components(subject *s) {
  uint32_t n = start_kinds(s);
  for (uint32_t i = 0; i < n; i++) {
    const sozai_texture_info *t = kinds[i].texture;
    if (!t) continue;
    if (!EXPECT(t->component_count > 0 && t->component_count <= 65536, "%s: it has %u components",
                t->id, t->component_count))
      continue;
    for (uint32_t c = 0; c < t->component_count; c++) {
      uint32_t owners = 0;
      for (uint32_t h = 0; h < t->channel_count; h++)
        owners +=
            c >= t->channels[h]->first && c - t->channels[h]->first < t->channels[h]->components;
      EXPECT(owners == 1, "%s: component %u belongs to %u channels", t->id, c, owners);
    }
    for (uint32_t h = 0; h < t->channel_count; h++)
      EXPECT((uint64_t)t->channels[h]->first + t->channels[h]->components <= t->component_count,
             "%s: channel %s goes past the %u components", t->id, t->channels[h]->id,
             t->component_count);
  }
}

/* ---- tables of generators ----------------------------------------------------- */

static void tables(subject *s) {
  uint32_t n = start_kinds(s);
  for (uint32_t i = 0; i < n; i++) {
    const sozai_generator_info *g = kinds[i].generator;
    for (uint32_t t = 0; g && t < g->table_count; t++) {
      const sozai_table_info *q = g->tables[t];
      EXPECT(q->size >= sizeof *q, "%s: table %s has size %u", g->id, q->id, q->size);
      text_of("table", q->id ? q->id : "?", "id", q->id, false);
      text_of("table", q->id, "doc", q->doc, false);
      EXPECT(q->column_count > 0 && q->columns, "%s: table %s has no columns", g->id, q->id);
      for (uint32_t c = 0; q->columns && c < q->column_count; c++) {
        text_of("column", q->columns[c].id ? q->columns[c].id : "?", "id", q->columns[c].id, false);
        text_of("column", q->columns[c].id, "unit", q->columns[c].unit, true);
        text_of("column", q->columns[c].id, "doc", q->columns[c].doc, true);
        for (uint32_t d = 0; d < c; d++)
          EXPECT(strcmp(q->columns[c].id, q->columns[d].id) != 0, "%s: table %s has two columns %s",
                 g->id, q->id, q->columns[c].id);
      }
      for (uint32_t u = 0; u < t; u++)
        EXPECT(strcmp(g->tables[u]->id, q->id) != 0, "%s: two tables are called %s", g->id, q->id);
    }
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
       {"describe.stable", "create.default", "descriptions keep their address and content", stable},
       {"describe.parameter-kinds", "describe.strings", "parameters are of known kinds",
        parameter_kinds},
       {"describe.ranges", "describe.strings", "ranges are ordered, sliders within them", ranges},
       {"describe.defaults", "describe.strings",
        "defaults are within their ranges and of their kind", defaults},
       {"describe.choices", "describe.strings",
        "choices have ids, phrases and a default among them", choices},
       {"describe.buffers", "describe.strings",
        "buffer_kind is set where a buffer is taken, and only there", buffers},
       {"describe.groups", "describe.strings", "parameters of a group stand together", groups},
       {"describe.presets", "describe.strings",
        "presets give known parameters values of their kind and range", presets},
       {"describe.channels", "describe.strings",
        "channels have 1 to 3 components, suffixes and known inputs", channels},
       {"describe.components", "describe.strings",
        "channels cover the components without overlap or gap", components},
       {"describe.tables", "describe.strings",
        "tables of generators have ids and docs, their columns ids", tables});
