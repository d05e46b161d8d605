/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre-cone reflection: Marschner, Westin, Arbree and Moon, "Measuring and
 * modeling the appearance of finished wood" (SIGGRAPH 2005), equations (1) to
 * (4). Fibres below a smooth surface reflect light on the cone about their
 * axis that contains the refracted direction of incidence:
 *
 *   f = coat + Ti Tr (diffuse + k g(beta, psi_r + psi_i) / cos^2((psi_r - psi_i) / 2))
 *
 * with psi the inclination of a refracted direction to the plane square to the
 * fibre, g a normalised Gaussian, T what the surface lets through, k the
 * fibres' colour.
 *
 * The paper adds its parts up, which may give more light than came in. Here
 * the diffuse part takes what the lobe leaves: with e(w) the lobe's reflectance
 * for light from w, it is rho (1 - k e_i) (1 - k e_r) / (1 - k e_mean),
 * which is reciprocal and sums with the lobe to no more than 1. k is its
 * brightest channel's: channel by channel it would be a product of two colours,
 * another one in each working space. e depends on psi and on the dive angle
 * alone, and is a table.
 */
#ifndef SOZAI_WOOD_CONE_H
#define SOZAI_WOOD_CONE_H

#include "../core/maths.h"
#include "wood.h"

/* A direction below the surface. */
typedef struct {
  vf cosine;    /* to the normal, above the surface */
  vf sine, psi; /* of the inclination to the fibre, below */
  vf through;   /* what the surface lets through */
  vf d[3];      /* itself */
} cone_ray;

/* Slopes of fibres that the footprint averages: their variance along the radius (c, s), and round
 * the stem. */
typedef struct {
  vf c, s, out, around;
} cone_lost;

/* Fresnel's reflectance of a dielectric, unpolarised; cosine and the refracted
 * one. */
INLINE vf fresnel(vf eta, vf ci, vf ct) {
  vf parallel = (eta * ci - ct) / (eta * ci + ct), across = (ci - eta * ct) / (ci + eta * ct);
  return splat(0.5f) * (parallel * parallel + across * across);
}

/* The cosine below the surface, of one above it. */
INLINE vf cone_refracted(const wood_constants *w, vf cosine) {
  vf one = splat(1.0f), k = splat(w->inverse_ior);
  return vsqrt(vmax(one - (one - cosine * cosine) * k * k, splat(0.0f)));
}

/* What the coat lets through. ct: the cosine below the surface. */
INLINE vf coat_through(const wood_constants *w, vf cosine, vf ct) {
  return splat(1.0f) - splat(w->coat) * fresnel(splat(w->ior), vmax(cosine, splat(1e-4f)), ct);
}

/* d, n: unit. f: unit, the fibre's axis. */
INLINE cone_ray cone_enter(const wood_constants *w, const vf d[3], const vf n[3], const vf f[3]) {
  vf one = splat(1.0f), k = splat(w->inverse_ior);
  cone_ray r;
  r.cosine = clamp01(d[0] * n[0] + d[1] * n[1] + d[2] * n[2]);
  vf ct = cone_refracted(w, r.cosine);
  vf shift = ct - r.cosine * k;
  vf s = splat(0.0f);
  for (int c = 0; c < 3; c++) {
    r.d[c] = d[c] * k + n[c] * shift;
    s = s + r.d[c] * f[c];
  }
  r.sine = clamp(s, splat(-1.0f), one);
  r.psi = arcsin(r.sine);
  r.through = coat_through(w, r.cosine, ct);
  return r;
}

/* A place in a table over the dive's sine. */
typedef struct {
  vi row;
  vf part;
} cone_dive;

INLINE cone_dive cone_dive_of(vf sine) {
  cone_dive d;
  vf x = vmin(vabs(sine) * splat((float)(WOOD_CONE_DIVE - 1)), splat(WOOD_CONE_DIVE - 1.001f));
  d.part = x - vfloor(x, &d.row);
  return d;
}

INLINE vf cone_along(const float *table, const cone_dive *d) {
  return mix(gather(table, d->row), gather(table + 1, d->row), d->part);
}

