/* SPDX-License-Identifier: Apache-2.0 */
#include "job.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

#define VALUES_MOST 8
#define POINTS 96
#define SIDE 24u /* of the picture handed over */

uint64_t job_random(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15ull;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ z >> 27) * 0x94d049bb133111ebull;
  return z ^ z >> 31;
}

static double unit(uint64_t *s) { return (double)(job_random(s) >> 11) * 0x1p-53; }
static uint32_t below(uint64_t *s, uint32_t n) { return (uint32_t)(job_random(s) % n); }

void job_failed(tally *t, const char *format, ...) {
  va_list list;
  va_start(list, format);
  fputs("soak: ", stderr);
  vfprintf(stderr, format, list);
  fputc('\n', stderr);
  va_end(list);
  atomic_fetch_add(&t->failures, 1);
}

static uint64_t mix(uint64_t h, const void *data, size_t n) {
  const unsigned char *b = data;
  for (size_t i = 0; i < n; i++) h = (h ^ b[i]) * 0x100000001b3ull;
  return h;
}

/* ---- values ------------------------------------------------------------ */

typedef struct {
  sozai_value list[VALUES_MOST];
  uint32_t count;
  sozai_buffer picture;
  float pixels[SIDE * SIDE * 3];
} values;

static const char *const trees[] = {"sugi", "hinoki", "karamatsu"};

static double number(const sozai_parameter *p, uint64_t *s) {
  int hard = below(s, 12) == 0;
  double low = hard ? p->hard_min : p->soft_min, high = hard ? p->hard_max : p->soft_max;
  double x = low + unit(s) * (high - low);
  return p->kind == SOZAI_KIND_FLOAT ? x : (double)(int64_t)x;
}

/* A value for a parameter; 0: none is given. Now and then one that is refused. */
static int value_for(values *v, const sozai_parameter *p, uint64_t *s) {
  sozai_value *o = &v->list[v->count];
  *o = (sozai_value){.id = p->id, .kind = p->kind};
  switch (p->kind) {
  case SOZAI_KIND_FLOAT:
  case SOZAI_KIND_INT:
    o->number[0] = number(p, s);
    break;
  case SOZAI_KIND_BOOL:
    o->number[0] = below(s, 2);
    break;
  case SOZAI_KIND_CHOICE:
    o->text = p->choices[below(s, p->choice_count)];
    break;
  case SOZAI_KIND_COLOUR:
    if (below(s, 2)) o->text = "ACEScg";
    for (int c = 0; c < 3; c++) o->number[c] = unit(s);
    break;
  case SOZAI_KIND_FLOAT3:
    for (int c = 0; c < 3; c++) o->number[c] = p->soft_min + unit(s) * (p->soft_max - p->soft_min);
    break;
  case SOZAI_KIND_TEXT:
    if (strcmp(p->id, "tree") != 0 || below(s, 4)) return 0;
    o->text = trees[below(s, 3)];
    break;
  case SOZAI_KIND_IMAGE:
    if (below(s, 8)) return 0;
    for (uint32_t i = 0; i < SIDE * SIDE * 3; i++) v->pixels[i] = (float)unit(s);
    v->picture = (sozai_buffer){.size = sizeof v->picture,
                                .kind = SOZAI_BUFFER_IMAGE,
                                .dims = {SIDE, SIDE, 3},
                                .data = v->pixels};
    o->buffer = &v->picture;
    break;
  default:
    return 0;
  }
  switch (below(s, 90)) {
  case 0:
    o->number[0] = 1e30;
    break;
  case 1:
    o->kind = SOZAI_KIND_STRING;
    o->text = "no value at all";
    break;
  case 2:
    o->id = "no_such_parameter";
    break;
  default:
    break;
  }
  return 1;
}

static void make_values(values *v, const sozai_parameter *const *parameters, uint32_t count,
                        uint64_t *s) {
  uint32_t n = below(s, VALUES_MOST - 1);
  v->count = 0;
  for (uint32_t i = 0; i < n; i++)
    v->count += (uint32_t)value_for(v, parameters[below(s, count)], s);
}

