/* SPDX-License-Identifier: Apache-2.0
 *
 * A section from a picture of the end grain, in place of the grown one: what a
 * point's fibre showed when the reference section was photographed. The grain
 * carries it along the stem as it carries rings and vessels.
 *
 * Beyond the rim the picture is folded back at it: rho runs out to the rim, in
 * again to the pith and so on, so that a log of any size has no hole and no
 * seam. The rim is a table over theta', in units of rho.
 */
#ifndef SOZAI_WOOD_PICTURE_H
#define SOZAI_WOOD_PICTURE_H

#include "../core/images.h"
#include "rings.h"
#include "stem.h"

typedef struct {
  vf x, z;   /* mm, within the rim */
  vf around; /* how much an arc has shrunk in the fold */
  vf inward; /* -1 where the fold has turned the radius round, else 1 */
} picture_place;

INLINE picture_place picture_fold(const wood_constants *w, vf x, vf z, vf c, vf s, vf rho) {
  vf one = splat(1.0f);
  picture_place p = {x, z, one, one};
  if (!w->folded) return p;
  vi i;
  vf turn = arctan2(s, c) * splat(0.15915494f);
  turn = (turn - vfloor(turn, &i)) * splat((float)WOOD_RIM);
  vf whole = vfloor(vmin(turn, splat((float)WOOD_RIM - 0.001f)), &i), part = turn - whole;
  vf low = gather(w->rim, i), rim = low + (gather(w->rim + 1, i) - low) * part;
  vi n;
  vf twice = rim + rim, turns = vfloor(rho / twice, &n);
  vf m = clamp(rho - turns * twice, splat(0.0f), twice);
  vm back = gt(m, rim);
  vf k = sel(back, twice - m, m) / vmax(rho, splat(1e-6f));
  vm beyond = gt(rho, rim);
  p.around = sel(beyond, k, one);
  p.inward = sel(and_(beyond, back), splat(-1.0f), one);
  p.x = x * p.around;
  p.z = z * p.around;
  return p;
}

/* Sides of a parallelogram over (arc, rho) whose products are f's: the
 * Cholesky factor. */
typedef struct {
  vf arc, shear, radial;
} picture_sides;

INLINE picture_sides picture_split(vf aa, vf ab, vf bb) {
  picture_sides q;
  vf inverse = inverse_root(vmax(aa, splat(1e-16f)));
  q.arc = aa * inverse;
  q.shear = ab * inverse;
  q.radial = vsqrt(vmax(bb - q.shear * q.shear, splat(0.0f)));
  return q;
}

/* Look the picture up over a footprint of products aa, ab, bb. n: lanes that
 * are points. Lanes past them are zero. */
INLINE void picture_sample(const wood_constants *w, const picture_place *p, vf c, vf s, vf widen,
                           vf aa, vf ab, vf bb, uint32_t n, vf out[3]) {
  /* a texture's look-up blurs by a level's texels and by its own interpolation:
   * three times the variance of a box of the sides it is given */
  vf k = splat(1.0f / 3.0f);
  picture_sides q = picture_split(aa * k, ab * k, bb * k);
  /* (arc, rho) -> (x, z): along the arc and along the radius */
  vf a = q.arc * p->around * widen, h = q.shear * p->inward * widen, r = q.radial * widen;
  vf ks = splat(w->picture_per_mm[0]), kt = splat(w->picture_per_mm[1]);
  float st[6][LANES], rgb[3][LANES];
  memset(rgb, 0, sizeof rgb);
  store(st[0], splat(w->picture_pith[0]) + p->x * ks);
  store(st[1], splat(w->picture_pith[1]) + p->z * kt);
  store(st[2], (h * c - a * s) * ks);
  store(st[3], (h * s + a * c) * kt);
  store(st[4], r * c * ks);
  store(st[5], r * s * kt);
  float *const to[3] = {rgb[0], rgb[1], rgb[2]};
  /* a picture that cannot be read any more is black, and evaluate says so */
  images_answered(w->images->sample(w->images->self, w->picture, n, st[0], st[1], st[2], st[3],
                                    st[4], st[5], to));
  for (int k = 0; k < 3; k++) out[k] = load(rgb[k]);
}

/* Reflectance from the picture, its fine detail stronger or weaker as asked. */
INLINE void picture_albedo(const wood_constants *w, const picture_place *p, vf c, vf s, vf widen,
                           const footprint2 *f, uint32_t n, vf out[3]) {
  picture_sample(w, p, c, s, widen, f->aa, f->ab, f->bb, n, out);
  if (w->picture_detail != 1.0f) {
    vf more = splat(w->picture_detail_size * w->picture_detail_size), coarse[3];
    picture_sample(w, p, c, s, widen, f->aa + more, f->ab, f->bb + more, n, coarse);
    for (int k = 0; k < 3; k++) {
      out[k] = coarse[k] + (out[k] - coarse[k]) * splat(w->picture_detail);
    }
  }
  for (int k = 0; k < 3; k++) out[k] = clamp01(out[k]);
}

/* How dark the picture is there, from its brightest earlywood to its darkest
 * latewood. */
INLINE vf picture_late(const wood_constants *w, const vf rgb[3]) {
  vf grey = (rgb[0] + rgb[1] + rgb[2]) * splat(1.0f / 3.0f);
  return clamp01((splat(w->picture_bright) - grey) * splat(w->picture_inverse_contrast));
}

#endif
