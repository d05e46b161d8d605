/* SPDX-License-Identifier: Apache-2.0 */
#include "units.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "evaluate.h"
#include "parallel.h"
#include "texel_parts.h"

#define CHUNK 4096u /* texels that a thread takes at a time, more or less */
#define INPUTS 7    /* point, normal, footprint */
#define SIDES 6     /* of texels in parts: across, down */

/* A run of columns of a unit, all of its rows. */
typedef struct chunk {
  uint32_t unit, column, columns;
} chunk;

typedef struct job {
  const bake_source *source;
  const sozai_texture_info *info;
  const bake_unit *units;
  uint8_t *const *pixels;
  chunk *chunks;
  bool *wanted; /* the texture's components */
  uint32_t wanted_count;
  atomic_bool failed;
  failure why; /* of the first to fail */
} job;

uint64_t bake_unit_bytes(const bake_outputs *o, const bake_unit *u) {
  return (uint64_t)u->width * u->rows * o->pixel_bytes;
}

/* ---- one chunk --------------------------------------------------------------- */

typedef struct bench {
  float *memory;
  surface_room room;
  float **out;     /* the texture's components, NULL where not wanted */
  float *colours;  /* three numbers for each texel */
  uint32_t *place; /* of each texel among those evaluated */
  uint32_t count;  /* of those */
} bench;

static bool allocate(bench *b, const job *j, size_t texels) {
  memset(b, 0, sizeof *b);
  bool parts = surface_shape_of(j->source->ground->surface)->samples > 1;
  size_t inputs = INPUTS + (parts ? SIDES : 0);
  b->memory = malloc((inputs + 3 + j->wanted_count) * texels * sizeof *b->memory);
  b->room.covered = malloc(texels);
  b->place = malloc(texels * sizeof *b->place);
  b->out = calloc(j->info->component_count + 1, sizeof *b->out);
  if (!b->memory || !b->room.covered || !b->place || !b->out) return false;
  float *next = b->memory;
  for (int k = 0; k < 3; k++, next += texels) b->room.point[k] = next;
  for (int k = 0; k < 3; k++, next += texels) b->room.normal[k] = next;
  for (int k = 0; k < 3 && parts; k++, next += texels) b->room.across[k] = next;
  for (int k = 0; k < 3 && parts; k++, next += texels) b->room.down[k] = next;
  b->room.footprint = next, next += texels;
  b->colours = next, next += 3 * texels;
  for (uint32_t k = 0; k < j->info->component_count; k++)
    if (j->wanted[k]) b->out[k] = next, next += texels;
  return true;
}

static void release(bench *b) {
  free(b->memory);
  free(b->room.covered);
  free(b->place);
  free(b->out);
}

/* Texels far from all charts are all one: the first stands for the rest. */
static void gather(bench *b, uint32_t texels) {
  uint32_t far = UINT32_MAX;
  b->count = 0;
  for (uint32_t i = 0; i < texels; i++) {
    if (b->room.covered[i] == 0 && far != UINT32_MAX) {
      b->place[i] = far;
      continue;
    }
    uint32_t to = b->count++;
    if (b->room.covered[i] == 0) far = to;
    b->place[i] = to;
    if (to == i) continue;
    for (int k = 0; k < 3; k++) {
      b->room.point[k][to] = b->room.point[k][i];
      b->room.normal[k][to] = b->room.normal[k][i];
      if (!b->room.across[k]) continue;
      b->room.across[k][to] = b->room.across[k][i];
      b->room.down[k][to] = b->room.down[k][i];
    }
    b->room.footprint[to] = b->room.footprint[i];
  }
}

/* From the last to the first, each from a place not after its own. */
static void scatter(const bench *b, float *numbers, uint32_t texels) {
  if (b->count == texels) return;
  for (uint32_t i = texels; i-- > 0;) numbers[i] = numbers[b->place[i]];
}

static bool answer_mesh(const job *j, bench *b, const bake_unit *u, const chunk *c, failure *why) {
  const bake_source *s = j->source;
  const bake_ground *g = s->ground;
  uint32_t texels = c->columns * u->rows;
  if (!atlas_texels(g->atlas, g->tiles[u->picture], u->width, u->height, c->column, u->row,
                    c->columns, u->rows, &b->room))
    return fail(why, EXIT_FAILURE, "no texels at %u, %u of level %u", c->column, u->row, u->level);
  gather(b, texels);
  sozai_batch batch = {.size = sizeof batch,
                       .count = b->count,
                       .footprint = b->room.footprint,
                       .out = b->out,
                       .out_count = j->info->component_count};
  texel_parts parts = {.side = surface_shape_of(g->surface)->samples};
  for (int k = 0; k < 3; k++) {
    batch.point[k] = b->room.point[k];
    batch.normal[k] = b->room.normal[k];
    parts.across[k] = b->room.across[k];
    parts.down[k] = b->room.down[k];
  }
  surface_material material = {s->textures, s->texture};
  int32_t result = parts.side > 1 ? texel_parts_evaluate(&parts, &material, &batch)
                                  : s->textures->evaluate(s->texture, &batch);
  if (result == SOZAI_OK) return true;
  return fail(why, EXIT_FAILURE, "evaluate: %s", s->textures->last_error());
}

