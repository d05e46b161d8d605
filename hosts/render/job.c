/* SPDX-License-Identifier: Apache-2.0 */
#include "render.h"

#include <string.h>
#include "parallel.h"

void render_job_init(render_job *job, const sozai_textures_1 *textures,
                     const sozai_texture *texture) {
  *job = (render_job){
      .textures = textures,
      .texture = texture,
      .shape = SHAPE_BOARD,
      .size = {120, 240, 20},
      .bevel = 1,
      .mesh_scale = 1,
      .spp = 32,
      .threads = parallel_default_threads(),
      .camera = CAMERA_VIEW,
      .camera_azimuth = -32,
      .camera_elevation = 42,
      .camera_angle = 24,
      .zoom = 1,
      .light_azimuth = 75,
      .light_elevation = 48,
      .light_colour = {1, 1, 1},
      .light_size = 4,
      .sky = 1,
      .floor = true,
  };
}
