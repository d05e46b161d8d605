/* SPDX-License-Identifier: Apache-2.0
 *
 * Fibre's evaluate: compiled once for each instruction set and width.
 */
#include "../../core/lanes.h"
#include "bundle.h"
#include "cloth.h"
#include "lanes.h"
#include "strand_light.h"

extern const fibertex_kernel KERNEL_NAME(fibertex_kernel_);

/* Sums over what is seen; of colours the shares of the first and the second. */
typedef struct {
  vf left;      /* what is not covered yet */
  vf albedo[2]; /* in the shade of what is over it */
  vf direct[2]; /* reached by the light straight */
  vf bare;      /* as direct, whatever the colour */
  vf depth;
} sums;

/* What a cloth's yarn does to its strands, and what is the hull's of an aggregate. */
typedef struct {
  vf along[3], across[3], up[3]; /* in the hull's frame */
  vf weft, ambient, around, onward, straight;
  vf place[2]; /* along and round the yarn, mm */
  vf level, solid;
  vu h;
} ground;

/* A block of LANES points on its way through the layers. */
typedef struct {
  uint32_t i, n;
  vf at[3];
  hull_frame f;
  lattice_frame g[LATTICES];
  lane_filter filter;
  ground ground;
  vf s;
  sums sum;
  vf shade;                    /* what is left of light by strands close above */
  vf front;                    /* 0 behind, 1 in front, with a soft edge */
  vf inverse_up, step[2], lit; /* step: factors from layer to layer, of lit and of itself */
  /* the strand that most is seen of, and how much of the next */
  vf most, next;
  struct {
    vf direction[2], slope, across, second, bare, bright, detail, level;
    vu id;
  } best;
} block;

INLINE void put(const kernel_io *io, const block *k, int channel, vf x) {
  if (io->wanted >> channel & 1) store_active(io->in, io->out[channel], k->i, k->n, x);
}

/* An input's direction; with zero_is_normal, `otherwise` where it is none. */
INLINE void direction_of(const block *k, const float *const from[3], const vf otherwise[3],
                         int zero_is_normal, vf out[3]) {
  for (int c = 0; c < 3; c++) out[c] = otherwise[c];
  if (!from[0]) return;
  vf v[3], size = splat(0.0f);
  for (int c = 0; c < 3; c++) {
    v[c] = load_lanes(from[c], k->i, k->n);
    size = size + vabs(v[c]);
  }
  vm given = and_(gt(size, splat(0.0f)), lt(size, splat(1e38f)));
  unit_direction(v);
  for (int c = 0; c < 3; c++) out[c] = zero_is_normal ? sel(given, v[c], otherwise[c]) : v[c];
}

/* e1: the axis laid down on the surface; another where it stands upright. */
INLINE void frame_axes(const fibertex_constants *w, const vf given[3], hull_frame *f) {
  vf axis[3], along = dot3(given, f->n);
  vm upright = gt(vabs(along), splat(0.995f));
  for (int c = 0; c < 3; c++) axis[c] = sel(upright, splat(w->axis[(c + 1) % 3]), given[c]);
  along = dot3(axis, f->n);
  for (int c = 0; c < 3; c++) f->e1[c] = axis[c] - along * f->n[c];
  vf k = inverse_root(vmax(dot3(f->e1, f->e1), splat(1e-6f)));
  for (int c = 0; c < 3; c++) f->e1[c] = f->e1[c] * k;
  f->e2[0] = f->n[1] * f->e1[2] - f->n[2] * f->e1[1];
  f->e2[1] = f->n[2] * f->e1[0] - f->n[0] * f->e1[2];
  f->e2[2] = f->n[0] * f->e1[1] - f->n[1] * f->e1[0];
}

INLINE void into_frame(const hull_frame *f, const vf v[3], vf out[3]) {
  out[0] = dot3(v, f->e1);
  out[1] = dot3(v, f->e2);
  out[2] = dot3(v, f->n);
}

