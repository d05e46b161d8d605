/* SPDX-License-Identifier: Apache-2.0
 * Values that are refused, by textures and generators alike: before anything is
 * made of them. */
#include <stdlib.h>
#include <string.h>

#include "groups.h"
#include "make.h"

static kind kinds[KINDS_MOST];

#define POISON ((void *)(uintptr_t)0x10)

/* One bad value, alone: refused, by that error if there is one for it. */
static void refused(subject *s, const kind *k, const bad *b) {
  made m = {.kind = k};
  doing("%s of %s with %s %s", k->texture ? "create" : "grow", k->id, b->value.id, b->what);
  int32_t r;
  if (k->texture) {
    m.texture = POISON;
    r = s->textures->create(NULL, k->id, NULL, &b->value, 1, &m.texture);
    EXPECT(r == SOZAI_OK || !m.texture, "%s: %s %s was refused, *out left as it was", k->id,
           b->value.id, b->what);
  } else {
    m.geometry = POISON;
    r = s->geometry->grow(NULL, k->id, NULL, &b->value, 1, &m.geometry);
    EXPECT(r == SOZAI_OK || !m.geometry, "%s: %s %s was refused, *out left as it was", k->id,
           b->value.id, b->what);
  }
  EXPECT(r != SOZAI_OK, "%s: %s is taken: %s", k->id, b->value.id, b->what);
  if (r == SOZAI_OK) unmake(s, &m);
  if (r != SOZAI_OK && b->wanted)
    EXPECT(r == b->wanted, "%s: %s %s gave %s, not %s", k->id, b->value.id, b->what, result_name(r),
           result_name(b->wanted));
}

typedef bool chosen(const bad *b);

/* All bad values of all parameters that are chosen: of each parameter all, for
 * they are refused before any work. */
static void all_refused(subject *s, chosen *choose) {
  uint32_t n = subject_all(s, kinds);
  static bad wrong[BAD_MOST];
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t p = 0; p < kinds[i].parameter_count && !enough(); p++) {
      uint32_t count = make_bad(kinds[i].parameters[p], wrong);
      for (uint32_t b = 0; b < count; b++)
        if (choose(&wrong[b])) refused(s, &kinds[i], &wrong[b]);
    }
}

static bool is_text(const bad *b) { return b->value.kind == SOZAI_KIND_STRING && b->value.text; }
static bool is_null(const bad *b) { return strstr(b->what, "NULL") && !b->value.buffer; }
static bool is_buffer(const bad *b) { return b->value.buffer != NULL; }
static bool is_not_finite(const bad *b) {
  return !is_text(b) && (strstr(b->what, "infinity") || strstr(b->what, "not a number"));
}
static bool is_range(const bad *b) {
  return !is_text(b) && !is_not_finite(b) && !is_buffer(b) &&
         (strstr(b->what, "range") || strstr(b->what, "1e30"));
}
static bool is_choice(const bad *b) { return strcmp(b->what, "none of the choices") == 0; }
static bool is_whole(const bad *b) {
  return !is_text(b) && (strstr(b->what, "whole") || strstr(b->what, "neither 0"));
}
static bool is_unreadable(const bad *b) { return is_text(b) && !is_choice(b); }
static bool is_kind(const bad *b) {
  return !is_text(b) && !is_null(b) && !is_buffer(b) && !is_not_finite(b) && !is_range(b) &&
         !is_choice(b) && !is_whole(b);
}

/* "RANGE: a value outside its hard range" */
static void range(subject *s) { all_refused(s, is_range); }
static void not_finite(subject *s) { all_refused(s, is_not_finite); }
/* "or none of the choices" */
static void choice(subject *s) { all_refused(s, is_choice); }
/* "INT: number[0], a whole number"; "BOOL: number[0], 0 or 1" */
static void whole(subject *s) { all_refused(s, is_whole); }
/* "KIND: a value of the wrong kind" */
static void wrong_kind(subject *s) { all_refused(s, is_kind); }
/* "or unreadable as text" */
static void unreadable(subject *s) { all_refused(s, is_unreadable); }
/* "ARGUMENT: a NULL" */
static void null_text(subject *s) { all_refused(s, is_null); }
static void buffer(subject *s) { all_refused(s, is_buffer); }

/* "reserved: 0, else ARGUMENT" */
static void reserved(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t p = 0; p < kinds[i].parameter_count && !enough(); p++) {
      bad b = {.what = "with a reserved of 1", .wanted = SOZAI_ERROR_ARGUMENT};
      if (!make_default(kinds[i].parameters[p], &b.value)) continue;
      b.value.reserved = 1;
      refused(s, &kinds[i], &b);
    }
}

