/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_BENCH_DECODE_H
#define SOZAI_BENCH_DECODE_H

#include <stdint.h>

/* What an x86-64 instruction does for a living. */
typedef enum op_kind {
  OP_OTHER,  /* moves, loads, gathers, shuffles, mask registers, general registers, branches */
  OP_FLOAT,  /* SSE to AVX-512: arithmetic, roots, comparisons, conversions */
  OP_INTEGER /* likewise: arithmetic, shifts, logic, comparisons, blends */
} op_kind;

op_kind decode_op(const uint8_t *code);

#endif
