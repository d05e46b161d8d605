/* SPDX-License-Identifier: Apache-2.0 */
#include "active.h"

#include <string.h>

/* Points: shorter ones are copied, which is sooner than half a block's waste. */
#define STRETCH 48u
#define PACKED 64u /* points that are copied at a time */

/* So many points that stand at `at`. */
static __attribute__((noinline)) void run_packed(const kernel_set *use, const void *constants,
                                                 const kernel_io *io, const uint32_t *at,
                                                 uint32_t count) {
  float in[KERNEL_INPUTS][PACKED], room[ACTIVE_OUTPUTS][PACKED];
  sozai_batch b = *io->in;
  float *out[ACTIVE_OUTPUTS];
  for (int k = 0; k < ACTIVE_OUTPUTS; k++) out[k] = io->wanted >> k & 1 ? room[k] : NULL;
  for (int i = 0; i < KERNEL_INPUTS; i++) {
    const float **from = kernel_input(&b, i);
    if (!*from) continue;
    for (uint32_t n = 0; n < count; n++) in[i][n] = (*from)[at[n]];
    *from = in[i];
  }
  b.count = count;
  b.active = NULL;
  const kernel_io part = {&b, out, io->wanted};
  kernel_run(use, constants, &part);
  for (int k = 0; k < ACTIVE_OUTPUTS; k++) {
    for (uint32_t n = 0; n < count && out[k]; n++) io->out[k][at[n]] = room[k][n];
  }
}

/* How many points from the first on are active, of so many at most. */
static uint32_t stretch(const uint8_t *active, uint32_t most) {
  most = kernel_piece(most);
  const uint8_t *end = memchr(active, 0, most);
  return end ? (uint32_t)(end - active) : most;
}

void active_run(const kernel_set *use, const void *constants, const kernel_io *io) {
  uint32_t at[PACKED], packed = 0;
  const uint8_t *active = io->in->active;
  for (uint32_t i = 0, count = io->in->count, n; i < count; i += n) {
    n = 1;
    if (!active[i]) continue;
    n = stretch(active + i, count - i);
    if (n >= STRETCH) {
      kernel_run_part(use, constants, io, i, n);
      continue;
    }
    for (uint32_t k = 0; k < n; k++) {
      at[packed++] = i + k;
      if (packed < PACKED) continue;
      run_packed(use, constants, io, at, packed);
      packed = 0;
    }
  }
  if (packed) run_packed(use, constants, io, at, packed);
}