/* "UNKNOWN: no texture, preset, parameter or channel of that name" */
static void unknown(subject *s) {
  if (!subject_start(s)) return;
  static const char *const names[] = {"validate_none", "", " ", "%s%s%n", "\xff\xfe", "a\nb"};
  uint32_t n = subject_kinds(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t k = 0; k < COUNT_OF(names); k++) {
      const bad b = {.value = {.id = names[k], .kind = SOZAI_KIND_FLOAT, .number = {1}},
                     .what = "an unknown parameter",
                     .wanted = SOZAI_ERROR_UNKNOWN};
      refused(s, &kinds[i], &b);
    }
    /* Another case of a known one. */
    for (uint32_t p = 0; p < kinds[i].parameter_count && p < 1; p++) {
      char id[200] = "";
      strncpy(id, kinds[i].parameters[p]->id, sizeof id - 1);
      id[0] = (char)(id[0] - 'a' + 'A');
      const bad b = {.value = {.id = id, .kind = SOZAI_KIND_FLOAT, .number = {1}},
                     .what = "a parameter in capitals",
                     .wanted = SOZAI_ERROR_UNKNOWN};
      refused(s, &kinds[i], &b);
    }
  }
}

/* A text of 4 MiB: taken as text or refused, nothing else. */
static void huge(subject *s) {
  uint32_t n = subject_all(s, kinds);
  size_t size = (size_t)4 << 20;
  char *text = malloc(size + 1);
  if (!text) return failed("out of memory");
  memset(text, '7', size);
  text[size] = '\0';
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t p = 0; p < kinds[i].parameter_count; p++) {
      const sozai_parameter *q = kinds[i].parameters[p];
      if (q->kind == SOZAI_KIND_TEXT || q->kind == SOZAI_KIND_PATH || q->kind == SOZAI_KIND_IMAGE) {
        made m;
        const sozai_value v = {.id = q->id, .kind = SOZAI_KIND_STRING, .text = text};
        if (make(s, &kinds[i], NULL, NULL, &v, 1, &m) == SOZAI_OK) unmake(s, &m);
        asked();
      } else if (q->kind != SOZAI_KIND_FLOAT || q->hard_max < 1e300) {
        const bad b = {.value = {.id = q->id, .kind = SOZAI_KIND_STRING, .text = text},
                       .what = "as a text of 4 MiB"};
        refused(s, &kinds[i], &b);
      }
    }
  text[size - 1] = 'x';
  const bad b = {.value = {.id = text, .kind = SOZAI_KIND_FLOAT},
                 .what = "a parameter's id of 4 MiB",
                 .wanted = SOZAI_ERROR_UNKNOWN};
  made m = {0};
  for (uint32_t i = 0; i < n; i++) {
    doing("a parameter's id of 4 MiB");
    m.kind = &kinds[i];
    int32_t r = make(s, &kinds[i], NULL, NULL, &b.value, 1, &m);
    EXPECT(r == SOZAI_ERROR_UNKNOWN, "%s: a parameter's id of 4 MiB gave %s", kinds[i].id,
           result_name(r));
  }
  free(text);
}

/* A bad value among good ones is no better, and neither is one that a later one
 * takes the place of. */
static void among_good(subject *s) {
  uint32_t n = subject_all(s, kinds);
  static bad wrong[BAD_MOST];
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    sozai_value *values = calloc(k->parameter_count + 2, sizeof *values);
    if (!values) return failed("out of memory");
    for (uint32_t round = 0; k->parameter_count && round < 30; round++) {
      uint32_t count = 0;
      for (uint32_t p = 0; p < k->parameter_count; p++)
        if (make_default(k->parameters[p], &values[count])) count++;
      uint32_t of = chance_below(s, k->parameter_count);
      uint32_t bads = make_bad(k->parameters[of], wrong);
      if (!bads || !count) continue;
      const bad *b = &wrong[chance_below(s, bads)];
      uint32_t at = chance_below(s, count + 1);
      memmove(&values[at + 1], &values[at], (count - at) * sizeof *values);
      values[at] = b->value;
      made m;
      int32_t r = make(s, k, NULL, NULL, values, count + 1, &m);
      EXPECT(r != SOZAI_OK, "%s: %s is taken among good values: %s", k->id, b->value.id, b->what);
      if (r == SOZAI_OK) unmake(s, &m);
    }
    free(values);
  }
}

CHECKS(
    refuse, //
    {"refuse.unknown", "create.default", "an unknown parameter is refused as UNKNOWN", unknown},
    {"refuse.kind", "create.default", "a value of another kind is refused as KIND", wrong_kind},
    {"refuse.range", "create.default", "a value outside its range is refused as RANGE", range},
    {"refuse.not-finite", "create.default", "NaN is refused, and infinity where the range ends",
     not_finite},
    {"refuse.whole", "create.default", "0.5 is refused by an INT and a BOOL", whole},
    {"refuse.choice", "create.default", "what is none of the choices is refused as RANGE", choice},
    {"refuse.text", "create.default", "unreadable text is refused as KIND", unreadable},
    {"refuse.null-text", "create.default", "a NULL for a text is refused", null_text},
    {"refuse.huge-text", "create.default", "4 MiB of text do no harm", huge},
    {"refuse.reserved", "create.default", "a value whose reserved is not 0 is refused", reserved},
    {"refuse.buffer", "create.default", "buffers that say more than they hold are refused", buffer},
    {"refuse.among-good", "create.default", "one bad value among good ones is refused",
     among_good});
