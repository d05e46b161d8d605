/* SPDX-License-Identifier: Apache-2.0
 * What presets, channels and tables say of themselves. */
#include "describe.h"

#include <string.h>

#include "batch.h"
#include "make.h"

static kind kinds[KINDS_MOST];

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
  uint32_t numbers = kind_numbers(q->kind);
  for (uint32_t i = 0; v->kind != SOZAI_KIND_STRING && kind_has_range(q->kind) && i < numbers; i++)
    EXPECT(v->number[i] >= q->hard_min && v->number[i] <= q->hard_max,
           "%s: preset %s: %s is %g, outside of %g to %g", k->id, p->id, q->id, v->number[i],
           q->hard_min, q->hard_max);
}

/* "A named set of values" */
void describe_presets(subject *s) {
  uint32_t n = subject_all(s, kinds);
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

void describe_channels(subject *s) {
  uint32_t n = subject_all(s, kinds);
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
void describe_components(subject *s) {
  uint32_t n = subject_all(s, kinds);
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

void describe_tables(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const sozai_generator_info *g = kinds[i].generator;
    for (uint32_t t = 0; g && t < g->table_count; t++) {
      const sozai_table_info *q = g->tables[t];
      EXPECT(q->size >= sizeof *q, "%s: table %s has size %u", g->id, q->id, q->size);
      described_text("table", q->id ? q->id : "?", "id", q->id, false);
      described_text("table", q->id, "doc", q->doc, false);
      EXPECT(q->column_count > 0 && q->columns, "%s: table %s has no columns", g->id, q->id);
      for (uint32_t c = 0; q->columns && c < q->column_count; c++) {
        described_text("column", q->columns[c].id ? q->columns[c].id : "?", "id", q->columns[c].id,
                       false);
        described_text("column", q->columns[c].id, "unit", q->columns[c].unit, true);
        described_text("column", q->columns[c].id, "doc", q->columns[c].doc, true);
        for (uint32_t d = 0; d < c; d++)
          EXPECT(strcmp(q->columns[c].id, q->columns[d].id) != 0, "%s: table %s has two columns %s",
                 g->id, q->id, q->columns[c].id);
      }
      for (uint32_t u = 0; u < t; u++)
        EXPECT(strcmp(g->tables[u]->id, q->id) != 0, "%s: two tables are called %s", g->id, q->id);
    }
  }
}
