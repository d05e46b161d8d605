/* SPDX-License-Identifier: Apache-2.0
 *
 * The looks at a footprint, one after the other or in fours.
 */
#ifndef SOZAI_STONE_LOOKS_H
#define SOZAI_STONE_LOOKS_H

#include "look_stages.h"
#include "sites.h"

/* Look i, j of a footprint's. */
INLINE void look_at(const stone_cells *c, cells_eye *e, int i, int j, vm there, cells_look *o) {
  vf half = splat(0.5f), at[3];
  vf u = (splat((float)i + 0.5f) * e->view->inverse[0] - half) * e->s;
  vf v = (splat((float)j + 0.5f) * e->view->inverse[1] - half) * e->s;
  for (int k = 0; k < 3; k++) at[k] = e->p[k] + e->t1[k] * u + e->t2[k] * v;
  look_place(c, at, o);
  o->there = there;
  o->slot = j * CELLS_STEPS + i;
  o->eye = e;
}

/* What four looks have found. tone: of what differs from place to place, of kinds 0 and 2 and of
 * kind 1. */
INLINE void sites_add(const stone_cells *c, const cells_look looks[SITES_LOOKS], int shaped,
                      const cells_sites *s, const vf straight[3], vf share[SITES_LOOKS][SITES],
                      const vf tone[SITES_LOOKS][2]) {
  vf zero = splat(0.0f), one = splat(1.0f), a[SITES_LOOKS], b[SITES_LOOKS], own[SITES_LOOKS][3];
  cells_eye *eye = looks[0].eye;
  const cells_view *view = eye->view;
  for (int l = 0; l < SITES_LOOKS; l++) a[l] = b[l] = own[l][0] = own[l][1] = own[l][2] = zero;
  vf keep = crystal_keep(view->most, 0.4f * LAMELLAE_GONE, LAMELLAE_GONE) * splat(c->cleavage);
  int lamellae = !shaped && c->cleavage > 0.0f && any(gt(keep, zero));
  cells_square both;
  for (int k = 0; k < 3; k++) {
    both.u[k] = view->part.u[k] + view->part.u[k];
    both.v[k] = view->part.v[k] + view->part.v[k];
  }
  for (int k = 0; k < sites_count(shaped); k++) {
    vf all = share[0][k] + share[1][k] + share[2][k] + share[3][k];
    if (!any(gt(all, zero))) continue;
    cells_kind kind = shaped ? s->kind[k] : cells_kind_of(c, s->at[k]);
    vf bright = splat(c->variation / HASH_ONE) * hash_signed(s->h[k] + splatu(HASH_Y));
    if (lamellae) {
      vf l = keep * crystal_lamellae(s->h[k], straight, &both);
      bright = bright + sel(kind.first, splat(0.05f), splat(0.1f)) * l;
    }
    for (int l = 0; l < SITES_LOOKS; l++) {
      vf first = sel(kind.first, share[l][k], zero), second = sel(kind.second, share[l][k], zero);
      a[l] = a[l] + first;
      b[l] = b[l] + second;
      if (!shaped) own[l][0] = own[l][0] + (share[l][k] - first - second) * bright;
      own[l][1] = own[l][1] + first * bright;
      own[l][2] = own[l][2] + second * bright;
    }
  }
  for (int l = 0; l < SITES_LOOKS; l++) {
    vf look[CELLS_PARTS];
    if (shaped) own[l][2] = own[l][2] * splat(c->calm);
    look[0] = shaped ? a[l] + b[l] : (one - a[l] - b[l]) * tone[l][0] + own[l][0];
    look[1] = vmax(a[l] * tone[l][1] + own[l][1], zero);
    look[2] = b[l] * (shaped ? cells_calm(c, one, tone[l][0]) : tone[l][0]) + own[l][2];
    for (int k = 0; k < CELLS_PARTS; k++) {
      if (eye->looks) eye->looks->of[k][looks[l].slot] = look[k];
      eye->sum.of[k] = sel(looks[l].there, eye->sum.of[k] + look[k], eye->sum.of[k]);
    }
  }
}

/* How far from the middle of all looks a body's edge is still seen: the furthest look's middle,
 * its quarters', half an edge, and more than rounding does. */
INLINE vf sites_reach(const cells_view *e, const cells_look looks[SITES_LOOKS], const vf middle[3],
                      vf inverse) {
  vf far = splat(0.0f);
  for (int l = 0; l < SITES_LOOKS; l++) {
    vf x[3];
    for (int k = 0; k < 3; k++) x[k] = looks[l].q[k] - middle[k];
    far = vmax(far, dot3(x, x));
  }
  return vsqrt(far) + splat(0.5f) * e->part_wide + splat(0.54f) / inverse + splat(0.001f);
}

