/* SPDX-License-Identifier: Apache-2.0 */
#include <string.h>

#include "../core/scalar.h"
#include "../core/status.h"
#include "build.h"
#include "parameters.h"

#define DEGREE 0.017453292519943295769

/* Which parameter layout_build means, and why it will not do. */
static int32_t refuse(const settings *s, const layout *l, const char *what, double least,
                      double most) {
  const char *kind = s->list[P_LAYOUT].text;
  if (strcmp(what, "joint") == 0) {
    return fail(SOZAI_ERROR_RANGE,
                "joint_width: %.9g mm is too wide for layout = %s, whose units are %.9g mm across; "
                "%.9g to %.9g mm",
                (double)l->joint, kind, (double)l->narrowest, least, most);
  }
  return fail(SOZAI_ERROR_RANGE,
              "board_length: %.9g mm does not suit layout = %s and board_width = %.9g mm; "
              "%.9g to %.9g mm",
              (double)l->length, kind, (double)l->width, least, most);
}

static int32_t build_profile(wood_boards *b, const settings *s) {
  const double angle = number_at(s, P_BEVEL_ANGLE) * DEGREE, bevel = number_at(s, P_BEVEL);
  double most = 0.5 * ((double)b->layout.narrowest - (double)b->layout.joint);
  if (bevel > most) {
    return fail(SOZAI_ERROR_RANGE,
                "bevel: %.9g mm is more than half of the narrowest unit, which is %.9g mm across; "
                "0 to %.9g mm",
                bevel, (double)b->layout.narrowest, most);
  }
  layout_profile *p = &b->profile;
  p->bevel = (float)bevel;
  p->slope = (float)(scalar_sin(angle) / scalar_cos(angle));
  p->depth = (float)(b->layout.joint > 0.0f ? number_at(s, P_JOINT_DEPTH) : 0.0);
  p->cup = (float)number_at(s, P_CUPPING);
  double foot = (double)p->bevel * (double)p->slope, round = 2.0 * bevel;
  double sides = round / (double)b->layout.length + round / (double)b->layout.width;
  p->mean = (float)(-((double)b->layout.share * (foot + (double)p->depth) + 0.5 * foot * sides));
  return SOZAI_OK;
}

int32_t wood_build_boards(wood_constants *w, const settings *s, const float (*colours)[3]) {
  wood_boards *b = &w->boards;
  layout_choice c = {.kind = (int32_t)number_at(s, P_LAYOUT),
                     .length = number_at(s, P_BOARD_LENGTH),
                     .width = number_at(s, P_BOARD_WIDTH),
                     .joint = number_at(s, P_JOINT_WIDTH),
                     .variation = number_at(s, P_BOARD_LENGTH_VARIATION),
                     .stagger = number_at(s, P_STAGGER),
                     .angle = number_at(s, P_CHEVRON_ANGLE),
                     /* boards along +y, as boards that are cut alone */
                     .turn = 90.0 + number_at(s, P_LAYOUT_ROTATION)};
  double least, most;
  const char *wrong = layout_build(&b->layout, &c, &least, &most);
  if (wrong) return refuse(s, &b->layout, wrong, least, most);
  if (c.kind == LAYOUT_NONE) return SOZAI_OK;
  int32_t r = build_profile(b, s);
  if (r) return r;
  double flat = number_at(s, P_CUT_FLAT), rift = number_at(s, P_CUT_RIFT),
         quarter = number_at(s, P_CUT_QUARTER);
  double sum = flat + rift + quarter;
  if (sum <= 0.0) {
    return fail(
        SOZAI_ERROR_RANGE,
        "boards_flat, boards_rift, boards_quarter: %.9g, %.9g and %.9g leave no cut; one of "
        "them above 0, to 1",
        flat, rift, quarter);
  }
  b->flat = (float)(flat / sum);
  b->rift = (float)(rift / sum);
  b->distance = (float)number_at(s, P_CUT_DISTANCE);
  if (b->distance < 0.0f) b->distance = -b->distance;
  const double turn = 2.4494897 * DEGREE;
  b->lean = (float)(turn * number_at(s, P_CUT_TILT));
  b->skew = (float)(turn * number_at(s, P_CUT_SKEW));
  b->tone = (float)number_at(s, P_TONE_SPREAD);
  b->flip = (int32_t)number_at(s, P_FLIP);
  b->end = c.kind == LAYOUT_END_GRAIN || (int32_t)number_at(s, P_CUT) == CUT_END;
  memcpy(b->joint_colour, colours[P_JOINT_COLOUR], sizeof b->joint_colour);
  return SOZAI_OK;
}
