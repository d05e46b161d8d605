/* SPDX-License-Identifier: Apache-2.0
 * The plugin that lies beside this reader, opened when the first file is. */
#ifndef SOZAI_OIIO_LIBRARY_H
#define SOZAI_OIIO_LIBRARY_H

#include "host.h"
#include "plugin.h"

typedef struct library {
  plugin plugin;
  colour colour;
  host host;
  char working[128]; /* the working space's name; "" where no service says it */
} library;

/* The one of this process. It stays open: OpenImageIO's caches may read to the
 * very end of the process. NULL: why; the next call tries again. [thread-safe] */
const library *library_get(failure *why);

#endif