/* inverse_in, inverse_out: 1 over the cosines of light and view, none too great. */
INLINE void ground_hull(const fibertex_constants *w, block *k, vf inverse_in, vf inverse_out) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  for (int c = 0; c < 3; c++) {
    g->along[c] = c == 0 ? one : zero;
    g->across[c] = c == 1 ? one : zero;
    g->up[c] = c == 2 ? one : zero;
  }
  g->weft = g->level = zero;
  g->ambient = g->straight = g->solid = one;
  /* what comes back after many strands: less of light that grazes, and to an eye that does,
   * but more of a thin shell, which is deeper at a slant */
  vf in = vmax(k->f.light[2], zero), out = vmax(k->f.view[2], zero);
  vf deep = splat(w->slab) * (inverse_in + inverse_out), most = deep * deep;
  vf slab = most / (most + splat(w->slab_linear) * deep + splat(w->slab_square));
  vf x = one - in, y = one - out;
  g->around = in * slab * (one - splat(w->graze) * (x + y) + splat(w->graze_both) * x * y);
  /* what goes on through fades where light grazes */
  g->onward = in * in * splat(w->chain) / (in + splat(0.25f));
  g->place[0] = g->place[1] = zero;
  g->h = splatu(0);
}

/* How much of the straight light a yarn's flank lets its strands have. */
INLINE vf flank(vf up) { return clamp01(splat(0.25f) + splat(1.1f) * up); }

STAGE void ground_cloth(const fibertex_constants *w, block *k, vf u, vf v, vf sign) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  ground *g = &k->ground;
  cloth_hit q;
  cloth_at(w, u, v, k->s, &q);
  q.across = q.across * sign;
  cloth_frame(w, &q, g->along, g->across, g->up);
  g->weft = q.share;
  g->ambient = q.ambient;
  vf up = dot3(k->f.light, g->up);
  g->around = vmax(up, zero) * k->front;
  g->onward = zero;
  g->straight = flank(up);
  g->place[0] = q.along;
  /* the way round an ellipse from its crest: nearly */
  g->place[1] = q.half * q.across * (one + splat(0.3f) * q.across * q.across);
  g->level = splat(w->low) + one / splat(w->inverse_range) - q.top;
  g->solid = q.solid;
  vf tone = one + splat(w->yarn[0].tone) * byte_of(q.h, 2);
  g->ambient = g->ambient * tone;
  g->straight = g->straight * tone;
  g->h = q.h;
}

INLINE void stage_load(const fibertex_constants *w, int woven, const kernel_io *io, block *k) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf v[3], axis[3], other[3];
  cloth_place cloth;
  for (int c = 0; c < 3; c++) {
    k->at[c] = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n)) + splat(w->offset[c]);
    k->f.n[c] = splat(0.57735027f);
    axis[c] = splat(w->axis[c]);
  }
  k->s = zero;
  if (io->in->footprint) {
    k->s = clamp(load_lanes(io->in->footprint, k->i, k->n), zero, splat(1e4f));
  }
  if (io->in->normal[0]) {
    for (int c = 0; c < 3; c++) k->f.n[c] = load_lanes(io->in->normal[c], k->i, k->n);
    unit_direction(k->f.n);
  }
  if (woven) cloth_axes(w, k->f.n, k->at, &cloth, other);
  frame_axes(w, woven ? cloth.axis : axis, &k->f);
  direction_of(k, io->in->view, k->f.n, 1, v);
  into_frame(&k->f, v, k->f.view);
  /* at the horizon nothing is seen but the hull's edge: no further than this */
  vf up = vmax(k->f.view[2], splat(0.18f)), slant = one / up;
  for (int c = 0; c < 3; c++) k->f.step[c] = (v[c] - k->f.n[c] * k->f.view[2]) * slant;
  for (int c = 0; c < 2; c++) k->f.lean2[c] = k->f.view[c] * slant;
  lattice_of(&k->f, k->at, k->g);
  k->filter = lane_filter_of(w->layer[0].radius, k->s);
  direction_of(k, io->in->light, k->f.n, 0, v);
  into_frame(&k->f, v, k->f.light);
  k->f.between = dot3(k->f.light, k->f.view);
  k->front = smooth_step(splat(-0.02f), splat(0.22f), k->f.light[2]);
  /* where the eye looks along the light, what it sees is lit: the way in is the way out */
  vf apart = one + (one - k->f.between) * splat(w->opposition_sharp);
  vf inverse = one / vmax(k->f.light[2], splat(0.1f));
  k->inverse_up = (one - splat(w->opposition) / (apart * apart)) * inverse;
  if (woven)
    ground_cloth(w, k, cloth.u, cloth.v, sel(lt(dot3(other, k->f.e2), zero), zero - one, one));
  else
    ground_hull(w, k, inverse, slant);

  k->sum.left = k->shade = one;
  for (int c = 0; c < 2; c++) {
    k->sum.albedo[c] = k->sum.direct[c] = k->best.direction[c] = zero;
  }
  k->sum.bare = k->sum.depth = k->most = k->next = zero;
  k->best.slope = k->best.across = k->best.second = k->best.bare = k->best.bright = zero;
  k->best.detail = k->best.level = zero;
  k->best.id = splatu(0);
}

