/* SPDX-License-Identifier: Apache-2.0
 * Faces of a log, evaluated through the log's own texture. */
#ifndef SOZAI_CLI_SAW_FACE_H
#define SOZAI_CLI_SAW_FACE_H

#include "saw.h"

/* Where in the log the middle of a pixel is, mm, and which way the face looks. */
typedef struct saw_face saw_face;
struct saw_face {
  uint32_t width, height; /* pixels */
  double pixel;           /* mm */
  void (*place)(const saw_face *f, double x, double y, double point[3], double normal[3]);
  const saw_work *work;
  const saw_board *board;
  double from; /* mm: of a sheet's length, where the piece begins */
};

/* The log's lower end, seen from outside: x to the right, z up. */
saw_face saw_end_face(const saw_work *w, uint32_t pixels, double pixel);
/* A piece of a board's face, the lower end to the left; of a veneer, its
 * beginning to the left and the stem upright. */
saw_face saw_board_face(const saw_work *w, const saw_board *b, double from, double length,
                        double pixel);

/* rgb: 3 floats a pixel, scene-linear, top row first; knot: the share of knots.
 * Either may be NULL. */
bool saw_face_evaluate(const saw_face *f, float *rgb, float *knot, failure *why);
/* The same at points of the log, mm: x, y and z each. */
bool saw_knot_share(const saw_work *w, uint32_t count, float *const point[3], float *knot,
                    failure *why);

#endif
