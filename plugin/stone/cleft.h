/* SPDX-License-Identifier: Apache-2.0
 *
 * What stone looks like that was split along its cleavage: sheets that end in steps.
 *
 * A crack that runs along the cleavage leaves it for the next sheet wherever that is weaker, so
 * that the face is level terraces with steps as high as the sheets are thick. Each family of sheets
 * is a field in space, and each of its sheets ends where the field passes a number of its own: ends
 * of one family run side by side, as those of sheets that broke together, and cross those of
 * another.
 *
 * A face across the cleavage, which is bed space's x and z, shows the sheets' own edges: ledges
 * that run along it, as they broke off.
 */
#ifndef SOZAI_STONE_CLEFT_H
#define SOZAI_STONE_CLEFT_H

#include "stone.h"
#include "value.h"

/* The field: gradient noise whose finer octaves fray the ends. */
#define CLEFT_OCTAVES 4
static const float cleft_finer[CLEFT_OCTAVES] = {1.0f, 4.3f, 15.0f, 47.0f},
                   cleft_high[CLEFT_OCTAVES] = {1.0f, 0.2f, 0.065f, 0.024f};
/* finer^2 high^2 summed, of the steepness^2 that the first alone would have */
#define CLEFT_STEEPER 3.963f
#define CLEFT_ALONG 0.6f /* how often ends come along the lineation, bed space's x */
#define CLEFT_SLOPE 0.7f /* the first octave's gradient's length, rms, over its frequency */

/* Where sheets end, in the field's numbers (sd 0.2), and of what they are thick together each one's
 * part; how wide a step is. */
#define CLEFT_SHEETS 3
static const float cleft_end[CLEFT_SHEETS] = {-0.11f, 0.02f, 0.07f},
                   cleft_part[CLEFT_SHEETS] = {0.25f, 0.5f, 0.25f};
#define CLEFT_STEP 0.010f

/* One octave of the field; adds to its slope, per mm, before the family's own frequency. */
INLINE vf cleft_octave(const vf at[3], vf s, vu seed, int o, vf g[3], vf *keep) {
  const float finer = cleft_finer[o], high = cleft_high[o];
  vf one = splat(1.0f), slope[3];
  *keep = one - smooth_step(splat(0.25f), splat(1.0f), s * splat(finer));
  if (!any(gt(*keep, splat(0.0f)))) return splat(0.0f);
  vf p[3] = {at[0] * splat(finer), at[1] * splat(finer), at[2] * splat(finer)};
  vf v = value_gradient(p, seed + splatu((uint32_t)o), slope), k = *keep * splat(high);
  for (int a = 0; a < 3; a++) g[a] = g[a] + k * splat(finer) * slope[a];
  return k * v;
}

/* Height in mm of a family's sheets, mean 0 or so; adds their gradient, what a footprint averages
 * out of its variance along one axis, and the height's variance. Under a footprint a step is as
 * wide as that is: exact where a step is much narrower or much wider, and between them as a
 * smooth step's width is the root of both squares. */
STAGE vf cleft_family(const stone_constants *w, int family, const vf p[3], vf s, vf slope[3],
                      vf *lost, vf *square) {
  const stone_cleft *c = &w->cleft[family];
  const vf zero = splat(0.0f), one = splat(1.0f), f = splat(c->frequency);
  const vf along[3] = {f * splat(CLEFT_ALONG), f, f};
  vf at[3], g[3] = {zero, zero, zero}, u = zero, keep[CLEFT_OCTAVES], steep = zero;
  for (int a = 0; a < 3; a++) at[a] = p[a] * along[a];
  for (int o = 0; o < CLEFT_OCTAVES; o++) {
    u = u + cleft_octave(at, s * f, splatu(c->seed), o, g, &keep[o]);
    float part = cleft_finer[o] * cleft_high[o];
    steep = steep + splat(part * part / CLEFT_STEEPER) * keep[o] * keep[o];
  }
  vf wide = s * f * splat(CLEFT_SLOPE) * vsqrt(splat(CLEFT_STEEPER) * steep);
  vf inverse = inverse_root(splat(CLEFT_STEP * CLEFT_STEP) + wide * wide);
  vf told = keep[0] * keep[0] * steep * splat(CLEFT_STEP) * inverse;
  *lost = *lost + splat(c->slope2) * (one - told);
  *square = *square + splat(0.2f * c->height * c->height) * keep[0] * keep[0];
  vf height = zero, grows = zero, all = keep[0] * splat(c->height);
  for (int i = 0; i < CLEFT_SHEETS; i++) {
    vf t = clamp01(splat(0.5f) + (u - splat(cleft_end[i])) * inverse), part = splat(cleft_part[i]);
    height = height + part * (t * t * (splat(3.0f) - t - t) - splat(0.5f));
    grows = grows + part * (splat(6.0f) * t * (one - t));
  }
  grows = grows * inverse * all;
  for (int a = 0; a < 3; a++) slope[a] = slope[a] + grows * g[a] * along[a];
  return height * all;
}

