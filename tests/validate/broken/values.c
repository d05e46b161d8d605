/* SPDX-License-Identifier: Apache-2.0
 * Values: read, checked, and given back. */
#include <stdio.h>
#include <string.h>

#include "plugin.h"

static uint32_t numbers_of(uint32_t kind) {
  if (kind == SOZAI_KIND_FLOAT3 || kind == SOZAI_KIND_COLOUR) return 3;
  return kind <= SOZAI_KIND_BOOL ? 1 : 0;
}

static int find(const sozai_parameter *const *parameters, uint32_t count, const char *id) {
  for (uint32_t i = 0; i < count; i++)
    if (strcmp(parameters[i]->id, id) == 0) return (int)i;
  return -1;
}

/* ---- text ------------------------------------------------------------------------ */

static int32_t unreadable(const sozai_parameter *p, const char *text) {
  return say(SOZAI_ERROR_KIND, "%s: cannot read \"%.60s\"", p->id, text);
}

static int hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

static bool read_hex(const char *text, double *number) {
  if (strlen(text) != 7) return false;
  for (int i = 0; i < 3; i++) {
    int high = hex(text[1 + 2 * i]), low = hex(text[2 + 2 * i]);
    if (high < 0 || low < 0) return false;
    number[i] = (high * 16 + low) / 255.0;
  }
  return true;
}

static int32_t read_text(const sozai_parameter *p, const char *text, sozai_value *v) {
  v->kind = p->kind;
  if (p->kind == SOZAI_KIND_BUFFER)
    return say(SOZAI_ERROR_KIND, "%s: takes a buffer, not text", p->id);
  if (p->kind == SOZAI_KIND_CHOICE || p->kind == SOZAI_KIND_TEXT) {
    v->text = text;
    return SOZAI_OK;
  }
  v->text = NULL;
  if (p->kind == SOZAI_KIND_BOOL) {
    if (strcmp(text, "true") != 0 && strcmp(text, "false") != 0) return unreadable(p, text);
    v->number[0] = text[0] == 't';
    return SOZAI_OK;
  }
  if (p->kind == SOZAI_KIND_COLOUR && *text == '#')
    return read_hex(text, v->number) ? SOZAI_OK : unreadable(p, text);
  const char *at = text;
  for (uint32_t i = 0; i < numbers_of(p->kind); i++)
    if (!number_of(at, &at, &v->number[i])) return unreadable(p, text);
  while (*at == ' ') at++;
#ifdef TRAILING_TEXT
  return SOZAI_OK;
#endif
  if (p->kind == SOZAI_KIND_COLOUR && *at == '@') {
    while (*++at == ' ') continue;
    v->text = at;
    at += strlen(at);
  }
  return *at ? unreadable(p, text) : SOZAI_OK;
}

/* ---- checks ------------------------------------------------------------------------- */

static int32_t check_number(const sozai_parameter *p, double x) {
#ifdef NO_RANGE
  return x == x && x - x == 0 ? SOZAI_OK : say(SOZAI_ERROR_RANGE, "%s: not finite", p->id);
#endif
#ifdef TAKES_NAN
  if (x != x) return SOZAI_OK;
#endif
#ifdef RANGE_NOT_TOLD
  if (!(x >= p->hard_min && x <= p->hard_max))
    return say(SOZAI_ERROR_RANGE, "%s: %g is not possible", p->id, x);
#endif
#ifdef END_EXCLUDED
  if (x == p->hard_max) return say(SOZAI_ERROR_RANGE, "%s: %g is outside", p->id, x);
#endif
  if (!(x >= p->hard_min && x <= p->hard_max))
    return say(SOZAI_ERROR_RANGE, "%s: %.10g is outside %.10g to %.10g", p->id, x, p->hard_min,
               p->hard_max);
#ifndef TAKES_FRACTIONS
  if (p->kind != SOZAI_KIND_FLOAT && numbers_of(p->kind) == 1 && x != (double)(int64_t)x)
    return say(SOZAI_ERROR_KIND, "%s: %.10g is no whole number", p->id, x);
#endif
  return SOZAI_OK;
}

