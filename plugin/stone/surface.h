/* SPDX-License-Identifier: Apache-2.0
 *
 * The surface as it lies: the finish's relief, domes and holes, the stones' edges
 * and how they lie, what grows and stands on them; as height with its slope, and
 * as shares of the footprint for the colours.
 */
#ifndef SOZAI_STONE_SURFACE_H
#define SOZAI_STONE_SURFACE_H

#include "../core/smith.h"
#include "bodies_height.h"
#include "laid.h"
#include "moss.h"
#include "relief.h"
#include "sand.h"

typedef struct {
  field height; /* mm over the face, object space */
  vf lost;      /* variance of slope along one axis that the footprint averages out, */
  vf edges;     /* and of that what lies in the joints and at the stones' edges */
  /* where in the relief's range the place lies, 0..1 (until all of it is found, its variance); its
   * sd of slope */
  vf low, steep;
  vf edge, shoulder; /* mm, of the stones' edges alone; from the joint's middle, what casts shade */
  vf polish;         /* how worn, 0..1 */
  vf grime;          /* light left by dirt */
  vf sand;           /* light and dark of the joint's filling */
  vf moss, tuft, dry; /* share; light and dark; lush, 0, to dry, 1 */
  vf moss_joint;      /* share of what is joint */
  vf film, water;     /* of water: as a film, standing */
  vf occlusion;       /* until it is laid, the relief's own hollows' */
} surface;

INLINE surface surface_none(void) {
  vf zero = splat(0.0f), one = splat(1.0f);
  surface q = {.height = field_of(zero), .lost = zero, .low = splat(0.5f), .steep = zero};
  q.edges = q.edge = q.shoulder = q.polish = q.sand = q.moss = q.moss_joint = q.tuft = q.dry =
      q.film = q.water = zero;
  q.grime = q.occlusion = one;
  return q;
}

/* How much of the sky's light a place h below two walls sees, by their distances. */
INLINE vf surface_slot(vf h, vf d0, vf d1) {
  vf h2 = h * h + splat(1e-6f);
  vf a = d0 * inverse_root(d0 * d0 + h2), b = d1 * inverse_root(d1 * d1 + h2);
  return splat(0.5f) * (a + b);
}

/* 1 / (1 + exp(-1.702 x)): a normal distribution's share below x, to 0.01. */
INLINE vf surface_below(vf x) {
  return splat(1.0f) /
         (splat(1.0f) + exp2_(clamp(splat(-2.4555f) * x, splat(-40.0f), splat(40.0f))));
}

/* Chips of some twice the rounding's width and of less than one, on each stone other ones. */
STAGE laid_round surface_round(const stone_constants *w, const laid *q, const vf p[3], vf s) {
  const stone_paving *v = &w->paving;
  laid_round r = {field_of(splat(v->round)), splat(v->round > 0.0f ? 1.0f / v->round : 0.0f)};
  if (v->chipping == 0.0f) return r;
  vf at[3], unused = splat(0.0f), one = splat(1.0f);
  for (int k = 0; k < 3; k++) at[k] = p[k] + q->shift[k];
  field n = weather_noise(at, v->chip_frequency, w->seed + 78u, 1.0f, s, &unused);
  n = field_add(n, weather_noise(at, 2.7f * v->chip_frequency, w->seed + 79u, 0.5f, s, &unused));
  n = field_scale(n, splat(3.0f * v->chipping));
  vf f = clamp(one + n.v, splat(STONE_ROUND_LEAST), splat(v->round_most));
  r.wide = field_through(n, splat(v->round) * f, sel(eq(f, one + n.v), splat(v->round), unused));
  r.inverse = one / r.wide.v;
  return r;
}

#define FILL_EDGE 0.3f /* of a grain: how far from the stones sand is as rough as it is */

/* What fills the joint, up to the stones. *lost: the variance of its slopes that the footprint
 * averages out. */
INLINE void surface_fill(const stone_constants *w, const laid *q, const vf p[3], vf s,
                         field *height, surface *out, vf *lost) {
  const stone_paving *v = &w->paving;
  float rim = FILL_EDGE / v->grain_frequency;
  if (rim > v->half) rim = v->half;
  field fill = laid_fall(q, v->half - rim, rim);
  fill.v = mix(q->joint, fill.v, q->near);
  for (int k = 0; k < 3; k++) fill.g[k] = fill.g[k] * q->near;
  vm there = gt(fill.v, splat(0.0f));
  if (!any(there)) return;
  sand grains = sand_at(p, v->grain_frequency, w->seed + 77u, s);
  out->sand = sel(there, grains.tone, out->sand);
  *lost = sel(there, grains.lost * fill.v, *lost);
  field filled = field_add(*height, field_mul(grains.height, fill));
  height->v = sel(there, filled.v, height->v);
  for (int k = 0; k < 3; k++) height->g[k] = sel(there, filled.g[k], height->g[k]);
}

