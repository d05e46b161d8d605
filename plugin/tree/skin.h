/* SPDX-License-Identifier: Apache-2.0
 *
 * A tube's bark, point by point: how thick it is and its colour, of furrows, lenticels and scars
 * together. And a stem's at any place near it, for the collars of its branches, over which it runs
 * on.
 */
#ifndef SOZAI_TREE_SKIN_H
#define SOZAI_TREE_SKIN_H

#include "bark_surface.h"
#include "rings.h"

/* A ring: how it lies, and what its bark is like. */
typedef struct {
  float r;                 /* mm, without roots */
  float own;               /* mm: where its branch's bark begins */
  float level[3], side[3]; /* its plane */
  float even[3];           /* its colour all round, where there is nothing on it */
  int plain;               /* that it is so everywhere */
  float bare[3], turned[3];
  bark_ring bark;
  scars_here scars;
} ring_skin;

/* All but how it lies. level: of detail. */
void skin_of(ring_skin *o, const tree *t, const tree_branch *b, const bark_surface *s,
             uint32_t level, const ring *at);

typedef struct {
  float thick; /* mm */
  float colour[3];
} skin_point;

/* round: cosine and sine, from level to side; r: mm from the axis; v: of uv. */
skin_point skin_at(const ring_skin *o, const bark_surface *s, const float round[2], float r,
                   float v);

/* The stem's rings at its nodes. */
typedef struct {
  ring at[RINGS_MOST];
  float level[RINGS_MOST][3], v[RINGS_MOST];
  uint32_t count;
} stem_skin;

void stem_skin_of(stem_skin *o, const tree *t, uint32_t level);

/* At a place near its surface. thick: over its mean. */
skin_point stem_skin_at(const stem_skin *o, const tree *t, const bark_surface *s, uint32_t level,
                        const float p[3]);

/* The frame of a ring that follows another: square to along, and turned no further. */
void skin_carry(float level[3], const float along[3]);
void skin_side(const float along[3], const float level[3], float side[3]);

#endif
