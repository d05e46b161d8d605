/* SPDX-License-Identifier: Apache-2.0
 * The services this program offers to the plugin. */
#ifndef SOZAI_HOSTS_HOST_H
#define SOZAI_HOSTS_HOST_H

#include <stdbool.h>
#include "colour.h"
#include "sozai.h"

typedef struct host {
  sozai_host abi; /* what create() is handed; points back at this struct */
  uint32_t threads;
  bool verbose; /* also log what is only information */
  const colour *colour;
} host;

/* colour may be NULL, config too; both and the host itself must outlive every
 * texture made with it, and the host may not move. */
void host_init(host *h, uint32_t threads, bool verbose, const colour *colour, const char *config);

#endif
