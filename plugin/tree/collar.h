/* SPDX-License-Identifier: Apache-2.0
 *
 * The collar of a branch: where it leaves its parent, wood and bark of the one run on into the
 * other's, furthest below it and in the crotch above it, least at its sides (Shigo 1985, Canadian
 * Journal of Botany 63, 1391-1401). A surface that leaves the parent's along the parent and comes
 * to the branch's along the branch, both smoothly: over each line along the branch a cubic of
 * Bezier's. No collar lies about a branch that is as thick as its parent, or that leaves it too
 * slowly to be told from it.
 */
#ifndef SOZAI_TREE_COLLAR_H
#define SOZAI_TREE_COLLAR_H

#include "bark_surface.h"
#include "rings.h"

#define COLLAR_RINGS 12u /* at most */

/* Ways along it, of a ring: its hem lies under the parent's surface up to COLLAR_SEEN, the branch
 * is a tube from COLLAR_TUBE on, and its rings are round from COLLAR_END on. */
#define COLLAR_SEEN 1.0f
#define COLLAR_TUBE 2.0f
#define COLLAR_END 3.0f

typedef struct {
  ring axis[48];                     /* the parent's, about the branch's base; r: of its surface */
  uint32_t nodes, parts[3];          /* parts: rings from way to way */
  int furrowed;                      /* whether bark of the parent stands out there */
  float bark;                        /* mm: how thick it is there, of the parent, in the mean */
  float sunk, raised;                /* mm: how deep under that its hem begins, and how high over
                                        it ends */
  float age, own_age;                /* of bark: the parent's there, and the branch's */
  float begin, end;                  /* mm along the branch: where it leaves the parent, and from
                                        where on it is a tube */
  float along[3], level[3], side[3]; /* at its beginning: its direction, and square to that */
  float end_level[3], end_side[3];   /* the same where it is a tube */
  float lengths[3];                  /* mm, the longest, from way to way */
  const ring *rings;                 /* the branch's */
  uint32_t count;
} collar;

/* Whether a branch may have one at a level of detail. */
int collar_may_be(const tree_branch *b, uint32_t level);
/* Whether one of such rings has one at a level of detail; they have to outlive it. */
int collar_of(collar *c, const tree *t, const tree_branch *b, const bark_surface *bark,
              uint32_t level, const ring *rings, uint32_t count);

/* How many sides show it. */
uint32_t collar_sides(const tree_branch *b, uint32_t level);

/* How many rings there are with its own, in place of the first ones; and those, at most
 * COLLAR_RINGS more than there were. */
uint32_t collar_count(const collar *c);
void collar_rings(const collar *c, ring *out);

/* A line of it, from the parent on. */
typedef struct {
  float hem[3], hem_normal[3]; /* its beginning, and the parent's normal there */
  float bend[4][3];            /* the cubic */
  float normal[3];             /* the parent's, where that begins */
  float along[2];              /* mm along the branch, at the cubic's ends */
} collar_line;

/* round: cosine and sine, from level to side. */
void collar_line_of(const collar *c, const float round[2], collar_line *out);

/* A place of it and the way out of bark there. way: as of a ring. Gives mm along the branch. */
float collar_at(const collar *c, const collar_line *line, const float round[2], float way,
                float p[3], float out[3]);

#endif
