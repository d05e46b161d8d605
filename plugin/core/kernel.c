/* SPDX-License-Identifier: Apache-2.0 */
#include "kernel.h"

int32_t kernel_choose(const kernel_set table[CPU_COUNT], kernel_set *out) {
  int set;
  int32_t r = cpu_choose(&set);
  if (!r) *out = table[set];
  return r;
}

void kernel_run(const kernel_set *use, const void *constants, const kernel_io *io) {
  if (io->in->count == 1) { /* on the path of every point alone: without the division */
    use->single->evaluate(constants, io, 0, 1);
    return;
  }
  uint32_t count = io->in->count, lanes = use->wide->lanes;
  uint32_t whole = count / lanes * lanes, rest = count - whole;
  /* from half a block up the wide kernel is the cheaper */
  if (rest > lanes / 2) {
    whole = count;
    rest = 0;
  }
  if (whole) use->wide->evaluate(constants, io, 0, whole);
  if (rest) (rest == 1 ? use->single : use->narrow)->evaluate(constants, io, whole, count);
}
