/* SPDX-License-Identifier: Apache-2.0
 *
 * The stages that looks at a layer of cells go through, several side by side: bent, found, added.
 */
#ifndef SOZAI_STONE_LOOK_STAGES_H
#define SOZAI_STONE_LOOK_STAGES_H

#include "footprint.h"
#ifdef SPREADS
#include "bodies_absent.h"
#endif

/* Whether lanes are likely near each other: neighbours are mostly about a footprint apart. */
#define CELLS_TOGETHER 0.2f
INLINE int looks_together(const cells_look *looks) {
  return any(lt(looks[0].eye->view->most, splat(CELLS_TOGETHER)));
}

/* A look's place. at: mm, bed space. */
INLINE void look_place(const stone_cells *c, const vf at[3], cells_look *o) {
  cells_turn(c, at, o->straight);
  o->bend = c->bends_shared ? o->other : o->straight;
  if (c->bends_shared) cells_turn_by(c->bend_turn, at, o->other);
}

/* kept: where a layer shares its noises with another. */
INLINE void looks_bend_as(const stone_cells *c, int kept, int together, cells_look *looks,
                          int count) {
  for (int l = 0; l < count; l++) {
    cells_look *o = &looks[l];
    cells_bends own;
    bends_none(&own);
    for (int k = 0; k < 3; k++) o->q[k] = o->straight[k];
    o->cloud =
        cells_bend(c, o->eye->view->fine, together, o->bend, o->q, kept ? o->eye->bends : &own);
  }
}

STAGE void looks_bend(const stone_cells *c, cells_look *looks, int count) {
  const int together = looks_together(looks);
  if (looks[0].eye->bends)
    looks_bend_as(c, 1, together, looks, count);
  else if (together)
    looks_bend_as(c, 0, 1, looks, count);
  else
    looks_bend_as(c, 0, 0, looks, count);
}

INLINE void looks_bend_parts_as(const stone_cells *c, int kept, cells_look *looks, int count) {
  for (int l = 0; l < count; l++) {
    cells_look *o = &looks[l];
    cells_bends own;
    bends_none(&own);
    const cells_square *part = o->part;
    vm wide = gt(o->eye->view->part_wide, splat(c->sheared));
    cells_square bent = *part;
    for (int k = 0; k < 3; k++) o->q[k] = o->straight[k];
    o->cloud = cells_bend_square(c, kept, o->eye->view->fine, o->bend, o->q, &bent,
                                 kept ? o->eye->bends : &own);
    for (int k = 0; k < 3; k++) {
      o->sheared.u[k] = sel(wide, bent.u[k], part->u[k]);
      o->sheared.v[k] = sel(wide, bent.v[k], part->v[k]);
    }
    o->part = &o->sheared;
  }
}

/* Looks of which each asks for itself what it sees: with their parts. */
STAGE void looks_bend_parts(const stone_cells *c, cells_look *looks, int count) {
  int sheared = 0;
  for (int l = 0; l < count; l++) {
    looks[l].part = &looks[l].eye->view->part;
    sheared |= any(gt(looks[l].eye->view->part_wide, splat(c->sheared)));
  }
  if (!sheared)
    looks_bend(c, looks, count);
  else if (looks[0].eye->bends)
    looks_bend_parts_as(c, 1, looks, count);
  else
    looks_bend_parts_as(c, 0, looks, count);
}

/* Whether no lane's parts are seen in quarters, nor their third crystal. */
INLINE int eye_whole(const stone_cells *c, const cells_eye *e) {
  return !any(gt(e->view->part_wide, splat(c->whole)));
}

#ifdef SPREADS
#define FIND_LOOKS 8 /* that go through the stages of finding side by side */

/* The boxes about groups of n looks in a row. n, or 0: some group has none, or looks are left over.
 * A look by itself may have none, as `near` tells. */
INLINE int looks_spans_of(const int n, const cells_own *own, int count, cells_span *spans,
                          int *near) {
  if (count % n) return 0;
  for (int g = 0; g * n < count; g++) {
    near[g] = cells_span_make(n, own + g * n, &spans[g]);
    if (!near[g] && n > 1) return 0;
  }
  return n;
}

/* How many looks in a row lie so close together that one list of cells serves them: four, two or
 * one, and no more than `each` was for those before. */
INLINE int looks_spans(int each, const cells_own *own, int count, cells_span *spans, int *near) {
  if (each >= 4 && looks_spans_of(4, own, count, spans, near)) return 4;
  if (each >= 2 && looks_spans_of(2, own, count, spans, near)) return 2;
  return looks_spans_of(1, own, count, spans, near);
}

/* cells_find of lanes that lie close together, in stages: how many cells are tried is guessed wrong
 * once a group of looks, and then nothing is lost but that. each: see looks_spans, and returned. */
