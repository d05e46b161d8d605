/* SPDX-License-Identifier: Apache-2.0
 *
 * Wood's evaluate: compiled once for each instruction set and width.
 */
#include "../core/lanes.h"
#include "alone.h"
#include "boards.h"
#include "canals.h"
#include "cells.h"
#include "cone.h"
#include "fibre.h"
#include "figure.h"
#include "grain.h"
#include "heart.h"
#include "knots.h"
#include "picture.h"
#include "pigment.h"
#include "plies/ply.h"
#include "rays.h"
#include "surface/relief.h"
#include "spalt.h"
#include "vessels.h"

extern const wood_kernel KERNEL_NAME(wood_kernel_);

/* What has been asked for, and the stages that it takes. */
typedef struct {
  int radiance, colour, fibre, dive;
  int late, bundle, vessel, lobe, direction, section, picture, cone, board, relief;
  const ply_taps *taps; /* what the plies are told, if the wood is of plies */
} wood_wants;

static wood_wants wants_of(const wood_constants *w, const kernel_io *io) {
  wood_wants q;
  q.taps = NULL;
  q.radiance = kernel_wants(io, WOOD_RADIANCE, 3);
  q.colour = kernel_wants(io, WOOD_ALBEDO, 3) || q.radiance;
  q.fibre = kernel_wants(io, WOOD_FIBER, 3);
  q.dive = kernel_wants(io, WOOD_DIVE, 1);
  q.vessel = kernel_wants(io, WOOD_VESSEL, 1) || kernel_wants(io, WOOD_RAY, 1) ||
             kernel_wants(io, WOOD_CANAL, 1) || q.colour;
  q.late = kernel_wants(io, WOOD_LATEWOOD, 1) || q.vessel;
  q.picture = w->picture && q.late;
  if (w->picture) q.late = q.vessel = 0;
  q.bundle = q.late && (w->has_front || q.colour);
  q.lobe = kernel_wants(io, WOOD_SPECULAR, 2) || q.radiance;
  q.cone = kernel_wants(io, WOOD_CONE_COLOUR, 5);
  q.board = kernel_wants(io, WOOD_BOARD_ID, WOOD_CANAL - WOOD_BOARD_ID);
  q.relief = w->surface.relief && (q.lobe || q.cone || (w->surface.stains && q.colour) ||
                                   kernel_wants(io, WOOD_NORMAL, 4));
  q.direction = q.fibre || q.dive || q.radiance || q.cone || q.relief;
  q.section = q.direction || q.vessel || q.bundle || q.picture || q.lobe || q.cone ||
              kernel_wants(io, WOOD_REFERENCE, 2);
  return q;
}

/* What the stages read and write. */
typedef struct {
  const sozai_batch *in;
#if LANES == 1
  float *const *out;
#else
  float *out[WOOD_COMPONENTS]; /* from the first point of the first block on; none is NULL */
#endif
} wood_io;

/* How far a footprint reaches along rho. */
INLINE vf rings_extent(const stem_place *p, const vf g[3], const vf n[3], int ball, vf s) {
  footprint2 f = footprint_through(g, g, n, ball, s);
  return vsqrt(f.aa + splat(12.0f) * p->lost);
}

/* The line through the middle of a footprint that rings curve under: level, across
 * the grain. rho along it from its two parts, of the radius and of what is straight. */
typedef struct {
  vf s, r, ur, rho, radial, linear;
  vf side, sag; /* mm^2: what is not along the line; mm: off a straight line, of rho */
} rings_line;

/* Average of a ring's profile along it: between `parts` nodes rho runs straight. */
static __attribute__((noinline)) vf rings_along(const wood_constants *w, int what,
                                                const rings_line *q, int parts) {
  float step = 1.0f / (float)parts;
  vf widen = q->side + q->sag * q->sag * splat(2.56f * step * step * step * step);
  vf sum = splat(0.0f), before = sum;
  for (int i = 0; i <= parts; i++) {
    vf a = q->s * splat(step * (float)i - 0.5f);
    vf square = q->r * q->r + splat(2.0f) * q->r * q->ur * a + a * a;
    vf r = vsqrt(vmax(square, splat(1e-12f)));
    vf rho = vmax(q->rho + (r - q->r) * q->radial + q->linear * a, splat(0.0f));
    if (i) {
      vf middle = splat(0.5f) * (rho + before), span = rho - before;
      ring_place at = ring_at(w, middle);
      sum = sum + ring_average(w, what, &at, middle, vsqrt(span * span + widen));
    }
    before = rho;
  }
  return sum * splat(step);
}

/* Average of a ring's profile over a footprint that may be wide enough for the
 * rings' curvature. rho: in place of p's; e: rings_extent. */
INLINE vf rings_across(const wood_constants *w, int what, const stem_place *p, vf rho,
                       const ring_place *ring, const vf g[3], const vf n[3], int ball, vf s, vf e) {
  vf mean = ring_average(w, what, ring, rho, e);
  /* the sag of s over a radius r is s^2 / 8 r at most */
  if (ball || !any(gt(s * s, splat(0.64f * w->ring_width) * p->r))) return mean;

  /* across: the horizontal direction in the surface */
  vf flat2 = n[0] * n[0] + n[2] * n[2];
  vm end = lt(flat2, splat(0.09f)); /* end grain: along the radius */
  vf k = inverse_root(vmax(flat2, splat(1e-6f)));
  vf ux = sel(end, p->c, n[2] * k), uz = sel(end, p->s, splat(0.0f) - n[0] * k);
  rings_line q = {.s = s, .r = p->r, .ur = ux * p->c + uz * p->s, .rho = rho};
  vf ut2 = vmax(splat(1.0f) - q.ur * q.ur, splat(0.0f));
  q.sag = s * s * ut2 / (splat(8.0f) * p->r);
  vm curved = gt(q.sag, splat(0.08f * w->ring_width));
  if (!any(curved)) return mean;

  vf slope = p->rho_x * ux + p->rho_z * uz; /* of rho along u */
  q.radial = p->rho_x * p->c + p->rho_z * p->s;
  q.linear = slope - q.radial * q.ur;
  /* what is not along u widens every part */
  vf gn = g[0] * n[0] + g[1] * n[1] + g[2] * n[2];
  vf all = vmax(g[0] * g[0] + g[1] * g[1] + g[2] * g[2] - gn * gn, splat(0.0f));
  q.side = vmax(all - slope * slope, splat(0.0f)) * s * s + splat(12.0f) * p->lost;
  /* more nodes where rho turns by more than a ring: as much lies at the turn as
   * anywhere else, and all of it in one ring */
  vm turned = and_(curved, gt(q.sag, splat(0.6f * w->ring_width)));
  if (any(and_(curved, not_(turned)))) mean = sel(curved, rings_along(w, what, &q, 4), mean);
  if (any(turned)) mean = sel(turned, rings_along(w, what, &q, 16), mean);
  return mean;
}

/* Rings over the parts of a wide footprint; see plies/wide.h. */
typedef struct {
  vf mean[3]; /* of MEAN_LATE... */
  vf share;   /* 0..1: how far they stand in for the whole */
} wide_rings;

/* A block of LANES points on its way through the stages. The stages run over a
 * few blocks each before the next begins, and are short: the blocks do not wait
 * for one another, and the processor sees far enough ahead to have the next one
 * begin while this one waits for its own results. */
typedef struct {
  uint32_t i, n;      /* the first point, and how many */
  uint32_t o;         /* the first point, among those of the blocks on their way together */
  vf p[3];            /* log space */
  vf nrm[3];          /* normal, log space */
  vf s;               /* footprint */
  vf up2, inverse_up; /* squared length of +y within the surface, its inverse root */
  stem_place stem;
  undulation_sum undulation;
  vf in_table; /* rho, within the table of rings */
  ring_place ring;
  vf years, divisor, phase;
  vf extent;     /* mm, of the footprint along y */
  noise_axis at; /* the year, for the grain's noises */
  wave_phase wave;
  grain_place grain;
  vf c, sn, x, z; /* reference section: direction and place */
  vf turn;        /* of the direction, over 2 pi */
  vf fibre[3];    /* direction, log space */
  vf sine;        /* of the dive angle */
  vf b[3], bn;    /* row of the map from surface to rho; that along the normal */
  vf reach;       /* mm: rings_extent */
  footprint2 f;   /* over (arc, rho) of the reference section */
  disc pore;
  vessel_cover_t vessels;
  int pores_parted, rows_parted; /* these have been looked up in parts */
  fibre_sum bundle;
  vf front_rho, front_reach; /* of latewood where it strays */
  ring_place front_ring;     /* where that crosses a ring's end for any lane */
  int crossed;
  vf shift; /* of brightness, a factor */
  vf late, over_late, cover, ray, albedo[3];
  vf exponent, strength, incident, rise, tilted, power; /* figure */
  vf light[3];                                          /* log space */
  vf streak, pigment;                                   /* share of minerals; depth of bands */
  vf lost;                                              /* variance of the surface's slopes */
  ray_turn ray_from;
  ray_cells ray_at;
  vu ray_on;
  ray_body ray_in;
  int rays_gone; /* no lane asks for the last two */
  canal_cover canal;
  vf cells, cell_contrast, lining; /* relative to the tissue's colour and the vessels' */
  vf ray_cells;                    /* and to the rays' */
  spalt_place spalt;
  wood_board board; /* where there are boards */
  knot_place *knot; /* where there are knots, else NULL */
  wide_rings *wide; /* where a footprint on veneer is wide, else NULL */
} block;

