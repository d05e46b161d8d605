/* SPDX-License-Identifier: Apache-2.0
 * A host that gives so much memory and no more, and cancels after so many calls of
 * progress: what an input asks for must not decide how long it takes. It checks that all it
 * gave comes back, with the size that was asked for. */
#ifndef SOZAI_TESTS_FUZZ_BOUNDED_H
#define SOZAI_TESTS_FUZZ_BOUNDED_H

#include "sozai.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct bounded_limits {
  size_t bytes;   /* at one time */
  uint32_t calls; /* of progress */
} bounded_limits;

void bounded_begin(const bounded_limits *limits);
/* Everything has come back. */
void bounded_end(void);
extern const sozai_host bounded_host;

#ifdef __cplusplus
}
#endif

#endif
