/* SPDX-License-Identifier: Apache-2.0
 * All groups, in the order in which they are reported. A group is a file of
 * its name; a check is an entry at that file's end and a function above it. */
#include "groups.h"

#define GROUP(name, title)                                                                         \
  { #name, title, name##_checks, &name##_check_count }

const check_group check_groups[] = {
    GROUP(symbols, "the file, before any of its code runs"),
    GROUP(version, "the version, and tables under their ids"),
    GROUP(init, "init and deinit"),
    GROUP(describe, "what it says of itself"),
    GROUP(create, "textures made and destroyed"),
    GROUP(values, "values that are taken"),
    GROUP(refuse, "values that are refused"),
    GROUP(errors, "why something failed"),
    GROUP(evaluate, "what evaluate writes"),
    GROUP(inputs, "what evaluate reads"),
    GROUP(batches, "the same bits whatever the batch"),
    GROUP(threads, "any thread at any time"),
    GROUP(surroundings, "what is the host's own"),
    GROUP(host, "the host's services"),
    GROUP(geometry, "what is grown"),
    GROUP(wood, "the table for wood"),
};
const uint32_t check_group_count = COUNT_OF(check_groups);
