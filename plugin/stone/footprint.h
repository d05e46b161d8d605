/* SPDX-License-Identifier: Apache-2.0
 *
 * A layer of cells under a footprint: a look where it is small, looks side by side
 * where it is not, a count of the cells where it is wide, and past that the mean.
 */
#ifndef SOZAI_STONE_FOOTPRINT_H
#define SOZAI_STONE_FOOTPRINT_H

#include "bodies.h"
#include "clusters.h"
#include "crystals.h"
#include "sections.h"

/* Shares of a footprint: of kinds 1 and 2 with their brightness; and first, of crystals
 * kind 0 with its own, of bodies what both of them cover. */
#define CELLS_PARTS 3
typedef struct {
  vf of[CELLS_PARTS];
} cells_cover;

INLINE cells_cover cells_none(void) {
  vf zero = splat(0.0f);
  return (cells_cover){{zero, zero, zero}};
}

#define CELLS_DARKEST 0.2f /* of its colour, a body's darkest: black mica's is near enough to 0 */

/* A cell's share goes to its mineral, and with the cell's brightness; of a body's, what is
 * not its core to kind 2. at: where the cell is; uneven: brightness within it, of kinds 0 and 2,
 * and of kind 1; third: to what there is of a third kind. */
INLINE void cells_add(const stone_cells *c, vu h, const vi at[3], cells_kind kind, vf share,
                      vf core, const vf uneven[2], cells_cover *out, vf *third) {
  vf zero = splat(0.0f), c3 = zero;
  vf own = splat(c->variation / HASH_ONE) * hash_signed(h + splatu(HASH_Y));
  vf tone = uneven[0] + own, tone1 = uneven[1] + own;
  if (c->shaped) {
    tone = vmax(cells_calm(c, splat(1.0f), tone), splat(CELLS_DARKEST));
    tone1 = vmax(tone1, splat(CELLS_DARKEST));
  }
  vf a = sel(kind.first, share, zero), b = sel(kind.second, share, zero);
  out->of[0] = out->of[0] + (c->shaped ? a + b : (share - a - b) * tone);
  if (c->third > 0.0f) {
    c3 = cells_take_third(c, at, &kind, share);
    a = a - c3;
  }
  if (c->shaped && c->rim > 0.0f) {
    vf inner = sel(kind.first, core, zero);
    b = b + (a - inner);
    a = inner;
  }
  a = a * tone1;
  b = b * tone;
  c3 = c3 * tone1;
  if (c->shaped && c->mixing > 0.0f)
    cells_mix_kinds(cells_mixed(c, h), &a, &b, c->third > 0.0f ? &c3 : NULL);
  out->of[1] = out->of[1] + a;
  out->of[2] = out->of[2] + b;
  *third = *third + c3;
}

#define CELLS_STEPS 8   /* looks along a side of the footprint, at most */
#define CELLS_ALONE 6   /* the same of looks that do not come in fours */
#define CELLS_FEW 5     /* the same of footprints that are not wider than */
#define CELLS_MANY 4.0f /* cells, or in fours of looks */
#define CELLS_IN_FOURS 4.5f
#define CELLS_ONE_FOUR 0.31f  /* cells of full contrast: what one four can tell, of crystals */
#define FLAKES_ONE_FOUR 0.36f /* and of flakes */
#define CELLS_FINE 1.0f      /* cells: wider footprints do not tell the finer of the faces' bends */
#define CELLS_SMALL 0.04f    /* cells: smaller looks are as good as points */
#define CELLS_LOOK_MOST 0.5f /* cells: a look at bodies sees past all of their faces but one */

/* What looks have seen of a layer, each by itself: the shares of which a body's first is what it
 * covers. */
typedef struct {
  vf n[2];   /* looks along each side */
  vf weight; /* what the footprint's shares have of theirs; 0 where there is one look, or none */
} cells_grid;
typedef struct {
  cells_grid grid;
  vf of[CELLS_PARTS][CELLS_STEPS * CELLS_STEPS];
} cells_seen;

/* The same of what only covers. */
typedef struct {
  cells_grid grid;
  vf of[CELLS_STEPS * CELLS_STEPS];
} cells_covered;

/* What the one look at a footprint's middle has found of bodies, for who asks how deep they
 * are. */
typedef struct {
  int bent, met; /* that the next is known; and the rest */
  vf fine;       /* what is left of the faces' finer bends */
  vf wide;       /* of the footprint's sides the longer, cells */
  cells_near near[3];
  vm body[2];
} cells_found;

/* How a layer sees a footprint of this size and slant, wherever it lies. Its looks are parts side
 * by side, each well below a cell's size. Lengths in cells. */
