/* SPDX-License-Identifier: Apache-2.0
 *
 * What the lines of a generator's table of parameters stand for (see
 * tree/parameters.h): each defines the parameter p_NAME.
 */
#ifndef SOZAI_GENERATOR_PARAMETERS_H
#define SOZAI_GENERATOR_PARAMETERS_H

#include "core/preset.h"

#define N_(...) NUMBER_ROW_(SOZAI_KIND_FLOAT, __VA_ARGS__)
#define I_(...) NUMBER_ROW_(SOZAI_KIND_INT, __VA_ARGS__)
#define NUMBER_ROW_(k, name, i, l, g, u, h0, h1, s0, s1, d, t)                                     \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = k,                                              \
                                           .id = i,                                                \
                                           .label = l,                                             \
                                           .group = g,                                             \
                                           .unit = u,                                              \
                                           .doc = t,                                               \
                                           .hard_min = h0,                                         \
                                           .hard_max = h1,                                         \
                                           .soft_min = s0,                                         \
                                           .soft_max = s1,                                         \
                                           .default_number = {d}};
#define C_(name, i, l, g, list, d, t)                                                              \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = SOZAI_KIND_CHOICE,                              \
                                           .id = i,                                                \
                                           .label = l,                                             \
                                           .group = g,                                             \
                                           .unit = "",                                             \
                                           .doc = t,                                               \
                                           .choices = list##_choices,                              \
                                           .choice_docs = list##_docs,                             \
                                           .choice_count = COUNT(list##_choices),                  \
                                           .default_number = {d}};
#define T_(name, i, l, g, t)                                                                       \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = SOZAI_KIND_TEXT,                                \
                                           .id = i,                                                \
                                           .label = l,                                             \
                                           .group = g,                                             \
                                           .unit = "",                                             \
                                           .doc = t,                                               \
                                           .default_text = ""};
#define B_(name, i, l, g, k, t)                                                                    \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = SOZAI_KIND_BUFFER,                              \
                                           .id = i,                                                \
                                           .label = l,                                             \
                                           .group = g,                                             \
                                           .unit = "",                                             \
                                           .doc = t,                                               \
                                           .buffer_kind = k};
#define X3_(name, i, l, g, a, b, c, t)                                                             \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = SOZAI_KIND_FLOAT3,                              \
                                           .id = i,                                                \
                                           .label = l,                                             \
                                           .group = g,                                             \
                                           .unit = "",                                             \
                                           .doc = t,                                               \
                                           .hard_max = 1,                                          \
                                           .soft_max = 1,                                          \
                                           .default_number = {a, b, c}};

#endif
