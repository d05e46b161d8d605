/* SPDX-License-Identifier: Apache-2.0
 * From pieces to the files. */
#ifndef SOZAI_BAKE_MERGE_H
#define SOZAI_BAKE_MERGE_H

#include "bake.h"
#include "pieces.h"
#include "plan.h"

/* Each file gets its name once it is whole; refused where a unit is missing. */
bool bake_merge(const bake_job *job, const bake_plan *plan, pieces *p, failure *why);

#endif
