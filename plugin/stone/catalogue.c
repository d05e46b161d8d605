/* SPDX-License-Identifier: Apache-2.0
 *
 * The stones, as data: stones/list.h lists them, stones/entry.h has the words
 * they are written in, and the entries are by kind in stones/. */
#include "catalogue.h"

#include "stones/entry.h"

#define ADDRESS(key) &stone_##key,
const sozai_preset *const stone_catalogue[] = {STONES_ALL(ADDRESS)};
const uint32_t stone_catalogue_count = COUNT(stone_catalogue);
