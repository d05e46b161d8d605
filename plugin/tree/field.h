/* SPDX-License-Identifier: Apache-2.0
 *
 * Measured trees (Hayashi & Takahashi 1997, section 4.1, figures 14 to 16):
 * their table as text, the tree it describes, and what can be fitted to it.
 */
#ifndef SOZAI_TREE_FIELD_H
#define SOZAI_TREE_FIELD_H

#include "tree.h"

/* One segment, from a node to the next. */
typedef struct {
  double length;     /* cm */
  double theta, phi; /* degrees */
  double diameter;   /* cm at its base; 0: not measured */
} field_row;

/* The trunk, or a branch. */
typedef struct {
  char name[24];
  uint32_t parent; /* index of its block */
  uint32_t order;
  uint32_t node; /* the node from the ground that it stands on: its zeros */
  uint32_t first, rows;
} field_block;

typedef struct {
  field_block *blocks;
  field_row *lines;
  uint32_t block_count, row_count, block_room, row_room;
} tree_field;

/* FILE and a message with line and column for what is malformed. */
int32_t field_read(tree_field *f, const sozai_host *host, const char *text);
void field_free(tree_field *f, const sozai_host *host);

/* Branches and nodes as measured. */
int32_t field_grow(tree *t, const sozai_host *host, const tree_field *f);

/* What its first-order branches say, as section 3 of the paper reckons it. */
typedef struct {
  double height;                /* mm */
  double a, a_up, a_down, rms;  /* rms: of the lengths' residuals over the curve, as a share */
  double turns, branches;       /* a year, a turn */
  double mean, sd, least, most; /* divergence */
  uint32_t count;
} field_fit;

/* The same reckoning for branches in order from the ground. */
typedef struct {
  double z, azimuth, length; /* mm, degrees, mm */
} fit_branch;
void fit_branches(field_fit *out, const fit_branch *list, uint32_t count, double height,
                  double years, double upslope, double b);

int32_t field_fit_make(field_fit *out, const tree_field *f, const tree_plan *p);
void field_fit_apply(const field_fit *fit, tree_plan *p);
/* The first-order branches, sorted by height; count at most. */
uint32_t field_first_order(const tree_field *f, fit_branch *out, uint32_t most, double *height);

#endif
