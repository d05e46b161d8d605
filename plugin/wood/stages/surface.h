/* SPDX-License-Identifier: Apache-2.0
 *
 * What tools, wear and finish leave: what the surface is at a block's points, and the normal that
 * it bends.
 */
#ifndef SOZAI_WOOD_STAGES_SURFACE_H
#define SOZAI_WOOD_STAGES_SURFACE_H

#include "../ends.h"
#include "../surface/relief.h"
#include "axes.h"
#include "footprint.h"
#include "vessels.h"

/* Which way tools have gone over the face, object space: along the board, or
 * along y of a piece; over the ends of one, along x. The face is the one that
 * the normal is nearest to, +z where there is none. */
INLINE void surface_feed(const wood_constants *w, int boards, const wood_io *io, const block *k,
                         vf along[3], vf across[3]) {
  vf one = splat(1.0f), zero = splat(0.0f);
  along[2] = across[2] = zero;
  if (boards && w->boards.layout.kind != LAYOUT_NONE) {
    const layout_unit *unit = &k->board.unit;
    along[0] = across[1] = unit->c;
    along[1] = unit->s;
    across[0] = zero - unit->s;
    return;
  }
  along[0] = across[1] = zero;
  along[1] = across[0] = one;
  if (!io->in->normal[0]) return;
  vf n[3];
  from_log(w, boards, k, k->nrm, n);
  for (int c = 0; c < 3; c++) n[c] = vabs(n[c]);
  vm x = and_(lt(n[2], n[0]), lt(n[1], n[0])), y = and_(lt(n[2], n[1]), le(n[0], n[1]));
  along[0] = sel(y, one, zero);
  along[1] = sel(y, zero, one);
  across[0] = sel(or_(x, y), zero, one);
  across[2] = sel(or_(x, y), one, zero);
}

INLINE void surface_marks(const wood_constants *w, int boards, const wood_io *io, const block *k,
                          surface_relief *r, surface_shade *s) {
  vf along[3], across[3], a = splat(0.0f), b = a, g[3], up[3], beside[3];
  surface_feed(w, boards, io, k, along, across);
  /* tools go over plies and veneers as over one piece */
  int laid = boards && w->boards.layout.kind != LAYOUT_NONE;
  if (laid) {
    a = k->board.unit.u;
    b = k->board.unit.v;
  } else {
    for (int c = 0; c < 3; c++) {
      vf p = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n));
      a = a + along[c] * p;
      b = b + across[c] * p;
    }
  }
  to_log(w, boards, k, along, up);
  to_log(w, boards, k, across, beside);
  vf to[2] = {splat(0.0f), splat(0.0f)}, turned[3];
  if (s) {
    to[0] = dot3(up, s->to);
    to[1] = dot3(beside, s->to);
  }
  vu seed = wood_seed(w, own_of(laid, k), SEED_MARKS);
  marks_relief m = marks_at(&w->surface, seed, a, b, k->s, to, s);
  for (int c = 0; c < 3; c++) g[c] = along[c] * m.a + across[c] * m.b;
  to_log(w, boards, k, g, turned);
  r->height = r->height + m.height;
  relief_add(r, splat(1.0f), turned);
  slopes_along(&r->lost, &r->lost.gentle, up, m.lost_aa);
  slopes_along(&r->lost, &r->lost.gentle, beside, m.lost_bb);
  slopes_between(&r->lost, &r->lost.gentle, up, beside, m.lost_ab);
}

/* The way back to log space from a place in a section, whose arc has the row a: of x and z, which
 * are the radius, `widen` of rho and growing by `slope` along the arc of the reference section,
 * times the direction. */
INLINE void surface_section_of(int boards, const block *k, const section_place *q, vf widen,
                               vf slope, const vf reference[3], const vf a[3], const vf b[3],
                               surface_section *p) {
  vf xr = widen * q->c, zr = widen * q->s, xs = slope * q->c, zs = slope * q->s;
  for (int c = 0; c < 3; c++) {
    p->arc[c] = a[c];
    p->along_x[c] = b[c] * xr + (reference[c] * xs - a[c] * zr);
    p->along_z[c] = b[c] * zr + (reference[c] * zs + a[c] * xr);
  }
  p->place = place_in(boards, q, k);
}

