/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood's evaluate: compiled once for each instruction set and width.
 *
 * A block of points goes through stages/ from load.h (where it is in a log) by stem.h, knots.h and
 * rings.h (its year), grain.h, direction.h and footprint.h (its fibre and the reference section),
 * fibre.h, vessels.h, rays.h, canals.h and cells.h (what grows there) to colour.h or picture.h,
 * surface.h, and kawai.h or cone.h (how it is lit). Here they are called.
 */
#include <string.h>

#include "radius.h"
#include "stages/canals.h"
#include "stages/cells.h"
#include "stages/colour.h"
#include "stages/cone.h"
#include "stages/direction.h"
#include "stages/fibre.h"
#include "stages/grain.h"
#include "stages/kawai.h"
#include "stages/load.h"
#include "stages/parenchyma.h"
#include "stages/picture.h"
#include "stages/rays.h"
#include "stages/rings.h"
#include "stages/stem.h"
#include "stages/surface.h"
#include "stages/vessels.h"
#include "stages/wants.h"

extern const wood_kernel KERNEL_NAME(wood_kernel_);

#define EACH(...)                                                                                  \
  for (uint32_t k = 0; k < count; k++) __VA_ARGS__

/* restrict, from here on: what is stored is no constant, so that those are loaded before the
 * loops and not in them. */

/* One layer of rays, after the turn. */
INLINE void evaluate_rays(const wood_constants *restrict w, int boards, int layer,
                          const wood_io *restrict io, block *blocks, uint32_t count) {
  if (layer) EACH(stage_ray_again(w, &blocks[k]));
  EACH(stage_ray_shell(w, boards, layer, &blocks[k]));
  EACH(ray_cell_at(w, &blocks[k].ray_at));
  EACH(stage_ray_seat(w, boards, layer, &blocks[k]));
  EACH(stage_ray_body(w, boards, layer, &blocks[k]));
  EACH(stage_rays(w, boards, layer, io, &blocks[k]));
}

#if LANES == 1
/* For a point alone in another order: the chain from the turn through the rays is the longest,
 * and what does not wait for it stands between its steps, where the processor sees both. */
INLINE void evaluate_one(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                         const wood_wants *restrict want, block *k, rings_room *room) {
  board_sawn sawn;
  if (boards) memset(&sawn, 0, sizeof sawn);
  stage_load(w, boards, io, want, &sawn, k);
  stage_pith(w, boards, k);
  if (want->radiance && !want->relief) {
    stage_light(w, boards, io, k);
    stage_incident(k);
  }
  stage_about(k);
  stage_undulations(w, boards, k);
  if (w->has_curl || w->has_quilt || w->has_eyes) stage_figure(w, boards, k);
  stage_rho(w, k);
  if (w->knots) {
    stage_knots(w, io, boards && !w->peeled ? knot_shift(k) : splat(0.0f), k);
  } else {
    store_lanes(io, WOOD_KNOT, k, splat(0.0f));
  }
  stage_ring_find(w, k);
  stage_ring(w, io, k);
  if (want->section) {
    stage_years(w, boards, k);
    if (w->has_wave) stage_wave(w, k);
    if (w->has_interlocked) stage_interlocked(w, boards, k);
    if (w->has_slope_noise) stage_grain_noises(w, boards, k);
    stage_turn(k);
    stage_section(w, io, k);
    stage_bolt(k);
  }
  if ((want->vessel || want->relief) && place_has_turn(w)) stage_turns(k);
  int rays = want->vessel && w->has_rays;
  if (want->direction) {
    stage_fibre(k);
    stage_direction(w, boards, io, want, k);
  }
  if (want->late) {
    stage_reach(w, boards, io, k);
    stage_curved(w, boards, io, want, k, &room->curved);
    if (has_bent_boards(w, boards)) stage_wide(w, boards, io, k, &room->wide);
    if (want->vessel || want->bundle) stage_section_footprint(w, boards, io, k);
    if (rays) stage_ray_turn(w, boards, k);
    if (want->bundle) stage_bundles(w, boards, k);
    if (want->bundle && w->drift > 0.0f) stage_drift(w, boards, k);
    if (rays) {
      stage_ray_shell(w, boards, 0, k);
      ray_cell_at(w, &k->ray_at);
    }
    if (w->has_front) stage_stray(w, k);
    stage_rings(w, boards, io, k);
  }
  if (rays) stage_ray_seat(w, boards, 0, k);
  if (want->relief && w->bands.on) stage_bands(w, boards, k);
  if (want->vessel) {
    stage_vessel_parts(w, boards, k);
    stage_disc(w, boards, k);
    if (w->parenchyma.sheaths) {
      stage_sheathed_pores(w, boards, w->bands.on, k);
    } else if (w->bands.on) {
      stage_banded_pores(w, boards, k);
    } else {
      stage_pores(w, boards, k);
    }
    if (rays) stage_ray_body(w, boards, 0, k);
  }
  if (!want->relief) {
    if (want->lobe) stage_lobe(w, boards, io, k);
    if (want->radiance) {
      stage_tilt(k);
      if (!w->cone) stage_gloss(k);
    }
  }
  if (want->vessel) {
    stage_rows(w, boards, k);
    stage_cover(w, boards, io, k);
    if (w->parenchyma.on) stage_parenchyma(w, boards, io, k);
    if (rays) {
      stage_rays(w, boards, 0, io, k);
      if (w->ray_layers > 1) evaluate_rays(w, boards, 1, io, k, 1);
    }
  }
}
#else