/* The light that reaches the next layer straight. */
INLINE void light_layers(const fibertex_constants *w, block *k) {
  k->step[0] = exp2_(splat(-1.442695f * w->step) * k->inverse_up);
  k->step[1] = exp2_(splat(-1.442695f * w->step_more) * k->inverse_up);
  k->lit = k->front;
}

/* A layer's strands over what is below them; direction: in the ground's frame. */
INLINE void compose(const fibertex_constants *w, const fibertex_layer *c, block *k,
                    const lane_hit *q, const vf direction[2], vf level, int light) {
  const vf one = splat(1.0f);
  sums *sum = &k->sum;
  vf share = sum->left * q->cover;
  sum->left = sum->left - share;
  vf dark = k->shade * q->bright, bright = dark * (one + splat(w->variation) * q->tone);
  vf part = share * bright, second = part * q->second, first = part - second;
  vf ambient = splat(c->ambient);
  sum->albedo[0] = sum->albedo[0] + first * ambient;
  sum->albedo[1] = sum->albedo[1] + second * ambient;
  sum->depth = sum->depth + share * level;
  vm more = gt(share, k->most);
  k->next = sel(more, k->most, vmax(k->next, share));
  k->most = sel(more, share, k->most);
  k->best.id = (vu)seli(more, (vi)q->id, (vi)k->best.id);
  for (int i = 0; i < 2; i++) {
    k->best.direction[i] = sel(more, direction[i], k->best.direction[i]);
  }
  k->best.slope = sel(more, q->slope, k->best.slope);
  k->best.across = sel(more, q->across, k->best.across);
  k->best.detail = sel(more, q->detail, k->best.detail);
  k->best.level = sel(more, level, k->best.level);
  if (light) {
    sum->direct[0] = sum->direct[0] + first * k->lit;
    sum->direct[1] = sum->direct[1] + second * k->lit;
    sum->bare = sum->bare + share * dark * k->lit;
    k->best.second = sel(more, q->second, k->best.second);
    k->best.bare = sel(more, dark * k->lit, k->best.bare);
    k->best.bright = sel(more, bright * k->lit, k->best.bright);
    k->lit = k->lit * k->step[0];
    k->step[0] = k->step[0] * k->step[1];
  }
  k->shade = k->shade * (one + splat(w->contact) * (splat(c->soft) - q->soft));
}

STAGE void layer_of_hull(const fibertex_constants *w, const fibertex_layer *c, block *k,
                         int light) {
  lane_place p;
  lane_hit q;
  vf d[2];
  bundle_at(w, c, &k->f, k->g, &p, d);
  lanes_at(w, c, 1, &p, &k->filter, &q);
  compose(w, c, k, &q, d, splat(c->depth), light);
}

INLINE void yarn_place(const fibertex_layer *c, const vf at[2], vu h, lane_place *p) {
  vf co = splat(c->twist[0]), si = splat(c->twist[1]), one = splat(1.0f);
  p->x = at[0] * co + at[1] * si;
  p->y = at[1] * co - at[0] * si;
  p->bend = p->rest2 = splat(0.0f);
  p->chord = p->inverse_length = p->widen = p->full = one;
  p->h = hash_mix(h + splatu(c->seed));
}

STAGE void layer_of_yarn(const fibertex_constants *w, const fibertex_layer *c, block *k,
                         int light) {
  lane_place p;
  lane_hit q;
  const vf d[2] = {splat(c->twist[0]), splat(c->twist[1])};
  yarn_place(c, k->ground.place, k->ground.h, &p);
  lanes_at(w, c, 0, &p, &k->filter, &q);
  q.cover = q.cover * k->ground.solid;
  compose(w, c, k, &q, d, splat(c->depth) + k->ground.level, light);
}

/* Of warp and weft (of an aggregate the first is all): what all directions together
 * show, and what reaches them. */
