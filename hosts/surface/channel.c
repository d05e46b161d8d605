/* SPDX-License-Identifier: Apache-2.0 */
#include "channel.h"

#include <string.h>

bool channel_is_id(const sozai_channel *c) {
  size_t length = strlen(c->id);
  return length > 3 && strcmp(c->id + length - 3, "_id") == 0;
}

bool channel_fits_half(const sozai_channel *c) {
  return !channel_is_id(c) && (!*c->unit || strcmp(c->unit, "rad") == 0);
}