/* Both sections. */
INLINE void surface_sections(const wood_constants *w, int boards, const wood_io *io, block *k,
                             surface_place *p) {
  vf slope, one = splat(1.0f), widen = one + outline_at(w, k->section.c, k->section.s, &slope);
  vf a[3], b[3], turned[3];
  section_rows(k, a, b);
  k->section.f = footprint_in_section(w, boards, io, k);
  if (k->knot) {
    /* a branch's section is round */
    vm in = gt(k->knot->inside, splat(0.0f));
    widen = sel(in, one, widen);
    slope = sel(in, splat(0.0f), slope);
  }
  surface_section_of(boards, k, &k->section, widen, slope, a, a, b, &p->stem);
  p->grown = &p->stem;
  if (!k->in.moved) return;
  vf shear = bolt_shear(k);
  for (int c = 0; c < 3; c++) turned[c] = a[c] + shear * b[c];
  k->bolt.f = footprint_in_bolt(&k->section.f, shear);
  surface_section_of(boards, k, &k->bolt, widen, slope, a, turned, b, &p->bolt);
  p->grown = &p->bolt;
}

/* Where the point is for wear and grooves. */
INLINE void surface_place_of(const wood_constants *w, int boards, const wood_io *io, block *k,
                             surface_place *p) {
  stem_row(k);
  vf one = splat(1.0f), rho2 = splat(0.0f), along_normal = rho2;
  surface_sections(w, boards, io, k, p);
  for (int c = 0; c < 3; c++) {
    p->rho[c] = k->b[c];
    rho2 = rho2 + k->b[c] * k->b[c];
    along_normal = along_normal + k->b[c] * k->nrm[c];
  }
  p->y = k->p[1];
  p->s = k->s;
  p->up2 = k->up2;
  stage_reach(w, boards, io, k);
  if (k->in.moved) k->bolt.f.bb = k->section.f.bb;
  p->reach = k->reach;
  if (io->in->normal[0]) rho2 = vmax(rho2 - along_normal * along_normal, splat(0.0f));
  p->across_rho2 = rho2;
  p->end = io->in->normal[0] ? ends_seen(one - k->up2) : splat(0.0f);
  if (k->knot) p->end = p->end * (one - clamp01(k->knot->inside));
}

/* The surface at the block's points; the share of light that its checks and
 * cracks swallow goes to the fibres' shift. */
static __attribute__((noinline)) void stage_relief(const wood_constants *w, int boards,
                                                   const wood_io *io, const wood_wants *want,
                                                   block *k, surface_relief *r) {
  vf one = splat(1.0f);
  surface_place p;
  surface_shade shade, *s = NULL;
  if (want->radiance && io->in->normal[0]) {
    shade = shade_under(k->light, k->nrm);
    s = &shade;
  }
  surface_place_of(w, boards, io, k, &p);
  *r = relief_grown(w, &p, k->nrm, s);
  surface_marks(w, boards, io, k, r, s);
  k->past = s ? shade_lit(s, r->slope) : one;
  if (boards) {
    vf face = one - k->board.unit.joint;
    r->height = r->height * face;
    for (int c = 0; c < 3; c++) r->slope[c] = r->slope[c] * face;
    k->past = mix(one, k->past, face);
  }
  k->lost = &r->lost;
  if (w->surface.stains) k->shift = k->shift * (one - r->dark);
}

/* The normal from here on is the surface's own. */
static __attribute__((noinline)) void stage_bump(const wood_constants *w, int boards,
                                                 const wood_io *io, block *k,
                                                 const surface_relief *r) {
  vf zero = splat(0.0f), one = splat(1.0f), out[3], along = zero;
  if (io->in->normal[0]) {
    for (int c = 0; c < 3; c++) along = along + r->slope[c] * k->nrm[c];
    for (int c = 0; c < 3; c++) k->nrm[c] = k->nrm[c] - (r->slope[c] - along * k->nrm[c]);
    unit_direction(k->nrm);
    k->up2 = vmax(one - k->nrm[1] * k->nrm[1], zero);
    k->inverse_up = inverse_root(vmax(k->up2, splat(1e-12f)));
    vf dive = k->fibre[0] * k->nrm[0] + k->fibre[1] * k->nrm[1] + k->fibre[2] * k->nrm[2];
    k->sine = zero - dive;
    from_log(w, boards, k, k->nrm, out);
    for (int c = 0; c < 3; c++) store_lanes(io, WOOD_NORMAL + c, k, out[c]);
  }
  vf height = r->height;
  if (boards && w->plies.count) height = height + k->board.step;
  if (boards && w->boards.layout.kind != LAYOUT_NONE) {
    height =
        height + layout_relief(&w->boards.layout, &w->boards.profile, &k->board.unit, k->s).height;
  }
  store_lanes(io, WOOD_HEIGHT, k, height);
}

#endif