/* Now and then a host that fails, or cancels, or allows too little. */
static void make_host(soak_host *h, uint64_t *s) {
  soak_host_init(h);
  uint32_t how = below(s, 24), when = 1 + below(s, 12);
  h->limit = (sozai_limit){"texture_bytes", 1000};
  if (how == 0) h->fail_at = when;
  if (how == 1) h->cancel_at = when;
  if (how == 2) h->host.limits = &h->limit, h->host.limit_count = 1;
}

static const char *preset_of(const sozai_preset *const *presets, uint32_t count, uint64_t *s) {
  if (!count || below(s, 8) == 0) return NULL;
  return below(s, 40) ? presets[below(s, count)]->id : "no such preset";
}

/* Every refusal is one of the header's, and says why. */
static uint64_t refused(const char *what, int32_t r, const char *why, const void *out, tally *t) {
  atomic_fetch_add(&t->refused, 1);
  if (r > SOZAI_ERROR_ARGUMENT || r < SOZAI_ERROR_LIMIT) job_failed(t, "%s gave %d", what, r);
  if (!why || !*why) job_failed(t, "%s gave %d without a reason", what, r);
  if (out) job_failed(t, "%s gave %d and an object", what, r);
  return mix(0x5eed, &r, sizeof r);
}

/* ---- textures ---------------------------------------------------------- */

uint64_t job_evaluate(const plugin *p, const sozai_texture *texture, uint64_t seed, uint64_t chunks,
                      tally *t) {
  enum { INPUTS = 16, MOST = 64 };
  uint64_t s = seed ^ 0xe7a1;
  uint32_t components = p->textures->info_of(texture)->component_count;
  float in[INPUTS][POINTS], out[MOST][POINTS], *to[MOST];
  for (int k = 0; k < INPUTS; k++) {
    double scale = k < 3 ? 400.0 : k == 15 ? 2.0 : 2.0;
    for (int i = 0; i < POINTS; i++) in[k][i] = (float)((unit(&s) - (k == 15 ? 0.2 : 0.5)) * scale);
  }
  uint64_t wanted = job_random(&s) | job_random(&s);
  for (uint32_t from = 0; from < POINTS;) {
    uint32_t n = 1 + (uint32_t)(job_random(&chunks) % (POINTS - from));
    sozai_batch b = {.size = sizeof b, .count = n, .out = to, .out_count = components};
    for (uint32_t c = 0; c < components; c++) to[c] = wanted >> c & 1 ? out[c] + from : NULL;
    for (int a = 0; a < 3; a++) {
      b.point[a] = in[a] + from;
      b.normal[a] = in[3 + a] + from;
      b.light[a] = in[6 + a] + from;
      b.light_colour[a] = in[9 + a] + from;
      b.view[a] = in[12 + a] + from;
    }
    b.footprint = in[15] + from;
    int32_t r = p->textures->evaluate(texture, &b);
    if (r) job_failed(t, "evaluate gave %d: %s", r, p->textures->last_error());
    from += n;
  }
  atomic_fetch_add(&t->points, POINTS);
  uint64_t h = wanted;
  for (uint32_t c = 0; c < components; c++)
    if (wanted >> c & 1) h = mix(h, out[c], sizeof out[c]);
  return h;
}

static int32_t create(const plugin *p, uint64_t seed, soak_host *h, sozai_texture **out, tally *t) {
  uint64_t s = seed;
  const sozai_texture_info *info = p->textures->info(below(&s, p->textures->count()));
  values v;
  make_values(&v, info->parameters, info->parameter_count, &s);
  const char *preset = preset_of(info->presets, info->preset_count, &s);
  int32_t r = p->textures->create(&h->host, info->id, preset, v.list, v.count, out);
  if (r == SOZAI_OK) atomic_fetch_add(&t->created, 1);
  return r;
}

