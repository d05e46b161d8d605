/* SPDX-License-Identifier: Apache-2.0
 *
 * Points on their way through the kernel, and where their answers go.
 */
#ifndef SOZAI_WOOD_STAGES_BLOCK_H
#define SOZAI_WOOD_STAGES_BLOCK_H

#include "../../core/lanes.h"
#include "../boards.h"
#include "../bolt.h"
#include "../canals.h"
#include "../fibre.h"
#include "../grain.h"
#include "../knots.h"
#include "../rays.h"
#include "../rings_curved.h"
#include "../spalt.h"
#include "../stem.h"
#include "../surface/slopes.h"
#include "../vessels.h"

#ifndef BLOCKS
#define BLOCKS (LANES == 1 ? 1 : 128 / LANES)
#endif

/* What the stages read and write. */
typedef struct {
  const sozai_batch *in;
#if LANES == 1
  float *const *out;
#else
  float *out[WOOD_COMPONENTS]; /* from the first point of the first block on; none is NULL */
#endif
} wood_io;

/* Rings over the parts of a wide footprint; see plies/wide.h. */
typedef struct {
  vf mean[RING_MEANS]; /* of MEAN_LATE... */
  vf share;            /* 0..1: how far they stand in for the whole */
} wide_rings;

/* What blocks that follow one another mostly share: the cells of wide noises. */
typedef struct {
  noise_held pith, undulation[2], interlocked, slope[2], drift, sway[2];
} wood_held;

INLINE void wood_held_none(wood_held *h) {
  noise_held *all = &h->pith;
  for (size_t i = 0; i < sizeof *h / sizeof *all; i++) noise_held_none(&all[i]);
}

/* A place in a cross section of the stem. */
typedef struct {
  vf c, s, x, z; /* direction from the pith; mm */
  footprint2 f;  /* over (arc, rho) there */
} section_place;

/* What is there for a few stages only shares its place with what comes after: less memory to go
 * through. A point alone goes through them in another order. */
#if LANES == 1
#define BY_TURNS struct
#else
#define BY_TURNS union
#endif

/* A block of LANES points on its way through the stages. The stages run over a
 * few blocks each before the next begins, and are short: the blocks do not wait
 * for one another, and the processor sees far enough ahead to have the next one
 * begin while this one waits for its own results. */
typedef struct {
  uint32_t i, n; /* the first point, and how many */
  uint32_t o;    /* the first point, among those of the blocks on their way together */
  BY_TURNS {
    undulation_sum undulation;
    vf in_table; /* rho, within the table of rings */
    struct {
      noise_axis at; /* the year, for the grain's noises */
      wave_phase wave;
    };
    fibre_sum bundle;
    struct {
      disc pore;
      matrix2 seen; /* the footprint over (x, z) there */
    };
    struct {
      ray_turn ray_from;
      ray_cells ray_at;
      vu ray_on;
      ray_body ray_in;
      vf ray_first; /* of the first layer where there are two: ray_in.a, */
      vu ray_first_on;
    };
    struct {
      vf exponent, strength, incident, rise, tilted, power; /* figure */
      vf light[3];                                          /* log space */
      vf streak, pigment;                                   /* share of minerals; depth of bands */
      vf steep_strength, steep_power; /* of the lobe over the relief's steep part; over power */
      vf past;                        /* of the light, what comes past the relief */
    };
  };
  vf p[3];            /* log space */
  vf nrm[3];          /* normal, log space */
  vf s;               /* footprint */
  vf up2, inverse_up; /* squared length of +y within the surface, its inverse root */
  stem_place stem;
  ring_place ring;
  vf years, divisor, phase;
  vf extent; /* mm, of the footprint along y */
  grain_place grain;
  section_place section; /* in the reference section */
  vf radius;             /* mm: in either section */
  section_place bolt;    /* and where what grows in a bolt of the stem is looked up, */
  bolt_at in;            /* only if it is elsewhere in some lane */
  vf turn;               /* of the direction, over 2 pi */
  vf fibre[3];           /* direction, log space */
  vf sine;               /* of the dive angle */
  vf b[3], bn;           /* row of the map from surface to rho; that along the normal */
  vf reach;              /* mm: rings_extent */
  vessel_bands bands;
  vessel_cover_t vessels;
  int pores_parted, rows_parted; /* these have been looked up in parts */
  fibre_bundle strays;           /* by which vessels' bands do */
  vf front_rho, front_reach;     /* of latewood where it strays */
  ring_place front_ring;         /* where that crosses a ring's end for any lane */
  int crossed;
  vf shift;                     /* of brightness, a factor */
  vf between;                   /* of parenchyma, among a band's vessels, */
  int between_found;            /* if it has been */
  vf margin, tough, rest, soft; /* parenchyma; see stages/parenchyma.h */
  vf late, over_late, cover, ray, albedo[3];
  const lost_slopes *lost; /* of the relief, where it has one */
  int rays_gone;           /* no lane asks for ray_on and ray_in */
  vf ray_lean, ray_unlike; /* of its cells' axis; the variance of it that the footprint averages */
  canal_cover canal;
  vf cells, cell_contrast, lining; /* relative to the tissue's colour and the vessels' */
  vf ray_cells;                    /* and to the rays' */
  spalt_place spalt;
  wood_board board; /* where there are boards */
  knot_place *knot; /* where there are knots, else NULL */
  wood_held *held;
  curved_rings *curve; /* where rings curve under some lane's footprint, else NULL */
  wide_rings *wide;    /* where a footprint on veneer is wide, else NULL */
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

/* Where vessels, rays and cells are. */
INLINE const section_place *grown_at(const block *k) {
  return k->in.moved ? &k->bolt : &k->section;
}

/* The board's offset to the seeds. */
INLINE vu own_of(int boards, const block *k) { return boards ? k->board.own : splatu(0); }

#endif