INLINE int looks_find_shared(const stone_cells *c, int graded, int most, int each,
                             cells_look *looks, int count) {
  cells_own own[FIND_LOOKS];
  cells_span spans[FIND_LOOKS];
  cells_reached reached[FIND_LOOKS];
  cells_list list[FIND_LOOKS];
  vf key[FIND_LOOKS][3];
  uint64_t left[FIND_LOOKS];
  int near[FIND_LOOKS];
  for (int l = 0; l < count; l++) {
    cells_look_own(c, looks[l].q, &own[l]);
    for (int k = 0; k < 3; k++) key[l][k] = splat(1e30f);
  }
  each = looks_spans(each, own, count, spans, near);
  const int groups = count / each;
  for (int g = 0; g < groups; g++) {
    if (near[g]) cells_list_make(c, graded, most, &spans[g], &list[g]);
    for (int l = g * each; l < (g + 1) * each && near[g]; l++)
      cells_reach_about(&spans[g], &own[l], &reached[l]);
  }
  for (int g = 0; g < groups; g++) left[g] = near[g] ? cells_list_left(&list[g], most) : 0;
  for (int g = 0, l = 0; g < groups; g++, l += each) {
    if (left[g] && each == 4)
      cells_list_try(&list[g], left[g], most, 4, reached + l, key + l);
    else if (left[g] && each == 2)
      cells_list_try(&list[g], left[g], most, 2, reached + l, key + l);
    else if (left[g])
      cells_list_try(&list[g], left[g], most, 1, reached + l, key + l);
    else
      for (int i = l; i < l + each; i++) cells_nearest(c, graded, most, &own[i], key[i]);
  }
  for (int l = 0; l < count; l++) {
    for (int k = 0; k < most; k++) looks[l].near[k] = cells_of_key(c, graded, &own[l], key[l][k]);
  }
  return each;
}

STAGE void looks_find_together(const stone_cells *c, int three, cells_look *looks, int count) {
  for (int l = 0, each = CELLS_GROUP; l < count; l += FIND_LOOKS) {
    int n = count - l < FIND_LOOKS ? count - l : FIND_LOOKS;
    if (c->sorted) {
      each = looks_find_shared(c, CELLS_SORTED, 3, each, looks + l, n);
    } else if (c->grading > 0.0f) {
      if (three)
        each = looks_find_shared(c, 1, 3, each, looks + l, n);
      else
        each = looks_find_shared(c, 1, 2, each, looks + l, n);
    } else if (three) {
      each = looks_find_shared(c, 0, 3, each, looks + l, n);
    } else {
      each = looks_find_shared(c, 0, 2, each, looks + l, n);
    }
  }
}
#endif

STAGE void looks_find(const stone_cells *c, cells_look *looks, int count) {
  int together = looks_together(looks), three[CELLS_EYES];
  for (int l = 0; l < count; l++) three[l] = cells_asked(c) < 3 && !eye_whole(c, looks[l].eye);
#ifdef SPREADS
  int threes = 0, empty = 0;
  for (int l = 0; l < count; l++) {
    threes += three[l];
    empty |= looks[l].empty;
  }
  if (together && !empty && (threes == 0 || threes == count)) {
    looks_find_together(c, threes || cells_asked(c) > 2, looks, count);
    return;
  }
#endif
  for (int l = 0; l < count; l++) {
    if (!looks[l].empty) cells_find(c, together, three[l], looks[l].q, looks[l].near);
  }
}

#define ZONED 5.0f /* what zones differ by, of what lamellae do */

/* That go through the stages of adding side by side: each is one long wait. Of points alone there
 * is mostly one. */
#define ADD_LOOKS (LANES == 1 ? 1 : 8)

/* What a look adds, on its way: of the nearest two cells, of crystals three, and of kinds 0 and 2
 * and of kind 1 the brightness. */
typedef struct {
  const cells_look *look;
  cells_kind kind[3];
  int second; /* the second nearest is seen in some lane */
  vf share[3], core[3], tone[2], lamellae[2];
  crystal_line line[2];
  crystal_seen seen;
} cells_adding;

/* Whether cell n is seen in some lane. */
INLINE int add_sees(const cells_adding *a, int n) {
  return n == 1 ? a->second : any(gt(a->share[n], splat(0.0f)));
}

