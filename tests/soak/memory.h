/* SPDX-License-Identifier: Apache-2.0
 *
 * A host whose allocator counts, and fails when it is told to.
 */
#ifndef SOZAI_TESTS_SOAK_MEMORY_H
#define SOZAI_TESTS_SOAK_MEMORY_H

#include "sozai.h"

typedef struct {
  sozai_host host;
  sozai_limit limit;
  uint32_t calls, fail_at; /* the call that gives NULL, from 1; 0: none */
  uint32_t reports, cancel_at;
} soak_host;

void soak_host_init(soak_host *h);

#endif
