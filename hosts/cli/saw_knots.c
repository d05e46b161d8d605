/* SPDX-License-Identifier: Apache-2.0
 *
 * Knots on the boards' faces: how many, and how much of the face they are. */
#include "saw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "cancel.h"
#include "saw_face.h"

/* Places where a knot may be, growing. */
typedef struct place_list {
  float *point[3];
  uint32_t *knot;
  uint32_t count, room;
  bool full;
} place_list;

static bool make_room(place_list *l) {
  uint32_t room = l->room ? 2 * l->room : 1024;
  for (int c = 0; c < 3; c++) {
    float *more = realloc(l->point[c], room * sizeof *more);
    if (!more) return false;
    l->point[c] = more;
  }
  uint32_t *more = realloc(l->knot, room * sizeof *more);
  if (!more) return false;
  l->knot = more;
  l->room = room;
  return true;
}

static void add_place(void *context, uint32_t knot, const double point[3]) {
  place_list *l = context;
  l->full = l->full || (l->count == l->room && !make_room(l));
  if (l->full) return;
  for (int c = 0; c < 3; c++) l->point[c][l->count] = (float)point[c];
  l->knot[l->count++] = knot;
}

static void free_places(place_list *l) {
  for (int c = 0; c < 3; c++) free(l->point[c]);
  free(l->knot);
}

/* Those that the wood shows at one of their places. */
static uint32_t count_knots(const place_list *l, const float *share) {
  uint32_t count = 0, last = UINT32_MAX;
  for (uint32_t i = 0; i < l->count; i++) {
    if (share[i] < 0.5f || l->knot[i] == last) continue;
    last = l->knot[i];
    count++;
  }
  return count;
}

static bool count_on(saw_work *w, size_t i, failure *why) {
  place_list l = {0};
  saw_knot_places(&w->log, &w->plan.boards[i], add_place, &l);
  float *share = malloc((l.count + 1) * sizeof *share);
  bool ok = (share && !l.full) || fail(why, EXIT_FAILURE, "out of memory");
  ok = ok && saw_knot_share(w, l.count, l.point, share, why);
  w->crossing[i] = ok ? count_knots(&l, share) : 0;
  free(share);
  free_places(&l);
  return ok;
}

/* Over the whole face, in squares of 3 mm or of as many as there is time for. */
static bool measure_share(saw_work *w, size_t i, failure *why) {
  const saw_board *b = &w->plan.boards[i];
  double length = b->plan == SAW_ROTARY ? b->width : w->log.length;
  double across = b->plan == SAW_ROTARY ? w->log.length : b->width;
  double pixel = fmin(fmax(3, sqrt(length * across / 2e5)), fmin(length, across));
  saw_face f = saw_board_face(w, b, 0, length, pixel);
  size_t n = (size_t)f.width * f.height;
  float *knot = malloc(n * sizeof *knot);
  if (!knot) return fail(why, EXIT_FAILURE, "out of memory");
  bool ok = saw_face_evaluate(&f, NULL, knot, why);
  double sum = 0;
  for (size_t k = 0; ok && k < n; k++) sum += (double)knot[k];
  w->share[i] = sum / (double)n;
  free(knot);
  return ok;
}

bool saw_measure_knots(saw_work *w, size_t i, failure *why) {
  if (cancel_requested()) return fail(why, EXIT_FAILURE, "cancelled");
  return count_on(w, i, why) && measure_share(w, i, why);
}
