/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood as a material: its description, and the choice of kernel.
 */
#include "material.h"

#include "../core/active.h"
#include "../core/float_mode.h"
#include "../core/status.h"
#include "build.h"
#include "parameters.h"
#include "species.h"
#include "wood.h"

KERNEL_SETS(wood_kernel, kernels);

typedef struct {
  wood_constants constants;
  kernel_set use;
} wood_state;

static const sozai_texture_info *describe(void) {
  static sozai_texture_info info = {
      .size = sizeof(sozai_texture_info),
      .revision = 34,
      .id = "wood",
      .label = "Wood",
      .doc =
          "Solid wood sawn from a stem: rings, vessels and fibres carried by one grain, with the "
          "figure that it gives.",
      .parameters = wood_parameters,
      .presets = wood_species,
      .channels = wood_channels,
      .parameter_count = WOOD_PARAMETERS,
      .component_count = WOOD_COMPONENTS,
  };
  /* counts of arrays of another file are no constants in C; init calls this
   * once, alone, before anyone else can */
  if (!info.preset_count) {
    wood_build_prepare();
    info.channel_count = wood_channel_count;
    info.preset_count = wood_species_count;
  }
  return &info;
}

static int32_t build(void *state, const sozai_host *host, const settings *s,
                     const float (*colours)[3], const image_set *images) {
  wood_state *w = state;
  int32_t r = kernel_choose(kernels, &w->use);
  if (r) return r;
  return wood_build(&w->constants, host, s, colours, images);
}

_Static_assert(WOOD_COMPONENTS <= ACTIVE_OUTPUTS, "active.h has room for fewer");

static void evaluate(const void *state, const sozai_batch *b, float *const *out, uint64_t wanted) {
  const wood_state *w = state;
  kernel_io io = {b, out, wanted};
  kernel_run(&w->use, &w->constants, &io);
}

static const char *instruction_set(const void *state) {
  return ((const wood_state *)state)->use.wide->name;
}

static void release(void *state, const sozai_host *host) {
  wood_release_knots(&((wood_state *)state)->constants, host);
}

static uint64_t bytes(const void *state) {
  const wood_knots *knots = ((const wood_state *)state)->constants.knots;
  return knots ? knots->bytes : 0;
}

const material wood_material = {
    describe, sizeof(wood_state), build, evaluate, instruction_set, release, bytes};

/* ---- sozai.wood/1 ----------------------------------------------------- */

static const wood_state *state_of(const sozai_texture *t) {
  return texture_state(t, &wood_material);
}

static const wood_kernel *wide_of(const wood_state *w) { return (const wood_kernel *)w->use.wide; }

/* Boards of a layout, and plies, are each of a log of their own. */
static int32_t one_log(const wood_state *w, const char *call) {
  const wood_constants *c = &w->constants;
  if (!c->plies.count && c->boards.layout.kind == LAYOUT_NONE) return SOZAI_OK;
  return fail(SOZAI_ERROR_UNSUPPORTED, "%s: of %s there is no one log", call,
              c->plies.count ? "plies" : "boards in a layout");
}

static int32_t ring_radius(const sozai_texture *t, uint32_t count, const float *years,
                           const float *theta, const float *y, float *out_r) {
  const wood_state *w = state_of(t);
  if (!w) return fail(SOZAI_ERROR_ARGUMENT, "ring_radius: the texture is not a wood");
  if (count && (!years || !theta || !y || !out_r)) {
    return fail(SOZAI_ERROR_ARGUMENT, "ring_radius: an array is NULL");
  }
  int32_t r = one_log(w, "ring_radius");
  if (r) return r;
  uint64_t mode = float_mode_enter();
  for (uint32_t from = 0, n; from < count; from += n) {
    n = kernel_piece(count - from);
    wide_of(w)->radius(&w->constants, n, years + from, theta + from, y + from, out_r + from);
  }
  float_mode_leave(mode);
  return SOZAI_OK;
}

static int32_t pith(const sozai_texture *t, uint32_t count, const float *y, float *out_x,
                    float *out_z) {
  const wood_state *w = state_of(t);
  if (!w) return fail(SOZAI_ERROR_ARGUMENT, "pith: the texture is not a wood");
  if (count && (!y || !out_x || !out_z)) {
    return fail(SOZAI_ERROR_ARGUMENT, "pith: an array is NULL");
  }
  int32_t r = one_log(w, "pith");
  if (r) return r;
  uint64_t mode = float_mode_enter();
  for (uint32_t from = 0, n; from < count; from += n) {
    n = kernel_piece(count - from);
    wide_of(w)->pith(&w->constants, n, y + from, out_x + from, out_z + from);
  }
  float_mode_leave(mode);
  return SOZAI_OK;
}

const sozai_wood_1 wood_table = {ring_radius, pith};
