/* SPDX-License-Identifier: Apache-2.0
 * A square of pixels, rendered in batches of samples. */
#ifndef SOZAI_RENDER_TILE_H
#define SOZAI_RENDER_TILE_H

#include "camera.h"
#include "film.h"
#include "render.h"
#include "scene.h"
#include "studio.h"

#define TILE_SIDE 32

typedef struct tile_context {
  const render_job *job;
  const sozai_texture_info *info;
  const scene *scene;
  const camera *camera;
  const studio *studio;
  film *film;
  int32_t albedo, radiance; /* first components; -1: the texture has none */
  /* likewise, and all four or none: what the sky's light takes beyond albedo */
  int32_t occlusion, normal, roughness, specular;
  int32_t coverage; /* likewise; what it leaves bare shows a grey card */
  float gaps;       /* of the whole face the bare share, by which light reaches the card */
} tile_context;

bool tile_render(const tile_context *c, uint32_t index, failure *why);
uint32_t tile_count(const film *f);

#endif
