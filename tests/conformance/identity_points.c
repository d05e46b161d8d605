/* SPDX-License-Identifier: Apache-2.0 */
#include "identity_points.h"

#include <string.h>

static float float_of_bits(uint32_t bits) {
  float f;
  memcpy(&f, &bits, sizeof f);
  return f;
}

/* Within -1..1, in steps of 2^-23: exact. */
static float sides(uint32_t r) { return (float)((int32_t)(r >> 8) - (1 << 23)) * 0x1p-23f; }

/* Every power of two from 2^lo to 2^(lo + octaves) as likely. */
static float any_size(uint64_t r, uint32_t lo, uint32_t octaves) {
  uint32_t exponent = 127u + lo + (uint32_t)(r >> 32) % octaves;
  return float_of_bits(exponent << 23 | ((uint32_t)r & 0x7fffffu));
}

uint32_t points_inputs(uint64_t block) {
  static const uint32_t without[] = {0,
                                     0,
                                     0,
                                     SOZAI_INPUT_LIGHT_COLOUR,
                                     SOZAI_INPUT_FOOTPRINT,
                                     SOZAI_INPUT_LIGHT,
                                     SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT,
                                     SOZAI_INPUT_VIEW | SOZAI_INPUT_LIGHT_COLOUR,
                                     SOZAI_INPUT_NORMAL | SOZAI_INPUT_LIGHT |
                                         SOZAI_INPUT_LIGHT_COLOUR | SOZAI_INPUT_VIEW |
                                         SOZAI_INPUT_FOOTPRINT};
  return 0x3fu & ~without[mix64(block * 3 + 1) % (sizeof without / sizeof without[0])];
}

/* A third anywhere in a log, a third close together as a picture's are, a
 * third about the pith and the planes where something might change over. */
static void place(uint64_t block, uint64_t r, float (*in)[BLOCK], uint32_t i) {
  uint64_t kind = mix64(block) % 3, cluster = mix64(block * 7 + i / 256u);
  for (int c = 0; c < 3; c++) {
    uint32_t a = (uint32_t)mix64(r + (uint64_t)c);
    float x = 1500.0f * sides(a);
    if (kind == 1) x = 0.25f * sides(a) + 200.0f * sides((uint32_t)mix64(cluster + (uint64_t)c));
    if (kind == 2) {
      static const float special[] = {0.0f, -0.0f, 900.0f, -1800.0f, 1.0f, 1e-20f};
      x = a & 0x100u ? special[a % 6u] : 8.0f * sides(a);
    }
    in[IN_POINT + c][i] = x;
  }
}

/* Of any length; some along an axis, some zero, few not numbers at all. */
static void direction(uint64_t r, float *x, float *y, float *z) {
  uint32_t rare = (uint32_t)(r % 64u);
  *x = sides((uint32_t)mix64(r));
  *y = sides((uint32_t)mix64(r + 1));
  *z = sides((uint32_t)mix64(r + 2));
  if (rare == 0) *x = *y = 0.0f;
  if (rare == 1) *x = *z = -0.0f;
  if (rare == 2) *x = *y = *z = 0.0f;
  if (rare == 3) *y = float_of_bits(0x7fc00000u);
  if (rare == 4) *x = *y = *z = *x * 1e25f;
  if (rare == 5) *z = *z * 1e-30f;
}

void points_make(uint64_t block, float (*in)[BLOCK]) {
  for (uint32_t i = 0; i < BLOCK; i++) {
    uint64_t r = mix64(block * BLOCK + i) & ~(uint64_t)255u;
    place(block, r, in, i);
    direction(mix64(r + 10), &in[IN_NORMAL][i], &in[IN_NORMAL + 1][i], &in[IN_NORMAL + 2][i]);
    direction(mix64(r + 20), &in[IN_LIGHT][i], &in[IN_LIGHT + 1][i], &in[IN_LIGHT + 2][i]);
    direction(mix64(r + 30), &in[IN_VIEW][i], &in[IN_VIEW + 1][i], &in[IN_VIEW + 2][i]);
    for (int c = 0; c < 3; c++) {
      in[IN_LIGHT_COLOUR + c][i] = 2.0f * sides((uint32_t)mix64(r + 40 + (uint64_t)c));
    }
    /* 2^-10 to 2^7 mm: a thousandth to a hundred and more */
    in[IN_FOOTPRINT][i] = any_size(mix64(r + 50), (uint32_t)-10, 17);
    if (r >> 8 & 1u && (r >> 9) % 16u == 0) in[IN_FOOTPRINT][i] = 0.0f;
  }
}
