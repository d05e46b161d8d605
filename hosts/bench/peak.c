/* SPDX-License-Identifier: Apache-2.0
 *
 * Six products and six sums run on beside one another: more than the product
 * of latency and width of any unit there is, in less than the 16 registers of
 * SSE2. The empty asm says that all of them are read and written, so that the
 * compiler can leave none out. */
#include "peak.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include "clock.h"

#define ROUNDS 20000
#define OPS_A_ROUND (4 * 12)
#define TRIES 200 /* of a tenth of a millisecond */

#define STEP(reg)                                                                                  \
  a = a * k, b = b * k, c = c * k, d = d * k, e = e * k, f = f * k;                                \
  g = g + z, h = h + z, i = i + z, j = j + z, l = l + z, m = m + z;                                \
  __asm__ volatile(""                                                                              \
                   : "+" reg(a), "+" reg(b), "+" reg(c), "+" reg(d), "+" reg(e), "+" reg(f),       \
                     "+" reg(g), "+" reg(h), "+" reg(i), "+" reg(j), "+" reg(l), "+" reg(m))

#define KERNEL(name, type, reg)                                                                    \
  static void name(void) {                                                                         \
    type k = (type){0} + 1, z = (type){0};                                                         \
    __asm__ volatile("" : "+" reg(k), "+" reg(z));                                                 \
    type a = k, b = k, c = k, d = k, e = k, f = k, g = k, h = k, i = k, j = k, l = k, m = k;       \
    for (uint32_t round = 0; round < ROUNDS; round++) {                                            \
      STEP(reg);                                                                                   \
      STEP(reg);                                                                                   \
      STEP(reg);                                                                                   \
      STEP(reg);                                                                                   \
    }                                                                                              \
  }

typedef float float4 __attribute__((vector_size(16)));

#if defined(__x86_64__)
typedef float float8 __attribute__((vector_size(32)));
typedef float float16 __attribute__((vector_size(64)));
KERNEL(run_scalar, float, "x")
KERNEL(run_sse2, float4, "x")
__attribute__((target("avx2"))) KERNEL(run_avx2, float8, "x") __attribute__((target("avx512f")))
KERNEL(run_avx512, float16, "v")

    static int always(void) {
  return 1;
}
static int has_avx2(void) { return __builtin_cpu_supports("avx2"); }
static int has_avx512(void) { return __builtin_cpu_supports("avx512f"); }
#else
KERNEL(run_scalar, float, "w")
KERNEL(run_neon, float4, "w")

static int always(void) { return 1; }
#endif

static struct kernel {
  const char *name;
  int lanes;
  int (*here)(void);
  void (*run)(void);
  double gops; /* the most so far */
} kernels[] = {
    {"scalar", 1, always, run_scalar, 0},
#if defined(__x86_64__)
    {"sse2", 4, always, run_sse2, 0},
    {"avx2", 8, has_avx2, run_avx2, 0},
    {"avx512", 16, has_avx512, run_avx512, 0},
#else
    {"neon", 4, always, run_neon, 0},
#endif
};

static double measure_peak(const struct kernel *k) {
  double best = 0;
  k->run(); /* wide units need a while to wake up */
  for (int i = 0; i < TRIES; i++) {
    double begin = thread_ns();
    k->run();
    double ns = thread_ns() - begin;
    double gops = (double)ROUNDS * OPS_A_ROUND * k->lanes / ns;
    if (ns > 0 && gops > best) best = gops;
  }
  return best;
}

peak peak_of(const char *instruction_set) {
  for (size_t i = 0; i < sizeof kernels / sizeof *kernels; i++) {
    struct kernel *k = &kernels[i];
    if (strcmp(k->name, instruction_set) != 0 || !k->here()) continue;
    /* Clock rates and neighbours change: another try, the best so far. */
    double gops = measure_peak(k);
    if (gops > k->gops) k->gops = gops;
    return (peak){.lanes = k->lanes, .gops = k->gops};
  }
  return (peak){0};
}
