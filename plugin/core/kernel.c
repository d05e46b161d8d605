/* SPDX-License-Identifier: Apache-2.0 */
#include "active.h"

int32_t kernel_choose(const kernel_set table[CPU_COUNT], kernel_set *out) {
  int set;
  int32_t r = cpu_choose(&set);
  if (!r) *out = table[set];
  return r;
}

static void run(const kernel_set *use, const void *constants, const kernel_io *io) {
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

const float **kernel_input(sozai_batch *b, int i) {
  const float **const list[] = {b->point, b->normal, b->light, b->light_colour, b->view};
  return i < KERNEL_INPUTS - 1 ? &list[i / 3][i % 3] : &b->footprint;
}

void kernel_run_part(const kernel_set *use, const void *constants, const kernel_io *io,
                     uint32_t first, uint32_t count) {
  sozai_batch b = *io->in;
  float *out[64];
  for (int i = 0; i < KERNEL_INPUTS; i++) {
    const float **array = kernel_input(&b, i);
    if (*array) *array += first;
  }
  for (int k = 0; k < 64; k++) out[k] = io->wanted >> k & 1 ? io->out[k] + first : NULL;
  b.count = count;
  b.active = NULL;
  const kernel_io part = {&b, out, io->wanted};
  run(use, constants, &part);
}

static __attribute__((noinline)) void run_pieces(const kernel_set *use, const void *constants,
                                                 const kernel_io *io) {
  for (uint32_t done = 0, n; done < io->in->count; done += n) {
    n = kernel_piece(io->in->count - done);
    kernel_run_part(use, constants, io, done, n);
  }
}

void kernel_run(const kernel_set *use, const void *constants, const kernel_io *io) {
  if (io->in->active) {
    active_run(use, constants, io);
  } else if (io->in->count == 1) { /* on the path of every point alone: without the division */
    use->single->evaluate(constants, io, 0, 1);
  } else if (io->in->count == kernel_piece(io->in->count)) {
    run(use, constants, io);
  } else {
    run_pieces(use, constants, io);
  }
}
