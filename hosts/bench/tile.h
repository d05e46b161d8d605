/* SPDX-License-Identifier: Apache-2.0
 * Reading a tile of a .sozai file through OpenImageIO, beside reading the same
 * tile of that picture baked: half, tiled, zip-compressed, with mipmaps. Of
 * several outputs, which are the channels of one subimage, it is baked to one
 * file with all channels, or to a file for each output. */
#ifndef SOZAI_BENCH_TILE_H
#define SOZAI_BENCH_TILE_H

#include <stdbool.h>
#include <stdint.h>
#include "failure.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct tile_kind {
  const char *material, *preset;
  const char *params;  /* as in a .sozai file, or NULL */
  double texel;        /* mm */
  const char *outputs; /* with commas between */
  bool apart;          /* baked to a file for each */
  int samples;         /* parts across a texel; 0: 1 */
} tile_kind;

#define TILE_SIDE 64u
#define TILE_COUNT 64u /* read in a repetition */

typedef struct tile tile;

/* Writes the file, and bakes it, into the folder. plugin_path: the sozai.so
 * that the reader is to use. */
tile *tile_open(const tile_kind *kind, const char *folder, const char *plugin_path, failure *why);
/* Removes both files. NULL is allowed. */
void tile_close(tile *t);
/* Read TILE_COUNT tiles; *ns is the thread's time. */
bool tile_read_sozai(tile *t, double *ns, failure *why);
bool tile_read_baked(tile *t, double *ns, failure *why);

#ifdef __cplusplus
}
#endif

#endif
