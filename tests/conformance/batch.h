/* SPDX-License-Identifier: Apache-2.0
 *
 * A batch with every input and every output, guards around each output.
 */
#ifndef SOZAI_TESTS_BATCH_H
#define SOZAI_TESTS_BATCH_H

#include "plugin.h"

#define BATCH_MAX 1024u
#define GUARD 32u

typedef struct {
  sozai_batch batch;
  float in[16][BATCH_MAX]; /* point, normal, light, light colour, view; footprint */
  float *out[COMPONENTS];
  float memory[COMPONENTS][GUARD + BATCH_MAX + GUARD];
  uint32_t components, reserved;
} full_batch;

/* Ordinary points, count of them, and every output asked for. */
void batch_make(full_batch *b, const sozai_texture_info *info, uint32_t count);
/* Fill every output and its guards with a pattern. */
void batch_mark(full_batch *b);
/* How many numbers outside the first `count` of an output were written; with
 * count 0, whether any was. */
uint32_t batch_spilt(const full_batch *b, uint32_t count);
/* How many of the first count answers of the wanted outputs are not finite or
 * were not written. */
uint32_t batch_unfit(const full_batch *b, uint32_t count);

#endif