typedef struct {
  vf n[2], inverse[2]; /* looks along each side */
  cells_square part;
  vf part_wide, most; /* the part's longer side, and the whole's */
  vf keep, fine;      /* how much the looks count beside the mean; of the faces' finer bends */
  vf swell, each;     /* what the looks of bodies see in excess, a factor; a look's share of all */
  vm seen, counted;   /* by looks; cell by cell */
  cells_square all;
  int once; /* one look at the middle is all, to every lane */
  int sole; /* and nothing else tells of it */
  int idle; /* no look is any use */
} cells_view;

/* A footprint on a layer, and what has been seen of it. s: mm. */
typedef struct {
  const vf *p, *t1, *t2;
  vf s;
  const cells_view *view;
  cells_seen *looks;  /* to be kept there, or NULL */
  vf *thirds;         /* likewise, the third kind's share */
  cells_found *found; /* likewise, of the last look */
  cells_bends *bends; /* at a lone look, where layers share them; or NULL */
  vu nearest;
  cells_cover sum;
  vf third; /* as sum, of the third kind */
} cells_eye;

#define CELLS_LOOKS 8 /* of one footprint, that go through the stages side by side */
#define CELLS_EYES 16 /* the same of footprints of which one look each is all */

/* A look at the two cells that meet at a part of a footprint, on its way through the
 * three stages below. They run over a few looks each, so that one look's chains of
 * operations fill the waits of the next one's. */
typedef struct {
  cells_eye *eye;
  int slot; /* of looks that are kept */
  vm there;
  vf straight[3], q[3], cloud; /* where it is, before and after the faces' bends */
  vf other[3];                 /* and in the cells of the layer whose noises bend them, */
  const vf *bend;              /* if that is another; this is either */
  const cells_square *part;    /* what it sees: its view's, or as the bends leave it */
  cells_square sheared;
  int empty;          /* no body is near any lane; the rest is not known then */
  cells_near near[3]; /* bodies' third; of it no one asks where it is */
} cells_look;

/* What the middle of a part knows of the bends there, and what a footprint that is all
 * but a cell wide need not. */
INLINE vf view_fine(const cells_view *e) {
  vm all = and_(le(e->part_wide, splat(0.12f)), le(e->most, splat(CELLS_FINE)));
  if (!any(not_(all))) return splat(1.0f);
  return crystal_keep(e->part_wide, 0.12f, 0.36f) *
         crystal_keep(e->most, CELLS_FINE, 1.6f * CELLS_FINE);
}

/* Whose looks are more than one. */
INLINE vm view_several(const cells_view *e) { return gt(e->n[0] * e->n[1], splat(1.0f)); }

/* Where the footprint takes more than one look. */
STAGE void view_divide(const stone_cells *c, cells_view *e, const cells_square *all,
                       const vf wide[2]) {
  vf one = splat(1.0f), side[2];
  for (int k = 0; k < 2; k++) {
    vi whole;
    vf dense = splat(c->looks) / (one + splat(c->spread) * wide[k]);
    vf looks = vfloor(wide[k] * dense + splat(c->least), &whole);
    vm few = lt(wide[k], splat(c->grouped ? CELLS_IN_FOURS : CELLS_MANY));
    vf many = splat(c->grouped ? CELLS_STEPS : CELLS_ALONE);
    e->n[k] = clamp(looks, one, sel(few, splat(CELLS_FEW), many));
  }
  if (c->grouped) {
    vm several = view_several(e);
    for (int k = 0; k < 2; k++) {
      vi whole;
      vf dense = wide[k] * splat(c->fours), two = splat(2.0f);
      vf fours = vfloor(dense + splat(1.5f), &whole);
      fours = vmin(fours, vfloor((e->n[k] + one) * splat(0.5f), &whole));
      vm more = gt(dense, splat(c->shaped ? FLAKES_ONE_FOUR : CELLS_ONE_FOUR));
      fours = sel(more, vmax(fours, two), fours);
      e->n[k] = sel(several, fours + fours, one);
    }
  }
  for (int k = 0; k < 2; k++) {
    e->inverse[k] = side[k] = one / e->n[k];
    if (c->shaped) {
      side[k] = vmin(side[k], splat(CELLS_LOOK_MOST) / vmax(wide[k], splat(CELLS_LOOK_MOST)));
    }
  }
  for (int k = 0; k < 3; k++) {
    e->part.u[k] = all->u[k] * side[0];
    e->part.v[k] = all->v[k] * side[1];
  }
  e->part_wide = vmax(cells_length(e->part.u), cells_length(e->part.v));
  e->fine = view_fine(e);
  e->keep = crystal_keep(e->most, 0.6f * c->fade, 2.1f * c->fade);
  e->counted = gt(e->most, splat(c->counted_from));
  if (any(e->counted)) {
    vf keep =
        crystal_keep(e->most, SECTIONS_KEEP * c->fade_counted, SECTIONS_GONE * c->fade_counted);
    e->keep = sel(e->counted, keep, e->keep);
    e->counted = and_(e->counted, gt(keep, splat(0.0f)));
  }
  e->seen = and_(gt(e->keep, splat(0.0f)), not_(e->counted));
  e->all = *all;
  e->once = !any(or_(view_several(e), not_(e->seen)));
  e->idle = !any(or_(e->seen, e->counted));
}

