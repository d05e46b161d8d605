/* SPDX-License-Identifier: Apache-2.0
 * last_error: "names the parameter, the value and the range". */
#include <ctype.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "groups.h"
#include "make.h"
#include "text.h"

static kind kinds[KINDS_MOST];

static const char *error_of(const subject *s, const kind *k) {
  return k->texture ? s->textures->last_error() : s->geometry->last_error();
}

/* Fails to make one; false: it did not fail. */
static bool fail_with(subject *s, const kind *k, const char *preset, const sozai_value *v) {
  made m;
  if (make(s, k, NULL, preset, v, v ? 1 : 0, &m) != SOZAI_OK) return true;
  unmake(s, &m);
  return false;
}

/* Whether the text has a number near x, written in the C locale. */
static bool has_number(const char *text, double x) {
  for (const char *at = text; *at;) {
    bool starts = isdigit((unsigned char)*at) ||
                  ((*at == '-' || *at == '.' || *at == '+') && isdigit((unsigned char)at[1])) ||
                  (*at == '-' && at[1] == '.' && isdigit((unsigned char)at[2]));
    if (!starts) {
      at++;
      continue;
    }
    char *end;
    double y = strtod(at, &end);
    if (fabs(y - x) <= 1e-4 * fabs(x) + 1e-12) return true;
    at = end > at ? end : at + 1;
  }
  return false;
}

/* "names the parameter, the value and the range" */
static void names(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t p = 0; p < kinds[i].parameter_count; p++) {
      const sozai_parameter *q = kinds[i].parameters[p];
      if (!kind_has_range(q->kind) || q->hard_max > 1e29) continue;
      sozai_value v = {.id = q->id, .kind = q->kind, .number = {3.25e31, 3.25e31, 3.25e31}};
      if (!fail_with(s, &kinds[i], NULL, &v)) continue;
      const char *text = error_of(s, &kinds[i]);
      if (!EXPECT(text && strstr(text, q->id), "%s: an error of %s does not name it: '%s'",
                  kinds[i].id, q->id, text ? text : "NULL"))
        continue;
      EXPECT(has_number(text, 3.25e31), "%s: an error of %s does not name the value: '%s'",
             kinds[i].id, q->id, text);
      EXPECT(has_number(text, q->hard_min) && has_number(text, q->hard_max),
             "%s: an error of %s does not name its range, %g to %g: '%s'", kinds[i].id, q->id,
             q->hard_min, q->hard_max, text);
    }
}

/* The name of what is unknown, and the choices where there are such. */
static void names_unknown(subject *s) {
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    const sozai_value v = {.id = "validate_none", .kind = SOZAI_KIND_FLOAT};
    if (fail_with(s, k, NULL, &v))
      EXPECT(strstr(error_of(s, k), "validate_none"),
             "%s: an error of an unknown parameter does not name it: '%s'", k->id, error_of(s, k));
    if (fail_with(s, k, "validate-no-preset", NULL))
      EXPECT(strstr(error_of(s, k), "validate-no-preset"),
             "%s: an error of an unknown preset does not name it: '%s'", k->id, error_of(s, k));
    for (uint32_t p = 0; p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      if (q->kind != SOZAI_KIND_CHOICE) continue;
      const sozai_value c = {.id = q->id, .kind = SOZAI_KIND_CHOICE, .text = "validate-no-choice"};
      if (!fail_with(s, k, NULL, &c)) continue;
      const char *text = error_of(s, k);
      EXPECT(strstr(text, q->id) && strstr(text, "validate-no-choice"),
             "%s: an error of %s does not name it and its value: '%s'", k->id, q->id, text);
      EXPECT(strstr(text, q->choices[0]), "%s: an error of %s does not name its choices: '%s'",
             k->id, q->id, text);
    }
  }
}