typedef struct {
  vf white[2], glow[2], bulk[2], around[2], albedo[2], straight, onward;
} looks;

STAGE void looks_of(const fibertex_constants *w, int woven, const block *k, int light, looks *q) {
  const vf zero = splat(0.0f);
  for (int i = 0; i < 2; i++) {
    q->white[i] = q->glow[i] = q->bulk[i] = q->around[i] = q->albedo[i] = zero;
  }
  q->straight = q->onward = zero;
  for (int m = 0; m < w->looks; m++) {
    const fibertex_look *o = &w->look[m];
    int i = woven ? o->weft : 0;
    q->albedo[i] = q->albedo[i] + splat(o->lit);
    if (!light) continue;
    strand_lit r;
    strand_axes t;
    for (int c = 0; c < 3; c++) {
      t.along[c] = splat(o->along[c]);
      t.across[c] = splat(o->across[c]);
      t.up[c] = splat(o->up[c]);
    }
    t.across2 = splat(o->across2);
    t.up2 = splat(o->up2);
    vf up = dot3(t.up, k->f.light), share = splat(o->straight);
    strand_light(w, k->f.light, k->f.view, k->f.between, &t, &r);
    q->around[i] =
        q->around[i] + splat(o->around) * (woven ? vmax(up, zero) * k->front : k->ground.around);
    if (woven) /* else strands across the view's slant look broader, and are more of what is seen */
      share = share * flank(up);
    else
      share = share * widening(k->f.lean2[0] * t.across[0] + k->f.lean2[1] * t.across[1],
                               w->layer[w->layers - 1].widen_most);
    q->glow[i] = q->glow[i] + share * r.glow;
    q->bulk[i] = q->bulk[i] + share * r.bulk;
    q->white[i] = q->white[i] + share * r.white;
    q->straight = q->straight + share;
    if (!woven) q->onward = q->onward + share * r.onward;
  }
  if (woven || !light) return;
  vf inverse = splat(1.0f) / q->straight;
  q->glow[0] = q->glow[0] * inverse;
  q->bulk[0] = q->bulk[0] * inverse;
  q->white[0] = q->white[0] * inverse;
  q->onward = q->onward * inverse;
}

/* Adds a density of strands: cover, with its ambient and its straight light. */
INLINE void add_mean(const fibertex_constants *w, sums *sum, vf cover, vf ambient, vf lit,
                     vf depth) {
  vf second = splat(w->second_share), first = splat(1.0f) - second;
  sum->left = sum->left - cover;
  sum->depth = sum->depth + depth;
  sum->albedo[0] = sum->albedo[0] + first * ambient;
  sum->albedo[1] = sum->albedo[1] + second * ambient;
  sum->direct[0] = sum->direct[0] + first * lit;
  sum->direct[1] = sum->direct[1] + second * lit;
  sum->bare = sum->bare + lit;
}

/* The layers' means over one another, and what lies deeper. */
STAGE void stage_far(const fibertex_constants *w, const block *k, int light, vf deep_lit,
                     sums *out) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  /* widening's mean over all directions */
  vf x = vmin(k->f.lean2[0] * k->f.lean2[0] + k->f.lean2[1] * k->f.lean2[1], splat(3.5f));
  vf wide = one + x * (splat(0.24f) + x * (splat(-0.03225f) + x * splat(0.00266f)));
  vf left = one, lit = zero, ambient = zero, depth = zero, reach = k->front;
  vf step = exp2_(splat(-1.442695f * w->step) * k->inverse_up);
  for (int l = 0; l < w->layers; l++) {
    const fibertex_layer *c = &w->layer[l];
    vf mean = splat(c->mean);
    if (c->ends) mean = vmin(mean * vmin(wide, splat(c->widen_most)), splat(0.97f));
    vf share = left * mean;
    left = left - share;
    if (light) {
      lit = lit + share * reach;
      reach = reach * step;
      step = step * k->step[1];
    }
    ambient = ambient + share * splat(c->ambient);
    depth = depth + share * splat(c->depth);
  }
  vf under = left * splat(w->deep);
  out->left = one;
  out->bare = out->depth = zero;
  for (int i = 0; i < 2; i++) out->albedo[i] = out->direct[i] = zero;
  add_mean(w, out, (one - left + under) * splat(w->solid),
           (ambient + under * splat(w->deep_ambient)) * splat(w->solid),
           (lit + under * deep_lit) * splat(w->solid),
           (depth + under * splat(w->deep_depth)) * splat(w->solid));
}

