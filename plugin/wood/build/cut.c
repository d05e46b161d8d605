/* SPDX-License-Identifier: Apache-2.0
 *
 * How the object lies in the log: sawn, or peeled off it.
 */
#include "parts.h"

#include <string.h>

#include "../../core/scalar.h"
#include "../../core/status.h"
#include "../parameters.h"
#include "../plies/parameters.h"

static int32_t build_veneer(wood_constants *w, const settings *s) {
  double radius = number_at(s, P_CUT_DISTANCE);
  if (radius < 1.0) {
    return fail(SOZAI_ERROR_RANGE,
                "cut_distance: %.9g mm is where the knife begins with cut = rotary; 1 to 5000 mm",
                radius);
  }
  if (choice_at(s, P_LAYOUT) != 0) {
    return fail(SOZAI_ERROR_RANGE, "layout: %s of a sheet of veneer (cut = rotary); only none",
                s->list[P_LAYOUT].text);
  }
  w->peeled = 1;
  w->peel_radius = (float)radius;
  w->peel_lead = (float)(number_at(s, P_VENEER) / (0.5 * TWO_PI));
  /* at first the face looks as that of a flat-sawn board does */
  w->peel_turn = (float)(TWO_PI * (0.25 + number_at(s, P_CUT_ROTATION) / 360.0));
  w->shift[1] += (float)number_at(s, P_CUT_HEIGHT);
  return SOZAI_OK;
}

/* The object's axes in the log, before the turn: columns are x, y, z. */
static void object_axes(const settings *s, int cut, double axes[3][3]) {
  static const double along[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  static const double end[3][3] = {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  /* a board's length leans towards its face and within it */
  const double lean = TWO_PI / 360.0 * number_at(s, P_CUT_TILT);
  const double askew = TWO_PI / 360.0 * number_at(s, P_CUT_SKEW);
  const double ct = scalar_cos(lean), st = scalar_sin(lean), ck = scalar_cos(askew),
               sk = scalar_sin(askew);
  const double tilted[3][3] = {{ck, sk * ct, -sk * st}, {-sk, ck * ct, -ck * st}, {0, st, ct}};
  memcpy(axes, cut == CUT_END ? end : cut == CUT_LOG ? along : tilted, sizeof tilted);
}

/* The middle of the object, before the turn. */
static void object_place(const settings *s, int cut, double place[3]) {
  static const double half_root = 0.70710678118654752440;
  double d = number_at(s, P_CUT_DISTANCE);
  place[0] = place[2] = 0.0;
  place[1] = cut == CUT_LOG ? 0 : number_at(s, P_CUT_HEIGHT);
  if (cut == CUT_FLAT) place[2] = d;
  if (cut == CUT_QUARTER || cut == CUT_END) place[0] = d;
  if (cut == CUT_RIFT) place[0] = place[2] = d * half_root;
}

int32_t wood_build_cut(wood_constants *w, const settings *s) {
  int cut = choice_at(s, P_CUT);
  if (choice_at(s, P_CONSTRUCTION) != CONSTRUCTION_SOLID) return SOZAI_OK; /* each ply its own */
  if (cut == CUT_ROTARY) {
    for (int i = 0; i < 3; i++) w->shift[i] = (float)s->list[P_CUT_OFFSET].number[i];
    return build_veneer(w, s);
  }
  double angle = number_at(s, P_CUT_ROTATION) * TWO_PI / 360.0;
  double c = scalar_cos(angle), n = scalar_sin(angle), axes[3][3], place[3];
  object_axes(s, cut, axes);
  object_place(s, cut, place);
  /* about the stem: x towards z, as theta runs */
  const double turn[3][3] = {{c, 0, -n}, {0, 1, 0}, {n, 0, c}};
  for (int i = 0; i < 3; i++) {
    double shift = s->list[P_CUT_OFFSET].number[i];
    for (int j = 0; j < 3; j++) {
      double sum = 0.0;
      for (int k = 0; k < 3; k++) sum += turn[i][k] * axes[k][j];
      w->turn[i][j] = (float)sum;
      if (w->turn[i][j] != (i == j ? 1.0f : 0.0f)) w->turned = 1;
      shift += turn[i][j] * place[j];
    }
    w->shift[i] = (float)shift;
  }
  return SOZAI_OK;
}