/* Whether there is anything to add: of bodies, those of kind 0 are not there. */
INLINE int add_begin(const stone_cells *c, const cells_look *o, cells_adding *a) {
  vf zero = splat(0.0f);
  cells_eye *eye = o->eye;
  vm body[2];
  a->look = o;
  if (!c->shaped) {
    eye->nearest = o->near[0].h;
    return 1;
  }
  body[0] = body[1] = lt(zero, zero);
  for (int n = 0; n < 2 && !o->empty; n++) {
    a->kind[n] = cells_kind_of(c, o->near[n].at);
    body[n] = or_(a->kind[n].first, a->kind[n].second);
  }
  int some = any(or_(body[0], body[1]));
  if (eye->found) {
    if (some) memcpy(eye->found->near, o->near, sizeof o->near);
    memcpy(eye->found->body, body, sizeof body);
  }
  if (some) return 1;
  for (int k = 0; k < CELLS_PARTS && eye->looks; k++) eye->looks->of[k][o->slot] = zero;
  if (eye->thirds) eye->thirds[o->slot] = zero;
  return 0;
}

/* How the look's parts are seen. whole: none in quarters. */
INLINE cells_parts add_parts(const stone_cells *c, int whole, const cells_look *o) {
  return whole ? cells_whole() : cells_part(o->eye->view->part_wide, c->whole);
}

INLINE void add_shares(const stone_cells *c, int whole, cells_adding *a) {
  const cells_look *o = a->look;
  vf wide = o->eye->view->part_wide, third = splat(0.0f);
  cells_parts parts = add_parts(c, whole, o);
  vm body[2];
  for (int n = 0; n < 2 && c->shaped; n++) body[n] = or_(a->kind[n].first, a->kind[n].second);
  if (!whole) third = splat(1.0f) - crystal_keep(wide, c->whole, 2.0f * c->whole);
  int three = !whole && cells_asked(c) < 3;
  cells_shares(c, o->near, body, o->part, &parts, three, third, a->share, a->core);
  a->second = any(gt(a->share[1], splat(0.0f)));
}

/* What clouds and cuts within the crystals. */
INLINE void add_noise(const stone_cells *c, int whole, cells_adding *a) {
  const cells_look *o = a->look;
  const cells_view *view = o->eye->view;
  cells_parts parts = add_parts(c, whole, o);
  crystal_see(c, o->straight, &view->part, &parts, view->part_wide, &a->seen);
}

INLINE void add_tones(const stone_cells *c, cells_adding *a) {
  const cells_look *o = a->look;
  vf uneven = o->cloud * splat(1.3f * c->variation) + splat(1.0f), tone[2];
  a->tone[0] = a->tone[1] = uneven;
  if (c->turbidity <= 0.0f) return;
  crystal_tones(c, &a->seen, o->eye->view->part_wide, o->cloud, tone);
  /* inclusions of either kind are feldspar's, if they are crystals */
  for (int k = 0; k < 2; k++) a->tone[k] = uneven + tone[c->shaped ? 0 : k];
}

INLINE void adds_lamellae(const stone_cells *c, cells_adding *adding, int count) {
  const float gone = c->shaped ? LAMELLAE_BODIES : LAMELLAE_GONE;
  vf side = splat(0.0f), zero = side;
  int each[ADD_LOOKS];
  for (int l = 0; l < count; l++) {
    cells_adding *a = &adding[l];
    const cells_look *o = a->look;
    const cells_view *view = o->eye->view;
    const vf keep[2] = {crystal_keep(view->most, 0.4f * gone, gone),
                        crystal_keep(view->most, LAMELLAE_NEXT, LAMELLAE_ONE)};
    each[l] = a->second && any(gt(keep[1], zero)) ? 2 : any(gt(keep[0], zero));
    for (int n = 0; n < 2; n++) a->lamellae[n] = n < each[l] ? keep[n] : zero;
    for (int n = 0; n < each[l]; n++) {
      a->line[n] = crystal_line_of(o->near[n].h, o->straight, &view->part);
      side = vmax(side, a->line[n].side);
    }
  }
  int wide = any(gt(side, splat(1.0f)));
  for (int l = 0; l < count; l++) {
    cells_adding *a = &adding[l];
    for (int n = 0; n < each[l]; n++)
      a->lamellae[n] = splat(c->cleavage) * crystal_line_mean(&a->line[n], wide) * a->lamellae[n];
  }
}

/* Zones of growth, as lamellae: over those. */
INLINE void adds_zones(const stone_cells *c, cells_adding *adding, int count) {
  for (int l = 0; l < count; l++) {
    cells_adding *a = &adding[l];
    const cells_look *o = a->look;
    const cells_view *view = o->eye->view;
    vf keep = crystal_keep(view->most, 0.4f * ZONES_GONE, ZONES_GONE);
    for (int n = 0; n < 2; n++) {
      if (c->cleavage <= 0.0f) a->lamellae[n] = splat(0.0f);
      if (!add_sees(a, n) || !any(gt(keep, splat(0.0f)))) continue;
      vf g[3], deep = cells_depth(c, o->near, n, g);
      crystal_line zones = crystal_zones_of(o->near[n].h, deep, g, &view->part);
      vf zone = crystal_line_mean(&zones, any(gt(zones.side, splat(1.0f))));
      a->lamellae[n] = a->lamellae[n] + splat(ZONED * c->zoning) * keep * zone;
    }
  }
}

