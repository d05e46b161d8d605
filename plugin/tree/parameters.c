/* SPDX-License-Identifier: Apache-2.0
 *
 * The tree's parameters as the ABI describes them.
 */
#include "parameters.h"

#define COUNT(a) (sizeof(a) / sizeof((a)[0]))

static const char *const foliage_choices[] = {"auto", "full", "sprigs", "none"};
static const char *const foliage_docs[] = {"full up to leaves_most", "every needle and leaf",
                                           "shoots clothed in needles, each as one body",
                                           "a winter's tree"};
static const char *const resample_choices[] = {"measured", "sibling"};
static const char *const resample_docs[] = {"the measured tree itself",
                                            "another tree of the statistics fitted to it"};
static const char *const whorl_choices[] = {"spiral", "whorls"};
static const char *const whorl_docs[] = {"climbing all along the year's shoot",
                                         "together below the year's bud"};
static const char *const round_choices[] = {"random", "flat", "spiral", "opposite"};
static const char *const round_docs[] = {"at random", "left and right in turn, in one plane",
                                         "each 137.5 degrees on",
                                         "in pairs, each pair square to the last"};
static const char *const leaf_choices[] = {"needle", "blade", "ellipse", "lobed"};
static const char *const leaf_docs[] = {"an awl or needle", "pointed, folded along its midrib",
                                        "a flat ellipse: the paper's", "a hand of five lobes"};

#define N_(name, i, l, g, u, h0, h1, s0, s1, d, t)                                                 \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = SOZAI_KIND_FLOAT,                               \
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
#define I_(name, i, l, g, u, h0, h1, s0, s1, d, t)                                                 \
  static const sozai_parameter p_##name = {.size = sizeof(sozai_parameter),                        \
                                           .kind = SOZAI_KIND_INT,                                 \
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
TREE_PARAMETERS(N_, I_, C_, T_, X3_)

#define AT_(name, ...) [T_##name] = &p_##name,
const sozai_parameter *const tree_parameters[TREE_PARAMETER_COUNT] = {
    TREE_PARAMETERS(AT_, AT_, AT_, AT_, AT_)};
