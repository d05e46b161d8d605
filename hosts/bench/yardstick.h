/* SPDX-License-Identifier: Apache-2.0
 * What a user would do instead: look up the baked picture, with OpenImageIO's
 * texture system. */
#ifndef SOZAI_BENCH_YARDSTICK_H
#define SOZAI_BENCH_YARDSTICK_H

#include "board.h"
#include "failure.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Write side x side pixels of r g b as a half EXR with mipmaps. */
bool yardstick_write(const char *path, uint32_t side, const float *rgb, failure *why);

typedef struct yardstick yardstick;

/* A texture system of its own, with a cache that holds the whole picture. */
yardstick *yardstick_open(const char *path, failure *why);
void yardstick_close(yardstick *y);

/* Look up the board's measured part in raster order, at texels' centres, with
 * default options; *ns is what that took. */
bool yardstick_run(yardstick *y, const board *b, double *ns, failure *why);

#ifdef __cplusplus
}
#endif

#endif
