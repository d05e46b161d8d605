/* SPDX-License-Identifier: Apache-2.0
 *
 * The words that every catalogue's entries are written in: one value each, and
 * the preset that they make.
 */
#ifndef SOZAI_CORE_PRESET_H
#define SOZAI_CORE_PRESET_H

#include "../../api/sozai.h"
#include "count.h"

#define NUMBER(name, x)                                                                            \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_FLOAT, .number = { x }                                          \
  }
#define WHOLE(name, x)                                                                             \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_INT, .number = { x }                                            \
  }
#define CHOICE(name, c)                                                                            \
  { .id = name, .kind = SOZAI_KIND_CHOICE, .text = c }
#define TEXT(name, t)                                                                              \
  { .id = name, .kind = SOZAI_KIND_TEXT, .text = t }
/* sRGB as 8-bit numbers */
#define SRGB(name, r, g, b)                                                                        \
  {                                                                                                \
    .id = name, .kind = SOZAI_KIND_COLOUR, .number = {(r) / 255.0, (g) / 255.0, (b) / 255.0},      \
    .text = "sRGB"                                                                                 \
  }

/* The preset `symbol` of an array of values. */
#define PRESET(symbol, key, list, name, about, literature)                                         \
  const sozai_preset symbol = {.size = sizeof(sozai_preset),                                       \
                               .value_count = COUNT(list),                                         \
                               .id = key,                                                          \
                               .label = name,                                                      \
                               .doc = about,                                                       \
                               .source = literature,                                               \
                               .values = list}

#endif
