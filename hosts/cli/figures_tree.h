/* SPDX-License-Identifier: Apache-2.0
 * The figures of Hayashi & Takahashi's paper, drawn from grown trees: plans,
 * profiles and turning (2 to 12), and views (20, 21, 23 to 27). */
#ifndef SOZAI_CLI_FIGURES_TREE_H
#define SOZAI_CLI_FIGURES_TREE_H

#include <stddef.h>
#include "figure.h"

extern const figure tree_figures[];
extern const size_t tree_figure_count;

#endif
