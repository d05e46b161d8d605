/* SPDX-License-Identifier: Apache-2.0
 *
 * Stone's evaluate: compiled once for each instruction set and width.
 */
#include <string.h>

#include "../core/directions.h"
#include "../core/lanes.h"
#include "fabric.h"
#include "gloss.h"
#include "means.h"
#include "paper.h"

extern const stone_kernel KERNEL_NAME(stone_kernel_);

/* What the stages read and write. */
typedef struct {
  const sozai_batch *in;
  float *out[STONE_COMPONENTS]; /* from the first point of the first block on; none is NULL */
} stone_io;

/* Asked for or not: a store costs less than to ask. */
INLINE void put(const stone_io *io, const block *k, int channel, vf x) {
  store(io->out[channel] + k->o, x);
}

/* The square's sides: the two axes of bed space nearest to the surface, the
 * first of them laid down on it. */
INLINE void square_sides(const vf n[3], vf t1[3], vf t2[3]) {
  vf ax = vabs(n[0]), ay = vabs(n[1]), az = vabs(n[2]), zero = splat(0.0f);
  vm x_least = and_(le(ax, ay), le(ax, az)), x_most = and_(not_(le(ax, ay)), not_(le(ax, az)));
  /* x unless the normal is along it, then y */
  vm use_x = or_(x_least, not_(x_most));
  vf a = sel(use_x, n[0], n[1]);
  vf k = inverse_root(vmax(splat(1.0f) - a * a, splat(1e-6f)));
  t1[0] = (sel(use_x, splat(1.0f), zero) - a * n[0]) * k;
  t1[1] = (sel(use_x, zero, splat(1.0f)) - a * n[1]) * k;
  t1[2] = (zero - a * n[2]) * k;
  cross3(n, t1, t2);
}

/* The face given, or without one what leans alike against every axis. */
INLINE void stage_face(const stone_io *io, int number, block *k) {
  k->facing = number && (io->in->normal[0] ? as_before(io->in->normal, k->i, k->n) : 1);
  if (k->facing) {
    copy3(k[-1].face, k->face);
    return;
  }
  for (int c = 0; c < 3; c++) k->face[c] = splat(0.57735027f);
  if (!io->in->normal[0]) return;
  for (int c = 0; c < 3; c++) k->face[c] = load_lanes(io->in->normal[c], k->i, k->n);
  unit_direction(k->face);
}

/* number: of the block, among those on their way. */
INLINE void stage_load(const stone_constants *w, int paved, const stone_io *io, int number,
                       block *k) {
  k->alike = number;
  for (int c = 0; c < 3; c++)
    k->at[c] = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n));
  k->s = splat(0.0f);
  if (io->in->footprint) {
    k->s = clamp(load_lanes(io->in->footprint, k->i, k->n), splat(0.0f), splat(1e4f));
  }
  stage_face(io, number, k);
  copy3(k->at, k->p);
  if (paved) {
    copy3(k->face, k->nrm);
    square_sides(k->nrm, k->t1, k->t2);
    laid_at(w, k->at, io->in->normal[0] ? k->face : NULL, k->t1, k->t2, k->s, &k->laid);
    laid_turn(&k->laid, k->p);
    laid_turn(&k->laid, k->nrm);
    for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + k->laid.shift[c];
  } else {
    for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + splat(w->offset[c]);
  }
  exchange(w, k->p);
  /* blocks whose footprints lie alike, as on flat ground they do, share what is made of them */
  int same = k->facing;
  if (paved || !same) {
    if (!paved) copy3(k->face, k->nrm);
    exchange(w, k->nrm);
    same = number && same_lanes(k->nrm, k[-1].nrm, 3);
    if (!same) square_sides(k->nrm, k->t1, k->t2);
  }
  if (!same) return;
  const block *before = &k[-1];
  copy3(before->nrm, k->nrm);
  copy3(before->t1, k->t1);
  copy3(before->t2, k->t2);
  if (same_lanes(&k->s, &before->s, 1)) k->alike = before->alike;
}

STAGE void stage_paper(const stone_constants *w, block *k) {
  vf sum[4], zero = splat(0.0f), one = splat(1.0f);
  const vf x[3] = {one, zero, zero}, y[3] = {zero, one, zero};
  if (w->tile.on)
    paper_at(w, k->at, x, y, k->s, sum);
  else
    paper_at(w, k->p, k->t1, k->t2, k->s, sum);
  for (int c = 0; c < 3; c++) k->albedo[c] = sum[c];
  k->speck = sum[3];
  k->hole = k->inclusion = splat(0.0f);
}

