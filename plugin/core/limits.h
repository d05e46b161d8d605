/* SPDX-License-Identifier: Apache-2.0
 *
 * The plugin's ceilings on what comes from outside: all of them, in one place.
 * Numbers that are parameters have their hard ranges beside these.
 */
#ifndef SOZAI_CORE_LIMITS_H
#define SOZAI_CORE_LIMITS_H

#include "../../api/sozai.h"

/* X(name, id, unit, where the host names none, what it may raise it to, doc) */
/* clang-format off */
#define LIMIT_ROWS(X) \
  X(TEXTURE_BYTES, "texture_bytes", "B", 1ull << 32, 1ull << 40, "Memory of one texture, at any time while it is made or afterwards.") \
  X(GEOMETRY_BYTES, "geometry_bytes", "B", 1ull << 34, 1ull << 40, "Memory of one tree or aggregate, at any time while it is grown or afterwards.") \
  X(MESH_BYTES, "mesh_bytes", "B", 1ull << 34, 1ull << 40, "Memory of one mesh made of a geometry, or of its curves.") \
  X(VALUES, "values", "", 65536, 65536, "Values handed to one create or grow.") \
  X(TEXT_BYTES, "text_bytes", "B", 65536, 1ull << 24, "Length of one value's text, a table of measured branches among them.") \
  X(BUFFER_BYTES, "buffer_bytes", "B", 1ull << 31, 1ull << 31, "Each array of a buffer that is handed in.") \
  X(IMAGE_PIXELS, "image_pixels", "", 1ull << 30, 1ull << 30, "Pixels of one picture, a buffer's or a file's.") \
  X(KNOTS, "knots", "", 65536, 65536, "Rows of the table of knots.") \
  X(TABLE_ROWS, "table_rows", "", 1ull << 24, 1ull << 24, "Rows of the other tables of a tree's that wood takes.") \
  X(HULL_TRIANGLES, "hull_triangles", "", 1ull << 27, 1ull << 27, "Triangles of a hull; or points of one given by points.") \
  X(HULL_VERTICES, "hull_vertices", "", 1ull << 24, 1ull << 24, "Vertices that the literal mode's spacing puts on a hull.") \
  X(STRANDS, "strands", "", 50000000, 50000000, "Strands of an aggregate, those that packing asks for among them.") \
  X(STRAND_POINTS, "strand_points", "", 1ull << 31, 1ull << 31, "Vertices of all strands together.") \
  X(SHOOTS, "shoots", "", 0xfffffff0ull, 0xfffffff0ull, "Stem, branches and shoots of a tree.") \
  X(LEAVES, "leaves", "", 0xfffffff0ull, 0xfffffff0ull, "Leaves and needles of a tree.")
/* clang-format on */

typedef enum {
#define LIMIT_NAME_(name, ...) LIMIT_##name,
  LIMIT_ROWS(LIMIT_NAME_)
#undef LIMIT_NAME_
      LIMITS
} limit;

extern const sozai_limits_1 limits_table;
extern const sozai_limit_info limit_infos[LIMITS];

/* The ceilings that a host sets, the rest as they are. ARGUMENT, UNKNOWN, RANGE. */
int32_t limits_read(uint64_t ceilings[LIMITS], const sozai_host *host);
/* One of them, of a host as meter_open gives it; of another the usual. */
uint64_t limit_of(const sozai_host *host, limit which);
/* LIMIT, with `what` naming the parameter, where n is above the ceiling. */
int32_t limit_check(const sozai_host *host, limit which, uint64_t n, const char *what);

#endif
