/* SPDX-License-Identifier: Apache-2.0
 * Values that a parameter must refuse, as far as its description tells. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "make.h"

typedef struct list {
  const sozai_parameter *p;
  bad *out;
  uint32_t count;
} list;

static void add(list *l, const char *what, int32_t wanted, sozai_value v) {
  if (l->count == BAD_MOST) return;
  v.id = l->p->id;
  l->out[l->count++] = (bad){.value = v, .what = what, .wanted = wanted};
}

/* In one number of the three the rest being the default, so that none hides. */
static void add_number(list *l, const char *what, int32_t wanted, double x) {
  uint32_t n = kind_numbers(l->p->kind);
  for (uint32_t i = 0; i < n; i++) {
    sozai_value v = {.kind = l->p->kind};
    memcpy(v.number, l->p->default_number, n * sizeof *v.number);
    v.number[i] = x;
    add(l, what, wanted, v);
  }
}

static void add_text(list *l, const char *what, int32_t wanted, const char *text) {
  add(l, what, wanted, (sozai_value){.kind = SOZAI_KIND_STRING, .text = text});
}

static void numbers(list *l) {
  const sozai_parameter *p = l->p;
  int32_t range = SOZAI_ERROR_RANGE;
  if (kind_has_range(p->kind)) {
    if (isfinite(p->hard_min) && p->hard_min > -1e300) {
      double under =
          p->kind == SOZAI_KIND_INT ? p->hard_min - 1 : nextafter(p->hard_min, -INFINITY);
      if (under < p->hard_min) add_number(l, "just below the range", range, under);
      add_number(l, "far below the range", range, -1e300);
      add_number(l, "-infinity", range, -INFINITY);
    }
    if (isfinite(p->hard_max) && p->hard_max < 1e300) {
      double over = p->kind == SOZAI_KIND_INT ? p->hard_max + 1 : nextafter(p->hard_max, INFINITY);
      if (over > p->hard_max) add_number(l, "just above the range", range, over);
      add_number(l, "far above the range", range, 1e300);
      add_number(l, "1e30", p->hard_max < 1e30 ? range : 0, 1e30);
      add_number(l, "infinity", range, INFINITY);
    }
    add_number(l, "not a number", 0, NAN);
  }
  if (p->kind == SOZAI_KIND_INT && p->hard_min + 1 <= p->hard_max)
    add_number(l, "no whole number", 0, p->hard_min + 0.5);
  if (p->kind == SOZAI_KIND_BOOL) {
    add_number(l, "neither 0 nor 1: 0.5", 0, 0.5);
    add_number(l, "neither 0 nor 1: 2", 0, 2);
    add_number(l, "neither 0 nor 1: -1", 0, -1);
    add_number(l, "not a number", 0, NAN);
  }
}

/* "KIND: a value of the wrong kind, or unreadable as text" */
static void kinds(list *l) {
  for (uint32_t k = SOZAI_KIND_FLOAT; k <= SOZAI_KIND_IMAGE; k++) {
    if (k == l->p->kind || (k == SOZAI_KIND_INT && l->p->kind == SOZAI_KIND_FLOAT)) continue;
    add(l, kind_name(k), SOZAI_ERROR_KIND,
        (sozai_value){.kind = k, .text = "1", .number = {1, 1, 1}});
  }
  add(l, "the unknown kind 11", 0, (sozai_value){.kind = 11, .text = "1", .number = {1, 1, 1}});
  add(l, "the unknown kind 4294967295", 0,
      (sozai_value){.kind = UINT32_MAX, .text = "1", .number = {1, 1, 1}});
}

