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

/* Radii at the count + 1 nodes of segments: as measured, cones between, and base, mm, where
 * not even the first was. */
void field_radii(const field_row *rows, uint32_t count, double base, tree_node *nodes);

/* A first-order branch as the fit sees it: mm, degrees. */
typedef struct {
  double z, azimuth, length;
  double elevation; /* of its tip, seen from its base */
  double diameter;  /* at its base; 0: not measured */
  double stem;      /* the stem's diameter there; 0: not measured */
} fit_branch;

/* A measured trunk: from its lowest measured diameter up. */
typedef struct {
  double z, diameter;
} fit_stem;

/* What a table says of both. */
typedef struct {
  fit_branch *list; /* from the ground */
  fit_stem *stem;
  uint32_t count, stem_count;
  uint32_t room, stem_room;
  double height; /* mm */
} fit_data;

int32_t fit_data_make(fit_data *out, const sozai_host *host, const tree_field *f);
void fit_data_free(fit_data *d, const sozai_host *host);

/* What first-order branches say, as section 3 of the paper reckons it, and how they and the
 * stem are built. */
typedef struct {
  double height;                /* mm */
  double a, a_up, a_down, rms;  /* rms: of the lengths' residuals over the curve, as a share */
  double turns, branches;       /* a year, a turn */
  double mean, sd, least, most; /* divergence */
  double lean, lean_sd;         /* elevation of tips seen from bases */
  double stem, stem_at;         /* the stem's diameter, mm, at that height, mm; 0: not measured */
  double slender;               /* diameters at the base over lengths; 0: not measured */
  double ratio;                 /* mean of it over the stem's there; 0: not measured */
  uint32_t count;
} field_fit;

void fit_branches(field_fit *out, const fit_branch *list, uint32_t count, double height,
                  double years, double upslope, double b);
/* Of a table; FILE if it has too little. */
int32_t fit_make(field_fit *out, const fit_data *d, const tree_plan *p);
/* From then on the plan grows its siblings. */
void sibling_plan(tree_plan *p, const field_fit *fit, const fit_data *d);

#endif
