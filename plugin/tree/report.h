/* SPDX-License-Identifier: Apache-2.0
 *
 * Fills the tables of a grown tree.
 */
#ifndef SOZAI_TREE_REPORT_H
#define SOZAI_TREE_REPORT_H

#include "field.h"
#include "life.h"

/* buds: of a grown tree, else NULL; field: of a measured one or a sibling. */
int32_t report_make(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count,
                    const tree_field *field);

#endif