sozai_texture *job_texture(const plugin *p, uint64_t seed, void **keep, tally *t) {
  soak_host *h = malloc(sizeof *h);
  if (!h) return NULL;
  sozai_texture *texture = NULL;
  soak_host_init(h);
  int32_t r = create(p, seed, h, &texture, t);
  if (r) refused("create", r, p->textures->last_error(), texture, t);
  *keep = h;
  return texture;
}

static uint64_t texture_job(const plugin *p, uint64_t seed, uint64_t chunks, tally *t) {
  uint64_t s = seed ^ 0x7e7;
  soak_host h;
  make_host(&h, &s);
  sozai_texture *texture = NULL;
  int32_t r = create(p, seed, &h, &texture, t);
  if (r) return refused("create", r, p->textures->last_error(), texture, t);
  uint64_t hash = job_evaluate(p, texture, seed, chunks, t);
  p->textures->destroy(texture);
  return hash;
}

/* ---- geometry ---------------------------------------------------------- */

static const float corners[8][3] = {{0, 0, 0},  {20, 0, 0},  {20, 15, 0},  {0, 15, 0},
                                    {0, 0, 10}, {20, 0, 10}, {20, 15, 10}, {0, 15, 10}};
static const uint32_t faces[36] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                   1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};

static uint64_t geometry_job(const plugin *p, uint64_t seed, tally *t) {
  uint64_t s = seed ^ 0x9e0;
  soak_host h;
  make_host(&h, &s);
  const sozai_generator_info *info = p->geometry->info(below(&s, p->geometry->count()));
  const sozai_buffer box = {.size = sizeof box,
                            .kind = SOZAI_BUFFER_MESH,
                            .dims = {8, 12},
                            .points = &corners[0][0],
                            .indices = faces};
  /* small ones: a year of soaking is not a forest */
  sozai_value tree[] = {{.id = "age", .kind = SOZAI_KIND_INT, .number = {2 + below(&s, 8)}},
                        {.id = "orders", .kind = SOZAI_KIND_INT, .number = {below(&s, 3)}},
                        {.id = "seed", .kind = SOZAI_KIND_INT, .number = {below(&s, 1000)}}};
  sozai_value fiber[] = {{.id = "hull", .kind = SOZAI_KIND_BUFFER, .buffer = &box},
                         {.id = "count", .kind = SOZAI_KIND_INT, .number = {1 + below(&s, 60)}},
                         {.id = "cells", .kind = SOZAI_KIND_INT, .number = {16}},
                         {.id = "vertices", .kind = SOZAI_KIND_INT, .number = {4 + below(&s, 12)}}};
  int is_tree = strcmp(info->id, "tree") == 0;
  sozai_geometry *g = NULL;
  int32_t r = p->geometry->grow(&h.host, info->id, preset_of(info->presets, info->preset_count, &s),
                                is_tree ? tree : fiber, is_tree ? 3 : 4, &g);
  if (r) return refused("grow", r, p->geometry->last_error(), g, t);
  atomic_fetch_add(&t->grown, 1);
  const sozai_curves *c = NULL;
  const sozai_mesh *m = NULL;
  uint64_t hash = 0;
  const sozai_detail detail = {.size = sizeof detail, .level = below(&s, 4)};
  r = p->geometry->curves(g, &detail, &c);
  hash = r ? refused("curves", r, p->geometry->last_error(), c, t)
           : mix(hash, c->points, c->point_count * 12);
  r = p->geometry->mesh(g, &detail, &m);
  p->geometry->release(g);
  hash ^= r ? refused("mesh", r, p->geometry->last_error(), m, t)
            : mix(hash, m->points, m->point_count * 12);
  p->geometry->release_curves(c);
  p->geometry->release_mesh(m);
  return hash;
}

uint64_t job_run(const plugin *p, uint64_t seed, uint64_t chunks, tally *t) {
  return seed % 16 == 0 ? geometry_job(p, seed, t) : texture_job(p, seed, chunks, t);
}
