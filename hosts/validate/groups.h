/* SPDX-License-Identifier: Apache-2.0
 * The checks there are, a file and a list for each part of the contract. */
#ifndef SOZAI_VALIDATE_GROUPS_H
#define SOZAI_VALIDATE_GROUPS_H

#include "check.h"

#define CHECK_LIST(name)                                                                           \
  extern const check name##_checks[];                                                              \
  extern const uint32_t name##_check_count
CHECK_LIST(symbols);
CHECK_LIST(version);
CHECK_LIST(init);
CHECK_LIST(describe);
CHECK_LIST(create);
CHECK_LIST(values);
CHECK_LIST(refuse);
CHECK_LIST(errors);
CHECK_LIST(evaluate);
CHECK_LIST(inputs);
CHECK_LIST(batches);
CHECK_LIST(threads);
CHECK_LIST(surroundings);
CHECK_LIST(host);
CHECK_LIST(geometry);
CHECK_LIST(wood);

/* At the end of a group's file. */
#define CHECKS(name, ...)                                                                          \
  const check name##_checks[] = {__VA_ARGS__};                                                     \
  const uint32_t name##_check_count = COUNT_OF(name##_checks)

#endif
