/* SPDX-License-Identifier: Apache-2.0
 *
 * What a mesh shows of bark beside its colour: furrows and lenticels, and how fine a mesh that
 * takes. Scars of branches are scars.h's.
 */
#ifndef SOZAI_TREE_BARK_SURFACE_H
#define SOZAI_TREE_BARK_SURFACE_H

#include "furrows.h"
#include "lenticels.h"
#include "scars.h"

typedef struct {
  furrows furrows;
  lenticels lenticels;
} bark_surface;

bark_surface bark_surface_of(const tree_plan *p);

/* Whether a branch is thick enough for it, or has scars. */
int bark_surface_on(const bark_surface *s, const tree *t, const tree_branch *b);

/* All round at one place of an axis. */
typedef struct {
  float depth;  /* mm, of furrows; as thick as their mean at least */
  float cut;    /* how much of them is cut, 0 to 1 */
  float dark;   /* their shade there, as a share */
  float old;    /* how much of it is rhytidome, in the mean */
  float first;  /* how much more of that is in furrows */
  float varied; /* how much plates differ, as a share */
  float turns;  /* and how much of that is in how far they have turned */
  float marks;  /* that of lenticels */
} bark_ring;

/* r, y: mm, the radius and the height. level: of detail. */
bark_ring bark_ring_at(const bark_surface *s, const tree_plan *p, float age, float r, float y,
                       uint32_t level);

/* mm: how far points may stand apart that show it, round the axis and along it; 0: at will. */
void bark_ring_steps(const bark_surface *s, const bark_ring *at, uint32_t level, float out[2]);

/* What it is like at one point. p: mm, across the axis, along it, across. */
typedef struct {
  float thick; /* mm */
  float old;   /* how much of it is rhytidome */
  float tone;  /* the factor of its colour */
} bark_point;

bark_point bark_at(const bark_surface *s, const bark_ring *at, const float p[3]);

#endif