static void fit(const kind *k, const char *text, const char *what) {
  if (!EXPECT(text, "%s: last_error is NULL, %s", k->id, what)) return;
  EXPECT(*text, "%s: last_error is empty, %s", k->id, what);
  EXPECT(one_line(text), "%s: last_error is more than a line, %s: '%s'", k->id, what, text);
  EXPECT(utf8_valid(text), "%s: last_error is not UTF-8, %s", k->id, what);
  EXPECT(strlen(text) < 4096, "%s: last_error is of %zu bytes, %s", k->id, strlen(text), what);
}

/* Every refusal says why, on a line that can be logged. */
static void one_line_each(subject *s) {
  static bad wrong[BAD_MOST];
  uint32_t n = subject_all(s, kinds);
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t p = 0; p < kinds[i].parameter_count && !enough(); p++) {
      uint32_t count = make_bad(kinds[i].parameters[p], wrong);
      for (uint32_t b = 0; b < count; b++)
        if (fail_with(s, &kinds[i], NULL, &wrong[b].value))
          fit(&kinds[i], error_of(s, &kinds[i]), wrong[b].what);
    }
}

/* "Strings are UTF-8", and a line stays one, whatever a host hands in: texts, ids and presets
 * with line ends, controls, format specifiers, cut characters. */
static void hostile(subject *s) {
  static const char *const texts[] = {
      "two\nlines", "\r\n", "\t", "\x1b[31mred\x1b[0m", "%s%s%s%s%n", "%99999d", "\"quotes\"",
      "\x7f", "caf\xc3\xa9 \xe6\x9c\xa8\xe6\x9d\x90",
      /* 79 bytes and then a character of three: where is it cut? */
      "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
      "\xe6\x9c\xa8\xe6\x9c\xa8\xe6\x9c\xa8\xe6\x9c\xa8\xe6\x9c\xa8\xe6\x9c\xa8\xe6\x9c\xa8\xe6\x9c"
      "\xa8"};
  uint32_t n = subject_all(s, kinds);
  char *huge = malloc(100001);
  if (!huge) return failed("out of memory");
  for (uint32_t i = 0; i < 100000; i++) huge[i] = "\xe6\x9c\xa8"[i % 3];
  huge[99999] = '\0';
  for (uint32_t i = 0; i < n; i++)
    for (uint32_t t = 0; t <= COUNT_OF(texts); t++) {
      const kind *k = &kinds[i];
      const char *text = t < COUNT_OF(texts) ? texts[t] : huge;
      char what[80] = "handed a text of 100 kB";
      if (t < COUNT_OF(texts)) strncpy(what, text, sizeof what - 1);
      sozai_value v = {.id = text, .kind = SOZAI_KIND_FLOAT};
      if (fail_with(s, k, NULL, &v)) fit(k, error_of(s, k), what);
      if (fail_with(s, k, text, NULL)) fit(k, error_of(s, k), what);
      for (uint32_t p = 0; p < k->parameter_count && !enough(); p++) {
        uint32_t of = k->parameters[p]->kind;
        if (of == SOZAI_KIND_PATH || of == SOZAI_KIND_IMAGE) continue;
        v = (sozai_value){.id = k->parameters[p]->id, .kind = SOZAI_KIND_STRING, .text = text};
        if (fail_with(s, k, NULL, &v)) fit(k, error_of(s, k), what);
        if (of != SOZAI_KIND_COLOUR) continue;
        v.kind = of;
        if (fail_with(s, k, NULL, &v)) fit(k, error_of(s, k), what);
      }
      sozai_texture *none = NULL;
      if (k->texture && s->textures->create(NULL, text, NULL, NULL, 0, &none) != SOZAI_OK)
        fit(k, error_of(s, k), what);
      s->textures ? s->textures->destroy(none) : (void)0;
    }
  free(huge);
}

/* ---- threads --------------------------------------------------------------------- */

static void *error_elsewhere(void *context) {
  const subject *s = context;
  const char *text = last_error(s);
  return *text ? context : NULL;
}

static void make_one_fail(subject *s, const char *id) {
  const sozai_value v = {.id = id, .kind = SOZAI_KIND_FLOAT};
  fail_with(s, &kinds[0], NULL, &v);
}

