/* SPDX-License-Identifier: Apache-2.0
 *
 * Products and sums run on beside one another: seven of each, which with what they are
 * multiplied by and added to are the 16 registers of SSE2, and of AVX-512 twelve, since two
 * units of each kind that take three cycles keep only just busy on six. The empty asm says that
 * all of them are read and written, so that the compiler can leave none out. */
#include "peak.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include "clock.h"

#define ROUNDS 20000
#define STEPS 4
#define TRIES 200 /* of a tenth of a millisecond */

/* Some numbers, each to be multiplied, or added to. */
#define ON6(reg, a, b, c, d, e, f, op, by)                                                         \
  a = a op by, b = b op by, c = c op by, d = d op by, e = e op by, f = f op by;                    \
  __asm__ volatile("" : "+" reg(a), "+" reg(b), "+" reg(c), "+" reg(d), "+" reg(e), "+" reg(f))
#define ON7(reg, a, b, c, d, e, f, g, op, by)                                                      \
  a = a op by, b = b op by, c = c op by, d = d op by, e = e op by, f = f op by, g = g op by;       \
  __asm__ volatile(""                                                                              \
                   : "+" reg(a), "+" reg(b), "+" reg(c), "+" reg(d), "+" reg(e), "+" reg(f),       \
                     "+" reg(g))

#define KERNEL(name, type, reg)                                                                    \
  static void name(void) {                                                                         \
    type k = (type){0} + 1, z = (type){0};                                                         \
    __asm__ volatile("" : "+" reg(k), "+" reg(z));                                                 \
    type a = k, b = k, c = k, d = k, e = k, f = k, g = k;                                          \
    type h = k, i = k, j = k, l = k, m = k, n = k, o = k;                                          \
    for (uint32_t step = 0; step < ROUNDS * STEPS; step++) {                                       \
      ON7(reg, a, b, c, d, e, f, g, *, k);                                                         \
      ON7(reg, h, i, j, l, m, n, o, +, z);                                                         \
    }                                                                                              \
  }

typedef float float4 __attribute__((vector_size(16)));

#if defined(__x86_64__)
typedef float float8 __attribute__((vector_size(32)));
typedef float float16 __attribute__((vector_size(64)));
KERNEL(run_scalar, float, "x")
KERNEL(run_sse2, float4, "x")
__attribute__((target("avx2"))) KERNEL(run_avx2, float8, "x")

    __attribute__((target("avx512f"))) static void run_avx512(void) {
  float16 k = (float16){0} + 1, z = (float16){0};
  __asm__ volatile("" : "+v"(k), "+v"(z));
  float16 a = k, b = k, c = k, d = k, e = k, f = k, g = k, h = k, i = k, j = k, l = k, m = k;
  float16 n = k, o = k, p = k, q = k, r = k, s = k, t = k, u = k, v = k, w = k, x = k, y = k;
  for (uint32_t step = 0; step < ROUNDS * STEPS; step++) {
    ON6("v", a, b, c, d, e, f, *, k);
    ON6("v", g, h, i, j, l, m, +, z);
    ON6("v", n, o, p, q, r, s, *, k);
    ON6("v", t, u, v, w, x, y, +, z);
  }
}

static int always(void) { return 1; }
static int has_avx2(void) { return __builtin_cpu_supports("avx2"); }
static int has_avx512(void) { return __builtin_cpu_supports("avx512f"); }
#else
KERNEL(run_scalar, float, "w")
KERNEL(run_neon, float4, "w")

static int always(void) { return 1; }
#endif

static struct kernel {
  const char *name;
  int lanes, ops; /* to a step, of each lane */
  int (*here)(void);
  void (*run)(void);
  double gops; /* the most so far */
} kernels[] = {
    {"scalar", 1, 14, always, run_scalar, 0},
#if defined(__x86_64__)
    {"sse2", 4, 14, always, run_sse2, 0},
    {"avx2", 8, 14, has_avx2, run_avx2, 0},
    {"avx512", 16, 24, has_avx512, run_avx512, 0},
#else
    {"neon", 4, 14, always, run_neon, 0},
#endif
};

static double measure_peak(const struct kernel *k) {
  double best = 0;
  k->run(); /* wide units need a while to wake up */
  for (int i = 0; i < TRIES; i++) {
    double begin = thread_ns();
    k->run();
    double ns = thread_ns() - begin;
    double gops = (double)ROUNDS * STEPS * k->ops * k->lanes / ns;
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