/* What a point's sums come to, of each of the palette. */
typedef struct {
  vf cover, depth, white;
  vf albedo[FIBERTEX_COLOURS], glow[FIBERTEX_COLOURS], bulk[FIBERTEX_COLOURS];
} shown;

/* From afar: by the means of all directions. */
INLINE void show_far(const fibertex_constants *w, const block *k, const sums *s, const looks *q,
                     shown *o) {
  o->cover = splat(1.0f) - s->left;
  o->depth = s->depth;
  o->white = s->bare * (q->white[0] + q->white[1]);
  vf often[2];
  for (int i = 0; i < 2; i++) often[i] = splat(w->multiple) * q->around[i];
  o->albedo[COLOUR_FIRST] = s->albedo[0] * q->albedo[0];
  o->albedo[COLOUR_WEFT] = s->albedo[0] * q->albedo[1];
  o->albedo[COLOUR_SECOND] = s->albedo[1] * (q->albedo[0] + q->albedo[1]);
  vf onward = q->onward * k->ground.onward;
  o->glow[COLOUR_FIRST] = s->direct[0] * q->glow[0] + s->albedo[0] * onward;
  o->glow[COLOUR_WEFT] = s->direct[0] * q->glow[1];
  o->glow[COLOUR_SECOND] = s->direct[1] * (q->glow[0] + q->glow[1]) + s->albedo[1] * onward;
  o->bulk[COLOUR_FIRST] = s->direct[0] * q->bulk[0] + s->albedo[0] * often[0];
  o->bulk[COLOUR_WEFT] = s->direct[0] * q->bulk[1] + s->albedo[0] * often[1];
  o->bulk[COLOUR_SECOND] =
      s->direct[1] * (q->bulk[0] + q->bulk[1]) + s->albedo[1] * (often[0] + often[1]);
}

/* The strand that is seen: its axes in the hull's frame. */
INLINE void best_axes(const fibertex_constants *w, const block *k, strand_axes *t) {
  const vf one = splat(1.0f);
  const ground *g = &k->ground;
  vf slope = k->best.slope, lost = one - k->best.detail;
  vf rise =
      splat(w->lean) + splat(w->rise * (1.0f / 128.0f)) * byte_of(k->best.id, 2) * k->best.detail;
  vf flat = inverse_root(one + slope * slope), steep = inverse_root(one + rise * rise);
  vf x = (k->best.direction[0] - slope * k->best.direction[1]) * flat;
  vf y = (k->best.direction[1] + slope * k->best.direction[0]) * flat;
  for (int c = 0; c < 3; c++) {
    vf level = x * g->along[c] + y * g->across[c];
    t->along[c] = (level + rise * g->up[c]) * steep;
    t->across[c] = x * g->across[c] - y * g->along[c];
    t->up[c] = (g->up[c] - rise * level) * steep;
  }
  t->across2 = lost * splat(w->scatter);
  t->up2 = lost * splat(w->scatter_up);
}

/* How much of what has gone on through many strands keeps the last one's lobe: the less, the
 * better a footprint's mean stands for its strands. */
#define ONWARD_LAST 0.5f

/* What one strand shows beyond its means, given to the colours. */
INLINE void share_out(const block *k, vf mean, vf change, const vf often[2], vf out[]) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const sums *s = &k->sum;
  vf straight = k->ground.straight, weft = k->ground.weft;
  vf second = change * k->best.second, first = change - second;
  vf a = vmax((s->direct[0] * mean + first) * straight + often[0], zero);
  vf b = vmax((s->direct[1] * mean + second) * straight + often[1], zero);
  out[COLOUR_FIRST] = a * (one - weft);
  out[COLOUR_WEFT] = a * weft;
  out[COLOUR_SECOND] = b;
}

