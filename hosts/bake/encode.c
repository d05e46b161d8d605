/* SPDX-License-Identifier: Apache-2.0 */
#include <half.h>
#include <math.h>
#include <string.h>
#include "outputs.h"

#define MOST_HALF 65504.0f

/* Rounded to nearest; what is below 0 or above 1 is cut. */
static uint32_t whole(float x, float most) {
  if (!(x > 0)) return 0;
  return x >= 1 ? (uint32_t)most : (uint32_t)(x * most + 0.5f);
}

static uint16_t half_of(float x) {
  float cut = x > MOST_HALF ? MOST_HALF : x < -MOST_HALF ? -MOST_HALF : x;
  return imath_float_to_half(cut);
}

void bake_encode(const bake_layer *l, const float *numbers, uint32_t count, uint8_t *to,
                 uint32_t pixel_bytes) {
  for (uint32_t i = 0; i < count; i++, to += pixel_bytes) {
    float x = l->code == BAKE_DIRECTION ? 0.5f + 0.5f * numbers[i] : numbers[i];
    uint16_t two;
    switch (l->type) {
    case IMAGE_UINT8:
      *to = (uint8_t)whole(x, 255);
      break;
    case IMAGE_UINT16:
      two = (uint16_t)whole(x, 65535);
      memcpy(to, &two, 2);
      break;
    case IMAGE_HALF:
      two = half_of(x);
      memcpy(to, &two, 2);
      break;
    default:
      memcpy(to, &x, 4);
    }
  }
}