/* To the stem, and the year. */
INLINE void evaluate_stem(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                          const wood_wants *restrict want, block *blocks, uint32_t count) {
  board_sawn sawn;
  if (boards) memset(&sawn, 0, sizeof sawn);
  EACH(stage_load(w, boards, io, want, &sawn, &blocks[k]));
  EACH(stage_pith(w, boards, &blocks[k]));
  undulation_octave octaves[2] = {undulation_octave_of(w, 0), undulation_octave_of(w, 1)};
  EACH({
    stage_about(&blocks[k]);
    stage_undulation(&octaves[0], boards, &blocks[k]);
  });
  EACH(stage_undulation(&octaves[1], boards, &blocks[k]));
  if (w->has_curl || w->has_quilt || w->has_eyes) EACH(stage_figure(w, boards, &blocks[k]));
  EACH(stage_rho(w, &blocks[k]));
  if (w->knots) {
    EACH(stage_knots(w, io, boards && !w->peeled ? knot_shift(&blocks[k]) : splat(0.0f),
                     &blocks[k]));
  } else {
    EACH(store_lanes(io, WOOD_KNOT, &blocks[k], splat(0.0f)));
  }
  EACH(stage_ring_find(w, &blocks[k]));
  EACH(stage_ring(w, io, &blocks[k]));
}

/* From there to the reference section. */
INLINE void evaluate_section(int boards, const wood_constants *restrict w,
                             const wood_io *restrict io, block *blocks, uint32_t count) {
  EACH(stage_years(w, boards, &blocks[k]));
  if (w->has_wave) EACH(stage_wave(w, &blocks[k]));
  if (w->has_interlocked) EACH(stage_interlocked(w, boards, &blocks[k]));
  if (w->has_slope_noise) {
    grain_octave slopes[2] = {grain_octave_of(w, 0), grain_octave_of(w, 1)};
    EACH(stage_grain_noise(&slopes[0], boards, 0, &blocks[k]));
    EACH(stage_grain_noise(&slopes[1], boards, 1, &blocks[k]));
  }
  EACH(stage_turn(&blocks[k]));
  EACH(stage_section(w, io, &blocks[k]));
  EACH(stage_bolt(&blocks[k]));
}

/* Latewood under the footprint, and the fibres' brightness that it strays with. */
INLINE void evaluate_late(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                          const wood_wants *restrict want, block *blocks, rings_room *rooms,
                          uint32_t count) {
  EACH({
    stage_reach(w, boards, io, &blocks[k]);
    stage_curved(w, boards, io, want, &blocks[k], &rooms[k].curved);
  });
  if (has_bent_boards(w, boards)) EACH(stage_wide(w, boards, io, &blocks[k], &rooms[k].wide));
  if (want->vessel || want->bundle) EACH(stage_section_footprint(w, boards, io, &blocks[k]));
  if (want->bundle) {
    UNROLL(3)
    for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
      fibre_octave octave = fibre_octave_of(w, o);
      EACH(stage_bundle(&octave, boards, o, &blocks[k]));
    }
    if (w->drift > 0.0f) EACH(stage_drift(w, boards, &blocks[k]));
  }
  if (w->has_front) EACH(stage_stray(w, &blocks[k]));
  EACH(stage_rings(w, boards, io, &blocks[k]));
}

/* Vessels and rays. */
INLINE void evaluate_vessels(int boards, const wood_constants *restrict w,
                             const wood_io *restrict io, block *blocks, uint32_t count) {
  EACH(stage_vessel_parts(w, boards, &blocks[k]));
  EACH(stage_disc(w, boards, &blocks[k]));
  if (w->parenchyma.sheaths && w->bands.on) {
    EACH(stage_sheathed_pores(w, boards, 1, &blocks[k]));
  } else if (w->parenchyma.sheaths) {
    EACH(stage_sheathed_pores(w, boards, 0, &blocks[k]));
  } else if (w->bands.on) {
    EACH(stage_banded_pores(w, boards, &blocks[k]));
  } else {
    EACH(stage_pores(w, boards, &blocks[k]));
  }
  EACH(stage_rows(w, boards, &blocks[k]));
  if (w->parenchyma.on) {
    EACH({
      stage_cover(w, boards, io, &blocks[k]);
      stage_parenchyma(w, boards, io, &blocks[k]);
    });
  } else {
    EACH(stage_cover(w, boards, io, &blocks[k]));
  }
  if (w->has_rays) {
    EACH(stage_ray_turn(w, boards, &blocks[k]));
    evaluate_rays(w, boards, 0, io, blocks, count);
    if (w->ray_layers > 1) evaluate_rays(w, boards, 1, io, blocks, count);
  }
}

