/* SPDX-License-Identifier: Apache-2.0
 *
 * From parameters to the kernel's constants and tables: what is worked out, in its order.
 */
#include "parts.h"

#include "../../core/hash1.h"
#include "../age.h"
#include "../parameters.h"
#include "../plies/build.h"
#include "../section.h"
#include "../surface/build.h"

/* What a tree may have a say in. */
static int32_t build_grown(wood_constants *w, const sozai_host *host, const settings *s,
                           const float (*colours)[3]) {
  knot_source tree;
  int32_t r = knot_source_open(&tree, host, s);
  if (r) return r;
  r = wood_build_stem(w, s);
  if (!r) r = wood_build_rings(w, s, &tree);
  if (!r) r = wood_build_knots(w, host, s, &tree, colours);
  knot_source_close(&tree, host);
  return r;
}

/* Once all of it is known. Products as the kernels of many lanes round them. */
static void build_fours(wood_constants *w) {
  wood_fours *q = &w->fours;
  for (int i = 0; i < 4; i++) {
    int both = i & 1, twice = i >> 1; /* which of two: both of them twice; each of them twice */
    q->pith[i] = i < 2 ? w->pith_amplitude : w->pith_amplitude * w->pith_frequency;
    q->pith_seed[i] = w->seeds[twice ? SEED_PITH_Z : SEED_PITH_X];
    q->section[i] = w->undulation_frequency_section[twice];
    q->axis[i] = w->undulation_frequency_axis[twice];
    q->height[i] = w->undulation[both];
    q->slope_y[i] = i < 2 ? 1.0f : w->undulation_frequency_axis[both];
    q->slope[i] = w->undulation_frequency_section[both];
    q->undulation_seed[i] = w->seeds[SEED_UNDULATION + twice];
    q->often[i] = w->slope_noise_frequency[twice];
    q->far[i] = w->slope_noise[both] * (i < 2 ? 1.0f : w->slope_noise_frequency[both]);
    q->by_years[i] = w->slope_noise[both] * w->slope_noise_years;
    q->slope_seed[i] = w->seeds[SEED_SLOPE + twice];
    if (i == WOOD_FIBRE_OCTAVES) break;
    q->blur[i] = w->fibre_blur[i];
    q->blur2[i] = w->fibre_blur[i] * w->fibre_blur[i];
    q->frequency[i] = w->fibre_frequency[i];
    q->scale[i] = w->fibre_scale[i];
    q->front[i] = w->fibre_front[i];
    q->variance[i] = w->fibre_variance[i];
    q->fibre_seed[i] = w->seeds[SEED_FIBRE + i];
  }
}

int32_t wood_build(wood_constants *w, const sozai_host *host, const settings *s,
                   const float (*colours)[3], const image_set *images) {
  w->seed = hash1_named((uint32_t)number_at(s, P_SEED) + 0x51ed270bu, s->list[P_OBJECT].text);
  for (uint32_t i = 0; i < WOOD_SEEDS; i++) w->seeds[i] = hash1(w->seed + 0x9e3779b9u * (i + 1));
  int32_t r = wood_build_cut(w, s);
  if (r) return r;
  wood_build_season(w, s);
  r = build_grown(w, host, s, colours);
  if (r) return r;
  wood_build_grain(w, s);
  r = wood_build_figure(w, s);
  if (r) return r;
  wood_build_vessels(w, s);
  wood_build_rays(w, s);
  wood_build_parenchyma(w, s, colours);
  wood_build_fibres(w, s);
  r = wood_build_colour(w, host, s, colours);
  if (r) return r;
  r = surface_build(w, s);
  if (r) return r;
  wood_build_canals(w, s, colours);
  wood_build_spalt(w, s);
  age_build(w, s, colours);
  w->shade = (float)number_at(s, P_END_SHADE);
  w->ray_shade = (float)number_at(s, P_RAY_SHADE);
  w->has_ends = w->shade > 0.0f || w->ray_shade > 0.0f;
  surface_build_colour(w, s, colours);
  wood_build_cells(w, s);
  wood_build_cone(w, s);
  r = wood_build_boards(w, s, colours);
  if (!r) r = plies_build(w, s, colours);
  if (!r && images->service && images->list[P_SECTION]) {
    r = section_build(w, host, s, images->service, images->list[P_SECTION]);
  }
  build_fours(w);
  return r;
}
