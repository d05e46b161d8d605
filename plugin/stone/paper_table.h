/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_STONE_PAPER_TABLE_H
#define SOZAI_STONE_PAPER_TABLE_H

#include "../core/params.h"
#include "stone.h"

/* The table of paper.h, and the mean of all texels. COLOUR where the config's
 * sRGB is no curve and matrix. w->mode, base and the like must be set. */
int32_t paper_build(stone_constants *w, const sozai_host *host);

/* The tile of paper_pattern, after paper_build. */
int32_t paper_build_tile(stone_constants *w, const settings *s, paper_scan *scan);

#endif