#if LANES == 1
INLINE void store_lanes(const wood_io *io, int channel, const block *k, vf x) {
  float *p = io->out[channel];
  if (p) p[k->i] = x;
}
#else
/* All of them, asked for or not: a store costs less than to ask. */
INLINE void store_lanes(const wood_io *io, int channel, const block *k, vf x) {
  store(io->out[channel] + k->o, x);
}
#endif

/* The board's offset to the seeds. */
INLINE vu own_of(int boards, const block *k) { return boards ? k->board.own : splatu(0); }

INLINE void to_log(const wood_constants *w, int boards, const block *k, const vf p[3], vf out[3]) {
  if (boards) {
    const vf(*t)[3] = k->board.turn;
    for (int c = 0; c < 3; c++) out[c] = t[c][0] * p[0] + t[c][1] * p[1] + t[c][2] * p[2];
    return;
  }
  if (!w->turned) {
    for (int c = 0; c < 3; c++) out[c] = p[c];
    return;
  }
  for (int c = 0; c < 3; c++) {
    out[c] =
        splat(w->turn[c][0]) * p[0] + splat(w->turn[c][1]) * p[1] + splat(w->turn[c][2]) * p[2];
  }
}

/* The board's channels, and the normal of its bevelled edges and cupped face. */
INLINE void stage_board(const wood_constants *w, int boards, const wood_io *io, block *k,
                        vf normal[3]) {
  vf zero = splat(0.0f), id = zero, u = zero, v = zero, edge = zero, height = zero;
  if (boards && w->boards.layout.kind == LAYOUT_NONE) {
    if (w->plies.count) {
      id = k->board.number;
      u = k->board.place[0];
      v = k->board.place[1];
      edge = k->board.to_glue;
    }
  } else if (boards) {
    const layout_unit *unit = &k->board.unit;
    layout_height h = layout_relief(&w->boards.layout, &w->boards.profile, unit, k->s);
    id = layout_number(unit->id);
    u = unit->u;
    v = unit->v;
    edge = unit->edge;
    height = h.height;
    if (io->in->normal[0]) {
      /* the face is tilted, the sides are not */
      vf face = vmax(normal[2], zero);
      normal[0] = normal[0] - face * h.slope_x;
      normal[1] = normal[1] - face * h.slope_y;
      unit_direction(normal);
    }
  }
  if (boards && w->plies.count) {
    height = height + k->board.step;
    if (io->in->normal[0]) {
      for (int c = 0; c < 3; c++) normal[c] = normal[c] - k->board.tilt[c];
      unit_direction(normal);
    }
  }
  store_lanes(io, WOOD_BOARD_ID, k, id);
  store_lanes(io, WOOD_BOARD_U, k, u);
  store_lanes(io, WOOD_BOARD_V, k, v);
  store_lanes(io, WOOD_BOARD_EDGE, k, edge);
  for (int c = 0; c < 3; c++) store_lanes(io, WOOD_NORMAL + c, k, normal[c]);
  store_lanes(io, WOOD_HEIGHT, k, height);
}

INLINE void stage_load(const wood_constants *w, int boards, const wood_io *io,
                       const wood_wants *want, board_sawn *sawn, block *k) {
  vf p[3];
  UNROLL(3)
  for (int c = 0; c < 3; c++) p[c] = finite_coordinate(load_lanes(io->in->point[c], k->i, k->n));
  k->s = splat(0.0f);
  if (io->in->footprint) {
    k->s = clamp(load_lanes(io->in->footprint, k->i, k->n), splat(0.0f), splat(1e4f));
  }
  if (!boards && !want->board && k->o && as_before(io->in->normal, k->i, k->n)) {
    const block *before = k - 1;
    to_log(w, boards, k, p, k->p);
    for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + splat(w->shift[c]);
    for (int c = 0; c < 3; c++) k->nrm[c] = before->nrm[c];
    k->up2 = before->up2;
    k->inverse_up = before->inverse_up;
    k->extent = k->s * (k->up2 * k->inverse_up);
    return;
  }
  vf normal[3] = {splat(0.0f), splat(0.0f), splat(1.0f)};
  if (io->in->normal[0]) {
    for (int c = 0; c < 3; c++) normal[c] = load_lanes(io->in->normal[c], k->i, k->n);
    unit_direction(normal);
  }
  if (boards && want->taps) {
    ply_at(w, want->taps, k->i, k->n, p, normal, !io->in->normal[0], k->s, &k->board, k->p);
  } else if (boards) {
    board_at(w, p, k->s, sawn, &k->board, k->p);
  } else {
    to_log(w, boards, k, p, k->p);
    for (int c = 0; c < 3; c++) k->p[c] = k->p[c] + splat(w->shift[c]);
  }
  k->up2 = splat(1.0f);
  if (want->board || boards) stage_board(w, boards, io, k, normal);
  to_log(w, boards, k, normal, k->nrm);
  if (io->in->normal[0]) k->up2 = vmax(splat(1.0f) - k->nrm[1] * k->nrm[1], splat(0.0f));
  k->inverse_up = inverse_root(vmax(k->up2, splat(1e-12f)));
  k->extent = k->s * (k->up2 * k->inverse_up);
}

INLINE void stage_pith(const wood_constants *w, int boards, block *k) {
#if LANES == 1
  k->stem.pith = pith_alone(w, own_of(boards, k), k->p[1]);
#else
  k->stem.pith = pith_at(w, own_of(boards, k), k->p[1]);
#endif
  k->stem.lost = k->stem.lost_slope = k->stem.eye = splat(0.0f);
  k->undulation = undulation_none();
}

INLINE void stage_about(block *k) { stem_about(k->p[0], k->p[2], &k->stem); }

INLINE void stage_undulation(const undulation_octave *q, int boards, block *k) {
  undulation_add(q, own_of(boards, k), k->p[1], k->s, &k->stem, &k->undulation);
}

INLINE void stage_figure(const wood_constants *w, int boards, block *k) {
  figure_add(w, own_of(boards, k), k->p[1], k->s, k->extent, &k->stem, &k->undulation);
}

INLINE void stage_rho(const wood_constants *w, block *k) {
  stem_rho(w, k->p[1], &k->undulation, &k->stem);
}

/* Where on the stem a board's log lies, in turns of the period. */
INLINE vf knot_shift(const block *k) {
  vu h = hash_mix(k->board.own + splatu(HASH_Z));
  return to_float((vi)(h >> 8)) * splat(1.0f / 16777216.0f);
}

/* Once in the code: it is long, and few points are near a knot. */
static __attribute__((noinline)) void stage_knots_near(const wood_constants *w, const wood_io *io,
                                                       vf shift, block *k) {
  vf zero = splat(0.0f);
  knot_place *q = k->knot;
  knot_eye e = {.y = k->p[1], .s = k->s, .n = k->nrm, .ball = !io->in->normal[0]};
  knot_taps taps;
  if (any(gt(k->s, splat(KNOT_CLOSE)))) {
    knot_taps_of(&k->stem, k->s, k->nrm, e.ball, &taps);
    e.taps = &taps;
  }
  *q = knot_none();
  knots_add(w->knots, shift, &e, &k->stem, q);
  if (e.taps) knot_taps_late(w, k->s, &taps, q);
  store_lanes(io, WOOD_KNOT, k, q->cover);
  /* a point that no knot has to do with is as in wood without knots, to the bit */
  if (!any(gt(q->near + q->cover + q->bark + q->halo + q->nodes, zero))) k->knot = NULL;
}

INLINE void stage_knots(const wood_constants *w, const wood_io *io, vf shift, block *k) {
  if (knots_near(w->knots, shift, k->p[1], k->s, &k->stem)) {
    stage_knots_near(w, io, shift, k);
    return;
  }
  k->knot = NULL;
  store_lanes(io, WOOD_KNOT, k, splat(0.0f));
}

INLINE void stage_ring_find(const wood_constants *w, block *k) {
  k->in_table = ring_find(w, k->stem.rho, &k->ring);
}

INLINE void stage_ring(const wood_constants *w, const wood_io *io, block *k) {
  ring_read(w, k->in_table, &k->ring);
  k->years = to_float(k->ring.ring) + k->ring.phase;
  store_lanes(io, WOOD_TIME, k, k->years);
  k->divisor = grain_divisor(k->stem.rho);
}

