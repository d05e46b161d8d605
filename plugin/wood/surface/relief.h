/* SPDX-License-Identifier: Apache-2.0
 *
 * All that a surface is made of, added up: height, exact gradient, and what of
 * the gradient's square the footprint averages out.
 */
#ifndef SOZAI_WOOD_SURFACE_RELIEF_H
#define SOZAI_WOOD_SURFACE_RELIEF_H

#include "cracks.h"
#include "grooves.h"
#include "marks.h"
#include "shade.h"
#include "slopes.h"
#include "splits.h"
#include "wear.h"

/* A place in a section, with its footprint. */
typedef struct {
  vessel_place place;
  vf along_x[3], along_z[3]; /* gradients of the section's x and z over log space, */
  vf arc[3];                 /* and of its arc */
} surface_section;

/* The point, as the other stages have found it. */
typedef struct {
  surface_section stem;         /* in the reference section; */
  surface_section bolt;         /* in the point's bolt, where that is elsewhere: bolt.h */
  const surface_section *grown; /* and of the two where vessels are */
  vf y;                         /* log space */
  vf rho[3];                    /* gradient of rho */
  vf reach;                     /* mm: what the footprint spans along rho */
  vf across_rho2;               /* square of rho's gradient within the surface */
  vf s;                         /* mm: the footprint */
  vf up2;                       /* squared length of +y within the face */
  vf end;                       /* 0..1: how far the face is end grain */
} surface_place;

typedef struct {
  vf height;        /* mm */
  vf slope[3];      /* gradient of the height, log space */
  lost_slopes lost; /* what of it the footprint has averaged out */
  vf dark;          /* share of the albedo that checks and cracks take */
} surface_relief;

INLINE void relief_add(surface_relief *r, vf k, const vf g[3]) {
  for (int c = 0; c < 3; c++) r->slope[c] = r->slope[c] + k * g[c];
}

/* Mean square slope within the surface of what has slope2 over the section:
 * half of it along each axis there. */
INLINE vf relief_within(const surface_place *p, const surface_section *q, vf slope2) {
  vf per = splat(1.0f) / vmax(p->s * p->s, splat(1e-12f));
  return splat(0.5f) * slope2 * (q->place.f.aa + q->place.f.bb) * per;
}

/* Where a groove lies: its paraboloid ends at 1.25 of the disc that its mean is of. */
#define RELIEF_GROOVED 1.25f
/* The same of checks, which taper to their ends and are of many sizes. */
#define RELIEF_CHECKED 3.1f

/* Mean square slope within the face of what has slope2 over the section, in a share of it. */
INLINE vf relief_square(const surface_place *p, const surface_section *q, float slope2,
                        float share) {
  return relief_within(p, q, splat(slope2 / (share > 1e-6f ? share : 1e-6f)));
}

INLINE void relief_lose_grooves(const surface_grooves *g, const surface_place *p,
                                const surface_section *q, vf left, surface_relief *r) {
  float share = RELIEF_GROOVED * g->mean / g->depth;
  slopes_steep(&r->lost, splat(share), splat(1.0f) - left, relief_square(p, q, g->slope2, share));
}

/* A section's x and z on the way to the light. */
INLINE void relief_way(const surface_section *q, const surface_shade *s, vf *x, vf *z) {
  *x = dot3(q->along_x, s->to);
  *z = dot3(q->along_z, s->to);
}

/* The shadow within a trough of disc d, whose x and z go that way. */
INLINE void relief_shade_trough(surface_shade *s, const surface_place *p, vf whole,
                                const trough_sum *g, const disc *d, vf x, vf z) {
  vf ahead = g->x * x + g->z * z + g->y * s->to[1];
  shade_trough(s, whole, g->depth, ahead, g->fall * disc_distance(d, x, z), p->s);
}

/* Rings rise along rho: at edges, or all over. */
INLINE void relief_lose_rings(const wood_surface *m, const surface_place *p, vf variance,
                              surface_relief *r, const surface_shade *s) {
  float all = m->erosion * m->erosion * m->wear_slope2[0], share = m->wear_share;
  if (share < 1.0f && all > 0.0f) {
    vf within = splat(all / share), taken = splat(share);
    /* edges that stand out and face the light take what would fall behind them */
    if (s) taken = taken * shade_takes(s, dot3(p->rho, s->to), within);
    slopes_steep_taking(&r->lost, splat(share), taken, variance * splat(1.0f / all),
                        within * p->across_rho2);
  } else {
    slopes_along(&r->lost, &r->lost.gentle, p->rho, variance);
  }
}

/* gone: of the mean square of the slopes, what boxes of e leave out. An edge alone would keep
 * soft / e; where that is not so the boxes have merged what it stands between. */
INLINE void relief_shade_rings(const wood_constants *w, const surface_place *p, vf late, vf e,
                               vf gone, surface_shade *s) {
  const wood_surface *m = &w->surface;
  vf ahead = dot3(p->rho, s->to), further, one = splat(1.0f);
  vf rise = wear_rise(w, &p->stem.place.ring, late, e, gt(ahead, splat(0.0f)), &further);
  vf left = (one - gone * splat(1.0f / m->wear_slope2[0])) * e * splat(1.0f / m->soft);
  rise = rise * vmin(left, one) * splat(m->erosion) * vabs(ahead);
  shade_steeper(&s->large, rise, rise * p->reach / further);
}

