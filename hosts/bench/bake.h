/* SPDX-License-Identifier: Apache-2.0
 * The board's albedo as a picture. */
#ifndef SOZAI_BENCH_BAKE_H
#define SOZAI_BENCH_BAKE_H

#include "board.h"
#include "plugin.h"

/* side x side pixels of r g b, the first row first; to be freed. NULL: why. */
float *bake_board(const plugin *p, const board *b, failure *why);

#endif
