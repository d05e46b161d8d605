/* SPDX-License-Identifier: Apache-2.0
 * What the parts of `sozai saw` hand to one another. */
#ifndef SOZAI_CLI_SAW_H
#define SOZAI_CLI_SAW_H

#include "plan.h"
#include "saw_folder.h"
#include "session.h"
#include "stem.h"

typedef struct saw_options {
  const char *species, *field, *wood, *plan, *output;
  double age, log_height, log_length, thickness, width, kerf, knot_size, azimuth;
  uint32_t seed, size[2];
} saw_options;

/* A board's place as wood's parameters have it. */
typedef struct saw_cut {
  const char *name;
  double distance, height, rotation, offset[3];
} saw_cut;

typedef struct saw_work {
  saw_options options;
  session *session;
  char *field;                  /* the text of --field's file; NULL: grown */
  const recipe *wood;           /* of the log: every board has these parameters, and its own */
  const sozai_texture *texture; /* the log's, cut = log */
  saw_stem stem;
  saw_log log;
  saw_job job;
  saw_plan plan;
  double lower; /* mm: radius at the log's lower end */
  double yield; /* percent of the log */
  uint32_t crossing[SAW_MOST_BOARDS];
  double share[SAW_MOST_BOARDS]; /* of knots on the face */
} saw_work;

saw_cut saw_cut_of(const saw_work *w, const saw_board *b);

/* How many knots board i has on its face, and their share of it. */
bool saw_measure_knots(saw_work *w, size_t i, failure *why);

/* A board's file name, "board-01.sozai". */
void saw_board_file(const saw_work *w, size_t i, char out[64]);

/* The boards' recipes and saw.json. */
bool saw_write_files(const saw_work *w, const saw_folder *f, failure *why);

/* log.png: the lower end with its cuts, and the faces. */
bool saw_write_picture(const saw_work *w, const saw_folder *f, failure *why);

#endif