INLINE void stage_years(const wood_constants *w, int boards, block *k) {
  k->grain = grain_spiral(w, k->p[1]);
  k->at = grain_years(w, k->years);
  if (w->has_wave && w->has_wave_irregularity) {
    k->wave = wave_at(w, own_of(boards, k), k->p[1], k->years);
  }
}

INLINE void stage_wave(const wood_constants *w, block *k) {
  if (w->has_wave_irregularity) {
    grain_wave(w, &k->wave, k->extent, &k->grain);
  } else {
    grain_wave_even(w, k->p[1], k->extent, &k->grain);
  }
}

INLINE void stage_interlocked(const wood_constants *w, int boards, block *k) {
  grain_interlocked(w, own_of(boards, k), k->p[1], k->years, &k->grain);
}

INLINE void stage_grain_noise(const grain_octave *q, int boards, block *k) {
  grain_noise(q, own_of(boards, k), k->p[1], &k->at, k->extent, &k->grain);
}

INLINE void stage_turn(block *k) {
  k->phase = k->grain.d * k->divisor;
  vf s, c;
  sine_cosine(k->knot ? k->phase - k->knot->turn : k->phase, &s, &c);
  k->c = k->stem.c * c + k->stem.s * s;
  k->sn = k->stem.s * c - k->stem.c * s;
}

/* In a knot the reference is the branch's own section. */
INLINE void stage_knot_section(block *k) {
  const knot_place *q = k->knot;
  vm in = gt(q->inside, splat(0.0f));
  if (!any(in)) return;
  vf turn = inverse_root(vmax(q->a * q->a + q->h * q->h, splat(1e-6f)));
  k->x = sel(in, q->a, k->x);
  k->z = sel(in, q->h, k->z);
  k->c = sel(in, q->a * turn, k->c);
  k->sn = sel(in, q->h * turn, k->sn);
}

INLINE void stage_section(const wood_constants *w, const wood_io *io, block *k) {
  vf unused;
  vf radius = k->stem.rho * (splat(1.0f) + outline_at(w, k->c, k->sn, &unused));
  k->x = radius * k->c;
  k->z = radius * k->sn;
  if (k->knot) stage_knot_section(k);
  store_lanes(io, WOOD_REFERENCE, k, k->x);
  store_lanes(io, WOOD_REFERENCE + 1, k, k->z);
}

/* Near knots rho and theta' both depend on all three coordinates: slopes along
 * the radius and round from the two equations. */
INLINE void stage_knot_slopes(const block *k, vf omega, vf rho_r, vf *climb, vf *around) {
  vm near = gt(k->knot->near, splat(0.0f));
  if (!any(near)) return;
  const stem_place *stem = &k->stem;
  const knot_place *q = k->knot;
  vf zero = splat(0.0f);
  vf rho_a = stem->rho_z * stem->c - stem->rho_x * stem->s;
  vf turn_r = q->turn_x * stem->c + q->turn_z * stem->s;
  vf turn_a = stem->inverse_r + (q->turn_z * stem->c - q->turn_x * stem->s);
  vf left = omega - q->turn_y, whole = rho_r * turn_a - rho_a * turn_r;
  vf inverse = splat(1.0f) / sel(lt(vabs(whole), splat(1e-9f)), splat(1e-9f), whole);
  vf radial = (zero - stem->rho_y * turn_a - rho_a * left) * inverse;
  vf round = (rho_r * left + turn_r * stem->rho_y) * inverse;
  /* no fibre runs more than 70 degrees off the stem */
  vf slope = radial * radial + round * round, most = splat(7.5f);
  vf keep = sel(gt(slope, most), vsqrt(most / vmax(slope, most)), splat(1.0f));
  *climb = sel(near, radial * keep, *climb);
  *around = sel(near, round * keep, *around);
}

/* The fibre's direction: theta' and rho are constant along it. */
INLINE void stage_fibre(block *k) {
  const stem_place *stem = &k->stem;
  vf one = splat(1.0f), zero = splat(0.0f), *f = k->fibre;
  vf omega = k->grain.g_filtered * k->divisor;
  vf rho_r = stem->rho_x * stem->c + stem->rho_z * stem->s;
  vf rho_t = stem->r * (stem->rho_z * stem->c - stem->rho_x * stem->s);
  vf climb = (zero - stem->rho_y - rho_t * omega) / vmax(rho_r, splat(0.05f));
  vf around = stem->r * omega;
  if (k->knot) stage_knot_slopes(k, omega, rho_r, &climb, &around);
  f[0] = climb * stem->c - around * stem->s + stem->pith.dx;
  f[2] = climb * stem->s + around * stem->c + stem->pith.dz;
  f[1] = inverse_root(f[0] * f[0] + one + f[2] * f[2]);
  f[0] = f[0] * f[1];
  f[2] = f[2] * f[1];
  if (k->knot && any(gt(k->knot->inside, zero))) {
    vm in = gt(k->knot->inside, zero);
    const vf *along = k->knot->along;
    vf axis[3] = {along[0] + stem->pith.dx * along[1], along[1],
                  along[2] + stem->pith.dz * along[1]};
    unit_direction(axis);
    for (int c = 0; c < 3; c++) f[c] = sel(in, axis[c], f[c]);
  }
  k->sine = zero - (f[0] * k->nrm[0] + f[1] * k->nrm[1] + f[2] * k->nrm[2]);
}

INLINE void stage_direction(const wood_constants *w, int boards, const wood_io *io,
                            const wood_wants *want, block *k) {
  const vf *f = k->fibre;
  if (want->fibre) {
    for (int c = 0; c < 3; c++) {
      vf back = f[c];
      if (boards) {
        const vf(*t)[3] = k->board.turn;
        back = t[0][c] * f[0] + t[1][c] * f[1] + t[2][c] * f[2];
      } else if (w->turned) {
        back =
            splat(w->turn[0][c]) * f[0] + splat(w->turn[1][c]) * f[1] + splat(w->turn[2][c]) * f[2];
      }
      store_lanes(io, WOOD_FIBER + c, k, back);
    }
  }
  if (want->dive) store_lanes(io, WOOD_DIVE, k, arcsin(k->sine));
}

INLINE void stem_row(block *k) {
  const stem_place *stem = &k->stem;
  k->b[0] = stem->rho_x;
  k->b[1] = stem->rho_y - stem->rho_x * stem->pith.dx - stem->rho_z * stem->pith.dz;
  k->b[2] = stem->rho_z;
}

/* Whether the footprint over rho is that of the wood's own rows. */
INLINE int reach_is_plain(const wood_constants *w, int boards, const block *k) {
  return !k->knot && !(boards && w->plies.count);
}

INLINE void stage_reach(const wood_constants *w, int boards, const wood_io *io, block *k) {
  stem_row(k);
  vf b[3] = {k->b[0], k->b[1], k->b[2]};
  if (reach_is_plain(w, boards, k)) {
    k->f.bb = footprint_along(b, k->nrm, !io->in->normal[0], &k->bn) * (k->s * k->s);
    k->reach = vsqrt(k->f.bb + splat(12.0f) * k->stem.lost);
    return;
  }
  if (boards && w->plies.count) ply_squeeze(&k->board, b);
  k->reach = rings_extent(&k->stem, b, k->nrm, !io->in->normal[0], k->s);
}

#include "plies/wide.h"

/* Where boards may be bent veneer. */
INLINE int has_bent_boards(const wood_constants *w, int boards) {
  return boards && (w->plies.count || w->peeled);
}

/* mm: the footprint that rings may curve under. */
INLINE vf curved_footprint(const wood_constants *w, int boards, const block *k) {
  return has_bent_boards(w, boards) ? k->board.wide : k->s;
}

/* The mean of a ring's profile under the footprint. */
INLINE vf rings_mean_at(const wood_constants *w, int boards, const wood_io *io, int what,
                        const block *k, vf rho, const ring_place *ring, vf reach) {
  vf mean = rings_across(w, what, &k->stem, rho, ring, k->b, k->nrm, !io->in->normal[0],
                         curved_footprint(w, boards, k), reach);
  if (has_bent_boards(w, boards) && k->wide) mean = wide_rings_mean(what, k, mean);
  return mean;
}

INLINE vf rings_mean(const wood_constants *w, int boards, const wood_io *io, int what,
                     const block *k) {
  return rings_mean_at(w, boards, io, what, k, k->stem.rho, &k->ring, k->reach);
}

INLINE void stage_wide(const wood_constants *w, int boards, const wood_io *io, block *k,
                       wide_rings *room) {
  k->wide = NULL;
  if (any(gt(k->board.bent, splat(WIDE_FROM)))) {
    wide_rings_of(w, own_of(boards, k), !io->in->normal[0], k, room);
  }
}

