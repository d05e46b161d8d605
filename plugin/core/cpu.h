/* SPDX-License-Identifier: Apache-2.0
 *
 * Which instruction set the kernels run on.
 */
#ifndef SOZAI_CORE_CPU_H
#define SOZAI_CORE_CPU_H

#include <stdint.h>

/* In order of preference; a later one is never chosen when an earlier can run. */
enum { CPU_AVX512, CPU_AVX2, CPU_SSE2, CPU_NEON, CPU_SCALAR, CPU_COUNT };

/* The best this machine has, or the one that the environment variable
 * SOZAI_CPU names: scalar, sse2, avx2, avx512 or neon. UNSUPPORTED, with a
 * message, when it names another, or one that this machine lacks. */
int32_t cpu_choose(int *out);

#endif
