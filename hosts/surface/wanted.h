/* SPDX-License-Identifier: Apache-2.0
 * A batch in parts that have room for all the channels asked for, so that where
 * a texel is more than one evaluation, each is done once, whatever is asked. */
#ifndef SOZAI_SURFACE_WANTED_H
#define SOZAI_SURFACE_WANTED_H

#include "evaluate.h"

#define WANTED_PART 64u /* points, at least */

/* The channels of which something is asked for. */
typedef struct wanted {
  const sozai_channel *channels[SURFACE_COMPONENTS];
  uint32_t channel_count, components, most; /* of theirs; points in a part */
} wanted;

void wanted_find(wanted *w, const surface_material *m, const sozai_batch *b);

/* SURFACE_ROOM numbers as outputs: `most` of each component, channel after
 * channel; out has SURFACE_COMPONENTS, NULL where nothing is wanted. */
void wanted_place(const wanted *w, float *room, float **out);

/* The points of a batch from the first on, at most so many; out: of the part. */
sozai_batch wanted_part(const sozai_batch *b, uint32_t first, uint32_t most, float **out);

/* Whether a channel is a quantity: what is not filtered is a name, and nothing
 * lies between two. */
bool wanted_filtered(const sozai_channel *c);

#endif
