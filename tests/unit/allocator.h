/* SPDX-License-Identifier: Apache-2.0
 *
 * A host whose allocator counts, checks what it is given back, and can be told
 * to fail once.
 */
#ifndef SOZAI_TESTS_ALLOCATOR_H
#define SOZAI_TESTS_ALLOCATOR_H

#include "sozai.h"

typedef struct {
  uint32_t calls;   /* of alloc so far */
  uint32_t fail_at; /* the call that gives NULL, counted from 1; 0: none */
  uint32_t fail_on; /* that call, and every one after it; 0: none */
  uint32_t live;    /* blocks not yet given back */
  uint32_t wrong;   /* blocks given back with another size or alignment, or twice */
  uint64_t bytes;   /* in the live blocks */
} allocator;

/* Memory that is handed out is full of rubbish. */
sozai_host allocator_host(allocator *a);

#endif
