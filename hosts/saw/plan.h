/* SPDX-License-Identifier: Apache-2.0
 * Where the boards lie in a log: rectangles in its section, as long as the log.
 *
 * The section is that of wood's log space: x and z in mm, the pith at 0, 0; a
 * direction of `a` degrees is (cos a, sin a). */
#ifndef SOZAI_SAW_PLAN_H
#define SOZAI_SAW_PLAN_H

#include <stddef.h>
#include "failure.h"

#define SAW_PI 3.14159265358979323846
#define SAW_MOST_BOARDS 999

enum { SAW_LIVE, SAW_QUARTER, SAW_RIFT, SAW_ROTARY, SAW_PLANS };
extern const char *const saw_plan_names[SAW_PLANS];

/* All lengths in mm. */
typedef struct saw_job {
  int plan;         /* SAW_* */
  double radius;    /* of the log, under its bark, at its thinner end */
  double thickness; /* of a board, or of the veneer */
  double kerf;      /* what the saw takes between two of them; a knife takes nothing */
  double width;     /* at most; 0: as wide as the log gives */
  double azimuth;   /* degrees: the log is turned by this much first */
} saw_job;

typedef struct saw_board {
  int plan;
  double centre[2]; /* of its section: x, z */
  double rotation;  /* degrees, as wood's cut_rotation: the width runs along (cos, sin), and
                       the face looks along (-sin, cos), away from the pith */
  double width, thickness;
  double from, to; /* veneer: the knife's radius at its beginning and at its end */
} saw_board;

typedef struct saw_plan {
  saw_board boards[SAW_MOST_BOARDS];
  size_t count;
} saw_plan;

/* No two boards are nearer than the kerf, and all lie within the radius.
 * RANGE is a failure: the job's numbers are not finite or not above 0, nothing
 * fits, or there is more than the plan has room for. */
bool saw_plan_make(saw_plan *p, const saw_job *job, failure *why);

/* How far two sections are apart at least; below 0: they overlap. */
double saw_gap(const saw_board *a, const saw_board *b);
/* Of a veneer, mm: the length of the sheet between two of the knife's radii. */
double saw_sheet_length(double from, double to, double thickness);
/* Area of the section that the plan uses, mm^2. */
double saw_area(const saw_plan *p);
void saw_board_axes(const saw_board *b, double along[2], double out[2]);

/* ---- for the plans, one file each -------------------------------------- */

/* Boards narrower than this are not kept. */
double saw_least_width(const saw_job *job);
/* A slab from a0 to a1 along its width, its underside `q` from the pith, in the
 * frame of a rotation: ripped into boards no wider than allowed. false: no room. */
bool saw_add(saw_plan *p, const saw_job *job, double rotation, double a0, double a1, double q,
             failure *why);
/* Half a chord of the log, `q` from the pith; 0 outside. */
double saw_half_chord(const saw_job *job, double q);

bool saw_live(saw_plan *p, const saw_job *job, failure *why);
bool saw_quarter(saw_plan *p, const saw_job *job, failure *why);
bool saw_rift(saw_plan *p, const saw_job *job, failure *why);
bool saw_rotary(saw_plan *p, const saw_job *job, failure *why);

#endif