/* "\"\" before any failure" */
static void empty_before(subject *s) {
  if (!subject_all(s, kinds)) return;
  EXPECT(!*last_error(s), "last_error before any failure is '%s'", last_error(s));
  make_one_fail(s, "validate_here");
  pthread_t thread;
  void *said = NULL;
  if (pthread_create(&thread, NULL, error_elsewhere, s) != 0) return;
  pthread_join(thread, &said);
  EXPECT(!said, "last_error on a thread without failures is not empty");
}

typedef struct own {
  subject *s;
  uint32_t index, wrong;
  pthread_barrier_t *step;
} own;

/* All fail, each in its own way, and only then does each look what it was told. */
static void *fail_often(void *context) {
  own *o = context;
  static const char *const names_of[] = {"validate_a", "validate_b", "validate_c", "validate_d"};
  for (int i = 0; i < 200; i++) {
    make_one_fail(o->s, names_of[o->index]);
    pthread_barrier_wait(o->step);
    if (!strstr(error_of(o->s, &kinds[0]), names_of[o->index])) o->wrong++;
    pthread_barrier_wait(o->step);
  }
  return NULL;
}

/* "Why the last call on this thread failed" */
static void by_thread(subject *s) {
  if (!subject_all(s, kinds)) return;
  own owns[4];
  pthread_t threads[4];
  pthread_barrier_t step;
  pthread_barrier_init(&step, NULL, 4);
  doing("failing calls on 4 threads");
  for (uint32_t i = 0; i < 4; i++) {
    owns[i] = (own){.s = s, .index = i, .step = &step};
    if (pthread_create(&threads[i], NULL, fail_often, &owns[i]) != 0) {
      failed("no thread");
      _Exit(1);
    }
  }
  for (uint32_t i = 0; i < 4; i++) pthread_join(threads[i], NULL);
  for (uint32_t i = 0; i < 4; i++)
    EXPECT(!owns[i].wrong, "last_error gave another thread's failure %u times of 200",
           owns[i].wrong);
  pthread_barrier_destroy(&step);
}

/* "valid until the thread's next failing call" */
static void kept(subject *s) {
  if (!subject_all(s, kinds)) return;
  make_one_fail(s, "validate_kept");
  const char *text = last_error(s);
  if (!EXPECT(strstr(text, "validate_kept"), "last_error does not name the failure: '%s'", text))
    return;
  char *copy = strdup(text);
  if (!copy) return failed("out of memory");
  if (s->textures) {
    for (uint32_t i = 0; i < s->textures->count(); i++) {
      const sozai_texture_info *info = s->textures->info(i);
      sozai_texture *t = NULL;
      sozai_value v;
      if (s->textures->create(NULL, info->id, NULL, NULL, 0, &t) != SOZAI_OK) return free(copy);
      if (info->parameter_count) s->textures->value(t, info->parameters[0]->id, &v);
      s->textures->destroy(t);
    }
    EXPECT(strcmp(last_error(s), copy) == 0, "calls that did not fail changed last_error to '%s'",
           last_error(s));
    EXPECT(strcmp(text, copy) == 0, "the text of last_error changed without a failing call");
  }
  free(copy);
}

CHECKS(errors, //
       {"errors.range", "refuse.range", "an error of the range names parameter, value and range",
        names},
       {"errors.unknown", "refuse.unknown",
        "an error of a name has it, and an error of a choice the choices", names_unknown},
       {"errors.line", "create.default", "every refusal says why, in one line of UTF-8",
        one_line_each},
       {"errors.hostile", "create.default",
        "so it does of texts with line ends, controls and percent signs", hostile},
       {"errors.empty-before", "create.default",
        "last_error is empty before any failure of the thread", empty_before},
       {"errors.thread", "create.default", "each thread has its own last_error", by_thread},
       {"errors.kept", "create.default", "the text stays until the thread's next failure", kept});
