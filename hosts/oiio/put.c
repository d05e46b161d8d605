/* SPDX-License-Identifier: Apache-2.0 */
#include "put.h"

#include <string.h>
#include "evaluate.h"
#include "half.h"

#define WOVEN 4 /* layers of halves at once */

/* `to` comes by value: what is written could be it, for all the compiler knows,
 * which would read it again for every texel. */

static void put_floats(const float *from, const put_place to, uint32_t offset) {
  for (uint32_t row = 0; row < to.h; row++) {
    char *at = to.first + (ptrdiff_t)row * to.row + offset;
    for (uint32_t x = 0; x < to.w; x++, at += to.texel) memcpy(at, from++, sizeof *from);
  }
}

static void put_halves(const float *from, const put_place to, uint32_t offset) {
  uint16_t halves[SURFACE_BLOCK];
  half_from_float(halves, from, (size_t)to.w * to.h);
  const uint16_t *half = halves;
  for (uint32_t row = 0; row < to.h; row++) {
    char *at = to.first + (ptrdiff_t)row * to.row + offset;
    for (uint32_t x = 0; x < to.w; x++, at += to.texel) memcpy(at, half++, sizeof *half);
  }
}

static void put_four(float *const planes[WOVEN], const put_place to, uint32_t offset) {
  uint16_t halves[WOVEN][SURFACE_BLOCK];
  for (uint32_t k = 0; k < WOVEN; k++) half_from_float(halves[k], planes[k], (size_t)to.w * to.h);
  for (uint32_t row = 0; row < to.h; row++) {
    const uint16_t *from[WOVEN];
    for (uint32_t k = 0; k < WOVEN; k++) from[k] = halves[k] + (size_t)row * to.w;
    half_weave(to.first + (ptrdiff_t)row * to.row + offset, to.texel, from, to.w);
  }
}

/* Layers of halves side by side, four at once; the last four may write again
 * what those before them wrote. */
static void put_run(const put_layer *layers, uint32_t count, float *const *planes,
                    const put_place *to) {
  for (uint32_t k = 0; count < WOVEN && k < count; k++)
    put_halves(planes[k], *to, layers[k].offset);
  for (uint32_t k = 0; count >= WOVEN && k < count; k += WOVEN) {
    uint32_t first = k + WOVEN <= count ? k : count - WOVEN;
    put_four(planes + first, *to, layers[first].offset);
  }
}

/* Colours alone, which is what is read most. */
static bool is_rgb(const put_layer *layers, uint32_t count, const put_place *to) {
  const uint32_t size = sizeof(uint16_t);
  return count == 3 && layers[0].half && layers[1].half && layers[2].half &&
         to->texel == 3 * (ptrdiff_t)size && (uintptr_t)to->first % size == 0 &&
         to->row % (ptrdiff_t)size == 0;
}

static void put_rgb(float *const *planes, const put_place to) {
  for (uint32_t row = 0; row < to.h; row++) {
    size_t at = (size_t)row * to.w;
    const float *from[3] = {planes[0] + at, planes[1] + at, planes[2] + at};
    half_from_rgb((uint16_t *)(void *)(to.first + (ptrdiff_t)row * to.row), from, to.w);
  }
}

static void encode(float *numbers, size_t count) {
  for (size_t i = 0; i < count; i++) numbers[i] = 0.5f + 0.5f * numbers[i];
}

void put_layers(const put_layer *layers, uint32_t count, float *const *planes,
                const put_place *to) {
  for (uint32_t k = 0; k < count; k++)
    if (layers[k].encoded) encode(planes[k], (size_t)to->w * to->h);
  if (is_rgb(layers, count, to)) {
    put_rgb(planes, *to);
    return;
  }
  for (uint32_t k = 0, end; k < count; k = end) {
    for (end = k; end < count && layers[end].half;) end++;
    if (end > k)
      put_run(layers + k, end - k, planes + k, to);
    else
      put_floats(planes[end], *to, layers[end].offset), end++;
  }
}

void put_zeros(const put_place *to, size_t bytes) {
  for (uint32_t row = 0; row < to->h; row++)
    for (uint32_t x = 0; x < to->w; x++)
      memset(to->first + row * to->row + x * to->texel, 0, bytes);
}
