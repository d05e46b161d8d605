/* SPDX-License-Identifier: Apache-2.0 */
#include "weights.h"

#include <stdio.h>
#include <stdlib.h>

bool weights_set_role(recipe *r, const match_role *role, const char *text, failure *why) {
  return recipe_set(r, role->colour, text, 0, why) &&
         (!role->second || recipe_set(r, role->second, text, 0, why));
}

bool weights_copy_recipe(recipe *to, const recipe *from, failure *why) {
  if (!recipe_open(to, from->material, why)) return false;
  bool ok = !from->preset || recipe_set_preset(to, from->preset, why);
  for (size_t i = 0; ok && i < from->param_count; i++)
    ok = recipe_set(to, from->params[i].id, from->params[i].text, 0, why);
  if (!ok) recipe_free(to);
  return ok;
}

/* Three roles at a time, the others black: red, green and blue of the working
 * space are then their weights. */
static bool weigh_three(const weighing *q, recipe *r, size_t first, float *to, size_t stride,
                        failure *why) {
  const sozai_colour_1 *service = q->colour->service;
  const char *space = service ? service->working_space(service->self) : "sRGB";
  bool ok = true;
  for (size_t i = 0; ok && i < q->roles; i++) {
    char text[192];
    snprintf(text, sizeof text, "%d %d %d @ %s", i == first, i == first + 1, i == first + 2, space);
    ok = weights_set_role(r, &q->material->roles[i], text, why);
  }
  float *rgb = NULL;
  if (!ok || !board_channel(q->board, r, "albedo", &rgb, why)) return false;
  for (uint64_t p = 0; p < board_points(q->board); p++)
    for (size_t k = 0; k < 3 && first + k < q->roles; k++)
      to[p * stride + first + k] = rgb[3 * p + k];
  free(rgb);
  return true;
}

static bool weigh_at(const weighing *q, const recipe *from, double brightness, float *to,
                     size_t stride, failure *why) {
  recipe r;
  if (!weights_copy_recipe(&r, from, why)) return false;
  bool ok = true;
  if (q->material->brightness) {
    char text[32];
    snprintf(text, sizeof text, "%.9g", brightness);
    ok = recipe_set(&r, q->material->brightness, text, 0, why);
  }
  for (size_t first = 0; ok && first < q->roles; first += 3)
    ok = weigh_three(q, &r, first, to, stride, why);
  recipe_free(&r);
  return ok;
}

bool weights_take(weights *w, const weighing *q, const recipe *r, failure *why) {
  bool has_brightness = q->material->brightness != NULL;
  *w = (weights){.stride = has_brightness ? 2 * q->roles : q->roles,
                 .points = board_points(q->board)};
  w->of = malloc(w->points * w->stride * sizeof *w->of);
  bool ok =
      w->of ? weigh_at(q, r, 0, w->of, w->stride, why) : fail(why, EXIT_FAILURE, "out of memory");
  if (ok && has_brightness)
    ok = weigh_at(q, r, q->most_brightness, w->of + q->roles, w->stride, why);
  for (uint64_t p = 0; ok && has_brightness && p < w->points; p++)
    for (size_t i = 0; i < q->roles; i++) {
      float *at = w->of + p * w->stride;
      at[q->roles + i] = (at[q->roles + i] - at[i]) / (float)q->most_brightness;
    }
  if (!ok) weights_free(w);
  return ok;
}

void weights_free(weights *w) {
  free(w->of);
  w->of = NULL;
}
