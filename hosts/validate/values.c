/* SPDX-License-Identifier: Apache-2.0
 * Values that are taken, and read back. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "batch.h"
#include "groups.h"
#include "make.h"

static kind kinds[KINDS_MOST];

/* Made of these values, or a failure. */
static bool made_of(subject *s, const kind *k, const char *preset, const sozai_value *values,
                    uint32_t count, made *m, const char *what) {
  int32_t r = make(s, k, NULL, preset, values, count, m);
  return EXPECT(r == SOZAI_OK, "%s: %s%s%s gave %s: %s", k->id, count ? values[0].id : "",
                count ? " " : "", what, result_name(r), last_error(s));
}

static bool holds(subject *s, const made *m, const sozai_value *wanted, const char *what) {
  sozai_value v;
  int32_t r = made_value(s, m, wanted->id, &v);
  if (!EXPECT(r == SOZAI_OK, "%s: value(%s) gave %s", m->kind->id, wanted->id, result_name(r)))
    return false;
  EXPECT(v.id && strcmp(v.id, wanted->id) == 0, "%s: value(%s) is called '%s'", m->kind->id,
         wanted->id, v.id ? v.id : "NULL");
  return EXPECT(value_same(&v, wanted), "%s: value(%s) is %s %s, not %s, %s", m->kind->id,
                wanted->id, kind_name(v.kind), value_shown(&v), value_shown(wanted), what);
}

/* "Values that a preset does not name stay at the parameters' defaults"; without a preset all */
static void default_read(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    made m;
    if (!made_of(s, &kinds[i], NULL, NULL, 0, &m, "no values")) continue;
    for (uint32_t p = 0; p < kinds[i].parameter_count; p++) {
      sozai_value v;
      if (make_default(kinds[i].parameters[p], &v)) holds(s, &m, &v, "of the defaults");
    }
    unmake(s, &m);
  }
}

/* A default that is given is the default. */
static void default_given(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    made all, one;
    if (!made_of(s, &kinds[i], NULL, NULL, 0, &one, "no values")) continue;
    sozai_value *values = calloc(kinds[i].parameter_count + 1, sizeof *values);
    if (!values) return failed("out of memory");
    uint32_t count = 0;
    for (uint32_t p = 0; p < kinds[i].parameter_count && !enough(); p++) {
      if (!make_default(kinds[i].parameters[p], &values[count])) continue;
      if (made_of(s, &kinds[i], NULL, &values[count], 1, &all, "at its default")) {
        if (s->thorough || chance_below(s, 4) == 0)
          same_bits(s, kinds[i].texture, one.texture, all.texture, values[count].id);
        unmake(s, &all);
      }
      count++;
    }
    if (made_of(s, &kinds[i], NULL, values, count, &all, "and all others at their defaults")) {
      same_bits(s, kinds[i].texture, one.texture, all.texture, "with each default given");
      unmake(s, &all);
    }
    free(values);
    unmake(s, &one);
  }
}

/* What differs between ways of giving a value. */
typedef void way(subject *s, const kind *k, const sozai_parameter *p, const sozai_value *good);

static void each_good(subject *s, uint32_t most, way *run) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    uint32_t step = s->thorough || k->parameter_count <= most ? 1 : k->parameter_count / most + 1;
    for (uint32_t p = step > 1 ? chance_below(s, step) : 0; p < k->parameter_count && !enough();
         p += step) {
      sozai_value v;
      if (make_good(s, k->parameters[p], &v) || make_default(k->parameters[p], &v))
        run(s, k, k->parameters[p], &v);
    }
  }
}

static void set_one(subject *s, const kind *k, const sozai_parameter *p, const sozai_value *good) {
  made m;
  (void)p;
  if (!made_of(s, k, NULL, good, 1, &m, value_shown(good))) return;
  holds(s, &m, good, "as it was given");
  unmake(s, &m);
}

/* "The value of one parameter as the texture was made with" */
static void set_read(subject *s) { each_good(s, 60, set_one); }

static void text_one(subject *s, const kind *k, const sozai_parameter *p, const sozai_value *good) {
  given text;
  made a, b;
  if (!make_text(p, good, &text)) return;
  if (!made_of(s, k, NULL, good, 1, &a, value_shown(good))) return;
  if (made_of(s, k, NULL, &text.value, 1, &b, text.text)) {
    holds(s, &b, good, "given as text");
    if (chance_below(s, 4) == 0)
      same_bits(s, k->texture, a.texture, b.texture, "with a value given as text");
    unmake(s, &b);
  }
  unmake(s, &a);
}

