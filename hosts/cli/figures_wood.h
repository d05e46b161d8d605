/* SPDX-License-Identifier: Apache-2.0
 * The figures of Kawai's paper that show the model at work, drawn from the
 * plugin: 5 and 6 (vessels under three grains), 7 (a cross-section and the
 * face it gives) and 9 (the figure under three lights). */
#ifndef SOZAI_CLI_FIGURES_WOOD_H
#define SOZAI_CLI_FIGURES_WOOD_H

#include <stddef.h>
#include "figure.h"

extern const figure wood_figures[];
extern const size_t wood_figure_count;

#endif
