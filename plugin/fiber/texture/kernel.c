/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre's evaluate: compiled once for each instruction set and width.
 */
#include "cloth_looks.h"
#include "cloud.h"
#include "hull_looks.h"
#include "measure.h"
#include "measure_both.h"
#include "nap.h"
#include "output.h"

extern const fibertex_kernel KERNEL_NAME(fibertex_kernel_);

/* Where a footprint holds some of the nap's patches. */
INLINE void show_nap(const fibertex_constants *w, const block *k, int light, shown *far) {
  if (!any(gt(k->nap_lost, splat(0.0f)))) return;
  shown of = *far;
  show_far_of_nap(w, k, light, &of);
  blend(far, &of, sel(gt(k->nap_lost, splat(0.0f)), splat(1.0f), splat(0.0f)), 0, light);
}

/* From what is summed up to what is seen. */
INLINE void stage_show(const fibertex_constants *w, int woven, block *k, const looks *q,
                       strand_axes *t, const strand_lit *lit, int wants, shown *near) {
  const int light = wants & WANTS_LIGHT;
  const vf zero = splat(0.0f), one = splat(1.0f);
  sums sum;
  shown mean;
  if (any(lt(k->far, one))) {
    show_near(w, woven, k, q, t, lit, light, near);
    if (!any(gt(k->far, zero))) return;
    far_sums(w, k, light, &sum);
    show_far(w, woven, k, &sum, q, &mean);
    if (!woven && w->nap > 0.0f) show_nap(w, k, light, &mean);
    blend(near, &mean, k->far, woven, light);
  } else { /* nothing near is left of it */
    far_sums(w, k, light, &sum);
    show_far(w, woven, k, &sum, q, near);
    if (!woven && w->nap > 0.0f) show_nap(w, k, light, near);
  }
  if (!(wants & WANTS_STRAND)) return;
  vm nothing = le(one, k->far);
  for (int c = 0; c < 3; c++) t->along[c] = sel(nothing, zero, t->along[c]);
  k->best.id = selu(nothing, splatu(0), k->best.id);
}

INLINE void evaluate_as(const fibertex_constants *w, int woven, const kernel_io *io, uint32_t from,
                        uint32_t to) {
  const int light = kernel_wants(io, FIBERTEX_RADIANCE, 3) ? WANTS_LIGHT : 0;
  const int strand =
      light || kernel_wants(io, FIBERTEX_TANGENT, 4) || kernel_wants(io, FIBERTEX_HEIGHT, 5);
  const int wants = light | (strand ? WANTS_STRAND : 0);
  for (uint32_t i = from; i < to; i += BLOCKS_TOGETHER * LANES) {
    block of[BLOCKS_TOGETHER];
    looks all[BLOCKS_TOGETHER];
    output out[BLOCKS_TOGETHER];
    uint32_t left = (to - i + LANES - 1) / LANES;
    uint32_t count = left < BLOCKS_TOGETHER ? left : BLOCKS_TOGETHER;
    EACH(b, count) {
      of[b].i = i + b * LANES;
      of[b].n = to - of[b].i < LANES ? to - of[b].i : LANES;
      stage_point(w, woven, io, &of[b]);
    }
    if (!woven && w->nap > 0.0f) EACH(b, count) nap_turn(w, &of[b]);
    if (w->cloud > 0.0f) EACH(b, count) stage_cloud(w, &of[b]);
    EACH(b, count) stage_view(io, &of[b]);
    if (light) {
      EACH(b, count) stage_light(w, io, &of[b]);
    } else {
      EACH(b, count) stage_dark(&of[b]);
    }
    int level = (woven || !(w->nap > 0.0f)) && eye_level(of, count);
    EACH(b, count) stage_bundles(w, level, &of[b]);
    if (light) {
      EACH(b, count) stage_reach(w, &of[b]);
      if (woven) EACH(b, count) stage_reach_of_cloth(w, &of[b]);
    }
    EACH(b, count) {
      if (woven)
        ground_cloth(w, light, &of[b]);
      else
        ground_hull(w, light, &of[b]);
    }
    EACH(b, count) stage_empty(w, &of[b]);
    stage_layers(w, woven, of, count, level, wants);
    if (woven)
      stage_looks_of_cloth(w, of, count, light, all);
    else
      stage_looks_of_hull(w, of, count, level, light, all);
    if (strand) EACH(b, count) stage_best(&of[b]);
    EACH(b, count) stage_deep(w, &of[b]);
    strand_axes t[BLOCKS_TOGETHER];
    strand_lit lit[BLOCKS_TOGETHER];
    shown seen[BLOCKS_TOGETHER];
    EACH(b, count) {
      if (strand)
        best_axes(w, woven, &of[b], &t[b]);
      else
        strand_axes_none(&t[b]);
    }
    if (light) {
      strand_angles a[BLOCKS_TOGETHER];
      EACH(b, count) {
        strand_angles_of(w, woven, of[b].f.light, of[b].f.view, of[b].f.between, &t[b], &a[b]);
      }
      EACH(b, count) {
        if (woven)
          strand_lobes_of_yarn(w, &a[b], &lit[b]);
        else
          strand_lobes(w, &a[b], &lit[b]);
      }
    }
    EACH(b, count) stage_show(w, woven, &of[b], &all[b], &t[b], &lit[b], wants, &seen[b]);
    EACH(b, count) stage_put(w, woven, io, &of[b], &seen[b], &t[b], wants, &out[b]);
    stage_store(io, of, count, out);
  }
}

static __attribute__((noinline)) void
evaluate_hull(const fibertex_constants *w, const kernel_io *io, uint32_t from, uint32_t to) {
  evaluate_as(w, 0, io, from, to);
}
static __attribute__((noinline)) void
evaluate_cloth(const fibertex_constants *w, const kernel_io *io, uint32_t from, uint32_t to) {
  evaluate_as(w, 1, io, from, to);
}
static void evaluate(const void *constants, const kernel_io *io, uint32_t from, uint32_t to) {
  const fibertex_constants *w = constants;
  if (w->structure == STRUCTURE_WOVEN)
    evaluate_cloth(w, io, from, to);
  else
    evaluate_hull(w, io, from, to);
}

const fibertex_kernel KERNEL_NAME(fibertex_kernel_) = {KERNEL_OF(evaluate), measure, measure_cloth,
                                                       measure_both};
