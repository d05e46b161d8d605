/* SPDX-License-Identifier: Apache-2.0
 * Growing fibre in a hull through the plugin. */
#ifndef SOZAI_HOSTS_AGGREGATE_H
#define SOZAI_HOSTS_AGGREGATE_H

#include "growth.h"
#include "mesh.h"

/* hull: read during the call only. pairs: "name=value" each. */
bool aggregate_grow(const sozai_geometry_1 *table, const sozai_host *host, const char *preset,
                    const char *const *pairs, size_t pair_count, const mesh *hull,
                    sozai_geometry **out, failure *why);
/* By a mesh's path, or the name of one that is made here: see hull_make_named. */
bool aggregate_hull(mesh *m, const char *name, double scale, failure *why);
/* Whether it is a mesh's file, and not one that is made here. */
bool aggregate_hull_is_file(const char *name);

#endif