static int32_t check_choice(const sozai_parameter *p, const char *text, double *index) {
  for (uint32_t i = 0; i < p->choice_count; i++)
    if (strcmp(p->choices[i], text) == 0) {
      *index = i;
      return SOZAI_OK;
    }
#ifdef ANY_CHOICE
  *index = 0;
  return SOZAI_OK;
#endif
  return say(SOZAI_ERROR_RANGE, "%s: \"%.60s\" is none of: %s, %s", p->id, text, p->choices[0],
             p->choices[1]);
}

static int32_t read_buffer(const sozai_parameter *p, const sozai_buffer *given, setting *s) {
  sozai_buffer b;
  memset(&b, 0, sizeof b);
  s->has_buffer = given != NULL;
  if (!given) return SOZAI_OK;
  if (given->size < 8) return say(SOZAI_ERROR_ARGUMENT, "%s: the buffer has no size", p->id);
  memcpy(&b, given, given->size < sizeof b ? given->size : sizeof b);
  if (b.kind != p->buffer_kind)
    return say(SOZAI_ERROR_KIND, "%s: a buffer of kind %u", p->id, b.kind);
#ifndef BUFFER_TRUSTED
  if (b.dims[0] > WEIGHTS_MOST || b.dims[1] > WEIGHTS_MOST || b.dims[0] * b.dims[1] > WEIGHTS_MOST)
    return say(SOZAI_ERROR_RANGE, "%s: more than %d numbers", p->id, WEIGHTS_MOST);
#endif
  uint64_t n = b.dims[0] * b.dims[1];
  if (n && !b.data) return say(SOZAI_ERROR_ARGUMENT, "%s: the buffer's numbers are NULL", p->id);
  if (n) memcpy(s->weights, b.data, n * sizeof(float));
  s->buffer = b;
  return SOZAI_OK;
}

static int32_t copy_text(const sozai_parameter *p, const char *text, setting *s) {
  if (strlen(text) >= TEXT_MOST)
    return say(SOZAI_ERROR_RANGE, "%s: text of more than %d bytes", p->id, TEXT_MOST - 1);
  s->lent = text;
  strcpy(s->text, text);
  return SOZAI_OK;
}

static int32_t read_value(const sozai_parameter *p, const sozai_value *given, setting *s) {
  sozai_value v = *given;
  bool wants_text =
      v.kind == SOZAI_KIND_STRING ||
      ((v.kind == SOZAI_KIND_CHOICE || v.kind == SOZAI_KIND_TEXT) && v.kind == p->kind);
#ifdef NULL_TRUSTED
  wants_text = false;
#endif
  if (wants_text && !v.text) return say(SOZAI_ERROR_ARGUMENT, "%s: its text is NULL", p->id);
  int32_t r = SOZAI_OK;
  if (v.kind == SOZAI_KIND_STRING) r = read_text(p, given->text, &v);
  if (r) return r;
#ifndef INT_NOT_TAKEN
  if (v.kind == SOZAI_KIND_INT && p->kind == SOZAI_KIND_FLOAT) v.kind = SOZAI_KIND_FLOAT;
#endif
#ifndef ANY_KIND
  if (v.kind != p->kind)
    return say(SOZAI_ERROR_KIND, "%s: kind %u, not %u", p->id, v.kind, p->kind);
#endif
  for (uint32_t i = 0; i < numbers_of(p->kind); i++) {
    r = check_number(p, v.number[i]);
    if (r) return r;
  }
#ifdef FIRST_COUNTS
  if (s->lent) return SOZAI_OK;
  s->lent = "";
#endif
  memcpy(s->number, v.number, numbers_of(p->kind) * sizeof *s->number);
  if (p->kind == SOZAI_KIND_CHOICE) {
    r = check_choice(p, v.text, &s->number[0]);
    return r ? r : copy_text(p, p->choices[(int)s->number[0]], s);
  }
  if (p->kind == SOZAI_KIND_TEXT) return copy_text(p, v.text, s);
  if (p->kind == SOZAI_KIND_COLOUR)
    return copy_text(p, v.text && *v.text ? v.text : p->default_text, s);
  return p->kind == SOZAI_KIND_BUFFER ? read_buffer(p, v.buffer, s) : SOZAI_OK;
}

