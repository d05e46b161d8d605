/* SPDX-License-Identifier: Apache-2.0 */
#include "clothed.h"

#include <math.h>

const double views[VIEWS] = {90, 50, 25};

static eye eye_of(int view, int side) {
  return (eye){views[view], 180.0 * side / SIDES - 90.0 / SIDES, 180.0 / SIDES};
}

/* ---- curves ------------------------------------------------------------ */

static void add_view(const traced *t, int v, int side, uint32_t rays, clothed *o) {
  const double all = 1.0 / VIEWS / SIDES / LIGHTS;
  seen s = look_at_curves(t, eye_of(v, side), rays);
  o->covered += s.covered / VIEWS / SIDES;
  for (int k = 0; k < 3; k++) {
    double sum = 0;
    for (int l = 0; l < LIGHTS; l++) {
      sum += s.sum[l][k];
      o->radiance[v][side][l][k] = s.sum[l][k];
      o->chance[v][side][l][k] = seen_chance(&s, l, k, rays);
    }
    o->mean[k] += sum * all;
    o->mean_chance[k] += (s.square_of_all[k] - sum * sum) / rays * all * all;
  }
  if (views[v] != 90) return;
  /* the albedo is of what comes back from within: not what glances off black strands too */
  traced black = *t;
  for (int k = 0; k < 3; k++) black.colour[k] = 0.001f;
  seen glints = look_at_curves(&black, eye_of(v, side), rays);
  for (int k = 0; k < 3; k++) {
    o->albedo[k] += (s.around[k] - glints.around[k]) / SIDES;
    o->albedo_chance[k] += (s.around2[k] - s.around[k] * s.around[k] + glints.around2[k] -
                            glints.around[k] * glints.around[k]) /
                           rays / SIDES / SIDES;
  }
}

clothed cloth_as_curves(const cloth *c, uint32_t seed, uint32_t rays) {
  clothed o = {0};
  woven b;
  weave_cloth(&b, c);
  b.t.seed = seed;
  for (int v = 0; v < VIEWS; v++) {
    for (int side = 0; side < SIDES; side++) add_view(&b.t, v, side, rays, &o);
  }
  for (int k = 0; k < 3; k++) {
    o.mean_chance[k] = sqrt(o.mean_chance[k]);
    o.albedo_chance[k] = sqrt(o.albedo_chance[k]);
  }
  free_cloth(&b);
  return o;
}

/* ---- texture ----------------------------------------------------------- */

sozai_texture *cloth_as_texture(const cloth *c, const sozai_textures_1 *textures,
                                const float of[3]) {
  const double rgb[3] = {encoded((double)of[0]), encoded((double)of[1]), encoded((double)of[2])};
#define NUMBER_(i, x)                                                                              \
  {                                                                                                \
    .id = i, .kind = SOZAI_KIND_FLOAT, .number = { x }                                             \
  }
#define COLOUR_(i)                                                                                 \
  { .id = i, .kind = SOZAI_KIND_COLOUR, .number = {rgb[0], rgb[1], rgb[2]}, .text = "sRGB" }
  const sozai_value values[] = {{.id = "axis", .kind = SOZAI_KIND_CHOICE, .text = "x"},
                                {.id = "weave", .kind = SOZAI_KIND_CHOICE, .text = c->weave},
                                NUMBER_("yarn_spacing", c->spacing[0]),
                                NUMBER_("weft_spacing", c->spacing[1]),
                                NUMBER_("yarn_width", c->width),
                                NUMBER_("yarn_flatness", c->flatness),
                                NUMBER_("yarn_swell", c->swell),
                                NUMBER_("twist", c->twist),
                                NUMBER_("slub", c->slub),
                                NUMBER_("diameter", c->diameter),
                                NUMBER_("elevation_spread", c->elevation_spread),
                                NUMBER_("flyaway", c->flyaway),
                                NUMBER_("flyaway_height", c->flyaway_height),
                                NUMBER_("roughness", c->roughness),
                                NUMBER_("tilt", c->tilt),
                                NUMBER_("ior", c->index),
                                NUMBER_("transmission", c->transmission),
                                COLOUR_("colour"),
                                COLOUR_("second_colour"),
                                COLOUR_("weft_colour")};
  sozai_texture *t;
  if (textures->create(NULL, "fiber", c->preset, values, sizeof values / sizeof *values, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

/* All views, sides and lights in one batch, and points for each. */
clothed cloth_as_seen(const sozai_texture *t, const sozai_textures_1 *textures, double footprint,
                      uint32_t points) {
  enum { LOOKS = VIEWS * SIDES * LIGHTS };
  ground g = ground_of(points * LOOKS, 1);
  uint32_t r = 9;
  for (uint32_t i = 0; i < g.count; i++) {
    uint32_t look = i % LOOKS, l = look % LIGHTS;
    eye e = eye_of((int)(look / LIGHTS / SIDES), (int)(look / LIGHTS % SIDES));
    double turn = e.from + e.range * random_of(&r);
    for (int k = 0; k < 2; k++) g.at[k][i] = (float)(400 * random_of(&r));
    ground_look(&g, i, aim(e.elevation, turn), aim(lights[l][0], lights[l][1] + turn));
  }
  ground_ask(&g, textures, t, footprint);
  clothed o = {0};
  for (uint32_t i = 0; i < g.count; i++) {
    uint32_t look = i % LOOKS, side = look / LIGHTS % SIDES, v = look / LIGHTS / SIDES;
    for (int k = 0; k < 3; k++) {
      double x = (double)g.out[RADIANCE + k][i];
      o.radiance[v][side][look % LIGHTS][k] += x / points;
      o.mean[k] += x / g.count;
      if (views[v] == 90) o.albedo[k] += (double)g.out[ALBEDO + k][i] / points / SIDES / LIGHTS;
    }
    o.covered += (double)g.out[COVERAGE][i] / g.count;
  }
  ground_free(&g);
  return o;
}