/* Where a knot's edge runs through the footprint, stem and knot have each its own;
 * of the part that the point is not in, the mean is known. */
INLINE vf stage_knot_late(const wood_constants *w, block *k) {
  knot_place *q = k->knot;
  vf zero = splat(0.0f), mean = splat(w->late_period * w->inverse_ring_period), at = k->late;
  vm in = gt(q->inside, zero), some = gt(q->nodes, zero);
  q->own = sel(in, at, mean);
  k->late = sel(and_(in, lt(q->cover, splat(1.0f))), mean, at);
  k->late = sel(some, mix(k->late, q->late, q->nodes), k->late);
  return sel(gt(q->cover, zero), mix(k->late, q->own, q->cover), k->late);
}

/* The row of the map from surface to arc of the reference section. */
INLINE void section_arc_row(const block *k, vf a[3]) {
  const stem_place *stem = &k->stem;
  vf zero = splat(0.0f);
  vf ratio = stem->rho * stem->inverse_r;
  vf phi_rho =
      (k->grain.d_t * k->ring.inverse_width - k->phase * stem->rho * k->divisor) * k->divisor;
  vf shear = stem->rho * phi_rho, g = stem->rho * k->grain.g * k->divisor;
  vf tx = zero - ratio * stem->s, tz = ratio * stem->c;
  a[0] = tx - shear * k->b[0];
  a[1] = zero - tx * stem->pith.dx - tz * stem->pith.dz - g - shear * k->b[1];
  a[2] = tz - shear * k->b[2];
  if (k->knot) {
    const knot_place *q = k->knot;
    a[0] = a[0] + stem->rho * q->turn_x;
    a[1] = a[1] + stem->rho * (q->turn_y - q->turn_x * stem->pith.dx - q->turn_z * stem->pith.dz);
    a[2] = a[2] + stem->rho * q->turn_z;
  }
}

/* Rows of the map from surface to arc and rho of the reference section; in a knot,
 * to its own. */
INLINE void section_rows(const block *k, vf a[3], vf b[3]) {
  section_arc_row(k, a);
  for (int c = 0; c < 3; c++) b[c] = k->b[c];
  if (!k->knot) return;
  vm in = gt(k->knot->inside, splat(0.0f));
  for (int c = 0; c < 3; c++) {
    a[c] = sel(in, k->knot->round[c], a[c]);
    b[c] = sel(in, k->knot->out[c], b[c]);
  }
}

/* The footprint over them. */
INLINE footprint2 footprint_in_section(const wood_constants *w, int boards, const wood_io *io,
                                       const block *k) {
  vf a[3], b[3];
  section_rows(k, a, b);
  if (boards && w->plies.count) {
    ply_squeeze(&k->board, a);
    ply_squeeze(&k->board, b);
  }
  return footprint_through(a, b, k->nrm, !io->in->normal[0], k->s);
}

/* The same where stage_reach has seen to rho. */
INLINE footprint2 footprint_after_reach(const wood_constants *w, int boards, const wood_io *io,
                                        const block *k) {
  if (!reach_is_plain(w, boards, k)) return footprint_in_section(w, boards, io, k);
  int ball = !io->in->normal[0];
  vf a[3], an, q = k->s * k->s;
  section_arc_row(k, a);
  footprint2 f = {footprint_along(a, k->nrm, ball, &an) * q, a[0] * k->b[0], k->f.bb};
  f.ab = f.ab + a[1] * k->b[1] + a[2] * k->b[2];
  if (!ball) f.ab = f.ab - an * k->bn;
  f.ab = f.ab * q;
  return f;
}

INLINE void stage_section_footprint(const wood_constants *w, int boards, const wood_io *io,
                                    block *k) {
  k->f = footprint_after_reach(w, boards, io, k);
}

/* One octave of the fibres' noise. */
INLINE void stage_bundle(const fibre_octave *q, int boards, int o, block *k) {
  if (o == 0) k->bundle = fibre_start(&k->f);
  fibre_add(q, own_of(boards, k), k->x, k->z, &k->bundle);
  k->shift = k->bundle.shift;
}

/* Where the latewood strays from its ring: it is as it would be that much nearer to the
 * pith or farther from it. */
INLINE void stage_stray(const wood_constants *w, block *k) {
  vf reach = k->reach, front = k->bundle.front, zero = splat(0.0f);
  k->front_rho = vmax(k->stem.rho - front, zero);
  k->front_reach = reach;
  if (any(gt(k->bundle.lost, zero))) {
    k->front_reach = vsqrt(reach * reach + splat(12.0f) * k->bundle.lost);
  }
  vf phase = k->ring.phase - front * k->ring.inverse_width;
  vm out = or_(lt(phase, zero), gt(phase, splat(1.0f)));
  k->crossed = any(out);
  if (k->crossed) {
    ring_place other = ring_at(w, k->front_rho), *ring = &k->front_ring;
    const ring_place *here = &k->ring;
    ring->turns = sel(out, other.turns, here->turns);
    ring->start = sel(out, other.start, here->start);
    ring->inverse_width = sel(out, other.inverse_width, here->inverse_width);
    ring->weight = sel(out, other.weight, here->weight);
    ring->last = sel(out, other.last, here->last);
  }
}

/* The latewood's mean. */
INLINE void stage_rings(const wood_constants *w, int boards, const wood_io *io, block *k) {
  if (w->has_front) {
    const ring_place *ring = k->crossed ? &k->front_ring : &k->ring;
    k->late = rings_mean_at(w, boards, io, MEAN_LATE, k, k->front_rho, ring, k->front_reach);
  } else {
    k->late = rings_mean(w, boards, io, MEAN_LATE, k);
  }
  vf late = k->late;
  if (k->knot) late = stage_knot_late(w, k);
  store_lanes(io, WOOD_LATEWOOD, k, late);
}

INLINE vessel_place vessel_place_of(int boards, const block *k) {
  return (vessel_place){
      k->x, k->z, k->c, k->sn, k->turn, k->stem.rho, k->ring, k->f, own_of(boards, k)};
}

/* Long footprints here; what is within one tap goes through the stages after this one. */
INLINE void stage_vessel_parts(const wood_constants *w, int boards, block *k) {
  vf zero = splat(0.0f);
  k->vessels = (vessel_cover_t){zero, zero, zero, zero};
  k->pores_parted = k->rows_parted = 0;
  vm none = lt(zero, zero), pores = w->has_pores ? pores_cut(w, &k->f) : none;
  vm rows = w->rows ? rows_cut(w, &k->f) : none, meet = w->rows ? rows_meet(w, &k->f) : none;
  if (!any(or_(pores, or_(rows, meet)))) return;
  vessel_place place = vessel_place_of(boards, k);
  k->pores_parted = any(pores);
  k->rows_parted = any(or_(rows, meet));
  if (k->pores_parted) pores_in_parts(w, &place, pores, &k->vessels);
  if (k->rows_parted) rows_in_parts(w, &place, rows, &k->vessels);
}

INLINE void stage_turns(block *k) { k->turn = place_turn(k->c, k->sn); }

INLINE void stage_disc(const wood_constants *w, int boards, block *k) {
  if (k->pores_parted || !w->has_pores) return;
  vessel_place place = vessel_place_of(boards, k);
  k->pore = pores_disc(w, &place, k->f.aa, k->f.ab, k->f.bb);
}

INLINE void stage_pores(const wood_constants *w, int boards, block *k) {
  if (k->pores_parted || !w->has_pores) return;
  k->vessels.pores = pores_cover(w, own_of(boards, k), k->x, k->z, &k->pore);
}

INLINE void stage_rows(const wood_constants *w, int boards, block *k) {
  if (k->rows_parted || !w->rows) return;
  vessel_place place = vessel_place_of(boards, k);
  row_place row = row_of(w, &place);
  if (!any(row.near)) return;
  disc d = rows_disc(w, k->f.aa, k->f.ab, k->f.bb);
  vf zero = splat(0.0f);
  k->vessels.rows = rows_cover(w, &row, k->stem.rho, zero, zero, &d);
}

/* Where the vessels could not be looked up, what is to be expected. */
INLINE void stage_cover(const wood_constants *w, int boards, const wood_io *io, block *k) {
  const vessel_cover_t *v = &k->vessels;
  vf one = splat(1.0f), zero = splat(0.0f);
  vf pores = v->pores, rows = v->rows;
  k->over_late = v->pores;
  if (w->has_pores && any(gt(v->pores_faded, zero))) {
    vf expected = one;
    if (w->pore_growth != 0.0f) {
      expected = rings_mean(w, boards, io, MEAN_PORE, k);
    }
    pores = mix(pores, splat(w->pores.coverage) * expected, v->pores_faded);
    k->over_late = mix(k->over_late, splat(w->late_vessel), v->pores_faded);
  }
  if (w->rows && any(gt(v->rows_faded, zero))) {
    vf expected = rings_mean(w, boards, io, MEAN_ROW, k);
    rows = mix(rows, splat(w->row.coverage) * expected, v->rows_faded);
  }
  if (w->rows) {
    vf late = rows * splat(w->late_row);
    k->over_late = k->over_late + late - k->over_late * late;
  }
  if (k->knot) rows = rows * (one - k->knot->cover); /* branches have no wide earlywood vessels */
  k->cover = vmin(pores + rows - pores * rows, one); /* they stand where they like */
  k->ray = zero;
  if (!w->has_rays) store_lanes(io, WOOD_RAY, k, zero);
  store_lanes(io, WOOD_VESSEL, k, k->cover);
}

