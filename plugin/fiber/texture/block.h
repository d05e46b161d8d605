/* SPDX-License-Identifier: Apache-2.0
 *
 * Points on their way through the kernel.
 */
#ifndef SOZAI_FIBERTEX_BLOCK_H
#define SOZAI_FIBERTEX_BLOCK_H

#include "../../core/lanes.h"
#include "bundle.h"
#include "cloth.h"
#include "lanes_counted.h"

/* Work of several blocks goes through a stage side by side: a stage waits for its own
 * results most of the time, and does not for another block's. */
#define BLOCKS_TOGETHER (LANES == 1 ? 1 : 32 / LANES)

#ifdef __clang__
#define ROLLED PRAGMA_(clang loop unroll(disable))
#else
#define ROLLED PRAGMA_(GCC unroll 1)
#endif
/* A stage over `count` of whatever it is, as a loop: copied out it would not fit the cache. */
#define EACH(k, count) ROLLED for (uint32_t k = 0; k < (count); k++)

/* What is asked for. The strand that most is seen of, of which light is asked, too. */
#define WANTS_LIGHT 1
#define WANTS_STRAND 2

/* Sums over what is seen; of colours the shares of the first and the second. */
typedef struct {
  vf left;      /* what is not covered yet */
  vf albedo[2]; /* in the shade of what is over it */
  vf direct[2]; /* reached by the light straight */
  vf bare;      /* as direct, whatever the colour */
  vf depth;
} sums;

/* How a face of a yarn is lit and seen: ground.h. */
typedef struct {
  vf in, out; /* cosines of light and view, over the face's own to the cloth */
  vf seen;    /* what of what is seen the face is, over what it is squarely */
} face_light;

/* What a cloth's yarn does to its strands, and what is the hull's of an aggregate. */
typedef struct {
  vf along[3], across[3], up[3]; /* in the hull's frame */
  vf weft, ambient, around, onward, straight;
  vf flown;   /* cloth: what single strands over it let through of straight light */
  vf lean[2]; /* cloth: tangent of the view's slant, 1 at most */
  face_light face;
  vf place[2];            /* along and round the yarn, mm */
  vf level, solid, whole; /* solid: there; whole: the mean */
  vf own[2];              /* cloth: what warp and weft show there, over their mean */
  vu h;
} ground;

/* A block of LANES points on its way through the layers. */
typedef struct {
  uint32_t i, n;
  cloth_place cloth;
  vf at[3];
  hull_frame f;
  lattice_frame g[LATTICES];
  lane_filter filter;
  ground ground;
  vf s;
  vf nap[2], nap_lost; /* the nap's turn, and how much steeper it is, log2; what the footprint holds
                        * of them, over all, standard deviations */
  vf cloud;            /* how bright strands are here, 1 in the mean; where there are clouds */
  sums sum;
  vf hole;                     /* what of it neither yarns nor what is below them cover */
  vf shade;                    /* what is left of light by strands close above */
  vf front;                    /* 0 behind, 1 in front, with a soft edge */
  vf inverse[2];               /* 1 over the cosines of light and view, none too great */
  vf inverse_up, step[2], lit; /* step: factors from layer to layer, of lit and of itself */
  vf reach;                    /* lit, of the first; of a cloth of the first on its yarns */
  vf deep_lit;                 /* what of it reaches what is below the layers */
  vf far;                      /* 0 where bundles are seen, 1 where only what all show together */
  /* the strand that most is seen of, and how much of the next */
  vf most, next;
  struct {
    vf direction[2], slope, bend, across;
    vf strand, lit;  /* what of its share is a strand, and lit */
    vf flown;        /* 1 where it stands off a cloth */
    vf bare, detail; /* in the end: how lit it is; 1 a strand, 0 no more than a mean */
    vu id;
  } best;
} block;

#endif
