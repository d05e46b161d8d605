/* SPDX-License-Identifier: Apache-2.0
 * Values as a hostile host would hand them over the ABI, made from an input's bytes. */
#ifndef SOZAI_TESTS_FUZZ_VALUES_H
#define SOZAI_TESTS_FUZZ_VALUES_H

#include "fuzz.h"
#include "sozai.h"

#ifdef __cplusplus
extern "C" {
#endif

#define VALUES_MOST 12

typedef struct values {
  sozai_value list[VALUES_MOST];
  uint32_t count;
  sozai_buffer buffers[VALUES_MOST];
  void *memory[8 * VALUES_MOST]; /* what they point to */
  uint32_t memory_count;
} values;

/* Some of the parameters', mostly of their own kinds and within their ranges, else of any kind
 * and number. Buffers hold as much as they say; where a pointer is NULL, a count is too high
 * to be a memory's, or a kind is unknown, the plugin must refuse by what it is told alone. */
void values_take(values *v, bytes *b, const sozai_parameter *const *parameters, uint32_t count);
void values_free(values *v);

/* So many floats, mostly from low to high, by some inputs any. To be freed. */
float *values_floats(bytes *b, size_t count, double low, double high);

#ifdef __cplusplus
}
#endif

#endif
