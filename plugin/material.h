/* SPDX-License-Identifier: Apache-2.0
 *
 * What a material gives to the registry. A new material is a folder with one
 * of these, and a line in registry.c.
 */
#ifndef SOZAI_MATERIAL_H
#define SOZAI_MATERIAL_H

#include "core/images.h"

typedef struct material {
  /* Its description; filled when first asked, at init. */
  const sozai_texture_info *(*describe)(void);
  size_t state_bytes;
  /* Settings, converted colours and opened pictures (which outlive it) to a
   * state, which then never changes. state is zeroed, aligned to 64. */
  int32_t (*build)(void *state, const sozai_host *host, const settings *s,
                   const float (*colours)[3], const image_set *images);
  /* The batch has been checked. out has a pointer for every component; bit k
   * of wanted says that out[k] is not NULL. */
  void (*evaluate)(const void *state, const sozai_batch *batch, float *const *out, uint64_t wanted);
  const char *(*instruction_set)(const void *state);
  /* NULL: build allocates nothing. release is called after a failure too. */
  void (*release)(void *state, const sozai_host *host);
  uint64_t (*bytes)(const void *state); /* of what it allocated */
} material;

extern const material *const registry[];
extern const uint32_t registry_count;

/* A texture's state if it is of that material, else NULL. */
const void *texture_state(const sozai_texture *texture, const material *m);

extern const sozai_textures_1 textures_table;
int textures_ready(void); /* between init and deinit */

/* What a texture would take; memory.c hands these out. */
int32_t texture_memory(const sozai_host *host, const char *id, const char *preset,
                       const sozai_value *values, uint32_t value_count, sozai_memory *out);
extern const sozai_memory_1 memory_table;

#endif
