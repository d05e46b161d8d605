/* SPDX-License-Identifier: Apache-2.0 */
#include "channel.h"

#include <string.h>

bool channel_is_id(const sozai_channel *c) {
  size_t length = strlen(c->id);
  return length > 3 && strcmp(c->id + length - 3, "_id") == 0;
}

static bool measured_in(const sozai_channel *c, const char *unit) {
  return strcmp(c->unit, unit) == 0;
}

bool channel_fits_half(const sozai_channel *c) {
  return !channel_is_id(c) && (measured_in(c, "") || measured_in(c, "rad") ||
                               measured_in(c, "share") || measured_in(c, "ratio"));
}

bool channel_is_vector(const sozai_channel *c) {
  return c->components == 3 && strcmp(c->suffixes, "xyz") == 0;
}

bool channel_is_direction(const sozai_channel *c) {
  return channel_is_vector(c) && measured_in(c, "");
}

bool channel_is_axis(const sozai_channel *c) {
  return channel_is_direction(c) || (channel_is_vector(c) && measured_in(c, "share"));
}