static void texts(list *l) {
  const uint32_t k = l->p->kind;
  const int32_t kind = SOZAI_ERROR_KIND;
  if (k == SOZAI_KIND_FLOAT || k == SOZAI_KIND_INT) {
    static const char *const no_number[] = {"",     " ",   "x",  "1x",   "1 2", "1;",
                                            "1.5.", "--1", "1e", "true", "#",   "1 1"};
    for (uint32_t i = 0; i < COUNT_OF(no_number); i++) add_text(l, "no number", kind, no_number[i]);
    add_text(l, "the text nan", 0, "nan");
    if (isfinite(l->p->hard_max)) add_text(l, "the text inf", 0, "inf");
    if (l->p->hard_max < 1e300) add_text(l, "the text 1e300", SOZAI_ERROR_RANGE, "1e300");
  }
  if (k == SOZAI_KIND_INT && l->p->hard_max > l->p->hard_min)
    add_text(l, "no whole number", 0, "0.5");
  if (k == SOZAI_KIND_BOOL) {
    static const char *const no_bool[] = {"", "maybe", "2", "truefalse", "0.5"};
    for (uint32_t i = 0; i < COUNT_OF(no_bool); i++)
      add_text(l, "neither true nor false", kind, no_bool[i]);
  }
  if (k == SOZAI_KIND_FLOAT3 || k == SOZAI_KIND_COLOUR) {
    static const char *const no_three[] = {"", "1", "1 2", "1 2 3 4", "1 2 x", "#12", "#gggggg"};
    for (uint32_t i = 0; i < COUNT_OF(no_three); i++)
      add_text(l, "not three numbers", kind, no_three[i]);
  }
  if (k == SOZAI_KIND_CHOICE) {
    static const char *const no_choice[] = {"", " ", "validate: no such choice", "0", "%s%n"};
    for (uint32_t i = 0; i < COUNT_OF(no_choice); i++) {
      bool is = false;
      for (uint32_t c = 0; c < l->p->choice_count; c++)
        is |= strcmp(l->p->choices[c], no_choice[i]) == 0;
      if (is) continue;
      add_text(l, "none of the choices", SOZAI_ERROR_RANGE, no_choice[i]);
      add(l, "none of the choices", SOZAI_ERROR_RANGE,
          (sozai_value){.kind = SOZAI_KIND_CHOICE, .text = no_choice[i]});
    }
  }
  if (k == SOZAI_KIND_BUFFER) add_text(l, "text for a buffer", 0, "1");
  if (k != SOZAI_KIND_BUFFER) add_text(l, "text that is NULL", 0, NULL);
  if (k == SOZAI_KIND_CHOICE || k == SOZAI_KIND_TEXT || k == SOZAI_KIND_PATH)
    add(l, "text that is NULL", 0, (sozai_value){.kind = k});
}

/* Buffers that say more than they hold, or another thing than is wanted. */
static void buffers(list *l) {
  static const float numbers[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 1};
  static const uint32_t past[3] = {0, 1, 7};
  static sozai_buffer of[8][16];
  static uint32_t turn;
  sozai_buffer *b = of[turn++ % 8];
  uint32_t right = l->p->buffer_kind, n = 0;
  bool points = right == SOZAI_BUFFER_MESH || right == SOZAI_BUFFER_POINTS;
  const sozai_buffer good = {.size = sizeof good,
                             .kind = right,
                             .dims = {2, 2, right == SOZAI_BUFFER_IMAGE ? 1 : 0},
                             .data = points ? NULL : numbers,
                             .points = points ? numbers : NULL,
                             .indices = past};
#define ADD_BUFFER(what, wanted, change)                                                           \
  do {                                                                                             \
    b[n] = good;                                                                                   \
    change;                                                                                        \
    add(l, what, wanted, (sozai_value){.kind = l->p->kind, .buffer = &b[n++]});                    \
  } while (0)
  ADD_BUFFER("a buffer of size 0", SOZAI_ERROR_ARGUMENT, b[n].size = 0);
  ADD_BUFFER("a buffer of the wrong kind", SOZAI_ERROR_KIND,
             b[n].kind = right == SOZAI_BUFFER_TABLE ? SOZAI_BUFFER_MESH : SOZAI_BUFFER_TABLE);
  ADD_BUFFER("a buffer of the unknown kind 77", 0, b[n].kind = 77);
  ADD_BUFFER("a buffer whose numbers are NULL", 0, b[n].data = b[n].points = NULL);
  ADD_BUFFER("a buffer of 2^63 by 2 numbers", 0, b[n].dims[0] = 1ull << 63);
  ADD_BUFFER("a buffer of 2^32 by 2^32 numbers", 0, b[n].dims[0] = b[n].dims[1] = 1ull << 32);
  if (right == SOZAI_BUFFER_MESH) {
    ADD_BUFFER("a mesh of an index past its points", 0, b[n].dims[0] = 3; b[n].dims[1] = 1);
    ADD_BUFFER("a mesh whose indices are NULL", 0, b[n].indices = NULL; b[n].dims[1] = 1);
  }
  if (right == SOZAI_BUFFER_IMAGE) {
    ADD_BUFFER("a picture without pixels", 0, b[n].dims[0] = 0);
    ADD_BUFFER("a picture without the first channel", 0, b[n].first_channel = 9);
    ADD_BUFFER("a picture of wrap 9", 0, b[n].wrap = 9);
  }
#undef ADD_BUFFER
}

uint32_t make_bad(const sozai_parameter *p, bad *out) {
  list l = {.p = p, .out = out};
  if (p->kind < SOZAI_KIND_FLOAT || p->kind > SOZAI_KIND_IMAGE) return 0;
  numbers(&l);
  texts(&l);
  if (p->kind == SOZAI_KIND_BUFFER || p->kind == SOZAI_KIND_IMAGE) buffers(&l);
  kinds(&l);
  return l.count;
}