/* Where two sheets' edges stand apart: how wide the ledge is, in the field's numbers (sd 0.2). */
#define CLEFT_LEDGE 0.17f

/* Edges of one size, as cleft_family. A field that changes across the sheets much sooner than along
 * them is 0 or 1. */
STAGE vf cleft_ledges(const stone_ledges *c, const vf p[3], vf s, vf slope[3], vf *lost,
                      vf *square) {
  const vf zero = splat(0.0f), one = splat(1.0f), f = splat(c->across), along = splat(c->along);
  vf keep = one - smooth_step(splat(0.25f), splat(1.0f), s * f), wide = s * f * splat(CLEFT_SLOPE);
  vf inverse = inverse_root(splat(CLEFT_LEDGE * CLEFT_LEDGE) + wide * wide);
  *lost = *lost + splat(c->slope2) * (one - keep * keep * splat(CLEFT_LEDGE) * inverse);
  if (!any(gt(keep, zero))) return zero;
  *square = *square + splat(0.2f * c->height * c->height) * keep * keep;
  vf at[3] = {p[0] * along, p[1] * f, p[2] * along}, g[3];
  vf u = value_gradient(at, splatu(c->seed), g);
  vf t = clamp01(splat(0.5f) + u * inverse), high = keep * splat(c->height);
  vf grows = splat(6.0f) * t * (one - t) * inverse * high;
  slope[0] = slope[0] + grows * g[0] * along;
  slope[1] = slope[1] + grows * g[1] * f;
  slope[2] = slope[2] + grows * g[2] * along;
  return high * (t * t * (splat(3.0f) - t - t) - splat(0.5f));
}

/* A sum of what one face shows, as far as it does. */
typedef struct {
  vf height, slope[3], lost, square;
} cleft_face;

INLINE void cleft_add(const cleft_face *c, vf part, vf *height, vf slope[3], vf *lost, vf *square) {
  *height = *height + part * c->height;
  for (int a = 0; a < 3; a++) slope[a] = slope[a] + part * c->slope[a];
  *lost = *lost + part * part * c->lost;
  *square = *square + part * part * c->square;
}

/* along: of the face, how far it lies along the cleavage, 0..1. *steep: the variance of all slopes
 * along one axis, of which the sheets' is there yet as it is along the cleavage. */
STAGE vf cleft_at(const stone_constants *w, const vf p[3], vf along, vf s, vf slope[3], vf *lost,
                  vf *square, vf *steep) {
  vf zero = splat(0.0f), across = splat(1.0f) - along, height = zero;
  cleft_face c = {zero, {zero, zero, zero}, zero, zero}, e = c;
  for (int i = 0; i < CLEFT_FAMILIES; i++) {
    if (any(gt(along, zero)))
      c.height = c.height + cleft_family(w, i, p, s, c.slope, &c.lost, &c.square);
    if (any(gt(across, zero)))
      e.height = e.height + cleft_ledges(&w->ledges[i], p, s, e.slope, &e.lost, &e.square);
    *steep = *steep + splat(w->ledges[i].slope2) * across * across -
             splat(w->cleft[i].slope2) * (splat(1.0f) - along * along);
  }
  cleft_add(&c, along, &height, slope, lost, square);
  cleft_add(&e, across, &height, slope, lost, square);
  return height;
}

#endif
