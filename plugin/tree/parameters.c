/* SPDX-License-Identifier: Apache-2.0
 *
 * The tree's parameters as the ABI describes them.
 */
#include "parameters.h"

#include "../generator_parameters.h"

static const char *const foliage_choices[] = {"auto", "full", "sprigs", "none"};
static const char *const foliage_docs[] = {"full up to leaves_most", "every needle and leaf",
                                           "shoots clothed in needles, each as one body",
                                           "a winter's tree"};
static const char *const resample_choices[] = {"measured", "sibling"};
static const char *const resample_docs[] = {"the measured tree itself",
                                            "another tree of the statistics fitted to it"};
static const char *const azimuth_choices[] = {"turning", "random"};
static const char *const azimuth_docs[] = {"each on from the last by the divergence",
                                           "each at random: the paper's sugi that is not measured"};
static const char *const whorl_choices[] = {"spiral", "whorls"};
static const char *const whorl_docs[] = {"climbing all along the year's shoot",
                                         "together below the year's bud"};
static const char *const round_choices[] = {"random", "flat", "spiral", "opposite"};
static const char *const round_docs[] = {"at random", "left and right in turn, in one plane",
                                         "each 137.5 degrees on",
                                         "in pairs, each pair square to the last"};
static const char *const leaf_choices[] = {"needle", "blade", "ellipse", "lobed", "toothed"};
static const char *const leaf_docs[] = {"an awl or needle", "pointed, folded along its midrib",
                                        "a flat ellipse: the paper's", "a hand of five lobes",
                                        "widest beyond its middle, with coarse teeth: an oak's"};

TREE_PARAMETERS(N_, I_, C_, T_, X3_)

#define AT_(name, ...) [T_##name] = &p_##name,
const sozai_parameter *const tree_parameters[TREE_PARAMETER_COUNT] = {
    TREE_PARAMETERS(AT_, AT_, AT_, AT_, AT_)};
