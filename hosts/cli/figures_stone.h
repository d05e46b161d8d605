/* SPDX-License-Identifier: Apache-2.0
 * The figures of Yamanaka and Nagaoka's paper that show what it makes: 5 (the
 * fine roughness dh) and 6 (a street's paving placed in a picture). */
#ifndef SOZAI_CLI_FIGURES_STONE_H
#define SOZAI_CLI_FIGURES_STONE_H

#include <stddef.h>
#include "figure.h"

extern const figure stone_figures[];
extern const size_t stone_figure_count;

#endif
