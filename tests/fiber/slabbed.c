/* SPDX-License-Identifier: Apache-2.0 */
#include "slabbed.h"

#include <math.h>

const double slab_views[SLAB_VIEWS] = {90, 45};

slabbed slab_as_curves(slab *b, uint32_t seed, uint32_t rays) {
  slabbed o = {0};
  b->t.seed = seed;
  for (int v = 0; v < SLAB_VIEWS; v++) {
    seen s = look_at_curves(&b->t, (eye){slab_views[v], 0, 360}, rays);
    for (int k = 0; k < 3; k++) {
      double sum = 0;
      for (int l = 0; l < LIGHTS; l++) {
        double mean = s.sum[l][k];
        o.radiance[v * LIGHTS + l][k] = mean;
        o.chance[v * LIGHTS + l][k] = seen_chance(&s, l, k, rays);
        sum += mean;
      }
      o.mean[k] += sum / SLAB_LOOKS;
      o.mean_chance[k] += (s.square_of_all[k] - sum * sum) / rays / SLAB_LOOKS / SLAB_LOOKS;
    }
  }
  for (int k = 0; k < 3; k++) o.mean_chance[k] = sqrt(o.mean_chance[k]);
  return o;
}

sozai_texture *slab_as_texture(const slab *b, const sozai_textures_1 *textures) {
  const aggregate *a = b->of;
#define NUMBER_(i, x)                                                                              \
  {                                                                                                \
    .id = i, .kind = SOZAI_KIND_FLOAT, .number = { x }                                             \
  }
  const sozai_value values[] = {
      NUMBER_("diameter", a->diameter),
      NUMBER_("diameter_spread", 0),
      NUMBER_("thickness", a->thick),
      NUMBER_("packing", b->packing),
      NUMBER_("flyaway", 0),
      NUMBER_("crimp", 0),
      NUMBER_("alignment", 0),
      NUMBER_("elevation", 0),
      NUMBER_("elevation_spread", atan(b->rise) * 180 / PI),
      NUMBER_("roughness", (double)a->roughness),
      NUMBER_("tilt", (double)a->tilt),
      NUMBER_("ior", (double)a->index),
      NUMBER_("transmission", 0.55 * (1 - 0.8 * (double)a->round) + 0.08),
      NUMBER_("second_share", 0),
      NUMBER_("variation", 0),
      {.id = "colour",
       .kind = SOZAI_KIND_COLOUR,
       .number = {encoded((double)colours[0]), encoded((double)colours[1]),
                  encoded((double)colours[2])},
       .text = "sRGB"},
  };
  sozai_texture *t;
  if (textures->create(NULL, "fiber", a->preset, values, sizeof values / sizeof *values, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

/* The hull's frame turns with the ground, as the curves' view does. */
slabbed slab_as_seen(const sozai_texture *t, const sozai_textures_1 *textures, double footprint,
                     uint32_t points) {
  ground g = ground_of(points * SLAB_LOOKS, 1);
  uint32_t r = 9;
  for (uint32_t i = 0; i < g.count; i++) {
    uint32_t look = i % SLAB_LOOKS;
    double turn = 360 * random_of(&r);
    const double *light = lights[look % LIGHTS];
    for (int k = 0; k < 2; k++) g.at[k][i] = (float)(400 * random_of(&r));
    ground_look(&g, i, aim(slab_views[look / LIGHTS], turn), aim(light[0], light[1] + turn));
  }
  ground_ask(&g, textures, t, footprint);
  slabbed o = {0};
  for (uint32_t i = 0; i < g.count; i++) {
    for (int k = 0; k < 3; k++) {
      double x = (double)g.out[RADIANCE + k][i];
      o.radiance[i % SLAB_LOOKS][k] += x / points;
      o.mean[k] += x / g.count;
    }
  }
  ground_free(&g);
  return o;
}