/* The number of the crystal at the point itself, its faces as bent as the colour has
 * them: the same whether that is asked for or not. */
STAGE void stage_grain(const stone_constants *w, const stone_io *io, block *k) {
  const stone_cells *c = &w->layer[LAYER_GRAINS];
  if (!k->crystal_known) {
    cells_view view;
    cells_eye eye = {.view = &view};
    cells_look look = {.eye = &eye};
    view_open(c, k->t1, k->t2, k->s, &view);
    look_place(c, k->p, &look);
    looks_bend(c, &look, 1);
    look.empty = 0;
    looks_find(c, &look, 1);
    k->crystal = look.near[0].h;
  }
  vu h = hash_mix(k->crystal + splatu(HASH_Z));
  put(io, k, STONE_GRAIN, to_float((vi)(h >> 8)) * splat(1.0f / 16777216.0f));
}

INLINE void stage_height(const stone_io *io, block *k) {
  const surface *q = &k->surface;
  put(io, k, STONE_HEIGHT, q->height.v);
  put(io, k, STONE_MOSS, q->moss);
  put(io, k, STONE_WET, vmax(q->film, q->water));
  put(io, k, STONE_OCCLUSION, q->occlusion);
}

/* Inclusions over the relief. Those that stand out are as smooth as water has left them. square:
 * of the height, its variance. */
INLINE field stage_raise(const stone_constants *w, block *k, field relief, vf *square) {
  surface *q = &k->surface;
  const stone_cells *c = &w->layer[LAYER_INCLUSIONS];
  const height_form form = {c, 1, 1.0f, w->dome_mean, w->dome_steep};
  vf lost = splat(0.0f), high = splat(w->raise);
  field dome = bodies_height(&form, k->p, k->t1, k->t2, k->s, k->inclusion, &k->inclusions, &lost);
  if (w->raise > 0.0f) {
    field rough = field_rest(field_scale(dome, splat(DOME_SMOOTH)));
    relief = field_mul(relief, rough);
    q->lost = q->lost * rough.v * rough.v;
    *square = *square * rough.v * rough.v;
  }
  q->lost = q->lost + high * high * lost;
  *square = *square + splat(w->raise_sd * w->raise_sd);
  return field_add(relief, field_scale(dome, high));
}

/* The finish's relief, and the inclusions' over it. */
INLINE void stage_relief(const stone_constants *w, int paved, block *k) {
  surface *q = &k->surface;
  *q = surface_none();
  if (w->tile.on) {
    k->relief = tile_relief(w, k->at, k->s, &q->lost);
    return;
  }
  const relief_place o = {k->p, k->t1, k->t2, k->nrm, k->s, paved};
  k->relief.v = relief_at(w, &o, k->relief.g, &q->lost, &q->low, &q->steep);
  if (w->raise != 0.0f) k->relief = stage_raise(w, k, k->relief, &q->low);
}

/* Where in the relief's range the place lies; until then q->low is its variance, and q->steep that
 * of all slopes. */
INLINE void stage_hollow(const stone_constants *w, block *k) {
  surface *q = &k->surface;
  q->low = surface_below((k->relief.v - splat(w->raise_mean)) * inverse_root(q->low));
  vf one = splat(1.0f), hollow = splat(w->hollow);
  if (w->is_cleft) hollow = clamp01(splat(HOLLOW) * vsqrt(q->steep));
  q->steep = vsqrt(vmax(q->steep - q->lost, splat(0.0f)));
  vf seen = clamp01(splat(HOLLOW) * q->steep);
  hollow = seen * (one - q->low) + (hollow - seen) * splat(w->hollow_deep);
  q->occlusion = one - splat(0.6f) * hollow;
}

INLINE void stage_surface(const stone_constants *w, int paved, const stone_io *io, block *k) {
  surface *q = &k->surface;
  laid_square sides;
  const moss_shares *moss = k->mossed ? &k->moss : NULL;
  if (w->weather.moss > 0.0f) stage_square(w, paved, k, &sides);
  if (w->tile.on) {
    surface_lay(w, 0, &k->laid, k->at, &sides, k->s, k->relief, moss, q);
    stage_height(io, k);
    return;
  }
  if (w->layer[LAYER_HOLES].on && w->hole_depth > 0.0f) {
    const stone_cells *c = &w->layer[LAYER_HOLES];
    const height_form bowl = {c, 0, w->hole_depth, -0.1f * w->hole_depth, w->hole_depth / c->size};
    k->relief = field_add(
        k->relief, bodies_height(&bowl, k->p, k->t1, k->t2, k->s, k->hole, &k->holes, &q->lost));
  }
  from_bed(w, paved, k, k->relief.g);
  surface_lay(w, paved, &k->laid, k->at, &sides, k->s, k->relief, moss, q);
  stage_height(io, k);
}

