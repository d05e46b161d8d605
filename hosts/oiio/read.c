/* SPDX-License-Identifier: Apache-2.0
 *
 * Evaluating a box of texels: cut into tiles, those into blocks that fit the
 * processor's nearest caches, each of them one batch of all channels asked
 * for. */
#include "picture_parts.h"

#include <stdatomic.h>
#include <stdlib.h>
#include "evaluate.h"
#include "parallel.h"
#include "put.h"

#define TILES_FOR_THREADS 4u /* fewer are not worth starting threads for */

typedef struct job {
  const picture *picture;
  uint32_t level;
  uint32_t pixels[3]; /* of the level */
  const picture_box *box;
  const picture_place *to;
  put_layer layers[SURFACE_COMPONENTS];
  uint32_t layer_count;
  size_t texel_bytes;
  uint32_t most;     /* texels in a block */
  uint32_t tiles[3]; /* how many, each way */
  atomic_bool failed;
  failure *why;
} job;

/* ---- what of a texel -------------------------------------------------- */

static void add_layer(job *j, const output *o, uint32_t k) {
  bool half = j->to->format == PICTURE_NATIVE ? o->half : j->to->format == PICTURE_HALF;
  j->layers[j->layer_count++] = (put_layer){.component = o->first + k,
                                            .offset = (uint32_t)j->texel_bytes,
                                            .half = half,
                                            .encoded = o->encoded};
  j->texel_bytes += half ? sizeof(uint16_t) : sizeof(float);
}

static bool set_layers(job *j, const subimage *s) {
  uint32_t first = j->to->first, end = first + j->to->count, at = 0;
  if (first > s->components || j->to->count > s->components - first || end > SURFACE_COMPONENTS)
    return false;
  for (uint32_t i = 0; i < s->output_count; i++)
    for (uint32_t k = 0; k < s->outputs[i].components; k++, at++)
      if (at >= first && at < end) add_layer(j, &s->outputs[i], k);
  j->most = surface_fit(j->layer_count, PICTURE_TILE);
  return true;
}

/* ---- a block ---------------------------------------------------------- */

typedef struct block {
  uint32_t x, y, z, w, h;
} block;

static put_place place_of(const job *j, const block *b) {
  const picture_place *to = j->to;
  const uint32_t *begin = j->box->begin;
  char *first = (char *)to->data + (ptrdiff_t)(b->x - begin[0]) * to->stride[0] +
                (ptrdiff_t)(b->y - begin[1]) * to->stride[1] +
                (ptrdiff_t)(b->z - begin[2]) * to->stride[2];
  return (put_place){first, to->stride[0], to->stride[1], b->w, b->h};
}

static bool read_block(const job *j, float *room, const block *b, failure *why) {
  const picture *p = j->picture;
  surface_material material = {p->library->plugin.textures, p->texture};
  float *out[SURFACE_COMPONENTS] = {NULL}, *planes[SURFACE_COMPONENTS];
  for (uint32_t k = 0; k < j->layer_count; k++)
    out[j->layers[k].component] = planes[k] = room + (size_t)k * j->most;
  failure reason;
  if (!surface_evaluate(p->surface, &material, j->level, b->x, b->y, b->z, b->w, b->h, out,
                        SURFACE_COMPONENTS, NULL, &reason))
    return fail(why, EXIT_FAILURE, "%s: %s", p->recipe.file, reason.text);
  put_place to = place_of(j, b);
  put_layers(j->layers, j->layer_count, planes, &to);
  return true;
}

/* ---- a tile ----------------------------------------------------------- */

static uint32_t least(uint32_t a, uint32_t b) { return a < b ? a : b; }

static void zeros(const job *j, uint32_t x, uint32_t y, uint32_t z, uint32_t w, uint32_t h) {
  put_place to = place_of(j, &(block){x, y, z, w, h});
  put_zeros(&to, j->texel_bytes);
}

/* One slice of a tile: what is in the picture, then what is past it. */
static bool read_slice(const job *j, float *room, const uint32_t begin[3], const uint32_t end[3],
                       uint32_t z, failure *why) {
  bool inside = z < j->pixels[2];
  uint32_t x1 = inside ? least(end[0], j->pixels[0]) : begin[0];
  uint32_t y1 = inside ? least(end[1], j->pixels[1]) : begin[1];
  if (x1 < begin[0]) x1 = begin[0];
  if (y1 < begin[1] || x1 == begin[0]) y1 = begin[1];
  block b = {.x = begin[0], .z = z, .w = x1 - begin[0]};
  uint32_t rows = b.w ? j->most / b.w : 0;
  for (b.y = begin[1]; b.y < y1; b.y += b.h) {
    b.h = least(rows, y1 - b.y);
    if (!read_block(j, room, &b, why)) return false;
  }
  zeros(j, x1, begin[1], z, end[0] - x1, y1 - begin[1]);
  zeros(j, begin[0], y1, z, end[0] - begin[0], end[1] - y1);
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
  _Alignas(64) float room[SURFACE_ROOM];
  failure why;
  for (uint32_t z = begin[2]; z < end[2]; z++)
    if (!read_slice(j, room, begin, end, z, &why)) {
      if (!atomic_exchange(&j->failed, true)) *j->why = why;
      return;
    }
}

bool picture_read(const picture *p, uint32_t subimage, uint32_t level, const picture_box *box,
                  const picture_place *to, uint32_t threads, failure *why) {
  if (subimage >= p->about.subimage_count || level >= p->about.shape.levels)
    return fail(why, EXIT_FAILURE, "%s: no such subimage or mip level", p->recipe.file);
  job j = {.picture = p, .level = level, .box = box, .to = to, .why = why};
  if (!set_layers(&j, &p->subimages[subimage]))
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
