/* SPDX-License-Identifier: Apache-2.0
 *
 * What the kernels of every material have in common: each is compiled once for
 * each instruction set and width, and a texture picks among those.
 */
#ifndef SOZAI_CORE_KERNEL_H
#define SOZAI_CORE_KERNEL_H

#include "../../api/sozai.h"
#include "cpu.h"

/* What evaluate was asked for: bit k of wanted says that out[k] is not NULL. Kernels are handed
 * batches whose `active` is NULL: active.h. */
typedef struct {
  const sozai_batch *in;
  float *const *out;
  uint64_t wanted;
} kernel_io;

static inline int kernel_wants(const kernel_io *io, int first, int count) {
  return (io->wanted >> first & ((1ull << count) - 1)) != 0;
}

/* Points from..to of the batch. constants: the material's own. */
typedef void kernel_evaluate(const void *constants, const kernel_io *io, uint32_t from,
                             uint32_t to);

/* One compilation of a kernel; the first member of the material's own struct. */
typedef struct {
  const char *name; /* of the instruction set */
  uint32_t lanes;
  kernel_evaluate *evaluate;
} kernel;

/* In a kernel's source: a name of this compilation's own, and its `kernel`. */
#define KERNEL_PASTE_(a, b) a##b
#define KERNEL_PASTE(a, b) KERNEL_PASTE_(a, b)
#define KERNEL_NAME(name) KERNEL_PASTE(name, SOZAI_KERNEL_SUFFIX)
#define KERNEL_STRING_(a) #a
#define KERNEL_STRING(a) KERNEL_STRING_(a)
#define KERNEL_OF(run)                                                                             \
  { KERNEL_STRING(SOZAI_ISA_NAME), LANES, run }

/* For each instruction set the wide kernel, one for what a few lanes hold, and
 * one for a point alone: a mostly empty block costs what a full one does. */
typedef struct {
  const kernel *wide, *narrow, *single;
} kernel_set;

/* Of so many points what a kernel is handed at a time: it counts in steps of some hundred, which
 * would run past the end of 32 bits. */
static inline uint32_t kernel_piece(uint32_t left) { return left < 1u << 30 ? left : 1u << 30; }

/* Defines table[CPU_COUNT] of the compilations type_ISA_LANES of a struct `type`
 * whose first member is `kernel kernel`. */
#if defined(__x86_64__)
#define KERNEL_SETS(type, table)                                                                   \
  extern const type type##_scalar_1, type##_sse2_4, type##_avx2_8, type##_avx2_1,                  \
      type##_avx512_16, type##_avx512_4, type##_avx512_1;                                          \
  static const kernel_set table[CPU_COUNT] = {                                                     \
      [CPU_AVX512] = {&type##_avx512_16.kernel, &type##_avx512_4.kernel, &type##_avx512_1.kernel}, \
      [CPU_AVX2] = {&type##_avx2_8.kernel, &type##_avx2_8.kernel, &type##_avx2_1.kernel},          \
      [CPU_SSE2] = {&type##_sse2_4.kernel, &type##_sse2_4.kernel, &type##_scalar_1.kernel},        \
      [CPU_SCALAR] = {&type##_scalar_1.kernel, &type##_scalar_1.kernel, &type##_scalar_1.kernel}}
#elif defined(__aarch64__)
#define KERNEL_SETS(type, table)                                                                   \
  extern const type type##_scalar_1, type##_neon_4;                                                \
  static const kernel_set table[CPU_COUNT] = {                                                     \
      [CPU_NEON] = {&type##_neon_4.kernel, &type##_neon_4.kernel, &type##_scalar_1.kernel},        \
      [CPU_SCALAR] = {&type##_scalar_1.kernel, &type##_scalar_1.kernel, &type##_scalar_1.kernel}}
#else
#define KERNEL_SETS(type, table)                                                                   \
  extern const type type##_scalar_1;                                                               \
  static const kernel_set table[CPU_COUNT] = {                                                     \
      [CPU_SCALAR] = {&type##_scalar_1.kernel, &type##_scalar_1.kernel, &type##_scalar_1.kernel}}
#endif

/* That of cpu_choose, whose errors it has. */
int32_t kernel_choose(const kernel_set table[CPU_COUNT], kernel_set *out);

/* A batch's input arrays, by number below KERNEL_INPUTS. */
#define KERNEL_INPUTS 16
const float **kernel_input(sozai_batch *b, int i);

/* Of a batch so many points from `first` on, no more than a piece: all of them, active or not. */
void kernel_run_part(const kernel_set *use, const void *constants, const kernel_io *io,
                     uint32_t first, uint32_t count);
/* A whole batch, each point by the kernel that is cheapest for it. */
void kernel_run(const kernel_set *use, const void *constants, const kernel_io *io);

#endif