/* Put together in each stage, of which each needs another part. */
INLINE ray_place ray_place_here(int boards, const block *k) {
  return (ray_place){.rho = k->stem.rho,
                     .y = k->p[1],
                     .aa = k->f.aa,
                     .ab = k->f.ab,
                     .bb = k->f.bb,
                     .along = k->extent,
                     .at = k->ray_from,
                     .own = own_of(boards, k)};
}

INLINE void stage_ray_turn(const wood_constants *w, int boards, block *k) {
  k->ray_from =
      ray_turn_of(w, own_of(boards, k), k->stem.rho, k->turn, k->p[1], k->stem.c, k->stem.s);
}

INLINE void stage_ray_shell(const wood_constants *w, int boards, block *k) {
  ray_place p = ray_place_here(boards, k);
  k->ray_at = ray_shell_at(w, &p);
}

INLINE void stage_ray_seat(const wood_constants *w, int boards, block *k) {
  ray_place p = ray_place_here(boards, k);
  ray_cell_size(w, &p, &k->ray_at);
  k->rays_gone = rays_gone(w, &p);
  if (!k->rays_gone) k->ray_on = ray_hash_of(&k->ray_at);
}

INLINE void stage_ray_body(const wood_constants *w, int boards, block *k) {
  if (k->rays_gone) return;
  ray_place p = ray_place_here(boards, k);
  k->ray_in = ray_body_of(w, &p, &k->ray_at, k->ray_on);
}

INLINE void stage_rays(const wood_constants *w, int boards, const wood_io *io, block *k) {
  ray_place p = ray_place_here(boards, k);
  vf found = splat(0.0f);
  if (!k->rays_gone) {
    found = ray_body_cover(w, &p, &k->ray_at, &k->ray_in);
    found = rays_cover(w, &p, &k->ray_at, found);
  }
  k->ray = rays_faded(w, &p, &k->ray_at, found);
  if (k->knot) k->ray = k->ray * (splat(1.0f) - k->knot->cover);
  store_lanes(io, WOOD_RAY, k, k->ray);
}

INLINE void stage_canals(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vessel_place place = vessel_place_of(boards, k);
  k->canal = canals_at(w, &place);
  if (k->knot) {
    vf stem = splat(1.0f) - k->knot->cover;
    k->canal.whole = k->canal.whole * stem;
    k->canal.core = k->canal.core * stem;
  }
  store_lanes(io, WOOD_CANAL, k, k->canal.whole);
}

INLINE void stage_cells(const wood_constants *w, int boards, block *k) {
  vessel_place place = vessel_place_of(boards, k);
  vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
  vf round = k->nrm[2] * k->stem.c - k->nrm[0] * k->stem.s;
  cell_face face = {round * round, k->nrm[1] * k->nrm[1], out * out};
  k->cells = cells_tissue(w, &place, &face, k->p[1], k->extent, k->late, &k->cell_contrast);
  k->lining = splat(0.0f);
  k->ray_cells = splat(0.0f);
  if (w->has_rays && !k->rays_gone && any(gt(k->ray, splat(0.0f)))) {
    ray_place p = ray_place_here(boards, k);
    vf far, fade = rays_fade(w, &p, &far); /* what is expected of rays has no cells */
    k->ray_cells = (splat(1.0f) - fade) * cells_ray(w, &p, k->ray_on, &k->ray_in, &face);
  }
  if (!any(gt(k->cover, splat(0.0f)))) return;
  vu own = own_of(boards, k);
  k->lining = k->cover * cells_rims(w, own, k->x, k->p[1], k->z, k->s, k->extent);
  if (w->rows) {
    vf within = cells_tyloses(w, own, k->x, k->p[1], k->z, k->s);
    k->lining = k->lining + k->vessels.rows * within;
  }
}

INLINE void stage_spalt(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf a[3], b[3];
  spalt_eye q = {.at = {k->x, k->p[1], k->z}, .n = k->nrm, .ball = !io->in->normal[0], .s = k->s};
  section_rows(k, a, b);
  for (int c = 0; c < 3; c++) {
    q.row[0][c] = k->c * b[c] - k->sn * a[c];
    q.row[1][c] = splat(c == 1 ? 1.0f : 0.0f);
    q.row[2][c] = k->sn * b[c] + k->c * a[c];
  }
  if (boards && w->plies.count) {
    for (int c = 0; c < 3; c++) ply_squeeze(&k->board, q.row[c]);
  }
  k->spalt = spalt_at(w, own_of(boards, k), &q);
}

/* Streaks of minerals along the fibre: a stain, which is no deeper where two
 * meet. */
static __attribute__((noinline)) void stage_streaks(const wood_constants *w, int boards, block *k) {
  vessel_place place = vessel_place_of(boards, k);
  vf left;
  trough_sum g =
      tubes_over(&w->streaks, wood_seed(w, place.own, SEED_STREAKS), &place, k->p[1], &left);
  k->streak = vmin(splat(WOOD_STREAK) * g.depth, splat(1.0f));
}

INLINE void stage_pigment(const wood_constants *w, int boards, block *k) {
  k->pigment =
      pigment_at(w, own_of(boards, k), k->stem.rho, vsqrt(k->f.bb), k->x, k->z, k->f.aa + k->f.bb);
}

/* Bleached wood is nearer to white, which is white in every working space; what
 * the zone lines are made of is melanin. */
INLINE void stage_spalt_colour(block *k) {
  vf one = splat(1.0f), *a = k->albedo;
  for (int c = 0; c < 3; c++) {
    vf pale = a[c] + (splat(0.8f) - a[c]) * splat(0.4f);
    a[c] = mix(a[c], pale, k->spalt.bleached);
    a[c] = a[c] * (one - splat(0.2f) * k->spalt.stained) * (one - splat(0.86f) * k->spalt.line);
  }
}

#define KNOT_RESIN 0.8f /* of the knot's colour in the wood beside it */
#define KNOT_HEART 0.3f /* by which it is darker at its pith than at its edge */

INLINE void stage_knot_colour(const wood_constants *w, block *k, vf late) {
  const knot_place *q = k->knot;
  vf one = splat(1.0f), least = splat(1e-6f);
  if (!any(gt(q->cover + q->bark + q->halo, splat(0.0f)))) return;
  /* of what bark leaves, the knot's share; and of the wood beside both, the resin's */
  vf rest = vmax(one - q->bark, least), cover = vmin(q->cover / rest, one);
  vf beside = vmax(rest - q->cover, least), ripe = q->heart / vmax(q->cover, least);
  vf stain = splat(w->knot_stain), full = splat(KNOT_RESIN) * stain;
  vf resin = clamp01((q->halo - q->cover - q->bark) / beside) * full;
  ripe = clamp(ripe, splat(-KNOT_TONE), splat(1.0f + KNOT_TONE));
  ripe = one - splat(KNOT_HEART) * ripe;
  for (int c = 0; c < 3; c++) {
    vf own = mix(splat(w->knot_early[c]), splat(w->knot_late[c]), late) * (k->shift * ripe);
    vf wet = splat(w->knot_early[c]) * k->shift;
    own = mix(mix(k->albedo[c], wet, full), own, stain);
    k->albedo[c] = mix(mix(k->albedo[c], wet, resin), own, cover);
    k->albedo[c] = k->albedo[c] * (splat(1.0f) - splat(0.8f) * q->check);
    k->albedo[c] = mix(k->albedo[c], splat(w->knot_bark[c]) * k->shift, q->bark);
  }
}

/* How far a face looks into the open ends of the cells along the stem, or of the rays': the
 * square of the normal's part along them, from 0.1 of the normal on. Without normals nothing. */
#define ENDS_FROM 0.01f
INLINE vf ends_seen(vf along2) {
  return vmax(along2 - splat(ENDS_FROM), splat(0.0f)) * splat(1.0f / (1.0f - ENDS_FROM));
}

#define EYE_STAIN 0.23f /* of what latewood reflects, what the outline of a bird's eye does not */

