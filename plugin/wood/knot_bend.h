/* SPDX-License-Identifier: Apache-2.0
 *
 * What a knot does to the growth front and to the fibres about it; the model is told in knots.h.
 */
#ifndef SOZAI_WOOD_KNOT_BEND_H
#define SOZAI_WOOD_KNOT_BEND_H

#include "knot_cover.h"

/* How far the branch had grown when the stem's front was at the point. */
typedef struct {
  vf own, own_d;         /* K(d), and its slope */
  vf e;                  /* d, of the radius that it grew to */
  vf front;              /* mm: of the stem, no later than the branch's death */
  vf radius, radius_rho; /* mm: of the branch; its slope */
  vf fade, fade_rho;     /* what is left of the collar after its death; its slope */
  vf keep;               /* and what the footprint leaves */
} knot_growth;

INLINE knot_growth knot_growth_of(const wood_knot *k, vf d, vf rho, vf s) {
  knot_growth g;
  vf zero = splat(0.0f), one = splat(1.0f), two = splat(2.0f);
  vf born = splat(k->born), dead = splat(k->death);
  vm alive = lt(rho, dead);
  vf lives = sel(alive, one, zero), q = splat(k->q), straight = splat(1.0f - k->q);
  g.front = vmin(rho, dead);
  g.e = d * splat(k->inverse_radius);
  g.own = born + splat(k->length) * g.e * (straight + q * g.e);
  g.own_d = splat(k->length * k->inverse_radius) * (straight + two * q * g.e);
  vf since = vmax(g.front - born, splat(0.05f)), tau = since * splat(k->inverse_length);
  vf now = knot_grown(k, tau);
  g.radius = splat(k->radius) * now;
  g.radius_rho = lives * splat(k->radius * k->inverse_length) / (straight + two * q * now);
  vf relax = splat(0.6f * k->inverse_radius), after = vmax(rho - dead, zero) * relax;
  g.fade = one / (one + after * after);
  g.fade_rho = zero - two * after * relax * g.fade * g.fade;
  g.keep = one - smooth_step(splat(2.0f * k->radius), splat(6.0f * k->radius), s);
  return g;
}

/* What it makes of the stem's front. */
typedef struct {
  vf rho, by_rho;     /* mm; its slopes: along the front that was, */
  vf by_d, by_g;      /* along d, and along how much of a place is above or below the axis */
  vf by_stub;         /* along where the stub ends */
  vm in, rises, scar; /* in the branch; on its collar; over what was shed */
} knot_front;

/* The collar, deeper above and below than at the sides. upright: the share of (a, h) that is h;
 * there: not yet shed. */
INLINE void knot_collar(const wood_knot *k, const knot_growth *g, vf d, vf upright, vm there, vf s,
                        vf rho, knot_front *f) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf wide = splat(KNOT_WIDE) + splat(KNOT_WIDE_RISING) * upright, inverse_wide = one / wide;
  vf high = splat(k->high) + splat(k->high_rising) * upright;
  vf x = g->front - g->own, inverse_radius = one / vmax(g->radius, splat(1e-3f));
  vm in = and_(and_(there, gt(x, zero)), lt(s, splat(2.5f) * g->radius));
  vf m = vmax(d * inverse_radius - one, zero) * inverse_wide, v = vmax(one - m, zero);
  vf v2 = v * v, v3 = v2 * v, hill = high * g->radius * v3 * g->keep;
  vf falls = splat(3.0f) * high * v2 * inverse_wide * g->keep; /* -d hill / d d */
  falls = sel(gt(m, zero), falls, zero);
  vf hill_radius = high * v3 * g->keep + falls * d * inverse_radius;
  vf hill_g =
      g->radius * (splat(k->high_rising) * v3 * g->keep + falls * splat(KNOT_WIDE_RISING) * m);
  f->rho = sel(in, g->own - high * d, rho - g->fade * hill);
  f->by_rho = sel(in, zero, one - g->fade * hill_radius * g->radius_rho - g->fade_rho * hill);
  f->by_d = sel(in, g->own_d - high, g->fade * falls);
  f->by_g = zero - sel(in, splat(k->high_rising) * d, g->fade * hill_g);
  f->in = in;
  f->rises = gt(v, zero);
}

/* Where it was shed the scar closes. gone: there. */
INLINE void knot_scar(const wood_knot *k, const knot_growth *g, const knot_stub *stub, vm gone,
                      vf rho, knot_front *f) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf fresh = clamp01(one - (rho - stub->end) * splat(0.5f * k->inverse_radius));
  vf within = vmax(one - g->e * g->e, zero), dent = splat(0.4f * k->radius) * g->keep;
  vm scar = and_(gone, gt(within, zero));
  f->scar = scar;
  f->by_stub = zero;
  if (!any(scar)) return;
  vf closing = within * within * fresh * fresh;
  f->rho = sel(scar, f->rho + dent * closing, f->rho);
  vf less = dent * within * within * fresh * splat(k->inverse_radius);
  f->by_rho = sel(scar, f->by_rho - less, f->by_rho);
  f->by_stub = sel(scar, less, zero);
  vf inward = splat(-4.0f) * dent * within * g->e * splat(k->inverse_radius) * fresh * fresh;
  f->by_d = sel(scar, f->by_d + inward, f->by_d);
}