INLINE void evaluate_many(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                          const wood_wants *restrict want, block *blocks, rings_room *rooms,
                          uint32_t count) {
  evaluate_stem(boards, w, io, want, blocks, count);
  if (want->section) evaluate_section(boards, w, io, blocks, count);
  if (want->direction) {
    EACH(stage_fibre(&blocks[k]));
    EACH(stage_direction(w, boards, io, want, &blocks[k]));
  }
  if (want->late) evaluate_late(boards, w, io, want, blocks, rooms, count);
  if ((want->vessel || want->relief) && place_has_turn(w)) EACH(stage_turns(&blocks[k]));
  if (want->relief && w->bands.on) EACH(stage_bands(w, boards, &blocks[k]));
  if (want->vessel) evaluate_vessels(boards, w, io, blocks, count);
}
#endif

/* What else has a colour, the colour of all, and the surface that it is seen on. */
INLINE void evaluate_colour(int boards, const wood_constants *restrict w,
                            const wood_io *restrict io, const wood_wants *restrict want,
                            block *blocks, surface_relief *reliefs, uint32_t count) {
  if (w->has_canals && want->vessel) EACH(stage_canals(w, boards, io, &blocks[k]));
  if (want->vessel && !w->has_canals) EACH(store_lanes(io, WOOD_CANAL, &blocks[k], splat(0.0f)));
  if (want->vessel && !w->parenchyma.on) {
    EACH(store_lanes(io, WOOD_PARENCHYMA, &blocks[k], splat(0.0f)));
  }
  if (want->colour && w->has_cells && !want->picture) EACH(stage_cells(w, boards, &blocks[k]));
  if (want->colour && w->has_spalt && !want->picture) EACH(stage_spalt(w, boards, io, &blocks[k]));
  /* of which the relief shades some */
  if (want->radiance && want->relief) EACH(stage_light(w, boards, io, &blocks[k]));
  if (want->picture) {
    EACH(stage_picture(w, boards, io, &blocks[k]));
    if (want->relief) EACH(stage_relief(w, boards, io, want, &blocks[k], &reliefs[k]));
  } else {
    if (want->relief) EACH(stage_relief(w, boards, io, want, &blocks[k], &reliefs[k]));
    if (want->colour && w->has_pigment) EACH(stage_pigment(w, boards, &blocks[k]));
    if (want->colour && w->streaks.share > 0.0f) EACH(stage_streaks(w, boards, &blocks[k]));
    if (want->colour) EACH(stage_colour(w, boards, io, &blocks[k]));
  }
  if (want->relief) EACH(stage_bump(w, boards, io, &blocks[k], &reliefs[k]));
}

/* The cone, the lobe and the radiance. lit: lobe and light have been seen to before the rays, as
 * of a point alone. */
INLINE void evaluate_light(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                           const wood_wants *restrict want, int lit, block *blocks,
                           uint32_t count) {
  if (want->cone) EACH(stage_cone(w, io, &blocks[k]));
  if (want->lobes) EACH(stage_lobes(w, boards, io, &blocks[k]));
  if (want->lobe && !lit) EACH(stage_lobe(w, boards, io, &blocks[k]));
  if (!want->radiance) return;
  if (!lit) {
    EACH({
      if (!want->relief) stage_light(w, boards, io, &blocks[k]);
      stage_incident(&blocks[k]);
      stage_tilt(&blocks[k]);
    });
  }
  if (w->cone) {
    EACH(stage_cone_radiance(w, boards, io, &blocks[k]));
  } else {
    if (!lit) EACH(stage_gloss(&blocks[k]));
    EACH(stage_radiance(w, boards, io, &blocks[k]));
  }
}

INLINE void evaluate_as(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                        const wood_wants *restrict want, block *blocks, surface_relief *reliefs,
                        rings_room *rooms, uint32_t count) {
#if LANES == 1
  int lit = !want->relief;
  evaluate_one(boards, w, io, want, &blocks[0], &rooms[0]);
#else
  int lit = 0;
  evaluate_many(boards, w, io, want, blocks, rooms, count);
#endif
  evaluate_colour(boards, w, io, want, blocks, reliefs, count);
  evaluate_light(boards, w, io, want, lit, blocks, count);
}

