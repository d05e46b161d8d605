/* SPDX-License-Identifier: Apache-2.0
 * What parameters say of themselves. */
#include "describe.h"

#include <math.h>
#include <string.h>

#include "make.h"

static kind kinds[KINDS_MOST];

#define EACH_PARAMETER(s, k, q)                                                                    \
  uint32_t kind_count_ = subject_all(s, kinds);                                                    \
  for (const kind *k = kinds; k < kinds + kind_count_; k++)                                        \
    for (uint32_t at_ = 0; at_ < k->parameter_count; at_++)                                        \
      for (const sozai_parameter *q = k->parameters[at_]; q; q = NULL)

void describe_parameter_kinds(subject *s) {
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
void describe_ranges(subject *s) {
  EACH_PARAMETER(s, k, q) {
    if (!kind_has_range(q->kind)) continue;
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

void describe_defaults(subject *s) {
  EACH_PARAMETER(s, k, q) {
    uint32_t numbers = kind_numbers(q->kind);
    for (uint32_t i = 0; kind_has_range(q->kind) && i < numbers; i++)
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
void describe_choices(subject *s) {
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
void describe_buffers(subject *s) {
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
void describe_groups(subject *s) {
  uint32_t n = subject_all(s, kinds);
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
