/* SPDX-License-Identifier: Apache-2.0
 *
 * From what is seen to the output channels.
 */
#ifndef SOZAI_FIBERTEX_OUTPUT_H
#define SOZAI_FIBERTEX_OUTPUT_H

#include "shown.h"

/* What of a block goes out. */
typedef struct {
  vf component[FIBERTEX_COMPONENTS];
} output;

/* Channel by channel, all blocks of each: where a caller's arrays lie alike in the cache, a line
 * that is left half full would have to be fetched again. */
INLINE void stage_store(const kernel_io *io, const block *k, uint32_t blocks, const output *o) {
  int whole = k[blocks - 1].n == LANES;
  for (int c = 0; c < FIBERTEX_COMPONENTS; c++) {
    if (!(io->wanted >> c & 1)) continue;
    float *to = io->out[c] + k->i;
    if (whole) {
      EACH(b, blocks) store(to + b * LANES, o[b].component[c]);
    } else {
      EACH(b, blocks) store_lanes_of(io->out[c], k[b].i, k[b].n, o[b].component[c]);
    }
  }
}

INLINE void put_vector(const kernel_io *io, const block *k, int channel, const vf v[3],
                       const vf otherwise[3], output *out) {
  if (!kernel_wants(io, channel, 3)) return;
  const hull_frame *f = &k->f;
  vf square = dot3(v, v);
  vm none = not_(gt(square, splat(1e-12f)));
  vf inverse = inverse_root(vmax(square, splat(1e-12f)));
  for (int c = 0; c < 3; c++) {
    vf x = (v[0] * f->e1[c] + v[1] * f->e2[c] + v[2] * f->n[c]) * inverse;
    out->component[channel + c] = sel(none, otherwise[c], x);
  }
}

INLINE void stage_put(const fibertex_constants *w, int woven, const kernel_io *io, const block *k,
                      const shown *o, const strand_axes *t, int wants, output *out) {
  const vf zero = splat(0.0f), one = splat(1.0f), far = k->far;
  const int colours = woven ? FIBERTEX_COLOURS : COLOUR_WEFT;
  vf cover = clamp01(o->cover), some = one / vmax(cover, splat(1e-6f));
  for (int c = 0; c < 3; c++) {
    vf a = zero, r = o->white;
    for (int i = 0; i < colours; i++) a = a + o->albedo[i] * splat(w->colour[i][c]);
    if (w->cloud > 0.0f) a = a * k->cloud;
    out->component[FIBERTEX_ALBEDO + c] = a;
    if (!(wants & WANTS_LIGHT)) continue;
    for (int i = 0; i < colours; i++) {
      r = r + o->glow[i] * splat(w->glow[i][c]) + o->bulk[i] * splat(w->bulk[i][c]);
    }
    if (w->cloud > 0.0f) r = r * k->cloud;
    if (io->in->light_colour[c]) {
      vf e = load_lanes(io->in->light_colour[c], k->i, k->n);
      r = r * sel(lt(vabs(e), splat(1e30f)), e, zero);
    }
    out->component[FIBERTEX_RADIANCE + c] = r;
  }
  out->component[FIBERTEX_COVERAGE] = cover;
  vf depth = vmax(o->depth * some, zero);
  out->component[FIBERTEX_DEPTH] = depth;
  if (!(wants & WANTS_STRAND)) return;
  put_vector(io, k, FIBERTEX_TANGENT, t->along, k->f.e1, out);
  out->component[FIBERTEX_STRAND] = to_float((vi)(k->best.id >> 8)) * splat(1.0f / 16777216.0f);
  /* the strand's own roundness is in the height */
  vf side = k->best.across, top = vsqrt(vmax(one - side * side, zero));
  vf seen = (k->most - k->next) * k->best.detail * (one - far);
  out->component[FIBERTEX_HEIGHT] = splat(w->layer[0].radius) * top * seen - depth;
  if (!kernel_wants(io, FIBERTEX_NORMAL, 4)) return;
  /* what no strand shows faces as the ground does, or the hull; what the mean has lost
   * in length is the normals' scatter */
  const ground *g = &k->ground;
  vf n[3], near = one - far;
  for (int c = 0; c < 3; c++) {
    vf of = seen * (side * t->across[c] + top * t->up[c]);
    if (woven) of = of + (near - seen) * g->up[c];
    if (c == 2) of = woven ? of + far : of + (one - seen);
    n[c] = sel(le(one, far), splat(c == 2 ? 1.0f : 0.0f), of);
  }
  vf alpha2 = splat(w->strand_alpha2) + splat(0.5f) * (one - seen);
  out->component[FIBERTEX_ROUGHNESS] = vsqrt(vmin(alpha2, one));
  put_vector(io, k, FIBERTEX_NORMAL, n, k->f.n, out);
}

#endif
