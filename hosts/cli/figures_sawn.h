/* SPDX-License-Identifier: Apache-2.0
 * A tree beside the boards that are sawn from its stem. */
#ifndef SOZAI_CLI_FIGURES_SAWN_H
#define SOZAI_CLI_FIGURES_SAWN_H

#include <stddef.h>
#include "figure.h"

extern const figure sawn_figures[];
extern const size_t sawn_figure_count;

#endif