/* Near: by the strand that is seen; what else is there by the means. */
INLINE void show_near(const fibertex_constants *w, int woven, const block *k, const looks *q,
                      const strand_axes *t, int light, shown *o) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const ground *g = &k->ground;
  const sums *s = &k->sum;
  o->cover = one - s->left;
  o->depth = s->depth;
  vf weft = g->weft, warp = one - weft;
  o->albedo[COLOUR_FIRST] = s->albedo[0] * g->ambient * warp;
  o->albedo[COLOUR_WEFT] = s->albedo[0] * g->ambient * weft;
  o->albedo[COLOUR_SECOND] = s->albedo[1] * g->ambient;
  o->white = zero;
  for (int i = 0; i < FIBERTEX_COLOURS; i++) o->glow[i] = o->bulk[i] = zero;
  if (!light) return;
  vf white = q->white[0], glow = q->glow[0], bulk = q->bulk[0];
  if (woven) {
    vf inverse = one / vmax(q->straight, splat(0.05f));
    white = (white + q->white[1]) * inverse;
    glow = (glow + q->glow[1]) * inverse;
    bulk = (bulk + q->bulk[1]) * inverse;
  }
  strand_lit r;
  strand_light(w, k->f.light, k->f.view, k->f.between, t, &r);
  /* a strand is brighter on the side that the light is on */
  vf facing = k->best.across * dot3(t->across, k->f.light), side = one + splat(0.6f) * facing;
  vf part = k->most - k->next, bright = part * k->best.bright;
  vf around = splat(w->multiple) * g->around * g->ambient;
  if (!woven) around = around * (one + splat(0.25f) * part * facing);
  const vf often[2] = {s->albedo[0] * around, s->albedo[1] * around};
  /* the last of the strands that it went through is the one that is seen */
  vf last = (q->onward + splat(ONWARD_LAST) * part * (r.onward - q->onward)) * g->onward;
  const vf onward[2] = {s->albedo[0] * last, s->albedo[1] * last};
  share_out(k, glow, bright * (r.glow * side - glow), onward, o->glow);
  share_out(k, bulk, bright * (r.bulk * side - bulk), often, o->bulk);
  o->white = vmax((s->bare * white + part * k->best.bare * (r.white - white)) * g->straight, zero);
}

INLINE void blend(shown *a, const shown *b, vf far, int woven, int light) {
  vm some = gt(far, splat(0.0f)), all = le(splat(1.0f), far);
  vf near = splat(1.0f) - far;
#define BLEND_(x) a->x = sel(some, sel(all, b->x, a->x * near + b->x * far), a->x)
  BLEND_(cover);
  BLEND_(depth);
  const int colours = woven ? FIBERTEX_COLOURS : COLOUR_WEFT;
  for (int i = 0; i < colours; i++) BLEND_(albedo[i]);
  if (!light) return;
  BLEND_(white);
  for (int i = 0; i < colours; i++) {
    BLEND_(glow[i]);
    BLEND_(bulk[i]);
  }
#undef BLEND_
}

INLINE void put_vector(const kernel_io *io, const block *k, int channel, const vf v[3],
                       const vf otherwise[3]) {
  if (!kernel_wants(io, channel, 3)) return;
  const hull_frame *f = &k->f;
  vf square = dot3(v, v);
  vm none = not_(gt(square, splat(1e-12f)));
  vf inverse = inverse_root(vmax(square, splat(1e-12f)));
  for (int c = 0; c < 3; c++) {
    vf x = (v[0] * f->e1[c] + v[1] * f->e2[c] + v[2] * f->n[c]) * inverse;
    put(io, k, channel + c, sel(none, otherwise[c], x));
  }
}

