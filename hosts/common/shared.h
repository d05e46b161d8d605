/* SPDX-License-Identifier: Apache-2.0
 * Objects that are dear to make and never change, kept by name for the whole
 * process: whoever asks for the same gets the same. A few that nobody uses
 * stay for a while, since programs open a file, close it and open it again. */
#ifndef SOZAI_HOSTS_SHARED_H
#define SOZAI_HOSTS_SHARED_H

#include <stdbool.h>
#include <stdint.h>

typedef struct shared shared; /* a use of one object */

#define SHARED_IDLE 8                    /* objects that stay unused */
#define SHARED_IDLE_BYTES (256ull << 20) /* and what they may hold together */

/* A use of the object of that key; NULL: there is none. [thread-safe] */
shared *shared_find(const char *key);
/* Keep an object, with its first use. Where another thread was faster, this
 * object is destroyed and the use is of that one's. NULL: out of memory, and the
 * object is destroyed. [thread-safe] */
shared *shared_add(const char *key, void *object, uint64_t bytes, void (*destroy)(void *object));
void *shared_object(const shared *s);
/* End a use. NULL is allowed. [thread-safe] */
void shared_release(shared *s);

#endif