/* The fibres part. p: as the front was before. */
INLINE void knot_stream(const wood_knots *all, const wood_knot *k, const knot_section *o,
                        const knot_growth *grown, vm near, const stem_place *p, knot_place *out) {
  vf zero = splat(0.0f), one = splat(1.0f), two = splat(2.0f), a = o->a, h = o->h;
  vf radius = grown->radius, inverse_r2 = one / vmax(radius * radius, splat(1e-4f));
  vf t = (a * a + splat(1.0f / (KNOT_STREAM * KNOT_STREAM)) * h * h) * inverse_r2;
  vf window = vmax(one - t * splat(1.0f / KNOT_WINDOW), zero);
  vm parting = and_(near, gt(window, zero));
  if (!any(parting)) return;
  vf f = inverse_root(one + t * t), whole = f * window * window;
  vf slope = zero - t * f * f * f * window * window - splat(2.0f / KNOT_WINDOW) * f * window;
  vf g = splat(all->grain) * grown->fade * grown->keep * p->inverse_r, shift = zero - g * a * whole;
  vf t_radius = zero - two * t * radius * inverse_r2;
  vf turn_a = zero - g * (whole + a * slope * two * a * inverse_r2);
  vf turn_h = zero - g * a * slope * splat(2.0f / (KNOT_STREAM * KNOT_STREAM)) * h * inverse_r2;
  vf turn_rho = zero - g * a * slope * t_radius * grown->radius_rho -
                splat(all->grain) * grown->fade_rho * grown->keep * p->inverse_r * a * whole;
  vf spread = zero - shift * p->inverse_r, kc = splat(k->c), ks = splat(k->s);
  vf tx = turn_h * o->hx - turn_a * ks + turn_rho * p->rho_x + spread * p->c;
  vf tz = turn_h * o->hz + turn_a * kc + turn_rho * p->rho_z + spread * p->s;
  vf ty = turn_h * splat(k->cosine) + turn_rho * p->rho_y;
  out->turn = out->turn + sel(parting, shift, zero);
  out->turn_x = out->turn_x + sel(parting, tx, zero);
  out->turn_y = out->turn_y + sel(parting, ty, zero);
  out->turn_z = out->turn_z + sel(parting, tz, zero);
}

/* In it, its section is the reference. */
INLINE void knot_reference(const wood_knot *k, const knot_section *o, vm in, knot_place *out) {
  vf zero = splat(0.0f), far = splat(k->apart), cosine = splat(k->cosine);
  vf kc = splat(k->c), ks = splat(k->s);
  out->inside = sel(in, splat(1.0f), out->inside);
  out->a = sel(in, o->a + far, out->a);
  out->h = sel(in, o->h - far, out->h);
  vf along[3] = {kc, splat(k->slope), ks};
  vf row_a[3] = {zero - ks, zero, kc}, row_h[3] = {o->hx, cosine, o->hz};
  for (int c = 0; c < 3; c++) {
    out->along[c] = sel(in, along[c] * cosine, out->along[c]);
    out->out[c] = sel(in, o->da * row_a[c] + o->dh * row_h[c], out->out[c]);
    out->round[c] = sel(in, o->da * row_h[c] - o->dh * row_a[c], out->round[c]);
  }
}

/* Its effect on front and fibres. */
INLINE void knot_bend(const wood_knots *all, const wood_knot *k, const knot_section *o, vm near,
                      vf s, stem_place *p, knot_place *out) {
  vf zero = splat(0.0f), one = splat(1.0f), a = o->a, h = o->h, rho = p->rho;
  out->near = sel(near, one, out->near);
  knot_growth g = knot_growth_of(k, o->d, rho, s);
  knot_stub stub = knot_stub_of(k, a, h, o->d);
  vm gone = lt(stub.end, rho);
  vf n2 = vmax(a * a + h * h, splat(1e-6f)), inverse_n2 = one / n2;
  vf upright = h * h * inverse_n2, steep = splat(2.0f) * a * h * inverse_n2 * inverse_n2;
  knot_front f;
  knot_collar(k, &g, o->d, upright, and_(near, not_(gone)), s, rho, &f);
  knot_scar(k, &g, &stub, and_(near, gone), rho, &f);

  vf by_d = f.by_d + f.by_stub * stub.by_d;
  vf by_a = by_d * o->da - f.by_g * steep * h + f.by_stub * stub.by_a;
  vf by_h = by_d * o->dh + f.by_g * steep * a + f.by_stub * stub.by_h;
  knot_stream(all, k, o, &g, near, p, out);
  if (any(f.in)) knot_reference(k, o, f.in, out);

  vm touched = and_(near, or_(or_(f.in, f.scar), f.rises));
  p->rho = sel(touched, vmax(f.rho, zero), p->rho);
  vf nx = f.by_rho * p->rho_x - by_a * splat(k->s) + by_h * o->hx;
  vf ny = f.by_rho * p->rho_y + by_h * splat(k->cosine);
  vf nz = f.by_rho * p->rho_z + by_a * splat(k->c) + by_h * o->hz;
  p->rho_x = sel(touched, nx, p->rho_x);
  p->rho_y = sel(touched, ny, p->rho_y);
  p->rho_z = sel(touched, nz, p->rho_z);
}

#endif