INLINE void relief_fibres(const wood_constants *w, const surface_place *p, vf late, vf slope,
                          surface_relief *r, surface_shade *s) {
  const wood_surface *m = &w->surface;
  vf one = splat(1.0f), extent = vsqrt(p->stem.place.f.aa + p->stem.place.f.bb);
  fibre_relief f = wear_fibres(w, p->stem.place.own, p->stem.place.x, p->stem.place.z, extent);
  /* latewood keeps its fibres */
  vf fall = splat(m->fibre_late - 1.0f), share = one + fall * late;
  r->height = r->height + share * f.height;
  r->dark = r->dark - splat(m->fibre_stain) * share * f.height;
  relief_add(r, share * f.x, p->stem.along_x);
  relief_add(r, share * f.z, p->stem.along_z);
  relief_add(r, f.height * fall * slope, p->rho);
  slopes_section(&r->lost.gentle, p->up2,
                 share * share * relief_within(p, &p->stem, f.lost + f.lost));
  if (!s) return;
  vf x, z;
  relief_way(&p->stem, s, &x, &z);
  shade_noise(s, share * share * f.left * (x * x + z * z), f.rank, share * (f.x * x + f.z * z));
}

INLINE void relief_wear(const wood_constants *w, const surface_place *p, surface_relief *r,
                        surface_shade *s) {
  const wood_surface *m = &w->surface;
  vf zero = splat(0.0f), late = zero, slope = zero;
  if (m->erosion > 0.0f) {
    vf k = splat(m->erosion), e = vsqrt(p->reach * p->reach + splat(m->soft * m->soft));
    late = wear_average(w, &p->stem.place.ring, p->stem.place.rho, e, &slope);
    r->height = r->height + k * (late - splat(1.0f));
    relief_add(r, k * slope, p->rho);
    vf gone = vmax(splat(m->wear_slope2[0]) - wear_slope2(m, e), zero);
    relief_lose_rings(m, p, k * k * gone, r, s);
    if (s) relief_shade_rings(w, p, late, e, gone, s);
  }
  if (m->fibre[0].height != 0.0f) relief_fibres(w, p, late, slope, r, s);
}

INLINE void relief_vessels(const wood_constants *w, const surface_place *p, surface_relief *r,
                           surface_shade *s) {
  const wood_surface *m = &w->surface;
  const surface_section *q = p->grown;
  const vessel_place *v = &q->place;
  vf zero = splat(0.0f), one = splat(1.0f);
  /* past what the nearest cells answer the mean takes over */
  vf e2 = v->f.aa + v->f.bb;
  if (m->pores.depth > 0.0f) {
    vf faded = fade_beyond(e2, w->pores.reach), k = splat(m->pores.depth) * (one - faded);
    vf left = zero;
    r->height = r->height - splat(m->pores.mean) * faded;
    if (any(lt(faded, one))) {
      matrix2 f = to_section(v->f.aa, v->f.ab, v->f.bb, v->c, v->s);
      disc d = pores_disc(w, v, &f);
      trough_sum g = grooves_pores(w, v->own, v->x, v->z, &d);
      r->height = r->height - k * g.depth;
      relief_add(r, zero - k * g.x, q->along_x);
      relief_add(r, zero - k * g.z, q->along_z);
      if (s) {
        vf x, z;
        relief_way(q, s, &x, &z);
        relief_shade_trough(s, p, k, &g, &d, x, z);
      }
      left = trough_left(&d) * (one - faded) * (one - faded);
    }
    relief_lose_grooves(&m->pores, p, q, left, r);
  }
  if (m->rows.depth > 0.0f) {
    row_place row = row_of(w, v);
    vf faded = fade_beyond(e2, w->row.reach), k = splat(m->rows.depth) * (one - faded);
    disc d = rows_disc(w, v->f.aa, v->f.ab, v->f.bb);
    vf left = trough_left(&d) * (one - faded) * (one - faded);
    r->height = r->height - splat(m->rows.mean) * faded;
    if (any(and_(lt(faded, one), row.near))) {
      trough_sum g = grooves_rows(w, &row, v->rho, zero, zero, &d);
      r->height = r->height - k * g.depth;
      relief_add(r, zero - k * g.x, q->arc);
      relief_add(r, zero - k * g.z, p->rho);
      if (s) relief_shade_trough(s, p, k, &g, &d, dot3(q->arc, s->to), dot3(p->rho, s->to));
    }
    relief_lose_grooves(&m->rows, p, q, left, r);
  }
}