/* The lobe's reflectance for white fibres, at the sine of an inclination whose
 * sign has been turned with the dive's. */
INLINE vf cone_reflectance(const wood_constants *w, vf sine, const cone_dive *d) {
  vf p = (sine + splat(1.0f)) * splat(0.5f * (WOOD_CONE_PSI - 1));
  vi i;
  vf a = p - vfloor(vmin(p, splat(WOOD_CONE_PSI - 1.001f)), &i);
  vi at = d->row * splati(WOOD_CONE_PSI) + i;
  const float *t = w->cone_table;
  vf low = mix(gather(t, at), gather(t + 1, at), a);
  vf high = mix(gather(t + WOOD_CONE_PSI, at), gather(t + WOOD_CONE_PSI + 1, at), a);
  return mix(low, high, d->part);
}

/* The variance of psi_r + psi_i. A fibre that leans by a slope along e changes a direction's sine
 * by that times its part along e, and psi by as much over its cosine. */
INLINE vf cone_spread(const cone_ray *i, const cone_ray *r, const cone_lost *lost) {
  vf one = splat(1.0f), least = splat(0.05f), out, around;
  vf ki = inverse_root(vmax(one - i->sine * i->sine, least)),
     kr = inverse_root(vmax(one - r->sine * r->sine, least));
  vf x = i->d[0] * ki + r->d[0] * kr, z = i->d[2] * ki + r->d[2] * kr;
  out = x * lost->c + z * lost->s;
  around = z * lost->c - x * lost->s;
  return lost->out * out * out + lost->around * around * around;
}

/* What lies along an axis, and shines about it: fibres up the stem, or a ray's cells along the
 * radius. share: of the place, that they have; vessels have none. strength: a table over the dive
 * of their lobe's over the fibres', or NULL where it is 1. */
typedef struct {
  const vf *axis;
  vf sine; /* of the dive angle */
  vf share;
  const float *strength;
  const cone_lost *lost; /* slopes that the footprint averages, or NULL for none */
} cone_cells;

/* Radiance towards v under l, for light_colour 1. Without the coat's own highlight. */
INLINE void cone_radiance(const wood_constants *w, const vf l[3], const vf v[3], const vf n[3],
                          const cone_cells *q, const vf albedo[3], vf out[3]) {
  vf one = splat(1.0f), zero = splat(0.0f);
  cone_ray i = cone_enter(w, l, n, q->axis), r = cone_enter(w, v, n, q->axis);
  vf flip = sel(lt(q->sine, zero), splat(-1.0f), one);
  cone_dive dive = cone_dive_of(q->sine);
  vf ei = cone_reflectance(w, i.sine * flip, &dive), er = cone_reflectance(w, r.sine * flip, &dive);
  vf strength = q->strength ? cone_along(q->strength, &dive) : one;
  vf mean = cone_along(w->cone_mean, &dive), scale = cone_along(w->cone_scale, &dive);

  vf width2 = splat(w->cone_width * w->cone_width);
  if (q->lost) width2 = width2 + cone_spread(&i, &r, q->lost);
  vf root = inverse_root(width2), across = r.psi + i.psi;
  vf g = splat(0.39894228f) * root * exp2_(splat(-0.72134752f) * across * across * root * root);
  vf cd = vsqrt((one - i.sine * i.sine) * (one - r.sine * r.sine)) + i.sine * r.sine;
  vf half = vmax((one + cd) * splat(0.5f), splat(WOOD_CONE_LEAST));
  vf cosine = i.cosine * i.through * r.through;
  vf lobe = splat(3.14159265f) * g / half * cosine * scale * strength * q->share;
  vm seen = and_(gt(i.cosine, zero), gt(r.cosine, zero));
  vf k = splat(w->fibre_brightest) * strength;
  vf left = vmax(one - k * ei, zero) * vmax(one - k * er, zero) / (one - k * mean) * cosine;
  left = mix(cosine, left, q->share);
  for (int c = 0; c < 3; c++) {
    out[c] = sel(seen, splat(w->fibre_colour[c]) * lobe + albedo[c] * left, zero);
  }
}

#endif
