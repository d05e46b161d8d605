/* SPDX-License-Identifier: Apache-2.0
 *
 * Evaluating a box of texels: cut into tiles, those into blocks that fit the
 * processor's nearest cache, each of them one batch. */
#include "picture_parts.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "evaluate.h"
#include "half.h"
#include "parallel.h"

#define TILES_FOR_THREADS 4u /* fewer are not worth starting threads for */

typedef struct block {
  uint32_t x, y, z, w, h;
} block;

typedef struct job {
  const picture *picture;
  const output *output;
  uint32_t level;
  uint32_t pixels[3]; /* of the level */
  const picture_box *box;
  const picture_place *to;
  uint32_t tiles[3]; /* how many, each way */
  atomic_bool failed;
  failure *why;
} job;

typedef struct room {
  float out[OUTPUT_MOST_COMPONENTS][SURFACE_BLOCK];
  float row[OUTPUT_MOST_COMPONENTS * PICTURE_TILE]; /* texel by texel */
} room;

static char *place_of(const job *j, uint32_t x, uint32_t y, uint32_t z) {
  const picture_place *to = j->to;
  const uint32_t *begin = j->box->begin;
  return (char *)to->data + (ptrdiff_t)(x - begin[0]) * to->stride[0] +
         (ptrdiff_t)(y - begin[1]) * to->stride[1] + (ptrdiff_t)(z - begin[2]) * to->stride[2];
}

/* ---- writing ---------------------------------------------------------- */

static void put_row(const job *j, room *r, uint32_t row, const block *b) {
  const picture_place *to = j->to;
  uint32_t n = to->count;
  size_t from = (size_t)row * b->w;
  for (uint32_t k = 0; k < n; k++) {
    const float *value = r->out[to->first + k] + from;
    for (uint32_t x = 0; x < b->w; x++) r->row[x * n + k] = value[x];
  }
  uint16_t halves[OUTPUT_MOST_COMPONENTS * PICTURE_TILE];
  if (to->half) half_from_float(halves, r->row, (size_t)b->w * n);
  const char *texels = to->half ? (const char *)halves : (const char *)r->row;
  size_t size = n * (to->half ? sizeof(uint16_t) : sizeof(float));
  char *at = place_of(j, b->x, b->y + row, b->z);
  if (to->stride[0] == (ptrdiff_t)size)
    memcpy(at, texels, b->w * size);
  else
    for (uint32_t x = 0; x < b->w; x++) memcpy(at + x * to->stride[0], texels + x * size, size);
}

static void put_zeros(const job *j, uint32_t x, uint32_t to_x, uint32_t y, uint32_t z) {
  size_t size = j->to->count * (j->to->half ? sizeof(uint16_t) : sizeof(float));
  for (; x < to_x; x++) memset(place_of(j, x, y, z), 0, size);
}

/* ---- evaluating ------------------------------------------------------- */

static void encode(float *value, size_t count) {
  for (size_t i = 0; i < count; i++) value[i] = 0.5f + 0.5f * value[i];
}

static bool evaluate(const job *j, room *r, const block *b, failure *why) {
  const picture *p = j->picture;
  surface_material material = {p->library->plugin.textures, p->texture};
  float *out[SURFACE_COMPONENTS] = {NULL};
  uint32_t first = j->to->first, end = first + j->to->count;
  for (uint32_t k = first; k < end; k++) out[j->output->first + k] = r->out[k];
  failure reason;
  if (!surface_evaluate(p->surface, &material, j->level, b->x, b->y, b->z, b->w, b->h, out,
                        SURFACE_COMPONENTS, NULL, &reason))
    return fail(why, EXIT_FAILURE, "%s: %s", p->recipe.file, reason.text);
  for (uint32_t k = first; j->output->encoded && k < end; k++)
    encode(r->out[k], (size_t)b->w * b->h);
  return true;
}

/* ---- a tile ----------------------------------------------------------- */

static uint32_t least(uint32_t a, uint32_t b) { return a < b ? a : b; }

/* One slice of a tile: what is in the picture, then what is past it. */
static bool read_slice(const job *j, room *r, const uint32_t begin[3], const uint32_t end[3],
                       uint32_t z, failure *why) {
  bool inside = z < j->pixels[2];
  uint32_t x1 = inside ? least(end[0], j->pixels[0]) : begin[0];
  uint32_t y1 = inside ? least(end[1], j->pixels[1]) : begin[1];
  if (x1 < begin[0]) x1 = begin[0];
  if (y1 < begin[1] || x1 == begin[0]) y1 = begin[1];
  block b = {.x = begin[0], .z = z, .w = x1 - begin[0]};
  uint32_t rows = b.w ? SURFACE_BLOCK / b.w : 0;
  for (b.y = begin[1]; b.y < y1; b.y += b.h) {
    b.h = least(rows, y1 - b.y);
    if (!evaluate(j, r, &b, why)) return false;
    for (uint32_t row = 0; row < b.h; row++) {
      put_row(j, r, row, &b);
      put_zeros(j, x1, end[0], b.y + row, z);
    }
  }
  for (uint32_t y = y1; y < end[1]; y++) put_zeros(j, begin[0], end[0], y, z);
  return true;
}

static void read_tile(void *context, uint32_t index) {
  job *j = context;
  if (atomic_load(&j->failed)) return;
  uint32_t place[3] = {index % j->tiles[0], index / j->tiles[0] % j->tiles[1],
                       index / j->tiles[0] / j->tiles[1]};
  uint32_t begin[3], end[3];
  for (int c = 0; c < 3; c++) {
    begin[c] = j->box->begin[c] + place[c] * j->picture->about.tile[c];
    end[c] = least(begin[c] + j->picture->about.tile[c], j->box->end[c]);
  }
  room r;
  failure why;
  for (uint32_t z = begin[2]; z < end[2]; z++)
    if (!read_slice(j, &r, begin, end, z, &why)) {
      if (!atomic_exchange(&j->failed, true)) *j->why = why;
      return;
    }
}

bool picture_read(const picture *p, uint32_t output, uint32_t level, const picture_box *box,
                  const picture_place *to, uint32_t threads, failure *why) {
  if (output >= p->about.output_count || level >= p->about.shape.levels)
    return fail(why, EXIT_FAILURE, "%s: no such subimage or mip level", p->recipe.file);
  job j = {.picture = p,
           .output = &p->outputs[output],
           .level = level,
           .box = box,
           .to = to,
           .why = why};
  if (to->first > j.output->components || to->count > j.output->components - to->first)
    return fail(why, EXIT_FAILURE, "%s: no such channels", p->recipe.file);
  surface_level(p->surface, level, j.pixels);
  uint64_t tiles = 1;
  for (int c = 0; c < 3; c++) {
    uint32_t length = box->end[c] > box->begin[c] ? box->end[c] - box->begin[c] : 0;
    j.tiles[c] = (length + p->about.tile[c] - 1) / p->about.tile[c];
    tiles *= j.tiles[c];
  }
  if (tiles > UINT32_MAX)
    return fail(why, EXIT_FAILURE, "%s: too many texels at once", p->recipe.file);
  atomic_init(&j.failed, false);
  if (tiles < TILES_FOR_THREADS) threads = 1;
  parallel_for(threads ? threads : 1, (uint32_t)tiles, read_tile, &j);
  return !atomic_load(&j.failed);
}
