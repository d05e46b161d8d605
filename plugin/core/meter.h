/* SPDX-License-Identifier: Apache-2.0
 *
 * A host between the plugin and the host: it counts the memory that is taken,
 * holds it under a ceiling, and carries the ceilings to wherever they are asked
 * for. What is taken through it may be given back through the host itself, once
 * nothing is taken through it any more.
 *
 * Rehearsing: the work is done as far as sizes are known, and what would then
 * be taken is claimed: counted, and not taken.
 */
#ifndef SOZAI_CORE_METER_H
#define SOZAI_CORE_METER_H

#include <stdatomic.h>

#include "limits.h"

typedef struct {
  sozai_host real;
  uint64_t ceilings[LIMITS];
  limit under; /* the ceiling for what is counted */
  int rehearsing;
  float begin; /* of the progress bar, for what is still to come */
  atomic_uint_fast64_t held, peak;
  atomic_uint_fast64_t refused; /* what would have been held, had it been allowed; 0: nothing */
} meter;

/* host as host_copy gives it. Refuses ceilings as limits_read does. */
int32_t meter_open(meter *m, const sozai_host *host, limit under, sozai_host *out);
/* With ceilings that were read before. */
void meter_reopen(meter *m, const sozai_host *host, const uint64_t ceilings[LIMITS], limit under,
                  sozai_host *out);
/* What a failure was: MEMORY is LIMIT, with a message, where the ceiling was met. */
int32_t meter_result(const meter *m, int32_t r, const char *what);
/* An answer's beginning: all zero; ARGUMENT where it is NULL or too small. call: for the
 * message. */
int32_t memory_clear(sozai_memory *out, const char *call);

/* The meter behind a host, or NULL: the host is one of its own. */
meter *meter_of(const sozai_host *host);
/* The host behind a meter; any other host is itself. */
sozai_host meter_real(const sozai_host *host);

int host_rehearses(const sozai_host *host);
/* Sets whether it rehearses, and gives what was before. */
int host_rehearse(const sozai_host *host, int rehearsing);
/* From now on progress goes from there to 1. */
void host_progress_from(const sozai_host *host, float begin);
/* Counts as if taken: MEMORY above the ceiling. */
int32_t host_claim(const sozai_host *host, uint64_t bytes);
/* Counts as if given back. */
void host_unclaim(const sozai_host *host, uint64_t bytes);
/* Whether so much more would be under the ceiling: to refuse, before any of it
 * is taken, what comes piece by piece. MEMORY if not. */
int32_t host_has_room(const sozai_host *host, uint64_t bytes);

#endif
