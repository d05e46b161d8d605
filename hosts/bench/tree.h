/* SPDX-License-Identifier: Apache-2.0
 * Growing a tree of 7 years with all its needles. */
#ifndef SOZAI_BENCH_TREE_H
#define SOZAI_BENCH_TREE_H

#include "plugin.h"

#define TREE_GOAL_NS 50e6
/* ez-tree, a generator in JavaScript, makes about 34 thousand branches a second. */
#define TREE_BRANCH_GOAL_NS (1e9 / 34e3)

typedef struct tree_job {
  const char *preset;
  bool meshed;
  const sozai_geometry_1 *table;
  double branches; /* of all orders */
} tree_job;

/* Also counts its branches. */
bool tree_job_open(tree_job *t, const plugin *p, failure *why);
/* For measure(). */
bool tree_job_run(void *context, double *ns, failure *why);

#endif