static int32_t read_values(setting *out, const char *owner,
                           const sozai_parameter *const *parameters, uint32_t parameter_count,
                           const sozai_value *values, uint32_t count) {
  for (uint32_t i = 0; i < count; i++) {
    if (!values[i].id) return say(SOZAI_ERROR_ARGUMENT, "value %u has no id", i);
    int k = find(parameters, parameter_count, values[i].id);
#ifdef TAKES_UNKNOWN
    if (k < 0) continue;
#endif
    if (k < 0)
      return say(SOZAI_ERROR_UNKNOWN, "%s has no parameter \"%.60s\"", owner, values[i].id);
#ifndef RESERVED_TAKEN
    if (values[i].reserved)
      return say(SOZAI_ERROR_ARGUMENT, "%s: reserved is %u", values[i].id, values[i].reserved);
#endif
    int32_t r = read_value(parameters[k], &values[i], &out[k]);
    if (r) return r;
  }
  return SOZAI_OK;
}

int32_t settings_read(setting *out, const char *owner, const sozai_parameter *const *parameters,
                      uint32_t parameter_count, const sozai_preset *const *presets,
                      uint32_t preset_count, const char *preset, const sozai_value *values,
                      uint32_t value_count) {
  if (value_count && !values) return say(SOZAI_ERROR_ARGUMENT, "values is NULL");
  for (uint32_t i = 0; i < parameter_count; i++) {
    const sozai_parameter *p = parameters[i];
    memcpy(out[i].number, p->default_number, sizeof out[i].number);
    if (p->kind == SOZAI_KIND_CHOICE) strcpy(out[i].text, p->choices[(int)p->default_number[0]]);
    if (p->default_text) strcpy(out[i].text, p->default_text);
  }
  int32_t r = SOZAI_OK;
  for (uint32_t i = 0; preset && i <= preset_count && !r; i++) {
    if (i == preset_count)
      return say(SOZAI_ERROR_UNKNOWN, "%s has no preset \"%.60s\"", owner, preset);
    if (strcmp(presets[i]->id, preset) != 0) continue;
    r = read_values(out, owner, parameters, parameter_count, presets[i]->values,
                    presets[i]->value_count);
    break;
  }
#ifdef PRESET_ON_TOP
  if (preset) return r;
#endif
  return r ? r : read_values(out, owner, parameters, parameter_count, values, value_count);
}

int32_t setting_value(const setting *s, const char *owner, const sozai_parameter *const *parameters,
                      uint32_t count, const char *id, sozai_value *out) {
  if (!id || !out) return say(SOZAI_ERROR_ARGUMENT, "value: an argument is NULL");
  int k = find(parameters, count, id);
  if (k < 0) return say(SOZAI_ERROR_UNKNOWN, "%s has no parameter \"%.60s\"", owner, id);
  *out = (sozai_value){.id = parameters[k]->id, .kind = parameters[k]->kind};
  memcpy(out->number, s[k].number, sizeof out->number);
  bool has_text = parameters[k]->default_text || parameters[k]->kind == SOZAI_KIND_CHOICE;
  if (has_text) out->text = s[k].text;
#ifdef TEXT_NOT_COPIED
  if (has_text && s[k].lent) out->text = s[k].lent;
#endif
  if (s[k].has_buffer) out->buffer = &s[k].buffer;
  return SOZAI_OK;
}