/* How near a joint is, 1 in it. */
INLINE field surface_near(const stone_constants *w, int paved, const laid *q) {
  if (!paved) return field_of(splat(0.0f));
  return laid_fall(q, w->paving.half, w->weather.moss_spread);
}

/* seen: see moss_over. */
INLINE moss_shares surface_moss(const stone_constants *w, int paved, const laid *q, const vf p[3],
                                const laid_square *square, vf s, cells_covered *seen) {
  vf told = paved ? q->near : splat(1.0f);
  return moss_over(w, paved, p, square, surface_near(w, paved, q), told, s, seen);
}

/* p: object space; bed: that in the block's bed space. relief: the finish's, in
 * object space. moss: its shares, or NULL for none known yet. */
INLINE void surface_lay(const stone_constants *w, int paved, const laid *q, const vf p[3],
                        const laid_square *square, vf s, field relief, const moss_shares *moss,
                        surface *out) {
  const stone_paving *v = &w->paving;
  const stone_weather *air = &w->weather;
  vf zero = splat(0.0f), one = splat(1.0f);
  field near = surface_near(w, paved, q), buried = field_of(zero), height = relief;
  vf in_joint = zero; /* of the point, not the footprint */
  if (air->wet > 0.0f) relief = field_scale(relief, splat(1.0f - 0.5f * air->wet));
  height = relief;
  if (paved) {
    vf lost, sand_lost = zero;
    field top = field_rest(laid_fall(q, v->half, v->reach));
    if (air->wear > 0.0f) {
      field k = field_rest(field_scale(top, splat(0.75f * air->wear)));
      relief = field_mul(relief, k);
      out->lost = out->lost * k.v * k.v;
      out->polish = top.v * splat(air->wear);
    }
    laid_round round = surface_round(w, q, p, s);
    field profile = laid_profile(v, q, &round, &lost);
    field lie = laid_lie(v, q);
    height = field_add(relief, lie);
    if (v->half > 0.0f) {
      field joint = laid_fall(q, v->half - v->wall, v->wall);
      joint.v = mix(q->joint, joint.v, q->near);
      for (int k = 0; k < 3; k++) joint.g[k] = joint.g[k] * q->near;
      in_joint = joint.v;
      height = field_mul(height, field_rest(joint));
      surface_fill(w, q, p, s, &height, out, &sand_lost);
    }
    out->edge = profile.v;
    /* a chipped edge falls from as much further in */
    out->shoulder = splat(v->half + 0.5f * v->chamfer) + splat(0.35f) * round.wide.v;
    height = field_add(height, profile);
    /* moss lies as the stones do, and levels from one to the next about the joint */
    field level = field_mul(lie, field_rest(near));
    buried = field_add(height, field_scale(level, splat(-1.0f)));
    /* rounded, it may be over 1 */
    out->lost = out->lost * vmax(one - in_joint, zero) + lost + sand_lost;
    vf far = one - q->near;
    float steep = v->tilt / v->layout.width;
    vf lying = splat(steep * steep * 0.65f) * far;
    out->lost = out->lost + lying;
    out->edges = lost + sand_lost + lying;
    /* the sky that the joint's walls leave */
    vf depth = vmax(zero - profile.v, zero), reach = splat(v->half + 0.3f * v->round);
    vf slot = surface_slot(depth, q->m.v + reach, vmax(reach - q->m.v, zero) + depth * splat(0.2f));
    /* up on the stone there is the far wall alone */
    vf up = surface_slot(depth, q->m.v + reach, splat(1e6f));
    slot = mix(slot, up, smooth_step(splat(0.6f) * reach, splat(1.4f) * reach, q->m.v));
    out->occlusion = out->occlusion * mix(splat(v->occlusion), slot, q->near);
  }
  if (air->undulation > 0.0f) {
    vf unused = zero;
    height = field_add(height, weather_noise(p, air->undulation_frequency, air->seed + 9u,
                                             2.0f * air->undulation, s, &unused));
  }
  if (!air->on) {
    out->height = height;
    return;
  }
  vf exposed = near.v; /* of what is bare */
  if (air->moss > 0.0f) {
    moss_shares shares = moss ? *moss : surface_moss(w, paved, q, p, square, s, NULL);
    moss_growth growth = moss_grown(air, p, square, s);
    field cover = shares.all;
    out->moss = cover.v;
    out->moss_joint = shares.joint;
    if (paved) exposed = clamp01(shares.near / vmax(one - cover.v, splat(1e-4f)));
    out->tuft = growth.shade;
    out->dry = growth.dry;
    height = field_add(height, field_scale(field_mul(cover, growth.rise), splat(air->moss_height)));
    /* it fills the joint, up to the stones: neither edges nor sand nor how stones are tilted and
     * dressed below is seen through it */
    height = field_add(height, field_scale(field_mul(cover, buried), splat(-1.0f)));
    out->lost = out->lost * (one - cover.v) + splat(0.08f) * cover.v;
    out->edges = out->edges * (one - cover.v);
  }
  if (air->grime > 0.0f) {
    vf unused = zero;
    field cloud = weather_noise(p, 0.004f, air->seed + 5u, 1.3f, s, &unused);
    field spot = weather_noise(p, 0.05f, air->seed + 6u, 0.45f, s, &unused);
    vf dirt = splat(0.35f) + splat(0.55f) * exposed + splat(0.5f) * (cloud.v + spot.v);
    out->grime = one - splat(air->grime) * clamp01(dirt);
  }
  out->film = splat(air->wet);
  if (air->water > -999.0f) {
    /* standing water is level; at its border it bends within `soft` */
    vf soft = splat(0.15f) + splat(0.03f) * s, x = height.v - splat(air->water);
    if (paved) {
      vf spread = splat(v->settle * 0.3f + v->tilt * 0.4f + 0.5f * v->depth);
      soft = soft + spread * (one - q->near);
    }
    vf land = clamp01((x + soft) * (splat(0.5f) / soft));
    vf above = sel(lt(x, soft), soft * land * land, x);
    height = field_through(height, splat(air->water) + above, land);
    out->water = one - land;
    out->lost = out->lost * land;
    out->edges = out->edges * land;
    /* stone draws it up a little */
    vf drawn = clamp01(one - x * splat(1.0f / 3.0f)) * splat(0.8f);
    out->film = vmax(out->film, drawn);
  }
  out->height = height;
}