INLINE void stage_put(const fibertex_constants *w, int woven, const kernel_io *io, const block *k,
                      const shown *o, const strand_axes *t, vf far, int light) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  const int colours = woven ? FIBERTEX_COLOURS : COLOUR_WEFT;
  vf cover = clamp01(o->cover), some = one / vmax(cover, splat(1e-6f));
  for (int c = 0; c < 3; c++) {
    vf a = zero, r = o->white;
    for (int i = 0; i < colours; i++) a = a + o->albedo[i] * splat(w->colour[i][c]);
    put(io, k, FIBERTEX_ALBEDO + c, a);
    if (!light) continue;
    for (int i = 0; i < colours; i++) {
      r = r + o->glow[i] * splat(w->glow[i][c]) + o->bulk[i] * splat(w->bulk[i][c]);
    }
    if (io->in->light_colour[c]) {
      vf e = load_lanes(io->in->light_colour[c], k->i, k->n);
      r = r * sel(lt(vabs(e), splat(1e30f)), e, zero);
    }
    put(io, k, FIBERTEX_RADIANCE + c, r);
  }
  put(io, k, FIBERTEX_COVERAGE, cover);
  put_vector(io, k, FIBERTEX_TANGENT, t->along, k->f.e1);
  put(io, k, FIBERTEX_STRAND, to_float((vi)(k->best.id >> 8)) * splat(1.0f / 16777216.0f));
  vf depth = vmax(o->depth * some, zero);
  put(io, k, FIBERTEX_DEPTH, depth);
  /* the strand's own roundness is in the height */
  vf side = k->best.across, top = vsqrt(vmax(one - side * side, zero));
  vf seen = (k->most - k->next) * k->best.detail * (one - far);
  put(io, k, FIBERTEX_HEIGHT, splat(w->layer[0].radius) * top * seen - depth);
  if (!kernel_wants(io, FIBERTEX_NORMAL, 4)) return;
  /* what no strand shows faces as the ground does, or the hull; what the mean has lost
   * in length is the normals' scatter */
  const ground *g = &k->ground;
  vf n[3], near = one - far;
  for (int c = 0; c < 3; c++) {
    vf strand = side * t->across[c] + top * t->up[c];
    vf of = seen * strand + (near - seen) * g->up[c];
    n[c] = sel(le(one, far), splat(c == 2 ? 1.0f : 0.0f), c == 2 ? of + far : of);
  }
  vf alpha2 = splat(w->strand_alpha2) + splat(0.5f) * (one - seen);
  put(io, k, FIBERTEX_ROUGHNESS, vsqrt(vmin(alpha2, one)));
  put_vector(io, k, FIBERTEX_NORMAL, n, k->f.n);
}

INLINE void evaluate_as(const fibertex_constants *w, int woven, const kernel_io *io, uint32_t from,
                        uint32_t to) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  int light = kernel_wants(io, FIBERTEX_RADIANCE, 3);
  for (uint32_t i = from; i < to; i += LANES) {
    block k = {.i = i, .n = to - i < LANES ? to - i : LANES};
    looks q;
    sums sum;
    shown near, mean;
    strand_axes t;
    stage_load(w, woven, io, &k);
    light_layers(w, &k);
    vf far = smooth_step(splat(w->far[0]), splat(w->far[1]), k.s);
    if (any(lt(far, one))) {
      for (int l = 0; l < w->layers; l++) {
        const fibertex_layer *c = &w->layer[l];
        if (!any(gt(k.sum.left, zero))) break;
        if (!woven || c->ends)
          layer_of_hull(w, c, &k, light);
        else
          layer_of_yarn(w, c, &k, light);
      }
    }
    looks_of(w, woven, &k, light, &q);
    vf deep_lit = exp2_(splat(-1.442695f * w->deep_above) * k.inverse_up) * k.front;
    vf under = k.sum.left * splat(w->deep) * k.ground.solid, shaded = under * k.shade;
    add_mean(w, &k.sum, under, shaded * splat(w->deep_ambient), shaded * deep_lit,
             under * (splat(w->deep_depth) + k.ground.level));
    best_axes(w, &k, &t);
    if (any(lt(far, one))) {
      show_near(w, woven, &k, &q, &t, light, &near);
      if (any(gt(far, zero))) {
        stage_far(w, &k, light, deep_lit, &sum);
        show_far(w, &k, &sum, &q, &mean);
        blend(&near, &mean, far, woven, light);
      }
    } else { /* nothing near is left of it */
      stage_far(w, &k, light, deep_lit, &sum);
      show_far(w, &k, &sum, &q, &near);
    }
    vm nothing = le(one, far);
    for (int c = 0; c < 3; c++) t.along[c] = sel(nothing, zero, t.along[c]);
    k.best.id = (vu)seli(nothing, splati(0), (vi)k.best.id);
    stage_put(w, woven, io, &k, &near, &t, far, light);
  }
}

static __attribute__((noinline)) void
evaluate_hull(const fibertex_constants *w, const kernel_io *io, uint32_t from, uint32_t to) {
  evaluate_as(w, 0, io, from, to);
}
static __attribute__((noinline)) void
evaluate_cloth(const fibertex_constants *w, const kernel_io *io, uint32_t from, uint32_t to) {
  evaluate_as(w, 1, io, from, to);
}
static void evaluate(const void *constants, const kernel_io *io, uint32_t from, uint32_t to) {
  const fibertex_constants *w = constants;
  if (w->structure == STRUCTURE_WOVEN)
    evaluate_cloth(w, io, from, to);
  else
    evaluate_hull(w, io, from, to);
}