/* Light grains are greyer, and dark ones browner, than all together. */
INLINE vf joint_albedo(const stone_paving *v, int c, vf sand) {
  const float *all = v->colour, grey = (all[0] + all[1] + all[2]) / 3.0f;
  return splat(all[c]) + splat(0.5f * (all[c] + grey)) * sand;
}

/* What lies on the stone, and in its joints, over its colour. */
INLINE void stage_cover(const stone_constants *w, int paved, block *k) {
  const surface *q = &k->surface;
  const stone_weather *air = &w->weather;
  vf one = splat(1.0f), joint = splat(0.0f);
  if (paved) joint = k->laid.joint;
  /* what the moss has left of the joint, and of the stone; of the joint it takes more */
  vf bare = one - q->moss, open = vmin(joint * (one - q->moss_joint), bare);
  vf stone = bare - open;
  /* water darkens what it fills: a polished face has next to nothing open, joint and moss have */
  vf soaks = mix(one, splat(w->soaks), stone);
  /* where crystals or bodies were looked at in parts, how they lie under it is known */
  const int hides = k->mixed[OVER_MOSS];
  for (int c = 0; c < 3; c++) {
    vf a = k->albedo[c];
    if (paved) a = stone * (a * k->laid.tone[c]) + open * joint_albedo(&w->paving, c, q->sand);
    if (air->on) {
      if (!paved) a = a * bare;
      if (hides) {
        vf more = k->moss_hides[c] * (paved ? k->laid.tone[c] * (one - joint) : one);
        a = vmax(a - more, vmin(a, splat(0.0f)));
      }
      /* dust and soot, which are darker than most stones and browner */
      static const float dirt[3] = {0.066f, 0.058f, 0.048f};
      a = a * q->grime + splat(dirt[c]) * (splat(1.0f) - q->grime);
      /* what is dry is browner, and paler */
      static const float dry[3] = {1.45f, 1.05f, 0.75f};
      vf cushion = splat(air->moss_colour[c]) * (splat(0.79f) + q->tuft);
      cushion = cushion * mix(one, splat(dry[c]), q->dry);
      a = a + q->moss * vmax(cushion, splat(0.0f));
      a = weather_wet_albedo(a, vmax(q->film, q->water) * soaks);
    }
    k->albedo[c] = a;
  }
  k->speck = k->speck * stone;
  if (hides >> LAYER_SPECKS & 1)
    k->speck = vmax(k->speck - k->moss_hides_specks * (one - joint), splat(0.0f));
}

/* The variance of slopes, along one axis, that the gloss is as wide as. Holes have none, and so
 * theirs do not dull what is between them. */
INLINE vf stage_glossy_slopes(const stone_constants *w, const block *k) {
  vf lost = k->surface.lost;
  if (w->tile.on || !w->layer[LAYER_HOLES].on || w->hole_depth <= 0.0f) return lost;
  float size = w->layer[LAYER_HOLES].size;
  vf holes = bodies_lost(w->hole_depth / size, bodies_kept(size, k->s), k->hole);
  return vmax(lost - holes, splat(0.0f));
}