/* "SOZAI_KIND_STRING, whose text is read as the parameter's kind" */
static void as_text(subject *s) { each_good(s, 60, text_one); }

static void int_one(subject *s, const kind *k, const sozai_parameter *p, const sozai_value *good) {
  if (p->kind != SOZAI_KIND_FLOAT) return;
  sozai_value whole = *good;
  whole.number[0] = (double)(int64_t)good->number[0];
  if (whole.number[0] < p->hard_min || whole.number[0] > p->hard_max) return;
  sozai_value as_int = whole;
  as_int.kind = SOZAI_KIND_INT;
  made m;
  if (!made_of(s, k, NULL, &as_int, 1, &m, "given as an INT")) return;
  holds(s, &m, &whole, "given as an INT");
  unmake(s, &m);
}

/* "an INT is taken for a FLOAT" */
static void int_for_float(subject *s) { each_good(s, 40, int_one); }

static void later_one(subject *s, const kind *k, const sozai_parameter *p,
                      const sozai_value *good) {
  sozai_value two[2];
  if (!make_default(p, &two[0]) || kind_numbers(p->kind) == 0) return;
  made m;
  two[1] = *good;
  if (!made_of(s, k, NULL, two, 2, &m, "given twice")) return;
  holds(s, &m, good, "given after the default");
  unmake(s, &m);
}

/* "of two for one parameter the later counts" */
static void later(subject *s) { each_good(s, 20, later_one); }

/* Of a hundred thousand too; or of as many as the plugin says that it takes. */
static void many(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  enum { MANY = 100000 };
  const sozai_limits_1 *limits = s->entry ? s->entry->get_factory(SOZAI_LIMITS_1) : NULL;
  const sozai_limit_info *most = n && limits ? limits->find("values") : NULL;
  uint32_t count = most && most->value < MANY ? (uint32_t)most->value : MANY;
  sozai_value *values = calloc(MANY, sizeof *values);
  if (!values) return failed("out of memory");
  for (uint32_t i = 0; i < n; i++) {
    const sozai_parameter *p = NULL;
    for (uint32_t q = 0; q < kinds[i].parameter_count && !p; q++)
      if (kinds[i].parameters[q]->kind == SOZAI_KIND_FLOAT) p = kinds[i].parameters[q];
    if (!p) continue;
    for (uint32_t v = 0; v < count; v++) make_good(s, p, &values[v]);
    made m;
    if (!made_of(s, &kinds[i], NULL, values, count, &m, "given many times")) continue;
    holds(s, &m, &values[count - 1], "given many times");
    unmake(s, &m);
  }
  free(values);
}

static bool in_word(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }

/* Whether the error speaks of another parameter too: values that do not go together. */
static bool names_another(const kind *k, const sozai_parameter *p, const char *text) {
  for (uint32_t i = 0; i < k->parameter_count; i++) {
    const char *id = k->parameters[i]->id;
    size_t n = strlen(id);
    for (const char *at = text; k->parameters[i] != p && (at = strstr(at, id)); at += n)
      if ((at == text || !in_word(at[-1])) && !in_word(at[n])) return true;
  }
  return false;
}

/* The ends of the hard range belong to it: "values outside are refused". Other errors than
 * of the value itself are the plugin's to give: of memory, or of what does not go together. */
static void bounds_one(subject *s, const kind *k, const sozai_parameter *p,
                       const sozai_value *good) {
  if (!kind_has_range(p->kind)) return;
  const double ends[] = {p->hard_min, p->hard_max, p->soft_min, p->soft_max};
  for (uint32_t e = 0; e < COUNT_OF(ends); e++) {
    sozai_value v = *good;
    for (uint32_t c = 0; c < kind_numbers(p->kind); c++) v.number[c] = ends[e];
    made m;
    int32_t r = make(s, k, NULL, NULL, &v, 1, &m);
    bool own =
        (r == SOZAI_ERROR_RANGE || r == SOZAI_ERROR_KIND) && !names_another(k, p, last_error(s));
    EXPECT(!own, "%s: %s at %s gave %s: %s", k->id, p->id, value_shown(&v), result_name(r),
           last_error(s));
    if (r == SOZAI_OK) unmake(s, &m);
  }
}

static void bounds(subject *s) { each_good(s, 30, bounds_one); }

/* ---- text of each kind ----------------------------------------------------------- */

