/* SPDX-License-Identifier: Apache-2.0
 *
 * A job: everything about it follows from its seed, so that whoever does it,
 * on whichever thread, must come to the same number.
 */
#ifndef SOZAI_TESTS_SOAK_JOB_H
#define SOZAI_TESTS_SOAK_JOB_H

#include <stdatomic.h>

#include "sozai.h"

typedef struct {
  const sozai_entry_v1 *entry;
  const sozai_textures_1 *textures;
  const sozai_geometry_1 *geometry;
} plugin;

/* What was done, by all threads together. */
typedef struct {
  atomic_uint_fast64_t created, refused, grown, points, checked, failures;
} tally;

/* Memory handed out to the plugin and not yet given back. */
extern atomic_int_fast64_t live_bytes, live_blocks;

uint64_t job_random(uint64_t *state);

/* Makes, evaluates, destroys; or grows; or is refused. The number that it came
 * to: of every bit of every output, or of the error. chunks: cuts batches
 * otherwise, which must not matter. */
uint64_t job_run(const plugin *p, uint64_t seed, uint64_t chunks, tally *t);

/* A texture that is kept, for many threads at once; NULL: it was refused. The
 * host's memory lives in *keep, which the caller frees after the texture. */
sozai_texture *job_texture(const plugin *p, uint64_t seed, void **keep, tally *t);
/* Evaluates it at the seed's points. */
uint64_t job_evaluate(const plugin *p, const sozai_texture *texture, uint64_t seed, uint64_t chunks,
                      tally *t);

/* Reports what must not be, and counts it. */
__attribute__((format(printf, 2, 3))) void job_failed(tally *t, const char *format, ...);

#endif
