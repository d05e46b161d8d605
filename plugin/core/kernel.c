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

static void skip(const float **array, uint32_t count) {
  if (*array) *array += count;
}

/* Of a batch what lies behind the first so many points. */
static void skip_all(sozai_batch *b, float *out[64], uint32_t count) {
  for (int c = 0; c < 3; c++) {
    skip(&b->point[c], count);
    skip(&b->normal[c], count);
    skip(&b->light[c], count);
    skip(&b->light_colour[c], count);
    skip(&b->view[c], count);
  }
  skip(&b->footprint, count);
  for (int k = 0; k < 64; k++) {
    if (out[k]) out[k] += count;
  }
}

static __attribute__((noinline)) void run_pieces(const kernel_set *use, const void *constants,
                                                 const kernel_io *io) {
  sozai_batch b = *io->in;
  float *out[64];
  for (int k = 0; k < 64; k++) out[k] = io->wanted >> k & 1 ? io->out[k] : NULL;
  const kernel_io piece = {&b, out, io->wanted};
  for (uint32_t left = io->in->count; left; left -= b.count) {
    b.count = kernel_piece(left);
    run(use, constants, &piece);
    skip_all(&b, out, b.count);
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