/* The header's own examples: "1.5", "12", "true", "ring", "1 2 3", "#c08040",
 * "0.2 0.1 0.05 @ ACEScg". */
static void example_one(subject *s, const kind *k, const sozai_parameter *p,
                        const sozai_value *good) {
  given text = {.value = {.id = p->id, .kind = SOZAI_KIND_STRING}};
  text.value.text = text.text;
  sozai_value wanted = *good;
  made m;
  if (p->kind == SOZAI_KIND_COLOUR && p->hard_min <= 0 && p->hard_max >= 1) {
    snprintf(text.text, sizeof text.text, "#c08040");
    wanted.number[0] = 192 / 255.0;
    wanted.number[1] = 128 / 255.0;
    wanted.number[2] = 64 / 255.0;
  } else if (p->kind == SOZAI_KIND_FLOAT && p->hard_min <= 1.5 && p->hard_max >= 1.5) {
    snprintf(text.text, sizeof text.text, "1.5");
    wanted.number[0] = 1.5;
  } else if (p->kind == SOZAI_KIND_INT && p->hard_min <= 12 && p->hard_max >= 12) {
    snprintf(text.text, sizeof text.text, "12");
    wanted.number[0] = 12;
  } else if (p->kind == SOZAI_KIND_FLOAT3 && p->hard_min <= 1 && p->hard_max >= 3) {
    snprintf(text.text, sizeof text.text, "1 2 3");
    for (int c = 0; c < 3; c++) wanted.number[c] = c + 1;
  } else if (p->kind == SOZAI_KIND_BOOL) {
    snprintf(text.text, sizeof text.text, "false");
    wanted.number[0] = 0;
  } else {
    return;
  }
  int32_t r = make(s, k, NULL, NULL, &text.value, 1, &m);
  EXPECT(r != SOZAI_ERROR_KIND, "%s: %s as \"%s\" gave %s: %s", k->id, p->id, text.text,
         result_name(r), last_error(s));
  if (r != SOZAI_OK) return;
  holds(s, &m, &wanted, text.text);
  unmake(s, &m);
}

static void examples(subject *s) { each_good(s, 60, example_one); }

/* ---- presets ----------------------------------------------------------------------- */

static void preset_holds(subject *s, const kind *k, const sozai_preset *p, const made *m) {
  for (uint32_t v = 0; v < p->value_count; v++) {
    const sozai_value *w = &p->values[v];
    bool last = true; /* "of two for one parameter the later counts" */
    for (uint32_t l = v + 1; l < p->value_count; l++) last &= strcmp(p->values[l].id, w->id) != 0;
    if (!last || w->kind == SOZAI_KIND_STRING || w->kind >= SOZAI_KIND_BUFFER) continue;
    sozai_value wanted = *w;
    for (uint32_t q = 0; q < k->parameter_count; q++)
      if (strcmp(k->parameters[q]->id, w->id) == 0) wanted.kind = k->parameters[q]->kind;
    holds(s, m, &wanted, p->id);
  }
  for (uint32_t q = 0; q < k->parameter_count; q++) {
    bool named = false;
    for (uint32_t v = 0; v < p->value_count; v++)
      named |= strcmp(p->values[v].id, k->parameters[q]->id) == 0;
    sozai_value d;
    if (!named && make_default(k->parameters[q], &d)) holds(s, m, &d, "not named by the preset");
  }
}

static void presets(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    for (uint32_t p = 0; p < k->preset_count && !enough(); p++) {
      made m;
      int32_t r = make(s, k, NULL, k->presets[p]->id, NULL, 0, &m);
      if (!EXPECT(r == SOZAI_OK, "%s: preset %s gave %s: %s", k->id, k->presets[p]->id,
                  result_name(r), last_error(s)))
        continue;
      preset_holds(s, k, k->presets[p], &m);
      unmake(s, &m);
    }
  }
}

/* "values given to create() come on top" */
static void on_top(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    for (uint32_t round = 0; round < 12 && k->preset_count && k->parameter_count; round++) {
      const sozai_preset *p = k->presets[chance_below(s, k->preset_count)];
      if (!p->value_count) continue;
      const sozai_value *w = &p->values[chance_below(s, p->value_count)];
      const sozai_parameter *q = NULL;
      for (uint32_t c = 0; c < k->parameter_count; c++)
        if (strcmp(k->parameters[c]->id, w->id) == 0) q = k->parameters[c];
      sozai_value v;
      made m;
      if (!q || !make_default(q, &v)) continue;
      if (make(s, k, NULL, p->id, &v, 1, &m) != SOZAI_OK) continue; /* need not go together */
      holds(s, &m, &v, "given on top of a preset");
      unmake(s, &m);
    }
  }
}

