/* SPDX-License-Identifier: Apache-2.0 */
#include "cpu.h"

#include <stdlib.h>
#include <string.h>

#include "status.h"

static const char *const names[CPU_COUNT] = {"avx512", "avx2", "sse2", "neon", "scalar"};

static int has(int set) {
  switch (set) {
#if defined(__x86_64__)
  case CPU_AVX512:
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
  case CPU_AVX2:
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") != 0;
  case CPU_SSE2:
    return 1;
#elif defined(__aarch64__)
  case CPU_NEON:
    return 1;
#endif
  case CPU_SCALAR:
    return 1;
  default:
    return 0;
  }
}

int32_t cpu_choose(int *out) {
  const char *wish = getenv("SOZAI_CPU");
  if (!wish || !wish[0]) {
    int set = 0;
    while (!has(set)) set++;
    *out = set;
    return SOZAI_OK;
  }
  for (int set = 0; set < CPU_COUNT; set++) {
    if (strcmp(wish, names[set]) == 0) {
      *out = set;
      if (has(set)) return SOZAI_OK;
      return fail(SOZAI_ERROR_UNSUPPORTED, "SOZAI_CPU: this machine has no %s", wish);
    }
  }
  return fail(SOZAI_ERROR_UNSUPPORTED,
              "SOZAI_CPU: \"%.40s\" is none of: avx512, avx2, sse2, neon, scalar", wish);
}
