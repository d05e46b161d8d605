/* SPDX-License-Identifier: Apache-2.0 */
#include "photograph.h"

#include <math.h>
#include <stdlib.h>

const char *photograph_take(const photograph *q, const char *name) {
  sozai_texture *t = section_make(q->preset, q->parameters);
  double pixel = q->mm / q->width;
  size_t cells = (size_t)q->width * (size_t)q->height;
  float *rgb = malloc(sizeof(float) * 3 * cells);
  points p = {0};
  for (int j = 0; j < q->height; j++) {
    points_clear(&p);
    for (int i = 0; i < q->width; i++) {
      points_add(&p, (i + 0.5 - q->pith_s * q->width) * pixel, 0,
                 (j + 0.5 - q->pith_t * q->height) * pixel, 'y', pixel);
    }
    points_ask(&p, t);
    for (int i = 0; i < q->width; i++) {
      float *to = rgb + 3 * ((size_t)j * (size_t)q->width + (size_t)i);
      int wood = q->years == 0.0 || (double)p.out[TIME][i] < q->years;
      for (int k = 0; k < q->cracks && wood; k++) {
        double a = atan2((double)p.in[2][i], (double)p.in[0][i]) - 2.4 * k;
        double r = hypot((double)p.in[2][i], (double)p.in[0][i]);
        /* a wedge, from half way out */
        if (fabs(sin(a)) * r < 0.02 * r && cos(a) > 0 && r > 30) wood = -1;
      }
      float shake = 1.0f + q->noise * (float)(2.0 * uniform() - 1.0);
      for (int c = 0; c < 3; c++) {
        float v = wood > 0 ? p.out[ALBEDO + c][i] : wood < 0 ? 0.01f : q->background;
        to[c] = v * shake;
      }
    }
  }
  const char *path = section_path(name);
  if (host_images_write(path, q->width, q->height, rgb)) fail_msg("%s cannot be written", path);
  free(rgb);
  points_free(&p);
  textures->destroy(t);
  return path;
}
