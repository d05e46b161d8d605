/* SPDX-License-Identifier: Apache-2.0 */
#include "evaluate.h"

#include <stdlib.h>
#include <string.h>
#include "blend.h"
#include "patches.h"
#include "texel_parts.h"

/* A plane's normal, the same at every texel. */
#define FOUR_OF(x) x, x, x, x
static const float zeros[SURFACE_BLOCK],
    ones[SURFACE_BLOCK] = {FOUR_OF(FOUR_OF(FOUR_OF(FOUR_OF(FOUR_OF(1.0f)))))};
_Static_assert(SURFACE_BLOCK == 4 * 4 * 4 * 4 * 4, "as many ones as texels in a block");
static const float *const upwards[3] = {zeros, zeros, ones};

static bool too_far(const uint8_t *covered, size_t count) {
  for (size_t i = 0; i < count; i++)
    if (covered[i]) return false;
  return true;
}

/* Nothing of a mesh is near: one answer for all. */
static void repeat_first(float *const *out, uint32_t out_count, size_t count) {
  for (uint32_t k = 0; k < out_count; k++)
    for (size_t i = 1; out[k] && i < count; i++) out[k][i] = out[k][0];
}

static int32_t evaluate(const surface_shape *shape, const surface_material *m,
                        const sozai_batch *batch, const surface_room *texels) {
  const periodic *repeat = shape->seamless ? &shape->repeat : NULL;
  texel_parts parts = {.side = shape->samples, .repeat = repeat};
  for (int c = 0; c < 3; c++) {
    parts.across[c] = texels->across[c];
    parts.down[c] = texels->down[c];
  }
  if (parts.side > 1) return texel_parts_evaluate(&parts, m, batch);
  return repeat ? blend_evaluate(repeat, m, batch) : m->textures->evaluate(m->texture, batch);
}

bool surface_evaluate(const surface *s, const surface_material *m, uint32_t level, uint32_t x,
                      uint32_t y, uint32_t z, uint32_t w, uint32_t h, float *const *out,
                      uint32_t out_count, uint8_t *covered, failure *why) {
  _Alignas(64) float input[13][SURFACE_BLOCK];
  uint8_t own_covered[SURFACE_BLOCK];
  const surface_shape *shape = surface_shape_of(s);
  bool flat = shape->kind == SURFACE_PLANE, mesh = shape->kind == SURFACE_MESH;
  surface_room texels = {.point = {input[0], input[1], input[2]},
                         .footprint = input[6],
                         .covered = covered || !mesh ? covered : own_covered};
  for (int c = 0; c < 3; c++) {
    texels.normal[c] = mesh ? input[3 + c] : NULL;
    texels.across[c] = shape->samples > 1 ? input[7 + c] : NULL;
    texels.down[c] = shape->samples > 1 ? input[10 + c] : NULL;
  }
  size_t count = (size_t)w * h;
  if (count > SURFACE_BLOCK || !surface_texels(s, level, x, y, z, w, h, &texels))
    return fail(why, EXIT_FAILURE, "no such texels");
  if (out_count > SURFACE_COMPONENTS) out_count = SURFACE_COMPONENTS;
  bool alike = mesh && too_far(texels.covered, count);
  /* of what is no mesh all else is the same at each texel */
  for (int c = 0; !mesh && c < 2; c++) patches_of_rows(texels.point[c], w, h);
  sozai_batch batch = {.size = sizeof batch,
                       .count = alike ? 1 : (uint32_t)count,
                       .footprint = texels.footprint,
                       .out = out,
                       .out_count = out_count};
  for (int c = 0; c < 3; c++) {
    batch.point[c] = texels.point[c];
    batch.normal[c] = flat ? upwards[c] : texels.normal[c];
  }
  int32_t result = evaluate(shape, m, &batch, &texels);
  if (result != SOZAI_OK) return fail(why, EXIT_FAILURE, "%s", m->textures->last_error());
  for (uint32_t k = 0; !mesh && k < out_count; k++)
    if (out[k]) rows_of_patches(out[k], w, h);
  if (alike) repeat_first(out, out_count, count);
  return true;
}