INLINE void stage_light(const stone_constants *w, int paved, const stone_io *io, block *k,
                        int radiance) {
  const surface *q = &k->surface;
  vf n[3], zero = splat(0.0f), one = splat(1.0f);
  vf along = dot3(q->height.g, k->face);
  for (int c = 0; c < 3; c++) n[c] = k->face[c] - (q->height.g[c] - along * k->face[c]);
  vf l = inverse_root(vmax(dot3(n, n), splat(1e-12f)));
  for (int c = 0; c < 3; c++) n[c] = n[c] * l;
  for (int c = 0; c < 3; c++) put(io, k, STONE_NORMAL + c, n[c]);
  vf alpha2 = splat(w->alpha2), specular = splat(w->specular) * (one - k->hole);
  if (paved) {
    /* worn stone is polished towards an alpha of 0.25; what fills joints is matt */
    alpha2 = mix(alpha2, vmin(alpha2, splat(0.0625f)), q->polish * splat(0.8f));
    alpha2 = mix(alpha2, splat(0.9f), k->laid.joint);
    specular = mix(specular, splat(0.02f), k->laid.joint);
  }
  if (w->weather.on) {
    alpha2 = mix(alpha2, one, q->moss);
    specular = specular * (one - q->moss);
    vf gloss = smooth_step(splat(0.3f), one, q->film) * (one - splat(0.8f) * q->moss);
    gloss = vmax(gloss * splat(0.9f), q->water);
    /* a film evens out what is rougher; what is smoother stays so under it */
    alpha2 = mix(alpha2, vmin(alpha2, mix(splat(0.01f), splat(0.0004f), q->water)), gloss);
    specular =
        mix(specular, splat(0.0204f + w->specular_wet), gloss); /* water's, and what is below */
  }
  alpha2 = vmin(alpha2 + splat(2.0f) * stage_glossy_slopes(w, k), one);
  put(io, k, STONE_ROUGHNESS, vsqrt(alpha2));
  put(io, k, STONE_SPECULAR, specular);
  if (!radiance) return;
  vf below;
  const vf *light = k->light, *view = k->view;
  if (k->o && as_before(io->in->light, k->i, k->n))
    copy3(k[-1].light, k->light);
  else
    direction_of(io->in->light, k->i, k->n, k->face, 0, k->light);
  if (k->o && k->facing && as_before(io->in->view, k->i, k->n))
    copy3(k[-1].view, k->view);
  else
    direction_of(io->in->view, k->i, k->n, k->face, 1, k->view);
  vf lobe =
      gloss_lobe(n, light, view, alpha2, specular, splat(w->glancing) * surface_leans(q), &below);
  below = below * surface_levelled(w, q);
  /* light from behind the sawn face lights no slope of it */
  vf up = dot3(light, k->face);
  vm front = gt(up, zero);
  vf lit = surface_lit(w, paved, &k->laid, q, k->s, light, up);
  for (int c = 0; c < 3; c++) {
    vf r = sel(front, (below * k->albedo[c] + lobe) * lit, zero);
    if (io->in->light_colour[c]) {
      vf e = load_lanes(io->in->light_colour[c], k->i, k->n);
      r = r * sel(lt(vabs(e), splat(1e30f)), e, zero);
    }
    put(io, k, STONE_RADIANCE + c, r);
  }
}

/* The stone's own channels. */
INLINE void stage_laid(const stone_constants *w, int paved, const stone_io *io, block *k) {
  vf zero = splat(0.0f);
  const laid *q = &k->laid;
  vf joint = paved ? q->joint : zero;
  if (w->tile.on) {
    vf f = splat(w->inverse_texel);
    joint = tile_joint(&w->tile, k->at[0] * f, k->at[1] * f, k->s * f);
  }
  put(io, k, STONE_JOINT, joint);
  put(io, k, STONE_ID, paved ? layout_number(q->unit.id) : zero);
  put(io, k, STONE_U, paved ? q->unit.u : zero);
  put(io, k, STONE_V, paved ? q->unit.v : zero);
  put(io, k, STONE_EDGE, paved ? q->edge : zero);
}

/* What has been asked for, and the stages that it takes. */
typedef struct {
  int radiance, normal, surface, hollows, fabric, colour, grain, cover;
} stone_wants;

static stone_wants wants_of(const stone_constants *w, const kernel_io *io) {
  stone_wants q;
  q.radiance = kernel_wants(io, STONE_RADIANCE, 3);
  const int speck = kernel_wants(io, STONE_SPECK, 1), weathered = w->weather.on,
            paved = w->paving.layout.kind != LAYOUT_NONE,
            hollow = w->layer[LAYER_HOLES].on || w->raise != 0.0f;
  const int coloured = kernel_wants(io, STONE_ALBEDO, 3) || q.radiance || speck;
  q.normal =
      kernel_wants(io, STONE_NORMAL, 3) || kernel_wants(io, STONE_ROUGHNESS, 2) || q.radiance;
  q.hollows = kernel_wants(io, STONE_OCCLUSION, 1) || q.radiance;
  q.surface = q.normal || kernel_wants(io, STONE_HEIGHT, 1) || kernel_wants(io, STONE_MOSS, 3) ||
              ((paved || weathered) && coloured);
  q.colour = coloured || (hollow && q.surface);
  q.cover = q.colour && q.surface && (paved || weathered);
  q.fabric = q.colour && w->mode == 0;
  q.grain = kernel_wants(io, STONE_GRAIN, 1);
  return q;
}