/* ---- whose memory ------------------------------------------------------------------- */

/* "Strings handed in are copied where they are kept"; "Memory handed in by the host. Read
 * during create() only, and copied." */
static void copied(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    const kind *k = &kinds[i];
    for (uint32_t p = 0; p < k->parameter_count; p++) {
      const sozai_parameter *q = k->parameters[p];
      sozai_value v;
      if (!make_default(q, &v) || (q->kind != SOZAI_KIND_CHOICE && q->kind != SOZAI_KIND_TEXT &&
                                   q->kind != SOZAI_KIND_PATH && q->kind != SOZAI_KIND_COLOUR))
        continue;
      const char *text = v.text ? v.text : q->default_text;
      if (q->kind == SOZAI_KIND_TEXT && text && !*text) text = "validate";
      char id[200], room[400];
      if (!text || strlen(text) >= sizeof room || strlen(q->id) >= sizeof id) continue;
      strcpy(id, q->id);
      strcpy(room, text);
      sozai_value lent = v;
      lent.id = id;
      lent.text = room;
      made m;
      if (make(s, k, NULL, NULL, &lent, 1, &m) != SOZAI_OK) continue;
      memset(id, '#', strlen(id));
      memset(room, '#', strlen(room));
      memset(&lent, 0xff, sizeof lent);
      sozai_value is = {0};
      int32_t r = made_value(s, &m, q->id, &is);
      EXPECT(r == SOZAI_OK && is.text && strcmp(is.text, text) == 0,
             "%s: value(%s) is '%.100s', not '%s', after the host's own text changed", k->id, q->id,
             is.text ? is.text : "NULL", text);
      unmake(s, &m);
    }
  }
}

/* value: "UNKNOWN"; and ARGUMENT for "a NULL" */
static void asked_wrongly(subject *s) {
  uint32_t n = subject_textures(s, kinds);
  for (uint32_t i = 0; i < n; i++) {
    made m;
    sozai_value v = {0};
    if (make(s, &kinds[i], NULL, NULL, NULL, 0, &m) != SOZAI_OK) continue;
    static const char *const none[] = {"validate_none", "", "%s%n", "Seed "};
    for (uint32_t k = 0; k < COUNT_OF(none); k++) {
      doing("value(\"%s\")", none[k]);
      int32_t r = made_value(s, &m, none[k], &v);
      EXPECT(r == SOZAI_ERROR_UNKNOWN, "%s: value(\"%s\") gave %s", kinds[i].id, none[k],
             result_name(r));
    }
    doing("value(NULL)");
    int32_t r = made_value(s, &m, NULL, &v);
    EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: value(NULL) gave %s", kinds[i].id, result_name(r));
    if (kinds[i].parameter_count) {
      doing("value with out NULL");
      r = made_value(s, &m, kinds[i].parameters[0]->id, NULL);
      EXPECT(r == SOZAI_ERROR_ARGUMENT, "%s: value with out NULL gave %s", kinds[i].id,
             result_name(r));
    }
    unmake(s, &m);
  }
}

CHECKS(values, //
       {"values.default-read", "create.default",
        "value() gives the defaults of a texture made of none", default_read},
       {"values.default-given", "evaluate.answers",
        "a default that is given makes the same texture", default_given},
       {"values.set-read", "create.default", "value() gives what was given", set_read},
       {"values.as-text", "evaluate.answers", "a value as text is the value as a number", as_text},
       {"values.examples", "create.default",
        "the header's examples of text are read: 1.5, 12, 1 2 3, #c08040", examples},
       {"values.int-for-float", "create.default", "an INT is taken for a FLOAT", int_for_float},
       {"values.later-counts", "create.default", "of two values for one parameter the later counts",
        later},
       {"values.many", "create.default", "so does the last of a hundred thousand", many},
       {"values.bounds", "create.default", "the ends of a range belong to it", bounds},
       {"values.presets", "create.default",
        "every preset can be made, and value() gives its values", presets},
       {"values.on-top", "create.default", "values come on top of a preset", on_top},
       {"values.copied", "create.default", "texts handed in are copied", copied},
       {"values.unknown", "create.default", "value() of an unknown or no parameter is refused",
        asked_wrongly});
