/* SPDX-License-Identifier: Apache-2.0
 *
 * Plies: a sheet glued up from veneers. What a lay-up is once it is made:
 * numbers and tables that never change.
 *
 *   taps.h  which plies lie under a point's footprint, and how much of each;
 *           each is asked for its own wood, and the answers are averaged
 *   piece.h where a place in a ply was in the log that it was cut from
 *   ply.h   what a footprint sees of it
 *
 * Depth runs down from the sheet's face. A sheet's plies are numbered from the
 * face, those of the sheets below go on from there.
 */
#ifndef SOZAI_WOOD_PLIES_H
#define SOZAI_WOOD_PLIES_H

#include <stdint.h>

#define PLIES_MOST 101   /* of a sheet */
#define PLIES_TAPS 16    /* plies that a footprint looks at, at most */
#define PLIES_LEAVES 24  /* of a flitch */
#define PLIES_HOLLOW 0.1 /* of the wood's reflectance is seen in a gap of the core */

/* What a ply is. */
enum { PLY_CORE, PLY_FACE, PLY_BACK, PLY_STRIPS };

/* How the faces' veneer was cut; the core's is peeled, or sawn if it is strips. */
enum { FACE_ROTARY, FACE_SLICED, FACE_QUARTERED };
enum { MATCH_BOOK, MATCH_SLIP, MATCH_RANDOM };

typedef struct {
  int32_t count;          /* plies of a sheet; 0: solid wood */
  int32_t sheets;         /* glued one below the other */
  float face;             /* mm: z of the first sheet's face */
  float thick;            /* mm, of a sheet */
  float top[PLIES_MOST];  /* mm: depth at which a ply begins, in the glue's middle */
  float deep[PLIES_MOST]; /* mm: from there to the next one */
  int32_t kind[PLIES_MOST];
  int32_t crossed[PLIES_MOST]; /* 1: its grain runs across the faces' */

  float radius;   /* mm: of the log, where the knife begins; the mean */
  float tone;     /* sd of a ply's shade, relative */
  float width[2]; /* mm, of the pieces: the core's, the faces' */
  int32_t face_cut, match;
  float gap;                   /* mm, of the widest joint in the core */
  float check_depth;           /* of the thickness, the deepest; 0: none */
  float glue, step, step_ramp; /* mm */
  float wander, swell;         /* of glue lines: mm; of their thickness */
  uint32_t seed;
  float glue_colour[3], hollow_colour[3];
} wood_plies;

#endif
