/* SPDX-License-Identifier: Apache-2.0
 * The ceilings of these programs on what comes from outside, beside the
 * plugin's own (api/sozai.h, sozai_limits_1): all of them, in one place.
 *
 * Set by --limit NAME=VALUE and by $SOZAI_LIMITS, "NAME=VALUE,NAME=VALUE",
 * which is read first. */
#ifndef SOZAI_HOSTS_CEILINGS_H
#define SOZAI_HOSTS_CEILINGS_H

#include <stdbool.h>
#include <stdint.h>
#include "failure.h"
#include "sozai.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Those that arrays are sized by, or formats: fixed. */
#define RECIPE_MOST_TEXT 65536
#define RECIPE_MOST_PIXELS 1048576 /* a side */
#define CSV_LONGEST_LINE 65536
#define EVAL_MOST_CHANNELS 64
#define EVAL_MOST_OUTPUTS 256
#define RENDER_MOST_CHANNELS 32
#define VIEW_MOST_SIDE 32768
#define VIEW_MOST_SAMPLES 65536
#define BAKE_MOST_SIDE 65536
#define BAKE_MOST_SHARDS 100000
#define MOST_THREADS 256
#define FIELD_MOST 65536
#define HAIR_MOST_SEGMENTS 65535
#define PLY_MOST_LINES 10000

/* X(NAME, id, unit, usual, what it may be set to, doc); equal: it is fixed */
/* clang-format off */
#define HOST_LIMIT_ROWS(X) \
  X(RECIPE_BYTES, "recipe_bytes", "B", 1u << 20, 1u << 26, "A .sozai file, each of those included too.") \
  X(RECIPE_INCLUDES, "recipe_includes", "", 8, 64, ".sozai files, one included by another.") \
  X(RECIPE_PARAMETERS, "recipe_parameters", "", 1024, 65536, "Parameters of a recipe.") \
  X(RECIPE_TEXT, "recipe_text", "B", RECIPE_MOST_TEXT, RECIPE_MOST_TEXT, "One value in a .sozai file.") \
  X(QUERY_BYTES, "query_bytes", "B", 65536, 1u << 24, "A file's name with its query, as of OpenImageIO.") \
  X(PICTURE_SIDE, "picture_side", "", RECIPE_MOST_PIXELS, RECIPE_MOST_PIXELS, "Texels along a side of a .sozai picture or volume; its levels halve that to 1.") \
  X(MESH_FILE_BYTES, "mesh_file_bytes", "B", 1ull << 33, 1ull << 40, "A mesh's file.") \
  X(MESH_POINTS, "mesh_points", "", 1u << 28, 1u << 30, "Points of a mesh that is read.") \
  X(MESH_TRIANGLES, "mesh_triangles", "", 1u << 28, 1u << 30, "Triangles of a mesh that is read.") \
  X(FIELD_BYTES, "field_bytes", "B", FIELD_MOST, FIELD_MOST, "A measured tree's field table: what the plugin's text_bytes lets through.") \
  X(CSV_LINE, "csv_line", "B", CSV_LONGEST_LINE, CSV_LONGEST_LINE, "A line of the CSV file that eval reads; lines there may be any number of.") \
  X(EVAL_CHANNELS, "eval_channels", "", EVAL_MOST_CHANNELS, EVAL_MOST_CHANNELS, "Channels that eval writes.") \
  X(EVAL_OUTPUTS, "eval_outputs", "", EVAL_MOST_OUTPUTS, EVAL_MOST_OUTPUTS, "Columns that eval writes.") \
  X(PHOTO_PIXELS, "photo_pixels", "", 1u << 26, 1u << 28, "A photograph that match reads.") \
  X(VIEW_SIDE, "view_side", "", VIEW_MOST_SIDE, VIEW_MOST_SIDE, "Pixels along a side of a rendered picture.") \
  X(VIEW_SAMPLES, "view_samples", "", VIEW_MOST_SAMPLES, VIEW_MOST_SAMPLES, "Samples of a pixel.") \
  X(VIEW_BYTES, "view_bytes", "B", 1ull << 33, 1ull << 40, "Memory of a rendered picture while it is made.") \
  X(VIEW_CHANNELS, "view_channels", "", RENDER_MOST_CHANNELS, RENDER_MOST_CHANNELS, "Channels that render writes.") \
  X(BAKE_SIDE, "bake_side", "", BAKE_MOST_SIDE, BAKE_MOST_SIDE, "Texels along a side of a baked picture.") \
  X(BAKE_SHARDS, "bake_shards", "", BAKE_MOST_SHARDS, BAKE_MOST_SHARDS, "Shares that a bake is cut into.") \
  X(HAIR_SEGMENTS, "hair_segments", "", HAIR_MOST_SEGMENTS, HAIR_MOST_SEGMENTS, "Segments of a strand in a .hair file: the format's own.") \
  X(PLY_LINES, "ply_lines", "", PLY_MOST_LINES, PLY_MOST_LINES, "Lines of a PLY file's header.") \
  X(THREADS, "threads", "", MOST_THREADS, MOST_THREADS, "Threads.")
/* clang-format on */

typedef enum host_limit {
#define HOST_LIMIT_NAME_(name, ...) HOST_LIMIT_##name,
  HOST_LIMIT_ROWS(HOST_LIMIT_NAME_)
#undef HOST_LIMIT_NAME_
      HOST_LIMITS
} host_limit;

extern const sozai_limit_info host_limit_infos[HOST_LIMITS];

/* "NAME=VALUE", of these or, kept for limits_give, of the plugin's. Before any
 * thread is started. */
bool limits_set(const char *pair, failure *why);
/* The ceiling in force. */
uint64_t limits_value(host_limit which);
/* Hands the plugin's to it; refuses names that neither side knows, and whatever
 * $SOZAI_LIMITS says wrongly. What host points to lives as long as the program. */
bool limits_give(const sozai_entry_v1 *entry, sozai_host *host, failure *why);
/* false where n is above the ceiling. name: a file's, or what counts it. */
bool limits_check(host_limit which, uint64_t n, const char *name, failure *why);

#ifdef __cplusplus
}
#endif

#endif
