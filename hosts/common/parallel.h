/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_HOSTS_PARALLEL_H
#define SOZAI_HOSTS_PARALLEL_H

#include <stdint.h>

/* How many threads this process may run on. */
uint32_t parallel_default_threads(void);

/* Run task(context, i) for every i below count on up to `threads` threads, the
 * caller's among them, and return when all are done. Each thread takes the next
 * index in turn, so the result must not depend on who ran what. */
void parallel_for(uint32_t threads, uint32_t count, void (*task)(void *context, uint32_t i),
                  void *context);

#endif
