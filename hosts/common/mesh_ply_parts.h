/* SPDX-License-Identifier: Apache-2.0
 * What a PLY file's header says, between mesh_ply.c and mesh_ply_data.c. */
#ifndef SOZAI_HOSTS_MESH_PLY_PARTS_H
#define SOZAI_HOSTS_MESH_PLY_PARTS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include "failure.h"

typedef enum ply_format { PLY_ASCII, PLY_LITTLE, PLY_BIG } ply_format;

typedef enum ply_type {
  PLY_NONE,
  PLY_INT8,
  PLY_UINT8,
  PLY_INT16,
  PLY_UINT16,
  PLY_INT32,
  PLY_UINT32,
  PLY_FLOAT,
  PLY_DOUBLE
} ply_type;

/* An element, or a property of the last one above it. */
typedef struct ply_row {
  char name[64];
  bool element;
  bool faces, strips;  /* of an element: its vertex indices are corners; -1 ends a strip */
  uint64_t count;      /* of an element */
  ply_type type, list; /* of a property; list: its count's, PLY_NONE: it is one value */
} ply_row;

typedef struct ply_header {
  const char *path;
  double bytes, points;
  ply_format format;
  bool has_points, has_faces;
  uint32_t count;
  ply_row *rows; /* PLY_MOST_LINES */
} ply_header;

/* file: after the header. */
bool mesh_ply_indices(const ply_header *h, FILE *file, failure *why);

#endif
