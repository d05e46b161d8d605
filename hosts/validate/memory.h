/* SPDX-License-Identifier: Apache-2.0
 * Every allocation and lock of this process, counted: the program's own
 * functions come before libc's for every library that it loads. */
#ifndef SOZAI_VALIDATE_MEMORY_H
#define SOZAI_VALIDATE_MEMORY_H

#include <stdbool.h>
#include <stdint.h>

/* Whether they are: not under a sanitizer, which has these functions itself. */
bool memory_watched(void);
/* Whether a sanitizer built this, and so likely what it loads. */
bool memory_sanitized(void);
/* Calls of malloc and its like by this thread so far. */
uint64_t memory_calls(void);
/* From now on fresh memory holds rubbish, and memory given back too: what is
 * read in spite of that shows. */
void memory_scribble(void);
/* Bytes that the process has and has not given back. */
int64_t memory_live(void);
/* Calls of pthread_mutex_lock and its like by this thread so far. */
uint64_t memory_locks(void);
#endif
