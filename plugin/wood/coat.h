/* SPDX-License-Identifier: Apache-2.0
 *
 * The coat's own highlight: GGX with Smith's shadowing (Walter, Marschner, Li and Torrance,
 * "Microfacet models for refraction through rough surfaces", 2007), times pi cos. Over a relief
 * its facets are those of the slopes that the footprint averages, too, wider one way than the
 * other.
 */
#ifndef SOZAI_WOOD_COAT_H
#define SOZAI_WOOD_COAT_H

#include "cone.h"
#include "surface/slopes.h"

/* Half way between light and view: its cosines to the normal and to the view. */
typedef struct {
  vf d[3], nh, vh;
} coat_half;

INLINE coat_half coat_half_of(const vf l[3], const vf v[3], const vf n[3]) {
  coat_half h;
  vf square = splat(0.0f);
  h.nh = h.vh = square;
  for (int c = 0; c < 3; c++) {
    h.d[c] = l[c] + v[c];
    square = square + h.d[c] * h.d[c];
  }
  vf k = inverse_root(vmax(square, splat(1e-12f)));
  for (int c = 0; c < 3; c++) {
    h.d[c] = h.d[c] * k;
    h.nh = h.nh + h.d[c] * n[c];
    h.vh = h.vh + h.d[c] * v[c];
  }
  return h;
}

/* Fresnel's, of the facets that reflect. */
INLINE vf coat_fresnel(const wood_constants *w, const coat_half *h) {
  vf one = splat(1.0f), inverse = splat(w->inverse_ior), c = clamp(h->vh, splat(0.0f), one);
  vf ct = vsqrt(vmax(one - (one - c * c) * inverse * inverse, splat(0.0f)));
  return splat(w->coat) * fresnel(splat(w->ior), vmax(c, splat(1e-4f)), ct);
}

/* Facets and shadow alone, a2: alpha, squared. ci, cr: cosines of light and view. */
INLINE vf coat_facets(const coat_half *h, vf ci, vf cr, vf a2) {
  vf one = splat(1.0f), tiny = splat(1e-4f), d = h->nh * h->nh * (a2 - one) + one;
  vf ca = vmax(ci, tiny), cb = vmax(cr, tiny);
  vf smith = ca * vsqrt(cb * cb * (one - a2) + a2) + cb * vsqrt(ca * ca * (one - a2) + a2);
  /* pi cos times a2 / (pi d^2) / (2 smith) */
  return a2 * ca / (splat(2.0f) * d * d * smith);
}

/* A direction's parts along two of the face's. */
typedef struct {
  vf u, v;
} coat_parts;

INLINE vf coat_square(const slope_matrix *m, const coat_parts *p) {
  return m->uu * p->u * p->u + splat(2.0f) * m->uv * p->u * p->v + m->vv * p->v * p->v;
}

/* The same of facets whose alpha, squared, is a2 and twice the slopes' variance: Heitz,
 * "Understanding the masking-shadowing function" (2014), section 5.3. */
INLINE vf coat_facets_over(const slope_matrix *slopes, const coat_half *h, const coat_parts p[3],
                           vf ci, vf cr, vf a2) {
  vf one = splat(1.0f), two = splat(2.0f), tiny = splat(1e-4f);
  slope_matrix m;
  m.uu = vmin(a2 + two * slopes->uu, one);
  m.vv = vmin(a2 + two * slopes->vv, one);
  vf most = splat(0.98f) * vsqrt(m.uu * m.vv);
  m.uv = clamp(two * slopes->uv, splat(0.0f) - most, most);
  const slope_matrix inverted = {m.vv, splat(0.0f) - m.uv, m.uu};
  vf det = m.uu * m.vv - m.uv * m.uv;
  /* of a whole direction it is half at least; light from behind what is seen leaves none */
  vf d = vmax(coat_square(&inverted, &p[0]) / det + h->nh * h->nh, splat(0.5f));
  vf ca = vmax(ci, tiny), cb = vmax(cr, tiny);
  vf smith =
      ca * vsqrt(cb * cb + coat_square(&m, &p[2])) + cb * vsqrt(ca * ca + coat_square(&m, &p[1]));
  return ca / (two * vsqrt(det) * d * d * smith);
}

/* The parts of half, light and view along the face's directions, as the normal has turned them. */
INLINE void coat_parts_of(const lost_slopes *lost, const coat_half *h, const vf l[3], const vf v[3],
                          const vf n[3], coat_parts p[3]) {
  vf u[3], across[3];
  slopes_frame(lost->u, n, u, across);
  const vf *d[3] = {h->d, l, v};
  for (int i = 0; i < 3; i++) p[i] = (coat_parts){dot3(d[i], u), dot3(d[i], across)};
}

/* Towards v under l. lost: of the relief, or NULL where there is none. */
INLINE vf coat_highlight(const wood_constants *w, const vf l[3], const vf v[3], const vf n[3],
                         const lost_slopes *lost) {
  vf zero = splat(0.0f), a2 = splat(w->coat_alpha * w->coat_alpha);
  coat_half h = coat_half_of(l, v, n);
  vf ci = clamp01(dot3(l, n)), cr = clamp01(dot3(v, n));
  vf facets;
  if (lost) {
    coat_parts p[3];
    coat_parts_of(lost, &h, l, v, n, p);
    facets = coat_facets_over(&lost->gentle, &h, p, ci, cr, a2);
    if (any(gt(lost->share, zero))) {
      vf steep = vmin(a2 + slopes_within(lost), splat(1.0f));
      facets = mix(facets, coat_facets(&h, ci, cr, steep), lost->share);
    }
  } else {
    facets = coat_facets(&h, ci, cr, a2);
  }
  vm seen = and_(gt(ci, zero), gt(cr, zero));
  return sel(seen, coat_fresnel(w, &h) * facets, zero);
}

#endif