/* What a look has of the whole, and bodies nothing in excess of what fills a small look. */
INLINE void view_weigh(const stone_cells *c, cells_view *e) {
  vf one = splat(1.0f);
  e->swell = one;
  e->each = e->inverse[0] * e->inverse[1];
  if (c->shaped) {
    vf at = vmax(e->part_wide - splat(CELLS_SMALL), splat(0.0f)) *
            splat(1.0f / (CELLS_LOOK_MOST - CELLS_SMALL));
    e->swell = one / (one + splat(c->swell) * at * at);
    e->each = e->each * e->swell;
  }
  e->sole = e->once && !any(lt(e->keep, one));
}

/* t1, t2: the footprint's sides, s: mm. */
INLINE void view_open(const stone_cells *c, const vf t1[3], const vf t2[3], vf s, cells_view *e) {
  vf one = splat(1.0f), wide[2];
  cells_square all;
  cells_turn(c, t1, all.u);
  cells_turn(c, t2, all.v);
  for (int k = 0; k < 3; k++) {
    all.u[k] = all.u[k] * s;
    all.v[k] = all.v[k] * s;
  }
  wide[0] = dot3(all.u, all.u);
  wide[1] = dot3(all.v, all.v);
  e->most = vsqrt(vmax(wide[0], wide[1]));
  if (any(gt(e->most, splat(c->single)))) {
    for (int k = 0; k < 2; k++) wide[k] = vsqrt(wide[k]);
    view_divide(c, e, &all, wide);
  } else {
    e->part = all;
    e->part_wide = e->most;
    e->n[0] = e->n[1] = e->inverse[0] = e->inverse[1] = e->keep = one;
    e->fine = view_fine(e);
    e->seen = le(splat(0.0f), one);
    e->once = 1;
    e->idle = 0;
  }
  view_weigh(c, e);
}

/* Of what has been seen of a layer's third kind, of its mean and of what is counted of it, the
 * footprint's. */
INLINE vf eye_third(const cells_view *view, vf mean, vf seen, vf counted) {
  seen = sel(lt(view->keep, splat(1.0f)), mix(mean, seen, view->keep), seen);
  seen = sel(view->seen, seen, mean);
  return sel(view->counted, mix(mean, counted, view->keep), seen);
}

/* What has been seen, and as far as the looks do not reach the expected shares. */
INLINE void eye_close(const stone_cells *c, const cells_eye *e, cells_cover *out, vf *third) {
  const cells_view *view = e->view;
  vf one = splat(1.0f);
  if (e->looks) {
    for (int k = 0; k < 2; k++) e->looks->grid.n[k] = view->n[k];
    vm parts = and_(view->seen, view_several(view));
    e->looks->grid.weight = sel(parts, view->keep * view->swell, splat(0.0f));
  }
  *third = e->third * view->each;
  if (view->sole) {
    for (int k = 0; k < CELLS_PARTS; k++) out->of[k] = e->sum.of[k] * view->each;
    return;
  }
  vf mean[3] = {splat(c->mean[0]), splat(c->mean[1]), splat(c->third_mean)};
  vm asks = lt(view->keep, one); /* where no mean is asked for, none rounds */
  if (c->bedded && any(asks)) {
    vf rich = beds_mean(&c->beds, e->p, e->s * vsqrt(e->t1[1] * e->t1[1] + e->t2[1] * e->t2[1]));
    rich = sel(asks, rich, one);
    for (int k = 0; k < 2; k++) mean[k] = mean[k] * rich;
  }
  if (c->cluster > 0.0f && any(asks)) {
    vf rich = clusters_rich(c, e->p, &view->all, view->most, asks);
    for (int k = 0; k < 3; k++) mean[k] = mean[k] * rich;
  }
  vf bodies = mean[0] + mean[1];
  if (c->third > 0.0f) bodies = bodies + mean[2];
  const vf expected[CELLS_PARTS] = {c->shaped ? bodies : one - bodies, mean[0], mean[1]};
  for (int k = 0; k < CELLS_PARTS; k++) {
    /* all of a footprint is 1 and not nearly so */
    vf sum = e->sum.of[k] * view->each;
    vf some = sel(lt(view->keep, one), mix(expected[k], sum, view->keep), sum);
    out->of[k] = sel(view->seen, some, expected[k]);
  }
  const int counted = !view->once && any(view->counted);
  vf cut[CELLS_PARTS], cut_third = splat(0.0f);
  if (counted) sections_count(c, e->p, &view->all, view->counted, cut, &cut_third);
  if (c->third > 0.0f) *third = eye_third(view, mean[2], *third, cut_third);
  if (!counted) return;
  for (int k = 0; k < CELLS_PARTS; k++)
    out->of[k] = sel(view->counted, mix(expected[k], cut[k], view->keep), out->of[k]);
}

#endif
