/* SPDX-License-Identifier: Apache-2.0
 *
 * What a kind of geometry gives to the registry in geometry.c.
 */
#ifndef SOZAI_GENERATOR_H
#define SOZAI_GENERATOR_H

#include "core/params.h"

#define PARTS_MAX 8

/* A mesh on its way out; its arrays are writable until it is handed over. */
typedef struct mesh_block {
  sozai_mesh out; /* what the host sees; first, so that it leads back here */
  sozai_host host;
  size_t bytes;
  float *points, *normals, *uv, *colours;
  uint32_t *owner, *indices;
  sozai_part parts[PARTS_MAX];
} mesh_block;

typedef struct curves_block {
  sozai_curves out;
  sozai_host host;
  size_t bytes;
  float *points, *radii, *colours;
  uint64_t *first;
  uint32_t *ids;
  sozai_part parts[PARTS_MAX];
} curves_block;

/* Zeroed, with the counts set; NULL with the message set. coloured: points have colours of
 * their own. */
mesh_block *mesh_block_make(const sozai_host *host, uint64_t points, uint64_t triangles,
                            int coloured);
curves_block *curves_block_make(const sozai_host *host, uint64_t curves, uint64_t points,
                                int coloured);

typedef struct generator {
  const sozai_generator_info *(*describe)(void); /* filled when first asked, at init */
  size_t state_bytes;
  /* state is zeroed; release is called after a failure too. Rehearsing
   * (core/meter.h): up to where all sizes are known, the rest claimed. */
  int32_t (*grow)(void *state, const sozai_host *host, const settings *s);
  void (*release)(void *state, const sozai_host *host);
  int32_t (*mesh)(const void *state, const sozai_host *host, uint32_t level, mesh_block **out);
  int32_t (*curves)(const void *state, const sozai_host *host, uint32_t level, curves_block **out);
  /* The rows of the index-th table of the description. */
  const float *(*table)(const void *state, uint32_t index, uint64_t *rows);
  uint64_t (*bytes)(const void *state);
} generator;

/* Its parameters and presets as settings_make takes them. */
sozai_texture_info generator_parameters(const sozai_generator_info *g);

extern const sozai_geometry_1 geometry_table;
void geometry_describe(void); /* at init */

/* What they would take; memory.c hands these out. */
int32_t geometry_memory(const sozai_host *host, const char *id, const char *preset,
                        const sozai_value *values, uint32_t value_count, sozai_memory *out);
int32_t geometry_mesh_memory(const sozai_geometry *g, const sozai_detail *detail,
                             sozai_memory *out);
int32_t geometry_curves_memory(const sozai_geometry *g, const sozai_detail *detail,
                               sozai_memory *out);

/* fraction of the work done; CANCELLED when the host asks for it. */
int32_t host_progress(const sozai_host *host, double fraction, const char *what);

#endif
