/* SPDX-License-Identifier: Apache-2.0
 * A plugin that is sozai.so, but tells what evaluate() was asked. */
#ifndef TESTS_OIIO_WATCH_H
#define TESTS_OIIO_WATCH_H

#include <stdint.h>

typedef struct watch {
  uint64_t batches, points;
  uint64_t asked; /* bit k: out[k] was wanted in some batch */
} watch;

/* The plugin's other symbol: what came since the last call. One thread. */
#define WATCH_SYMBOL "watch_take"
typedef watch watch_take_function(void);

#endif