/* Points spread at random through a space that is large to everything. */
INLINE vf measure_place(uint32_t at, uint32_t axis) {
  vf r = splat(0.0f);
  for (uint32_t k = 0; k < LANES; k++) {
    uint32_t h = hash1((at + k) * 3u + axis + 0x3c6ef372u);
    set_lane(&r, k, (float)(h >> 8) * (4096.0f / 16777216.0f));
  }
  return r;
}

/* One after the other, so that the sum has the same bits for any width. */
INLINE void measure_add(double *sum, vf x) {
  for (uint32_t k = 0; k < LANES; k++) *sum += (double)lane(x, k);
}

/* What the yarns show: warp's and weft's shares, and those in their shade. */
static void measure_cloth(const fibertex_constants *w, uint32_t count, fibertex_means *out) {
  const vf zero = splat(0.0f);
  for (uint32_t i = 0; i < count; i += LANES) {
    cloth_hit q;
    cloth_at(w, measure_place(i, 0) * splat(w->yarn[1].spacing),
             measure_place(i, 1) * splat(w->yarn[0].spacing), zero, &q);
    vf weft = sel(q.weft, q.solid, zero), warp = sel(q.weft, zero, q.solid);
    measure_add(&out->yarn[0], warp);
    measure_add(&out->yarn[1], weft);
    measure_add(&out->shaded[0], warp * q.ambient);
    measure_add(&out->shaded[1], weft * q.ambient);
    vf along[3], across[3], up[3];
    cloth_frame(w, &q, along, across, up);
    vf around = q.ambient * vmax(up[2], zero), straight = flank(up[2]);
    measure_add(&out->around[0], warp * around);
    measure_add(&out->around[1], weft * around);
    measure_add(&out->straight[0], warp * straight);
    measure_add(&out->straight[1], weft * straight);
  }
  for (int i = 0; i < 2; i++) {
    out->yarn[i] /= count;
    out->shaded[i] /= count;
    out->around[i] /= count;
    out->straight[i] /= count;
  }
}

static void measure(const fibertex_constants *w, uint32_t count, fibertex_means *out) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  /* any surface; this leans alike against every axis */
  block k = {.i = 0, .n = LANES};
  k.f = (hull_frame){.n = {splat(0.57735027f), splat(0.57735027f), splat(0.57735027f)}};
  const vf axis[3] = {splat(w->axis[0]), splat(w->axis[1]), splat(w->axis[2])};
  frame_axes(w, axis, &k.f);
  for (int c = 0; c < 2; c++) k.f.lean2[c] = zero;
  for (int c = 0; c < 3; c++) k.f.step[c] = zero;
  memset(out, 0, sizeof *out);
  const lane_filter filter = lane_filter_of(w->layer[0].radius, zero);
  for (int l = 0; l < w->layers; l++) {
    const fibertex_layer *c = &w->layer[l];
    for (uint32_t i = 0; i < count; i += LANES) {
      vf at[3], d[2];
      for (uint32_t a = 0; a < 3; a++) at[a] = measure_place(i, a) * splat(c->size);
      lane_place p;
      lane_hit q;
      if (c->ends) {
        lattice_of(&k.f, at, k.g);
        bundle_at(w, c, &k.f, k.g, &p, d);
        lanes_at(w, c, 1, &p, &filter, &q);
      } else {
        yarn_place(c, at, splatu(0), &p);
        lanes_at(w, c, 0, &p, &filter, &q);
      }
      measure_add(&out->point[l], q.cover);
      measure_add(&out->soft[l], q.soft * (one - q.cover));
      measure_add(&out->bright[l], q.cover * q.bright);
      measure_add(&out->formula[l], lane_expected(c, c->ends, &p));
    }
    out->soft[l] /= count - out->point[l];
    if (out->point[l] > 0.0) out->bright[l] /= out->point[l];
    out->point[l] /= count;
    out->formula[l] /= count;
  }
  if (w->structure == STRUCTURE_WOVEN) measure_cloth(w, count, out);
}

const fibertex_kernel KERNEL_NAME(fibertex_kernel_) = {KERNEL_OF(evaluate), measure};
