/* SPDX-License-Identifier: Apache-2.0
 *
 * Fills the tables of a grown tree.
 */
#ifndef SOZAI_TREE_REPORT_H
#define SOZAI_TREE_REPORT_H

#include "field.h"
#include "life.h"

/* buds: of a grown tree, field: of a measured one, else NULL; was: what a sibling's table, or a
 * measured tree's, gave, else NULL. */
int32_t report_make(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count,
                    const tree_field *field, const field_fit *was);

#endif