INLINE void stage_colour(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf one = splat(1.0f), zero = splat(0.0f);
  /* pores stand everywhere; earlywood rows where there is no latewood, or in its stead */
  vf season = k->late;
  if (w->has_eyes) season = season + (one - season) * vmin(k->stem.eye, one);
  vf late = season * (one - vmin(k->over_late, one));
  if (w->has_canals) late = canals_leave(w, &k->canal, k->f.bb, k->ring.inverse_width, late);
  late = clamp(late, zero, vmax(one - k->cover, zero));
  vf shift = w->has_eyes ? k->shift * (one - splat(EYE_STAIN) * vmin(k->stem.eye, one)) : k->shift;
  vf early = vmax(one - k->cover - late, zero) * shift, dark = late * shift;
  vf open = w->has_cells ? k->cover + k->lining : k->cover;
  vf heart = heart_share(w, k->years, k->c, k->sn, vsqrt(k->f.bb) * k->ring.inverse_width);
  vm pale = lt(heart, one);
  vf light[3], deep[3], tissue[3];
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    light[c] = splat(w->early[c]);
    deep[c] = splat(w->late[c]);
  }
  if (w->has_pigment) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      light[c] = mix(light[c], splat(w->pigment[c]), k->pigment);
      deep[c] = mix(deep[c], splat(PIGMENT_LATE * w->pigment[c]), k->pigment);
    }
  }
  if (any(pale)) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      light[c] = sel(pale, mix(splat(w->sap_early[c]), light[c], heart), light[c]);
      deep[c] = sel(pale, mix(splat(w->sap_late[c]), deep[c], heart), deep[c]);
    }
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) tissue[c] = light[c] * early + deep[c] * dark;
  if (w->has_cells && any(lt(zero, k->cell_contrast))) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      vf contrast = vmin(k->cell_contrast, cells_room(w, light[c]));
      tissue[c] = tissue[c] + tissue[c] * k->cells * contrast;
    }
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) tissue[c] = tissue[c] + splat(w->vessel[c]) * open;
  if (w->streaks.share > 0.0f) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      tissue[c] = mix(tissue[c], splat(w->streak[c]) * k->shift, k->streak);
    }
  }
  int ends = w->has_ends && io->in->normal[0];
  if (ends) {
    vf seen = ends_seen(one - k->up2);
    if (any(gt(seen, zero))) {
      vf left = one - seen * splat(w->shade);
      UNROLL(3)
      for (int c = 0; c < 3; c++) tissue[c] = tissue[c] * left;
    }
  }
  if (w->has_rays) {
    vf lit = k->shift;
    if (ends) {
      vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
      lit = lit * (one - ends_seen(out * out) * splat(w->ray_shade));
    }
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      vf ray = splat(w->ray[c]) * lit;
      if (w->has_cells) {
        vf contrast = vmin(k->cell_contrast, cells_room(w, splat(w->ray[c])));
        ray = ray + ray * k->ray_cells * contrast;
      }
      tissue[c] = mix(tissue[c], ray, k->ray);
    }
  }
  if (w->has_canals) {
    UNROLL(3)
    for (int c = 0; c < 3; c++) {
      tissue[c] = mix(tissue[c], splat(w->canal_colour[c]), k->canal.whole - k->canal.core);
      tissue[c] = mix(tissue[c], splat(w->canal_lumen[c]), k->canal.core);
    }
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) k->albedo[c] = tissue[c];
  if (k->knot) stage_knot_colour(w, k, k->knot->own);
  if (w->has_spalt) stage_spalt_colour(k);
  for (int c = 0; c < 3; c++) {
    if (boards) k->albedo[c] = board_albedo(w, &k->board, c, k->albedo[c]);
    store_lanes(io, WOOD_ALBEDO + c, k, k->albedo[c]);
  }
}

/* The same from a picture of the section: it shows rings, vessels and fibres
 * down to its pixels, and the fibres' noise goes on below them. */
INLINE void stage_picture(const wood_constants *w, int boards, const wood_io *io, block *k) {
  const stem_place *stem = &k->stem;
  stem_row(k);
  footprint2 f = footprint_in_section(w, boards, io, k);
  vf unused, widen = splat(1.0f) + outline_at(w, k->c, k->sn, &unused);
  picture_place p = picture_fold(w, k->x, k->z, k->c, k->sn, stem->rho);
  picture_albedo(w, &p, k->c, k->sn, widen, &f, k->n, k->albedo);
  store_lanes(io, WOOD_LATEWOOD, k, picture_late(w, k->albedo));
  store_lanes(io, WOOD_VESSEL, k, splat(0.0f));
  k->ray = splat(0.0f);
  store_lanes(io, WOOD_RAY, k, k->ray);
  store_lanes(io, WOOD_CANAL, k, k->ray);
  vf shift = fibre_shift(w, own_of(boards, k), p.x, p.z, &f);
  for (int c = 0; c < 3; c++) k->albedo[c] = k->albedo[c] * shift;
  k->shift = shift;
  if (k->knot) stage_knot_colour(w, k, picture_late(w, k->albedo));
  for (int c = 0; c < 3; c++) {
    if (boards) k->albedo[c] = board_albedo(w, &k->board, c, k->albedo[c]);
    store_lanes(io, WOOD_ALBEDO + c, k, k->albedo[c]);
  }
}

/* Figure, Kawai's equation (4): the lobe's normal dives with the fibre; slopes
 * that the footprint averages widen it instead. */
INLINE void stage_lobe(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf one = splat(1.0f);
  vf roughness = splat(w->roughness);
  k->exponent = splat(w->shininess);
  k->strength = splat(w->specular);
  if (boards) k->strength = k->strength * (one - k->board.unit.joint);
  vf variance = k->grain.variance + k->stem.lost_slope;
  vm widened = gt(variance * k->exponent, splat(1e-4f));
  if (any(widened)) {
    vf across = k->nrm[2] * k->stem.c - k->nrm[0] * k->stem.s;
    vf out = k->nrm[0] * k->stem.c + k->nrm[2] * k->stem.s;
    vf lost = k->grain.variance * across * across + k->stem.lost_slope * out * out;
    vf wide = one / (one + k->exponent * lost);
    wide = sel(widened, wide, one);
    k->exponent = k->exponent * wide;
    k->strength = k->strength * vsqrt(wide);
    roughness = vmin(vsqrt(splat(2.0f) / (k->exponent + splat(2.0f))), one);
  }
  if (w->surface.relief) {
    /* slopes of the surface, alike in all directions: alpha^2 + 2 variance. The
     * lobe itself stays one of n >= 1, which is 0 where light comes from below */
    vf narrow = splat(2.0f) / (k->exponent + splat(2.0f)), wide = vmin(narrow + k->lost, one);
    vf lobe = vmin(wide, splat(2.0f / 3.0f));
    k->exponent = splat(2.0f) / lobe - splat(2.0f);
    k->strength = k->strength * (narrow / lobe);
    roughness = vmin(vsqrt(wide), one);
  }
  store_lanes(io, WOOD_SPECULAR, k, k->strength);
  store_lanes(io, WOOD_ROUGHNESS, k, roughness);
}

INLINE void stage_light(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf zero = splat(0.0f), light[3], *l = k->light;
  if (!boards && k->o && as_before(io->in->light, k->i, k->n)) {
    for (int c = 0; c < 3; c++) l[c] = k[-1].light[c];
  } else {
    for (int c = 0; c < 3; c++) light[c] = load_lanes(io->in->light[c], k->i, k->n);
    unit_direction(light);
    to_log(w, boards, k, light, l);
  }
  k->incident = l[0] * k->nrm[0] + l[1] * k->nrm[1] + l[2] * k->nrm[2];
  /* up the stem within the surface */
  vf rise = (l[1] - k->nrm[1] * k->incident) * k->inverse_up;
  k->rise = sel(gt(k->up2, splat(1e-6f)), rise, zero);
}

INLINE void stage_tilt(block *k) {
  vf cosine = vsqrt(vmax(splat(1.0f) - k->sine * k->sine, splat(0.0f)));
  k->tilted = clamp01(k->incident * cosine + k->rise * k->sine);
}

/* Radiance of a channel, under the light's colour. */
INLINE void store_lit(const wood_io *io, const block *k, int c, vf r) {
  if (io->in->light_colour[c]) {
    vf e = load_lanes(io->in->light_colour[c], k->i, k->n);
    r = r * sel(lt(vabs(e), splat(1e30f)), e, splat(0.0f));
  }
  store_lanes(io, WOOD_RADIANCE + c, k, r);
}

/* Towards the eye, log space; the normal where no view is given, or none that
 * is a direction. */
INLINE void view_of(const wood_constants *w, int boards, const wood_io *io, const block *k,
                    vf out[3]) {
  for (int c = 0; c < 3; c++) out[c] = k->nrm[c];
  if (!io->in->view[0]) return;
  vf v[3], turned[3], size = splat(0.0f);
  for (int c = 0; c < 3; c++) {
    v[c] = load_lanes(io->in->view[c], k->i, k->n);
    size = size + vabs(v[c]);
  }
  vm given = and_(gt(size, splat(0.0f)), lt(size, splat(1e38f)));
  unit_direction(v);
  to_log(w, boards, k, v, turned);
  for (int c = 0; c < 3; c++) out[c] = sel(given, turned[c], k->nrm[c]);
}

