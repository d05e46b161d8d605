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

#endif
