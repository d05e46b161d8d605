/* SPDX-License-Identifier: Apache-2.0
 *
 * The tables that a tree answers with.
 */
#ifndef SOZAI_TREE_TABLES_H
#define SOZAI_TREE_TABLES_H

#include "../../api/sozai.h"

enum {
  TABLE_BRANCHES,
  TABLE_KNOTS,
  TABLE_KNOT_RADII,
  TABLE_RINGS,
  TABLE_TURNING,
  TABLE_NODES,
  TABLE_STATISTICS,
  TABLE_FIT,
  TREE_TABLES
};

extern const sozai_table_info *const tree_table_infos[TREE_TABLES];
uint32_t tree_table_columns(int table);

#endif