INLINE void relief_checks(const wood_constants *w, const surface_place *p, surface_relief *r,
                          surface_shade *s) {
  const wood_surface *m = &w->surface;
  if (m->check_depth <= 0.0f) return;
  vf left, slope = splat(-m->check_depth), one = splat(1.0f);
  disc d;
  trough_sum g = tubes_over(&m->checks, wood_seed(w, p->stem.place.own, SEED_CHECKS),
                            &p->stem.place, p->y, &left, &d);
  relief_add(r, slope * g.x, p->stem.along_x);
  relief_add(r, slope * g.z, p->stem.along_z);
  r->slope[1] = r->slope[1] + slope * g.y;
  r->height = r->height + slope * g.depth;
  float share = RELIEF_CHECKED * m->checks.mean;
  slopes_steep(&r->lost, splat(share), one - left,
               slope * slope * relief_square(p, &p->stem, m->checks.slope2, share));
  r->dark = vmin(r->dark + splat(m->check_dark) * g.depth, one);
  if (!s) return;
  vf x, z;
  relief_way(&p->stem, s, &x, &z);
  relief_shade_trough(s, p, splat(m->check_depth), &g, &d, x, z);
}

#define SPLIT_DARK 0.9f /* of the light, what a gap keeps */

INLINE void relief_splits(const wood_constants *w, const surface_place *p, surface_relief *r) {
  const wood_surface *m = &w->surface;
  /* the ends of plies are too thin to split */
  if (m->split_depth <= 0.0f || w->plies.count) return;
  if (!any(gt(p->end, splat(0.0f)))) return;
  vf turn = place_turn(p->stem.place.c, p->stem.place.s),
     reach = vsqrt(p->stem.place.f.aa) * splat(0.5f);
  vi unused;
  turn = turn - vfloor(turn, &unused);
  reach = vmax(reach, splat(0.01f));
  vu seed = wood_seed(w, p->stem.place.own, SEED_SPLITS);
  for (int layer = 0; layer < SPLIT_LAYERS; layer++) {
    split_place q = split_layer(m, seed, layer, turn, p->stem.place.rho, reach);
    vf k = splat(m->split_depth) * p->end;
    relief_add(r, splat(0.0f) - k * q.arc, p->stem.arc);
    relief_add(r, splat(0.0f) - k * q.rho, p->rho);
    r->height = r->height - k * q.depth;
    slopes_steep(&r->lost, p->end * q.share, q.lost, k * k * splat(m->split_steep2));
    r->dark = vmin(r->dark + splat(SPLIT_DARK) * p->end * q.open, splat(1.0f));
  }
}

INLINE void relief_shade_cracks(const surface_place *p, const crack_view *view, vf whole, vf depth,
                                surface_shade *s) {
  vf zero = splat(0.0f), x, z;
  relief_way(&p->stem, s, &x, &z);
  for (int i = 0; i < 2; i++) {
    const crack_side *c = &view->side[i];
    vf away = c->away[0] * x + c->away[1] * s->to[1] + c->away[2] * z;
    vf rise = whole * vmax(zero - away, zero) * crack_rise(c, depth);
    shade_steeper(&s->large, rise, rise * p->s / (c->across + splat(0.1f)) * vabs(away));
  }
}

INLINE void relief_cracks(const wood_constants *w, const surface_place *p, surface_relief *r,
                          surface_shade *s) {
  const wood_surface *m = &w->surface;
  if (m->crack_depth <= 0.0f) return;
  vf one = splat(1.0f), zero = splat(0.0f), k = splat(m->crack_depth);
  float size = 1.0f / m->crack_frequency[0];
  vf keep = one - smooth_step(splat(0.3f * size), splat(1.2f * size), p->s);
  vf left = zero, depth = splat(m->crack_mean), dark = splat(m->crack_dark);
  if (any(gt(keep, zero))) {
    crack_view view;
    crack_place c = cracks_at(w, p->stem.place.own, p->stem.place.x, p->y, p->stem.place.z,
                              splat(0.5f) * p->s, s ? &view : NULL);
    depth = mix(depth, c.depth, keep);
    dark = mix(dark, c.dark, keep);
    vf slope = zero - k * keep;
    relief_add(r, slope * c.x, p->stem.along_x);
    relief_add(r, slope * c.z, p->stem.along_z);
    r->slope[1] = r->slope[1] + slope * c.y;
    left = keep * keep * crack_left(m, splat(0.5f) * p->s);
    if (s) relief_shade_cracks(p, &view, k * vsqrt(left), c.depth, s);
  }
  r->height = r->height - k * depth;
  vf gone = one - left, half = splat(0.5f * m->crack_gentle2) * gone;
  r->lost.gentle.uu = r->lost.gentle.uu + half;
  r->lost.gentle.vv = r->lost.gentle.vv + half;
  slopes_steep(&r->lost, splat(m->crack_share), gone, splat(m->crack_slope2));
  r->dark = vmin(r->dark + splat(m->crack_stain) * dark, one);
}

/* All but the tool's marks, which are not in log space. */
INLINE surface_relief relief_grown(const wood_constants *w, const surface_place *p, const vf n[3],
                                   surface_shade *s) {
  vf zero = splat(0.0f);
  surface_relief r = {zero, {zero, zero, zero}, slopes_none(n, p->up2), zero};
  relief_wear(w, p, &r, s);
  relief_vessels(w, p, &r, s);
  relief_checks(w, p, &r, s);
  relief_splits(w, p, &r);
  relief_cracks(w, p, &r, s);
  return r;
}

#endif
