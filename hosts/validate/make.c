/* SPDX-License-Identifier: Apache-2.0 */
#include "make.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "batch.h"

bool kind_has_range(uint32_t k) {
  return k == SOZAI_KIND_FLOAT || k == SOZAI_KIND_INT || k == SOZAI_KIND_FLOAT3 ||
         k == SOZAI_KIND_COLOUR;
}

uint32_t kind_numbers(uint32_t k) {
  if (k == SOZAI_KIND_FLOAT3 || k == SOZAI_KIND_COLOUR) return 3;
  return k == SOZAI_KIND_FLOAT || k == SOZAI_KIND_INT || k == SOZAI_KIND_BOOL ? 1 : 0;
}

bool make_default(const sozai_parameter *p, sozai_value *out) {
  *out = (sozai_value){.id = p->id, .kind = p->kind};
  memcpy(out->number, p->default_number, kind_numbers(p->kind) * sizeof *out->number);
  switch (p->kind) {
  case SOZAI_KIND_CHOICE:
    out->text = p->choices[(uint32_t)p->default_number[0]];
    return true;
  case SOZAI_KIND_TEXT:
  case SOZAI_KIND_PATH:
  case SOZAI_KIND_IMAGE:
    out->text = p->default_text;
    return true;
  case SOZAI_KIND_BUFFER:
    return false;
  default:
    return p->kind <= SOZAI_KIND_IMAGE;
  }
}

bool make_good(subject *s, const sozai_parameter *p, sozai_value *out) {
  *out = (sozai_value){.id = p->id, .kind = p->kind};
  double x = chance_between(s, p->soft_min, p->soft_max);
  switch (p->kind) {
  case SOZAI_KIND_FLOAT:
    out->number[0] = x;
    return true;
  case SOZAI_KIND_INT:
    out->number[0] = (double)(int64_t)x;
    if (out->number[0] < p->hard_min) out->number[0] = p->hard_min;
    return true;
  case SOZAI_KIND_BOOL:
    out->number[0] = chance_below(s, 2);
    return true;
  case SOZAI_KIND_CHOICE:
    out->text = p->choices[chance_below(s, p->choice_count)];
    return true;
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR:
    for (int i = 0; i < 3; i++) out->number[i] = chance_between(s, p->soft_min, p->soft_max);
    return true;
  default:
    return false;
  }
}

bool make_text(const sozai_parameter *p, const sozai_value *v, given *out) {
  out->value = (sozai_value){.id = p->id, .kind = SOZAI_KIND_STRING, .text = out->text};
  switch (p->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT:
    snprintf(out->text, sizeof out->text, "%.17g", v->number[0]);
    return true;
  case SOZAI_KIND_BOOL:
    snprintf(out->text, sizeof out->text, "%s", v->number[0] != 0 ? "true" : "false");
    return true;
  case SOZAI_KIND_FLOAT3:
  case SOZAI_KIND_COLOUR:
    snprintf(out->text, sizeof out->text, "%.17g %.17g %.17g%s%s", v->number[0], v->number[1],
             v->number[2], p->kind == SOZAI_KIND_COLOUR && v->text ? " @ " : "",
             p->kind == SOZAI_KIND_COLOUR && v->text ? v->text : "");
    return true;
  case SOZAI_KIND_CHOICE:
  case SOZAI_KIND_TEXT:
  case SOZAI_KIND_PATH:
    if (strlen(v->text) >= sizeof out->text) return false;
    snprintf(out->text, sizeof out->text, "%s", v->text);
    return true;
  default:
    return false;
  }
}

bool value_same(const sozai_value *a, const sozai_value *b) {
  if (a->kind != b->kind) return false;
  uint32_t n = kind_numbers(a->kind);
  if (memcmp(a->number, b->number, n * sizeof *a->number) != 0) {
    for (uint32_t i = 0; i < n; i++) /* -0 and 0 are one value */
      if (!(a->number[i] == b->number[i])) return false;
  }
  if (a->kind == SOZAI_KIND_CHOICE || a->kind == SOZAI_KIND_TEXT || a->kind == SOZAI_KIND_PATH)
    return a->text && b->text && strcmp(a->text, b->text) == 0;
  return true;
}

const char *value_shown(const sozai_value *v) {
  static _Thread_local char room[4][200];
  static _Thread_local unsigned turn;
  char *out = room[turn++ % 4];
  uint32_t n = kind_numbers(v->kind);
  if (n == 1)
    snprintf(out, 200, "%.17g", v->number[0]);
  else if (n == 3)
    snprintf(out, 200, "%.17g %.17g %.17g", v->number[0], v->number[1], v->number[2]);
  else
    snprintf(out, 200, "\"%.150s\"", v->text ? v->text : "(NULL)");
  return out;
}

/* ---- making ---------------------------------------------------------------- */

int32_t make(subject *s, const kind *k, const sozai_host *host, const char *preset,
             const sozai_value *values, uint32_t count, made *out) {
  *out = (made){.kind = k};
  doing("%s of %s%s%s", k->texture ? "create" : "grow", k->id, preset ? ", preset " : "",
        preset ? preset : "");
  if (k->texture) return s->textures->create(host, k->id, preset, values, count, &out->texture);
  return s->geometry->grow(host, k->id, preset, values, count, &out->geometry);
}

void unmake(subject *s, made *m) {
  doing("%s of %s", m->texture ? "destroy" : "release", m->kind->id);
  if (m->texture) s->textures->destroy(m->texture);
  if (m->geometry) s->geometry->release(m->geometry);
  *m = (made){.kind = m->kind};
}

int32_t made_value(const subject *s, const made *m, const char *id, sozai_value *out) {
  return m->texture ? s->textures->value(m->texture, id, out)
                    : s->geometry->value(m->geometry, id, out);
}

bool same_bits(subject *s, const sozai_texture_info *info, sozai_texture *a, sozai_texture *b,
               const char *what) {
  batch *points = batch_new(s, info, NULL, 96);
  if (!points) return false;
  bool same = batch_run(s, a, points, "all inputs");
  float *wanted = same ? batch_answers(points) : NULL;
  batch_mark(points);
  same = wanted && batch_run(s, b, points, what) && batch_all_same(points, wanted, 0, 96, what);
  free(wanted);
  batch_free(points);
  return same;
}
