/* SPDX-License-Identifier: Apache-2.0
 * What a channel's numbers fit into. */
#ifndef SOZAI_SURFACE_CHANNEL_H
#define SOZAI_SURFACE_CHANNEL_H

#include <stdbool.h>
#include "sozai.h"

/* A number that tells one piece from another: of any size. */
bool channel_is_id(const sozai_channel *c);
/* Lengths, years and ids go past what a half can say. */
bool channel_fits_half(const sozai_channel *c);
bool channel_is_vector(const sozai_channel *c);
/* Of length 1. */
bool channel_is_direction(const sozai_channel *c);
/* The same, or as long as its share, 0 to 1. */
bool channel_is_axis(const sozai_channel *c);

#endif
