/* SPDX-License-Identifier: Apache-2.0
 * Growing through the plugin, and the files that come of it. */
#ifndef SOZAI_HOSTS_GROWTH_H
#define SOZAI_HOSTS_GROWTH_H

#include <stdint.h>
#include <stdio.h>
#include "failure.h"
#include "sozai.h"

/* The plugin's table; a plugin without it is a failure. */
const sozai_geometry_1 *growth_table(const sozai_entry_v1 *entry, failure *why);

/* "name=value" each, as the plugin reads them. preset and field (the text of a
 * field table) may be NULL. */
bool growth_grow(const sozai_geometry_1 *table, const sozai_host *host, const char *id,
                 const char *preset, const char *const *pairs, size_t pair_count, const char *field,
                 sozai_geometry **out, failure *why);

/* Likewise, with values that are no text besides. */
bool growth_grow_with(const sozai_geometry_1 *table, const sozai_host *host, const char *id,
                      const char *preset, const char *const *pairs, size_t pair_count,
                      const sozai_value *more, size_t more_count, sozai_geometry **out,
                      failure *why);

/* The text of a file, with a zero at its end, to be freed. */
bool growth_read_text(const char *path, char **out, failure *why);

/* Which file (NULL: none) a message about a field table's line is of; gives false. */
bool growth_name_field(const char *path, failure *why);

/* What a code of the plugin's means for the program, with its message. */
bool growth_failed(const sozai_geometry_1 *table, int32_t code, failure *why);

/* A table by id. */
bool growth_rows(const sozai_geometry_1 *table, const sozai_geometry *g, const char *id,
                 sozai_table *out, failure *why);
/* The number in a row's column of that id. NAN: there is no such column. */
double growth_number(const sozai_table *t, uint64_t row, const char *column);

/* Of its points, r g b each, sRGB. NULL: as the parts are, or an older plugin's. */
const float *growth_mesh_colours(const sozai_mesh *m);
const float *growth_curves_colours(const sozai_curves *c);
/* Whether a part's points differ from the part's colour. */
bool growth_part_varies(const sozai_mesh *m, uint32_t part);

/* ---- writers, one file each ------------------------------------------- */

/* Each writes to `path`, in mm unless its format says otherwise. */
bool write_obj(const sozai_mesh *m, const char *path, failure *why);
bool write_gltf(const sozai_mesh *m, const char *path, failure *why);
/* mesh or curves, one of them NULL. */
bool write_usda(const sozai_mesh *m, const sozai_curves *c, const char *path, failure *why);
/* The table "nodes" as a field table. */
/* Refused where it grows past what may be read again. */
bool write_field(const sozai_table *nodes, const char *path, failure *why);
bool write_csv(const sozai_table *t, const char *path, failure *why);

#endif