/* ---- light ------------------------------------------------------------- */

/* Whether the light may be less steep than what Smith's Lambda has in some lane; steep2: the
 * variance of the slopes. */
INLINE int surface_grazed(vf steep2, vf t) {
  const float much = 2.01f * SMITH_STEEPER * SMITH_STEEPER; /* a little more: rounding */
  return any(lt(t * t, splat(much) * vmax(steep2, splat(1e-8f))));
}

/* Smith's Lambda for slopes of sd `steep` under a light whose elevation has the
 * tangent t. */
INLINE vf surface_lambda(vf steep, vf t) {
  return smith_lambda(t / vmax(steep * splat(1.41421356f), splat(1e-4f)));
}

/* Variance along one axis of slopes on the stones that nobody sees. */
INLINE vf surface_leans(const surface *f) { return vmax(f->lost - f->edges, splat(0.0f)); }

/* What they leave of light that is scattered: those towards the light gain what others' shades
 * take, and what is left is that all of them lean: the mean of the normals' height, to 0.02. At the
 * stones' edges what leans is mostly joint, and dark. */
INLINE vf surface_levelled(const stone_constants *w, const surface *f) {
  vf leans = surface_leans(f), one = splat(1.0f);
  return one - leans / (one + splat(w->leaning) * leans);
}

/* Share of the light that reaches the place: past the relief about it, by where
 * in the relief's range it lies (Smith, IEEE Trans. Antennas Propag. 15, 1967:
 * an expectation, not a trace), and past the stones' edges. light: object space;
 * up: its cosine to the face given. */
INLINE vf surface_lit(const stone_constants *w, int paved, const laid *q, const surface *f, vf s,
                      const vf light[3], vf up) {
  vf zero = splat(0.0f), one = splat(1.0f);
  vf c = clamp(up, splat(1e-3f), one), t = c * inverse_root(vmax(one - c * c, splat(1e-6f)));
  vf lit = one;
  if (surface_grazed(f->steep * f->steep, t)) {
    vf lambda = surface_lambda(f->steep, t);
    lit = exp2_(lambda * log2_(clamp(f->low, splat(1e-6f), one)));
  }
  if (!paved) return lit;
  const stone_paving *v = &w->paving;
  vf square = q->m.g[0] * q->m.g[0] + q->m.g[1] * q->m.g[1];
  vf across =
      (light[0] * q->m.g[0] + light[1] * q->m.g[1]) * inverse_root(vmax(square, splat(1e-6f)));
  vf shoulder = f->shoulder;
  vf crest = splat(-0.42f * v->drop - 0.5f * v->slope * v->chamfer);
  vf way = sel(lt(across, zero), shoulder + q->m.v, shoulder - q->m.v);
  /* where joints meet all stones may be further away */
  way = way + vmax(zero - (q->edge + splat(v->half)), zero);
  vf rise = c / vmax(vabs(across), splat(1e-3f));
  vf over = f->edge * (one - f->moss) + way * rise - crest;
  vf soft = splat(0.1f) + splat(0.01f) * vabs(way) + splat(0.6f) * s * (rise + splat(0.3f));
  vf past = clamp01(splat(0.5f) + over / soft);
  past = sel(gt(way, zero), past, one);
  /* where moss fills the joint its edges cast nothing; under a footprint that has the far edge,
   * too, what is lit there makes up for it */
  vf trough = splat(2.0f) * shoulder;
  vf alone = one - smooth_step(splat(0.25f) * trough, trough, s);
  return lit * mix(one, past, q->near * alone * (one - f->moss));
}

#endif