/* What a host needs to build the cone itself. */
INLINE void stage_cone(const wood_constants *w, const wood_io *io, block *k) {
  cone_dive dive = cone_dive_of(k->sine);
  vf scale = w->cone ? cone_along(w->cone_scale, &dive) : splat(1.0f);
  for (int c = 0; c < 3; c++) {
    store_lanes(io, WOOD_CONE_COLOUR + c, k, splat(w->fibre_colour[c]) * scale);
  }
  vf variance = k->grain.variance + k->stem.lost_slope;
  vf width2 = splat(w->cone_width * w->cone_width) + splat(4.0f) * variance;
  store_lanes(io, WOOD_CONE_WIDTH, k, vsqrt(width2));
  store_lanes(io, WOOD_COAT, k, splat(w->coat));
}

INLINE void stage_cone_radiance(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf r[3], v[3], coat2 = splat(w->coat_alpha * w->coat_alpha);
  if (w->surface.relief) coat2 = vmin(coat2 + k->lost, splat(1.0f));
  view_of(w, boards, io, k, v);
  vf variance = k->grain.variance + k->stem.lost_slope;
  cone_radiance(w, k->light, v, k->nrm, k->fibre, k->sine, variance, coat2, k->albedo, r);
  if (w->has_rays) {
    /* the cells of a ray lie along the radius */
    vf zero = splat(0.0f), axis[3] = {k->stem.c, zero, k->stem.s}, shine[3];
    vf dive = zero - (axis[0] * k->nrm[0] + axis[2] * k->nrm[2]);
    cone_radiance(w, k->light, v, k->nrm, axis, dive, zero, coat2, k->albedo, shine);
    for (int c = 0; c < 3; c++) r[c] = mix(r[c], shine[c], k->ray);
  }
  if (boards) {
    /* what lies in the joint has no fibres */
    vf lit = splat(w->diffuse) * vmax(k->incident, splat(0.0f));
    for (int c = 0; c < 3; c++) {
      r[c] = mix(r[c], lit * board_filler(w, &k->board, c), k->board.unit.joint);
    }
  }
  for (int c = 0; c < 3; c++) store_lit(io, k, c, r[c]);
}

INLINE void stage_gloss(block *k) { k->power = power01_log2(k->tilted, k->exponent); }

/* The coat over Kawai's equation: what it reflects itself, and the share of the rest that it lets
 * in and out again. What lies in the joint has none. */
INLINE vf stage_coat(const wood_constants *w, int boards, const wood_io *io, const block *k,
                     vf *through) {
  vf v[3], one = splat(1.0f), coat2 = splat(w->coat_alpha * w->coat_alpha);
  if (w->surface.relief) coat2 = vmin(coat2 + k->lost, one);
  view_of(w, boards, io, k, v);
  vf ci = clamp01(k->incident);
  vf cr = clamp01(v[0] * k->nrm[0] + v[1] * k->nrm[1] + v[2] * k->nrm[2]);
  vf in = coat_through(w, ci, cone_refracted(w, ci));
  vf out = coat_through(w, cr, cone_refracted(w, cr));
  vf coat = coat_highlight(w, k->light, v, k->nrm, ci, cr, coat2);
  coat = sel(gt(cr, splat(0.0f)), coat, splat(0.0f));
  *through = in * out;
  if (boards) {
    vf joint = k->board.unit.joint;
    coat = coat * (one - joint);
    *through = mix(*through, one, joint);
  }
  return coat;
}

INLINE void stage_radiance(const wood_constants *w, int boards, const wood_io *io, block *k) {
  vf zero = splat(0.0f);
  vf gloss = k->strength * exp2_(k->power);
  vf diffuse = splat(w->diffuse) * vmax(k->incident, zero);
  vf coat = zero;
  if (w->coat > 0.0f) {
    vf through;
    coat = stage_coat(w, boards, io, k, &through);
    gloss = gloss * through;
    diffuse = diffuse * through;
  }
  UNROLL(3)
  for (int c = 0; c < 3; c++) {
    vf r = diffuse * k->albedo[c];
    if (w->coat > 0.0f) r = r + coat;
    store_lit(io, k, c, r + gloss * splat(w->tint_colour[c]));
  }
}

#include "surface/stage.h"

#ifndef BLOCKS
#define BLOCKS (LANES == 1 ? 1 : 128 / LANES)
#endif
#define EACH(...)                                                                                  \
  for (uint32_t k = 0; k < count; k++) __VA_ARGS__

#if LANES == 1
/* All octaves at once. */
INLINE void stage_undulations(const wood_constants *w, int boards, block *k) {
  k->undulation = undulation_alone(w, own_of(boards, k), k->p[1], k->s, &k->stem);
}

INLINE void stage_grain_noises(const wood_constants *w, int boards, block *k) {
  grain_noise_alone(w, own_of(boards, k), k->p[1], &k->at, k->extent, &k->grain);
}

INLINE void stage_bundles(const wood_constants *w, int boards, block *k) {
  k->bundle = fibre_alone(w, own_of(boards, k), k->x, k->z, &k->f);
  k->shift = k->bundle.shift;
}

/* For a point alone in another order: the chain from the turn through the rays is the longest,
 * and what does not wait for it stands between its steps, where the processor sees both. */
INLINE void evaluate_one(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                         const wood_wants *restrict want, block *k, wide_rings *wide) {
  board_sawn sawn;
  if (boards) memset(&sawn, 0, sizeof sawn);
  stage_load(w, boards, io, want, &sawn, k);
  stage_pith(w, boards, k);
  if (want->radiance && !want->relief) stage_light(w, boards, io, k);
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
  }
  if ((want->vessel || want->relief) && place_has_turn(w)) stage_turns(k);
  int rays = want->vessel && w->has_rays;
  if (want->direction) {
    stage_fibre(k);
    stage_direction(w, boards, io, want, k);
  }
  if (want->late) {
    stage_reach(w, boards, io, k);
    if (has_bent_boards(w, boards)) stage_wide(w, boards, io, k, wide);
    if (want->vessel || want->bundle) stage_section_footprint(w, boards, io, k);
    if (rays) stage_ray_turn(w, boards, k);
    if (want->bundle) stage_bundles(w, boards, k);
    if (rays) {
      stage_ray_shell(w, boards, k);
      ray_cell_at(w, &k->ray_at);
    }
    if (w->has_front) stage_stray(w, k);
    stage_rings(w, boards, io, k);
  }
  if (rays) stage_ray_seat(w, boards, k);
  if (want->vessel) {
    stage_vessel_parts(w, boards, k);
    stage_disc(w, boards, k);
    stage_pores(w, boards, k);
    if (rays) stage_ray_body(w, boards, k);
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
    if (rays) stage_rays(w, boards, io, k);
  }
}
#endif

/* restrict: what is stored is no constant, so that those are loaded before the
 * loops and not in them. */