INLINE void evaluate_as(int paved, const stone_constants *w, const stone_io *io,
                        const stone_wants *want, block *blocks, int count) {
  for (int b = 0; b < count; b++) {
    block *k = &blocks[b];
    k->crystal_known = k->mossed = 0;
    k->mixed[OVER_MOSS] = 0;
    k->square = io->in->normal[0] != NULL;
    bends_none(&k->bends);
    k->holes.bent = k->holes.met = k->inclusions.bent = k->inclusions.met = 0;
    stage_load(w, paved, io, b, k);
    stage_laid(w, paved, io, k);
  }
  const int mossy = want->cover && w->weather.moss > 0.0f && !w->tile.on;
  if (want->fabric) stage_cells(w, paved, mossy, blocks, count);
  for (int b = 0; b < count; b++) {
    block *k = &blocks[b];
    if (want->fabric)
      stage_fabric(w, k);
    else if (want->colour)
      stage_paper(w, k);
    else
      k->hole = k->inclusion = splat(0.0f);
  }
  if (want->surface) {
    for (int b = 0; b < count; b++) stage_relief(w, paved, &blocks[b]);
    for (int b = 0; b < count && want->hollows && !w->tile.on; b++) stage_hollow(w, &blocks[b]);
    for (int b = 0; b < count; b++) stage_surface(w, paved, io, &blocks[b]);
  }
  for (int b = 0; b < count; b++) {
    block *k = &blocks[b];
    if (want->cover) stage_cover(w, paved, k);
    if (want->colour) {
      for (int c = 0; c < 3; c++) put(io, k, STONE_ALBEDO + c, k->albedo[c]);
      put(io, k, STONE_SPECK, k->speck);
    }
    if (want->grain) stage_grain(w, io, k);
  }
  if (want->normal) {
    for (int b = 0; b < count; b++) stage_light(w, paved, io, &blocks[b], want->radiance);
  }
}

/* Twice in the code: a block that is one piece pays nothing for paving. */
static __attribute__((noinline)) void evaluate_piece(const stone_constants *w, const stone_io *io,
                                                     const stone_wants *want, block *blocks,
                                                     int count) {
  evaluate_as(0, w, io, want, blocks, count);
}
static __attribute__((noinline)) void evaluate_paved(const stone_constants *w, const stone_io *io,
                                                     const stone_wants *want, block *blocks,
                                                     int count) {
  evaluate_as(1, w, io, want, blocks, count);
}
INLINE void evaluate_blocks(const stone_constants *w, const stone_io *io, const stone_wants *want,
                            block *blocks, int count) {
  if (w->paving.layout.kind != LAYOUT_NONE)
    evaluate_paved(w, io, want, blocks, count);
  else
    evaluate_piece(w, io, want, blocks, count);
}

/* The end of a batch, less than a block: by a detour, so that blocks need not ask which points are
 * to be written. k: the block. */
static __attribute__((noinline)) void evaluate_some(const stone_constants *w, const kernel_io *io,
                                                    const stone_wants *want, block *k) {
  float room[STONE_COMPONENTS][LANES];
  stone_io part = {.in = io->in};
  for (int c = 0; c < STONE_COMPONENTS; c++) part.out[c] = room[c];
  evaluate_blocks(w, &part, want, k, 1);
  for (int c = 0; c < STONE_COMPONENTS; c++) {
    if (io->wanted >> c & 1) memcpy(io->out[c] + k->i, room[c], k->n * sizeof(float));
  }
}

INLINE void block_at(block *k, uint32_t i, uint32_t n, uint32_t first) {
  k->i = i;
  k->n = n;
  k->o = i - first;
}

static void evaluate(const void *constants, const kernel_io *io, uint32_t from, uint32_t to) {
  const stone_constants *w = constants;
  const stone_wants want = wants_of(w, io);
  block blocks[STONE_BLOCKS];
  float spare[STONE_BLOCKS * LANES]; /* where components go that nobody asked for */
  stone_io part = {.in = io->in};
  for (uint32_t i = from; i < to;) {
    uint32_t first = i;
    int count = 0;
    for (; count < STONE_BLOCKS && to - i >= LANES; count++, i += LANES)
      block_at(&blocks[count], i, LANES, first);
    if (!count) {
      block_at(blocks, i, to - i, i);
      evaluate_some(w, io, &want, blocks);
      return;
    }
    for (int c = 0; c < STONE_COMPONENTS; c++)
      part.out[c] = io->wanted >> c & 1 ? io->out[c] + first : spare;
    evaluate_blocks(w, &part, &want, blocks, count);
  }
}

const stone_kernel KERNEL_NAME(stone_kernel_) = {KERNEL_OF(evaluate), measure, measure_laid,
                                                 scan_tile};