INLINE void add_sum(const stone_cells *c, int whole, const cells_adding *a) {
  const cells_look *o = a->look;
  cells_eye *eye = o->eye;
  cells_cover look = cells_none();
  vf third = splat(0.0f);
  for (int n = 0; n < (whole || c->shaped ? 2 : 3); n++) {
    if (!add_sees(a, n)) continue;
    vf tone[2] = {a->tone[0], a->tone[1]};
    if (n < 2 && (c->cleavage > 0.0f || c->zoning > 0.0f)) {
      tone[0] = tone[0] + splat(0.1f) * a->lamellae[n];
      tone[1] = tone[1] + splat(0.05f) * a->lamellae[n];
    }
    if (crystal_textured(c)) {
      for (int k = 0; k < 2; k++) tone[k] = vmax(tone[k], splat(0.0f));
    }
    cells_add(c, o->near[n].h, o->near[n].at, a->kind[n], a->share[n], a->core[n], tone, &look,
              &third);
  }
  cells_cover *sum = &eye->sum;
  for (int k = 0; k < CELLS_PARTS; k++) {
    if (eye->looks) eye->looks->of[k][o->slot] = look.of[k];
    sum->of[k] = sel(o->there, sum->of[k] + look.of[k], sum->of[k]);
  }
  if (c->third <= 0.0f) return;
  if (eye->thirds) eye->thirds[o->slot] = third;
  eye->third = sel(o->there, eye->third + third, eye->third);
}

INLINE void looks_add_as(const stone_cells *c, int whole, const cells_look *looks, int count) {
  cells_adding adding[ADD_LOOKS];
  int some = 0;
  for (int l = 0; l < count; l++) some += add_begin(c, &looks[l], &adding[some]);
  for (int l = 0; l < some; l++) add_shares(c, whole, &adding[l]);
  for (int l = 0; l < some && c->turbidity > 0.0f; l++) add_noise(c, whole, &adding[l]);
  for (int l = 0; l < some; l++) add_tones(c, &adding[l]);
  if (c->cleavage > 0.0f) adds_lamellae(c, adding, some);
  if (c->zoning > 0.0f) adds_zones(c, adding, some);
  for (int l = 0; l < some && !c->shaped; l++) {
    cells_adding *a = &adding[l];
    for (int n = 0; n < (whole ? 2 : 3); n++) {
      if (add_sees(a, n)) a->kind[n] = cells_kind_of(c, a->look->near[n].at);
    }
  }
  for (int l = 0; l < some; l++) add_sum(c, whole, &adding[l]);
}

STAGE void looks_add(const stone_cells *c, const cells_look *looks, int count) {
  int whole = 1;
  for (int l = 0; l < count; l++) whole &= eye_whole(c, looks[l].eye);
  for (int l = 0; l < count; l += ADD_LOOKS) {
    int n = count - l < ADD_LOOKS ? count - l : ADD_LOOKS;
    if (whole)
      looks_add_as(c, 1, looks + l, n);
    else
      looks_add_as(c, 0, looks + l, n);
  }
}

#define CELLS_SPARSE 0.25f /* cells: of wider footprints too many lie about all lanes */

/* Which looks have no body near, of one eye all together. */
STAGE void looks_empty(const stone_cells *c, cells_look *looks, int count) {
  for (int l = 0; l < count; l++) looks[l].empty = 0;
#ifndef SPREADS
  (void)c;
#else
  if (!c->sparse || any(gt(looks[0].eye->view->most, splat(CELLS_SPARSE)))) return;
  int each = count > 1 && looks[0].eye == looks[1].eye ? count : 1;
  for (int l = 0; l < count; l += each) {
    vf low[3], high[3], wide, unused;
    for (int k = 0; k < 3; k++) {
      low[k] = high[k] = looks[l].q[k];
      for (int i = 1; i < each; i++) {
        low[k] = vmin(low[k], looks[l + i].q[k]);
        high[k] = vmax(high[k], looks[l + i].q[k]);
      }
      if (each == 1) {
        range_of(low[k], &low[k], &high[k]);
      } else {
        range_of(low[k], &low[k], &unused);
        range_of(high[k], &unused, &high[k]);
      }
    }
    range_of(looks[l].eye->view->part_wide, &unused, &wide);
    int empty = bodies_absent(c, low, high, lane(wide, 0));
    for (int i = 0; i < each; i++) looks[l + i].empty = empty;
  }
#endif
}

INLINE void looks_run(const stone_cells *c, cells_look *looks, int count) {
  looks_bend_parts(c, looks, count);
  looks_empty(c, looks, count);
  looks_find(c, looks, count);
  looks_add(c, looks, count);
}

#endif