/* Four looks. */
INLINE void looks_four_as(const stone_cells *c, int shaped, cells_look looks[SITES_LOOKS]) {
  cells_sites s;
  const cells_view *e = looks[0].eye->view;
  vf one = splat(1.0f), quarter = splat(0.25f), middle[3], straight[3];
  vf share[SITES_LOOKS][SITES], tone[SITES_LOOKS][2], inverse = one, reach = one;
  looks_bend(c, looks, SITES_LOOKS);
  for (int k = 0; k < 3; k++) {
    middle[k] = quarter * ((looks[0].q[k] + looks[1].q[k]) + (looks[2].q[k] + looks[3].q[k]));
    straight[k] = quarter * ((looks[0].straight[k] + looks[1].straight[k]) +
                             (looks[2].straight[k] + looks[3].straight[k]));
  }
  if (shaped) {
    inverse = sites_inverse(splat(0.5f) * e->part_wide, c->blur);
    reach = sites_reach(e, looks, middle, inverse);
  }
  sites_find(c, shaped, middle, &e->part, reach, &s);
  int textured = !shaped && crystal_textured(c) && c->turbidity > 0.0f;
  for (int l = 0; l < SITES_LOOKS; l++) {
    const cells_look *o = &looks[l];
    vf from[3], more[2];
    for (int k = 0; k < 3; k++) from[k] = o->q[k] - middle[k];
    if (shaped)
      sites_flakes(c, &s, &e->part, from, inverse, share[l]);
    else
      sites_crystals(c, &s, &e->part, from, share[l]);
    tone[l][0] = tone[l][1] = o->cloud * splat(1.3f * c->variation) + one;
    if (!textured) continue;
    crystal_tones_sloped(c, o->straight, &e->part, e->part_wide, o->cloud, more);
    for (int k = 0; k < 2; k++) tone[l][k] = vmax(tone[l][k] + more[k], splat(0.0f));
  }
  sites_add(c, looks, shaped, &s, straight, share, (const vf(*)[2])tone);
}

STAGE void looks_four_bodies(const stone_cells *c, cells_look looks[SITES_LOOKS]) {
  looks_four_as(c, 1, looks);
}
STAGE void looks_four_crystals(const stone_cells *c, cells_look looks[SITES_LOOKS]) {
  looks_four_as(c, 0, looks);
}

/* The looks of those lanes that take several. */
STAGE void eye_look_in_fours(const stone_cells *c, cells_eye *e) {
  cells_look looks[SITES_LOOKS];
  const cells_view *view = e->view;
  vm seen = and_(view->seen, view_several(view));
  for (int j = 0; j < CELLS_STEPS; j += 2) {
    vm row = and_(seen, lt(splat((float)j), view->n[1]));
    if (!any(row)) break;
    for (int i = 0; i < CELLS_STEPS; i += 2) {
      vm there = and_(row, lt(splat((float)i), view->n[0]));
      if (!any(there)) break;
      for (int l = 0; l < SITES_LOOKS; l++)
        look_at(c, e, i + (l & 1), j + (l >> 1), there, &looks[l]);
      if (c->shaped)
        looks_four_bodies(c, looks);
      else
        looks_four_crystals(c, looks);
    }
  }
}

STAGE void eye_look_about(const stone_cells *c, cells_eye *e) {
  if (c->grouped) {
    /* lanes of one look first: what that keeps for the others is not theirs */
    cells_look look;
    vm alone = and_(e->view->seen, not_(view_several(e->view)));
    if (any(alone)) {
      look_at(c, e, 0, 0, alone, &look);
      looks_run(c, &look, 1);
    }
    eye_look_in_fours(c, e);
    return;
  }
  cells_look looks[CELLS_LOOKS];
  int count = 0;
  for (int j = 0; j < CELLS_STEPS; j++) {
    vm row = and_(e->view->seen, lt(splat((float)j), e->view->n[1]));
    if (!any(row)) break;
    for (int i = 0; i < CELLS_STEPS; i++) {
      vm there = and_(row, lt(splat((float)i), e->view->n[0]));
      if (!any(there)) break;
      look_at(c, e, i, j, there, &looks[count++]);
      if (count < CELLS_LOOKS) continue;
      looks_run(c, looks, count);
      count = 0;
    }
  }
  if (count) looks_run(c, looks, count);
}

/* A layer of cells under a few footprints of which one look at each is all. */
STAGE void eyes_look(const stone_cells *c, cells_eye *eyes, int count) {
  cells_look looks[CELLS_EYES];
  for (int e = 0; e < count; e++) {
    cells_look *o = &looks[e];
    look_place(c, eyes[e].p, o);
    o->there = eyes[e].view->seen;
    o->slot = 0;
    o->eye = &eyes[e];
  }
  looks_run(c, looks, count);
}

#endif
