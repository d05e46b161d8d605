/* SPDX-License-Identifier: Apache-2.0
 *
 * Jobs for as many threads as the host lends, with progress and cancelling.
 */
#ifndef SOZAI_CORE_CREW_H
#define SOZAI_CORE_CREW_H

#include "../../api/sozai.h"

typedef struct crew_progress {
  const char *what;
  double begin, end; /* of the host's bar */
} crew_progress;

/* work(context, i) for every i below jobs, in any order, each writing to places
 * of its own. CANCELLED when the host asks for it. */
int32_t crew_run(const sozai_host *host, uint32_t jobs, void (*work)(void *context, uint32_t i),
                 void *context, crew_progress progress);

#endif
