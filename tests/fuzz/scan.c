/* SPDX-License-Identifier: Apache-2.0
 * What wood reads off a picture of an end grain: any picture, of any proportion. */
#include <math.h>
#include <string.h>

#include "fuzz.h"
#include "wood/scan.h"

/* A log upon a ground, and pixels of the input's over it. */
static void paint(scan *s, float *rgb, bytes *b) {
  float radius = (float)take_u8(b) / 300.0f * (float)(s->nx < s->nz ? s->nx : s->nz);
  float x0 = (float)take_u8(b) / 255.0f * (float)s->nx;
  float z0 = (float)take_u8(b) / 255.0f * (float)s->nz;
  int ground = take_u8(b);
  for (int i = 0; i < s->nx * s->nz; i++) {
    float x = (float)(i % s->nx) - x0, z = (float)(i / s->nx) - z0, r = sqrtf(x * x + z * z);
    float value = r < radius ? 0.3f + 0.2f * sinf(r) : (float)ground / 255.0f;
    for (int c = 0; c < 3; c++) rgb[3 * i + c] = value;
  }
  while (b->left) {
    uint32_t at = take_u32(b) % (uint32_t)(3 * s->nx * s->nz);
    uint8_t way = take_u8(b);
    rgb[at] = (float)way / 255.0f;
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  bytes b = {data, size};
  scan s = {.nx = 1 + take_u8(&b) % 96, .nz = 1 + take_u8(&b) % 96};
  size_t cells = (size_t)(s.nx * s.nz), room = cells + 2 * (size_t)(s.nx + s.nz);
  float *rgb = malloc(3 * cells * sizeof *rgb), rim[64];
  s.wood = malloc(cells);
  s.grey = malloc(room * sizeof *s.grey);
  s.tensor = malloc(3 * cells * sizeof *s.tensor);
  s.stack = malloc(room * sizeof *s.stack);
  s.votes = malloc((size_t)scan_votes(s.nx, s.nz) * sizeof *s.votes);
  CHECK(rgb && s.wood && s.grey && s.tensor && s.stack && s.votes);
  paint(&s, rgb, &b);
  s.rgb = rgb;
  double pith[2] = {0.5 * s.nx, 0.5 * s.nz};
  int disc = scan_wood(&s);
  for (size_t i = 0; i < cells; i++) CHECK(s.wood[i] <= 1);
  if (scan_pith(&s, disc, pith)) CHECK(isfinite(pith[0]) && isfinite(pith[1]));
  if (scan_rim(&s, pith, 64, rim))
    for (int i = 0; i < 64; i++) CHECK(isfinite(rim[i]) && rim[i] >= 0);
  free(rgb);
  free(s.wood);
  free(s.grey);
  free(s.tensor);
  free(s.stack);
  free(s.votes);
  return 0;
}