/* In the blocks that surface_evaluate takes: some whole rows of the chunk. */
static bool answer_plane(const job *j, bench *b, const bake_unit *u, const chunk *c, failure *why) {
  const bake_source *s = j->source;
  surface_material material = {s->textures, s->texture};
  uint32_t most = SURFACE_BLOCK / c->columns;
  b->count = c->columns * u->rows;
  for (uint32_t row = 0; row < u->rows; row += most) {
    float *out[SURFACE_COMPONENTS] = {NULL};
    for (uint32_t k = 0; k < j->info->component_count && k < SURFACE_COMPONENTS; k++)
      if (b->out[k]) out[k] = b->out[k] + (size_t)row * c->columns;
    uint32_t rows = u->rows - row < most ? u->rows - row : most;
    if (!surface_evaluate(s->ground->surface, &material, u->level, c->column, u->row + row, 0,
                          c->columns, rows, out, SURFACE_COMPONENTS, NULL, why))
      return false;
  }
  return true;
}

/* Colours before anything is encoded: three layers at a time. A component may be
 * in one layer only. */
static bool convert(const job *j, bench *b, failure *why) {
  const bake_outputs *o = j->source->outputs;
  for (uint32_t f = 0; f < o->file_count; f++)
    for (uint32_t i = 0; i < o->files[f].layer_count; i++) {
      const bake_layer *l = &o->files[f].layers[i];
      if (l->code != BAKE_COLOUR) continue;
      if (!bake_to_space(o, b->out + l->component, b->count, b->colours, why)) return false;
      i += 2;
    }
  return true;
}

static void encode(const job *j, bench *b, const chunk *c) {
  const bake_outputs *o = j->source->outputs;
  const bake_unit *u = &j->units[c->unit];
  uint8_t *file = j->pixels[c->unit];
  for (uint32_t f = 0; f < o->file_count; f++) {
    const bake_file *to = &o->files[f];
    uint32_t offset = 0;
    for (uint32_t i = 0; i < to->layer_count; i++) {
      const bake_layer *l = &to->layers[i];
      scatter(b, b->out[l->component], c->columns * u->rows);
      for (uint32_t row = 0; row < u->rows; row++)
        bake_encode(l, b->out[l->component] + (size_t)row * c->columns, c->columns,
                    file + ((size_t)row * u->width + c->column) * to->pixel_bytes + offset,
                    to->pixel_bytes);
      offset += bake_type_bytes(l->type);
    }
    file += (size_t)u->width * u->rows * to->pixel_bytes;
  }
}

static bool work(const job *j, const chunk *c, failure *why) {
  const bake_unit *u = &j->units[c->unit];
  if (cancel_requested()) return fail(why, EXIT_FAILURE, "cancelled");
  uint32_t texels = c->columns * u->rows;
  bench b;
  bool ok = allocate(&b, j, texels) || fail(why, EXIT_FAILURE, "out of memory");
  ok = ok &&
       (j->source->ground->atlas ? answer_mesh(j, &b, u, c, why) : answer_plane(j, &b, u, c, why));
  ok = ok && convert(j, &b, why);
  if (ok) encode(j, &b, c);
  release(&b);
  return ok;
}

static void run(void *context, uint32_t i) {
  job *j = context;
  failure why;
  if (atomic_load(&j->failed) || work(j, &j->chunks[i], &why)) return;
  if (!atomic_exchange(&j->failed, true)) j->why = why;
}

/* ---- all of them --------------------------------------------------------------- */

static uint32_t chunk_columns(const bake_unit *u) {
  uint32_t columns = CHUNK / u->rows;
  return columns < 1 ? 1 : columns > SURFACE_BLOCK ? SURFACE_BLOCK : columns;
}

static bool cut(job *j, uint32_t count, uint32_t *chunks, failure *why) {
  *chunks = 0;
  for (uint32_t i = 0; i < count; i++) {
    uint32_t columns = chunk_columns(&j->units[i]);
    *chunks += (j->units[i].width + columns - 1) / columns;
  }
  j->chunks = malloc((*chunks + (size_t)1) * sizeof *j->chunks);
  j->wanted = calloc(j->info->component_count + 1, sizeof *j->wanted);
  if (!j->chunks || !j->wanted) return fail(why, EXIT_FAILURE, "out of memory");
  *chunks = 0;
  for (uint32_t i = 0; i < count; i++)
    for (uint32_t at = 0, most = chunk_columns(&j->units[i]); at < j->units[i].width; at += most) {
      uint32_t left = j->units[i].width - at;
      j->chunks[(*chunks)++] = (chunk){i, at, left < most ? left : most};
    }
  const bake_outputs *o = j->source->outputs;
  for (uint32_t f = 0; f < o->file_count; f++)
    for (uint32_t i = 0; i < o->files[f].layer_count; i++)
      j->wanted[o->files[f].layers[i].component] = true;
  for (uint32_t k = 0; k < j->info->component_count; k++) j->wanted_count += j->wanted[k];
  return true;
}

bool bake_evaluate(const bake_source *s, const bake_unit *units, uint32_t count,
                   uint8_t *const *pixels, failure *why) {
  job j = {.source = s, .info = s->textures->info_of(s->texture), .units = units, .pixels = pixels};
  atomic_init(&j.failed, false);
  uint32_t chunks;
  bool ok = cut(&j, count, &chunks, why);
  if (ok) {
    parallel_for(s->threads, chunks, run, &j);
    ok = !atomic_load(&j.failed);
    if (!ok) *why = j.why;
  }
  free(j.chunks);
  free(j.wanted);
  return ok;
}
