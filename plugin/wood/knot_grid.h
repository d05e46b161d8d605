/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_KNOT_GRID_H
#define SOZAI_WOOD_KNOT_GRID_H

#include "knot_table.h"

/* plan: of the list's knots its count and what does not depend on where they are.
 * height: mm, of the stem, after which it begins anew. SOZAI_OK or MEMORY; *out is
 * one block of plan.bytes. */
int32_t knot_grid_make(wood_knots **out, wood_knots *plan, const sozai_host *host, wood_knot *list,
                       double height);

#endif
