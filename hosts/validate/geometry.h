/* SPDX-License-Identifier: Apache-2.0
 * Growing something of a generator of which nothing is known but what it says. */
#ifndef SOZAI_VALIDATE_GEOMETRY_H
#define SOZAI_VALIDATE_GEOMETRY_H

#include "subject.h"

typedef struct grown {
  sozai_geometry *geometry;
  sozai_value values[4]; /* what it was grown of, beside the defaults */
  uint32_t value_count;
} grown;

/* Of its defaults; where those are refused, with a box of 20 mm for what takes
 * a mesh. */
int32_t grow_plain(subject *s, const sozai_generator_info *info, const sozai_host *host,
                   grown *out);

#endif