/* Twice in the code, with boards and without: a wood that is one piece pays
 * nothing for them. */
static __attribute__((noinline)) void evaluate_piece(const wood_constants *restrict w,
                                                     const wood_io *restrict io,
                                                     const wood_wants *restrict want, block *blocks,
                                                     surface_relief *reliefs, rings_room *rooms,
                                                     uint32_t count) {
  evaluate_as(0, w, io, want, blocks, reliefs, rooms, count);
}

static __attribute__((noinline)) void evaluate_boards(const wood_constants *restrict w,
                                                      const wood_io *restrict io,
                                                      const wood_wants *restrict want,
                                                      block *blocks, surface_relief *reliefs,
                                                      rings_room *rooms, uint32_t count) {
  evaluate_as(1, w, io, want, blocks, reliefs, rooms, count);
}

typedef struct {
  block blocks[BLOCKS];
  surface_relief reliefs[BLOCKS];
  knot_place knots[BLOCKS];
  rings_room rooms[BLOCKS];
  wood_held held;
} wood_blocks;

INLINE void evaluate_blocks(const wood_constants *w, const wood_io *io, const wood_wants *want,
                            int boards, wood_blocks *b, uint32_t count) {
  if (boards) {
    evaluate_boards(w, io, want, b->blocks, b->reliefs, b->rooms, count);
  } else {
    evaluate_piece(w, io, want, b->blocks, b->reliefs, b->rooms, count);
  }
}

INLINE void block_at(const wood_constants *w, wood_blocks *b, uint32_t which, uint32_t i,
                     uint32_t n, uint32_t first) {
  block *k = &b->blocks[which];
  k->i = i;
  k->n = n;
  k->o = i - first;
  k->held = &b->held;
  k->knot = w->knots ? &b->knots[which] : NULL;
}

#if LANES == 1
INLINE void evaluate_points(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                            int boards, uint32_t from, uint32_t to) {
  wood_blocks b;
  wood_held_none(&b.held);
  const wood_io part = {io->in, io->out};
  for (uint32_t i = from; i < to; i++) {
    block_at(w, &b, 0, i, 1, i);
    evaluate_blocks(w, &part, want, boards, &b, 1);
  }
}
#else
/* The end of a batch, less than a block: by a detour, so that blocks need not ask which points are
 * to be written. */
static __attribute__((noinline)) void evaluate_some(const wood_constants *w, const kernel_io *io,
                                                    const wood_wants *want, int boards,
                                                    wood_blocks *b, wood_io *part) {
  float room[WOOD_COMPONENTS][LANES];
  const block *k = &b->blocks[0];
  for (int c = 0; c < WOOD_COMPONENTS; c++) {
    if (io->out[c]) part->out[c] = room[c];
  }
  evaluate_blocks(w, part, want, boards, b, 1);
  for (int c = 0; c < WOOD_COMPONENTS; c++) {
    if (io->out[c]) memcpy(io->out[c] + k->i, room[c], k->n * sizeof(float));
  }
}

/* Points from..to, those of plies as wood in a layout is. */
INLINE void evaluate_points(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                            int boards, uint32_t from, uint32_t to) {
  wood_blocks b;
  wood_held_none(&b.held);
  float spare[BLOCKS * LANES]; /* where components go that nobody asked for */
  wood_io part;
  part.in = io->in;
  for (int c = 0; c < WOOD_COMPONENTS; c++) part.out[c] = io->out[c] ? io->out[c] + from : spare;
  for (uint32_t i = from; i < to;) {
    uint32_t count = 0, first = i;
    for (; count < BLOCKS && to - i >= LANES; count++, i += LANES)
      block_at(w, &b, count, i, LANES, first);
    if (!count) {
      block_at(w, &b, 0, i, to - i, i);
      evaluate_some(w, io, want, boards, &b, &part);
      return;
    }
    evaluate_blocks(w, &part, want, boards, &b, count);
    for (int c = 0; c < WOOD_COMPONENTS; c++) {
      if (io->out[c]) part.out[c] += i - first;
    }
  }
}
#endif

#include "plies/taps.h"

static void evaluate(const void *constants, const kernel_io *io, uint32_t from, uint32_t to) {
  const wood_constants *w = constants;
  wood_wants want = wants_of(w, io);
  if (w->plies.count) {
    evaluate_plies(w, io, &want, from, to);
    return;
  }
  evaluate_points(w, io, &want, w->boards.layout.kind != LAYOUT_NONE || w->peeled, from, to);
}

const wood_kernel KERNEL_NAME(wood_kernel_) = {KERNEL_OF(evaluate), ring_radius, pith};
