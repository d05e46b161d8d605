/* SPDX-License-Identifier: Apache-2.0
 * Batches of points with every input and every output, a band of marked
 * numbers before and after each output, and what can be asked of them. */
#ifndef SOZAI_VALIDATE_BATCH_H
#define SOZAI_VALIDATE_BATCH_H

#include "subject.h"

#define BATCH_MOST 4400u
#define BATCH_GUARD 64u
#define BATCH_INPUTS 16u /* point, normal, light, light colour, view: 3 each; footprint */

typedef struct batch {
  sozai_batch abi;
  const sozai_texture_info *info;
  const char *name;        /* the texture's, for messages */
  float *in[BATCH_INPUTS]; /* of BATCH_MOST */
  float **out;             /* component_count, within memory */
  float *memory;           /* component_count times guard, BATCH_MOST, guard */
} batch;

/* Ordinary points by chance, every input and every output, `count` of them.
 * NULL: out of memory, and said so. */
batch *batch_new(subject *s, const sozai_texture_info *info, const char *preset, uint32_t count);
void batch_free(batch *b);
/* Point the inputs and outputs of abi to the arrays from point `first` on. */
void batch_from(batch *b, uint32_t first, uint32_t count);
/* Leave out inputs: those of SOZAI_INPUT_* that are not in `given`. */
void batch_give(batch *b, uint32_t given);
/* Want only the components of that channel; NULL: all. */
void batch_want(batch *b, const sozai_channel *c);
/* Mark every output and its guards. */
void batch_mark(batch *b);
/* Evaluate, and fail if that is not SOZAI_OK. what: for messages. */
bool batch_run(subject *s, sozai_texture *t, batch *b, const char *what);

/* A copy of all answers, to be compared with; to be freed. */
float *batch_answers(const batch *b);
/* Whether component c of points [first, first + count) has the bits that it
 * has in `wanted`; fails with the first that has not. */
bool batch_same(const batch *b, const float *wanted, uint32_t c, uint32_t first, uint32_t count,
                const char *what);
/* The same for all components. */
bool batch_all_same(const batch *b, const float *wanted, uint32_t first, uint32_t count,
                    const char *what);
/* Component c of points [first, first + count) was written and is finite. */
bool batch_written(const batch *b, uint32_t c, uint32_t first, uint32_t count, const char *what);
/* Nothing of component c but points [first, first + count) was written; count
 * 0: nothing at all. */
bool batch_untouched(const batch *b, uint32_t c, uint32_t first, uint32_t count, const char *what);

/* An answer's place among those of batch_answers. */
static inline size_t batch_place(uint32_t c, uint32_t i) {
  return (size_t)c * (BATCH_GUARD + BATCH_MOST + BATCH_GUARD) + BATCH_GUARD + i;
}

/* "albedo.r" of component c. This thread's, till the next call. */
const char *component_name(const sozai_texture_info *info, uint32_t c);
/* The channel that component c belongs to, or NULL. */
const sozai_channel *channel_of(const sozai_texture_info *info, uint32_t c);
const char *input_name(uint32_t bit);

/* The inputs' bits and where they lie in batch.in. */
extern const struct batch_input { uint32_t bit, first, count; } batch_inputs[6];

#endif
