/* SPDX-License-Identifier: Apache-2.0
 * Packing 2,048 strands of 32 vertices into a hull of about 35,000 triangles. */
#ifndef SOZAI_BENCH_FIBER_H
#define SOZAI_BENCH_FIBER_H

#include "mesh.h"
#include "plugin.h"

/* On two cores; of one core's time it is twice that. */
#define FIBER_GOAL_NS 0.15e9

typedef struct fiber_job {
  bool fitted;  /* else placed only: the hull read, measured, and filled */
  bool threads; /* on two, by the clock on the wall; else one core's own time */
  const sozai_geometry_1 *table;
  mesh hull;
} fiber_job;

bool fiber_job_open(fiber_job *f, const plugin *p, failure *why);
void fiber_job_close(fiber_job *f);
/* For measure(). */
bool fiber_job_run(void *context, double *ns, failure *why);

#endif
