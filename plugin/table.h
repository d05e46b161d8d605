/* SPDX-License-Identifier: Apache-2.0
 *
 * The words that a generator's tables are described in.
 */
#ifndef SOZAI_TABLE_H
#define SOZAI_TABLE_H

#include "../api/sozai.h"
#include "core/count.h"

/* `name`, of the columns in the array name_columns. */
#define TABLE(name, id_, doc_)                                                                     \
  static const sozai_table_info name = {.size = sizeof(sozai_table_info),                          \
                                        .column_count = COUNT(name##_columns),                     \
                                        .id = id_,                                                 \
                                        .doc = doc_,                                               \
                                        .columns = name##_columns}

#endif
