/* SPDX-License-Identifier: Apache-2.0
 * Figures of Sakurai & Miyata's paper, and of aggregates beyond it. */
#ifndef SOZAI_CLI_FIGURES_FIBER_H
#define SOZAI_CLI_FIGURES_FIBER_H

#include <stddef.h>
#include "figure.h"

extern const figure fiber_figures[];
extern const size_t fiber_figure_count;

#endif