INLINE void evaluate_as(int boards, const wood_constants *restrict w, const wood_io *restrict io,
                        const wood_wants *restrict want, block *blocks, surface_relief *reliefs,
                        wide_rings *wides, uint32_t count) {
#if LANES == 1
  evaluate_one(boards, w, io, want, &blocks[0], &wides[0]);
#else
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
  if (want->section) {
    EACH(stage_years(w, boards, &blocks[k]));
    if (w->has_wave) EACH(stage_wave(w, &blocks[k]));
    if (w->has_interlocked) EACH(stage_interlocked(w, boards, &blocks[k]));
    if (w->has_slope_noise) {
      grain_octave slopes[2] = {grain_octave_of(w, 0), grain_octave_of(w, 1)};
      EACH(stage_grain_noise(&slopes[0], boards, &blocks[k]));
      EACH(stage_grain_noise(&slopes[1], boards, &blocks[k]));
    }
    EACH(stage_turn(&blocks[k]));
    EACH(stage_section(w, io, &blocks[k]));
  }
  if (want->direction) {
    EACH(stage_fibre(&blocks[k]));
    EACH(stage_direction(w, boards, io, want, &blocks[k]));
  }
  if (want->late) {
    EACH(stage_reach(w, boards, io, &blocks[k]));
    if (has_bent_boards(w, boards)) EACH(stage_wide(w, boards, io, &blocks[k], &wides[k]));
    if (want->vessel || want->bundle) EACH(stage_section_footprint(w, boards, io, &blocks[k]));
    if (want->bundle) {
      UNROLL(3)
      for (int o = 0; o < WOOD_FIBRE_OCTAVES; o++) {
        fibre_octave octave = fibre_octave_of(w, o);
        EACH(stage_bundle(&octave, boards, o, &blocks[k]));
      }
    }
    if (w->has_front) EACH(stage_stray(w, &blocks[k]));
    EACH(stage_rings(w, boards, io, &blocks[k]));
  }
  if ((want->vessel || want->relief) && place_has_turn(w)) EACH(stage_turns(&blocks[k]));
  if (want->vessel) {
    EACH(stage_vessel_parts(w, boards, &blocks[k]));
    EACH(stage_disc(w, boards, &blocks[k]));
    EACH(stage_pores(w, boards, &blocks[k]));
    EACH(stage_rows(w, boards, &blocks[k]));
    EACH(stage_cover(w, boards, io, &blocks[k]));
    if (w->has_rays) {
      EACH(stage_ray_turn(w, boards, &blocks[k]));
      EACH(stage_ray_shell(w, boards, &blocks[k]));
      EACH(ray_cell_at(w, &blocks[k].ray_at));
      EACH(stage_ray_seat(w, boards, &blocks[k]));
      EACH(stage_ray_body(w, boards, &blocks[k]));
      EACH(stage_rays(w, boards, io, &blocks[k]));
    }
  }
#endif
  if (w->has_canals && want->vessel) EACH(stage_canals(w, boards, io, &blocks[k]));
  if (want->vessel && !w->has_canals) EACH(store_lanes(io, WOOD_CANAL, &blocks[k], splat(0.0f)));
  if (want->colour && w->has_cells && !want->picture) EACH(stage_cells(w, boards, &blocks[k]));
  if (want->colour && w->has_spalt && !want->picture) EACH(stage_spalt(w, boards, io, &blocks[k]));
  if (want->picture) {
    EACH(stage_picture(w, boards, io, &blocks[k]));
    if (want->relief) EACH(stage_relief(w, boards, io, &blocks[k], &reliefs[k]));
  } else {
    if (want->relief) EACH(stage_relief(w, boards, io, &blocks[k], &reliefs[k]));
    if (want->colour && w->has_pigment) EACH(stage_pigment(w, boards, &blocks[k]));
    if (want->colour && w->streaks.share > 0.0f) EACH(stage_streaks(w, boards, &blocks[k]));
    if (want->colour) EACH(stage_colour(w, boards, io, &blocks[k]));
  }
  if (want->relief) EACH(stage_bump(w, boards, io, &blocks[k], &reliefs[k]));
  if (want->cone) EACH(stage_cone(w, io, &blocks[k]));
#if LANES == 1
  int lit = !want->relief; /* seen to before the rays */
#else
  int lit = 0;
#endif
  if (want->lobe && !lit) EACH(stage_lobe(w, boards, io, &blocks[k]));
  if (want->radiance) {
    if (!lit) {
      EACH({
        stage_light(w, boards, io, &blocks[k]);
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
}

/* Twice in the code, with boards and without: a wood that is one piece pays
 * nothing for them. */
static __attribute__((noinline)) void evaluate_piece(const wood_constants *restrict w,
                                                     const wood_io *restrict io,
                                                     const wood_wants *restrict want, block *blocks,
                                                     surface_relief *reliefs, wide_rings *wides,
                                                     uint32_t count) {
  evaluate_as(0, w, io, want, blocks, reliefs, wides, count);
}

static __attribute__((noinline)) void evaluate_boards(const wood_constants *restrict w,
                                                      const wood_io *restrict io,
                                                      const wood_wants *restrict want,
                                                      block *blocks, surface_relief *reliefs,
                                                      wide_rings *wides, uint32_t count) {
  evaluate_as(1, w, io, want, blocks, reliefs, wides, count);
}

typedef struct {
  block blocks[BLOCKS];
  surface_relief reliefs[BLOCKS];
  knot_place knots[BLOCKS];
  wide_rings wides[BLOCKS];
} wood_blocks;

INLINE void evaluate_blocks(const wood_constants *w, const wood_io *io, const wood_wants *want,
                            int boards, wood_blocks *b, uint32_t count) {
  if (boards) {
    evaluate_boards(w, io, want, b->blocks, b->reliefs, b->wides, count);
  } else {
    evaluate_piece(w, io, want, b->blocks, b->reliefs, b->wides, count);
  }
}

#if LANES == 1
INLINE void evaluate_points(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                            int boards, uint32_t from, uint32_t to) {
  wood_blocks b;
  const wood_io part = {io->in, io->out};
  const uint8_t *active = io->in->active;
  for (uint32_t i = from; i < to; i++) {
    if (active && !active[i]) continue;
    b.blocks[0].i = i;
    b.blocks[0].n = 1;
    b.blocks[0].o = 0;
    b.blocks[0].knot = w->knots ? b.knots : NULL;
    evaluate_blocks(w, &part, want, boards, &b, 1);
  }
}
#else
/* The end of a batch, and where some points are not active: by a detour, so that
 * blocks need not ask which points are to be written. */
static __attribute__((noinline)) void evaluate_some(const wood_constants *w, const kernel_io *io,
                                                    const wood_wants *want, int boards,
                                                    wood_blocks *b, uint32_t count, wood_io *part,
                                                    uint32_t from, uint32_t n) {
  float room[WOOD_COMPONENTS][BLOCKS * LANES];
  const uint8_t *active = io->in->active;
  for (int c = 0; c < WOOD_COMPONENTS; c++) {
    if (io->out[c]) part->out[c] = room[c];
  }
  evaluate_blocks(w, part, want, boards, b, count);
  for (int c = 0; c < WOOD_COMPONENTS; c++) {
    if (!io->out[c]) continue;
    for (uint32_t i = 0; i < n; i++) {
      if (!active || active[from + i]) io->out[c][from + i] = room[c][i];
    }
  }
}

/* Points from..to, those of plies as wood in a layout is. */
INLINE void evaluate_points(const wood_constants *w, const kernel_io *io, const wood_wants *want,
                            int boards, uint32_t from, uint32_t to) {
  wood_blocks b;
  float spare[BLOCKS * LANES]; /* where components go that nobody asked for */
  wood_io part;
  part.in = io->in;
  for (int c = 0; c < WOOD_COMPONENTS; c++) part.out[c] = io->out[c] ? io->out[c] + from : spare;
  for (uint32_t i = from; i < to;) {
    uint32_t count = 0, first = i;
    for (; count < BLOCKS && i < to; count++, i += LANES) {
      block *k = &b.blocks[count];
      k->i = i;
      k->n = to - i < LANES ? to - i : LANES;
      k->o = i - first;
      k->knot = w->knots ? &b.knots[count] : NULL;
    }
    if (i > to || io->in->active) {
      evaluate_some(w, io, want, boards, &b, count, &part, first, i < to ? i - first : to - first);
      continue;
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

/* R(t, theta, y): rho of the year from the table, then the radius whose rho it
 * is, by Newton's method from above, where the field is all but linear. */
static void ring_radius(const wood_constants *w, uint32_t count, const float *t, const float *theta,
                        const float *y, float *out) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    vf years = clamp(finite_coordinate(load_lanes(t, i, n)), splat(0.0f), splat(1e5f));
    vf height = finite_coordinate(load_lanes(y, i, n));
    vf angle = load_lanes(theta, i, n);
    angle = sel(lt(vabs(angle), splat(1e4f)), angle, splat(0.0f));
    vf s, c, unused;
    sine_cosine(angle, &s, &c);
    vi whole;
    vf phase = years - vfloor(years, &whole);
    vi turns;
    vfloor(to_float(whole) * splat(1.0f / WOOD_RINGS), &turns);
    vi j = whole - turns * splati(WOOD_RINGS);
    vf rho = to_float(turns) * splat(w->ring_period) + gather(w->start, j) +
             phase / gather(w->inverse_width, j);
    stem_pith pith = pith_at(w, splatu(0), height);
    vf r = rho * (splat(1.0f) + outline_at(w, c, s, &unused));
    for (int k = 0; k < 8; k++) {
      stem_place p = stem_with_figure(w, r * c + pith.x, height, r * s + pith.z);
      vf slope = vmax(p.rho_x * p.c + p.rho_z * p.s, splat(0.2f));
      r = vmax(r + (rho - p.rho) / slope, splat(0.0f));
    }
    for (uint32_t k = 0; k < n; k++) out[i + k] = lane(r, k);
  }
}

static void pith(const wood_constants *w, uint32_t count, const float *y, float *out_x,
                 float *out_z) {
  for (uint32_t i = 0; i < count; i += LANES) {
    uint32_t n = count - i < LANES ? count - i : LANES;
    stem_pith p = pith_at(w, splatu(0), finite_coordinate(load_lanes(y, i, n)));
    for (uint32_t k = 0; k < n; k++) {
      out_x[i + k] = lane(p.x, k);
      out_z[i + k] = lane(p.z, k);
    }
  }
}

const wood_kernel KERNEL_NAME(wood_kernel_) = {KERNEL_OF(evaluate), ring_radius, pith};
