/* SPDX-License-Identifier: Apache-2.0 */
#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "build.h"
#include "parameters.h"

#define MEASURED 16384u /* points, for the paving's means; whole blocks of every width */

/* What a square corner of a radius of 1 leaves of its stone, all four. */
#define CORNER_LACKS 0.8584

/* Rings' corners are none, and where a fan or an arc ends stones are cut to all angles, with gaps
 * between them: what corners leave open there, over that; by 400,000 places of porphyry and
 * granite_fan (property.stone_filter holds the mean). */
static double odd_corners(int32_t kind) {
  return kind == LAYOUT_ARCS ? 1.15 : kind == LAYOUT_FAN ? 1.06 : 1.0;
}

/* Which parameter layout_build means, and why it will not do. */
static int32_t refuse(const settings *s, const layout *l, const char *what, double least,
                      double most) {
  const char *kind = s->list[P_LAYOUT].text;
  if (strcmp(what, "joint") == 0) {
    return fail(
        SOZAI_ERROR_RANGE,
        "joint_width: %.9g mm is too wide for layout = %s, whose stones are %.9g mm across; "
        "%.9g to %.9g mm",
        (double)l->joint, kind, (double)l->narrowest, least, most);
  }
  return fail(SOZAI_ERROR_RANGE,
              "stone_length: %.9g mm does not suit layout = %s and stone_width = %.9g mm; "
              "%.9g to %.9g mm",
              (double)l->length, kind, (double)l->width, least, most);
}

/* `what` is `is` mm, which a stone has no room for. */
static int32_t too_wide(const char *what, double is, const layout *l, double most) {
  return fail(SOZAI_ERROR_RANGE,
              "%s: %.9g mm is more than half of the narrowest stone leaves, which is %.9g mm "
              "across; 0 to %.9g mm",
              what, is, (double)l->narrowest, most);
}

static int32_t build_edges(stone_paving *p, const settings *s) {
  const layout *l = &p->layout;
  double wear = number_at(s, P_WEAR), joint = (double)l->joint;
  double most = 0.5 * ((double)l->narrowest - joint);
  double bevel = number_at(s, P_BEVEL), round = number_at(s, P_ROUND),
         corner = number_at(s, P_CORNER), drop = number_at(s, P_ROUND_DROP);
  if (bevel > most) return too_wide("bevel", bevel, l, most);
  if (round > most) return too_wide("edge_round", round, l, most);
  if (corner > most) return too_wide("corner_radius", corner, l, most);
  const double angle = number_at(s, P_BEVEL_ANGLE) * 0.017453292519943295769;
  /* wear rounds the edge further, to a sixth of the stone at most */
  double room =
      most - round < 0.16 * (double)l->narrowest ? most - round : 0.16 * (double)l->narrowest;
  round += wear * room;
  drop += wear * room * 0.3;
  p->corner = (float)corner;
  p->half = (float)(0.5 * joint);
  p->depth = (float)(joint > 0.0 ? number_at(s, P_JOINT_DEPTH) : 0.0);
  double wall = 0.6 * (double)p->half;
  if (wall > (double)p->depth) wall = (double)p->depth;
  p->wall = (float)(wall > 1e-3 ? wall : 1e-3);
  if (p->depth < 1e-3f) p->depth = 0.0f;
  p->chamfer = (float)bevel;
  p->slope = (float)(scalar_sin(angle) / scalar_cos(angle));
  p->round = (float)(drop > 0.0 ? round : 0.0);
  p->drop = (float)(round > 0.0 ? drop : 0.0);
  p->chipping = (float)(round > 0.0 && drop > 0.0 ? number_at(s, P_CHIPPING) : 0.0);
  double wider = (double)STONE_ROUND_MOST;
  p->round_most = (float)(round > 0.0 && most < wider * round ? most / round : wider);
  p->chip_frequency = (float)(0.45 / (round > 0.25 ? round : 0.25));
  p->reach = 0.3f * l->narrowest;
  p->grain_frequency = (float)(1.0 / number_at(s, P_JOINT_GRAIN));
  return SOZAI_OK;
}

static void build_weather(stone_weather *a, const settings *s, const float (*colours)[3]) {
  a->wear = (float)number_at(s, P_WEAR);
  a->grime = (float)number_at(s, P_GRIME);
  a->undulation = (float)number_at(s, P_UNDULATION);
  a->undulation_frequency = (float)(1.0 / number_at(s, P_UNDULATION_SIZE));
  a->moss = (float)number_at(s, P_MOSS);
  a->moss_spread = (float)number_at(s, P_MOSS_SPREAD);
  a->moss_height = (float)number_at(s, P_MOSS_HEIGHT);
  a->moss_told = 80.0f * (a->moss_spread > 8.0f ? a->moss_spread : 8.0f); /* of its patches */
  memcpy(a->moss_colour, colours[P_MOSS_COLOUR], sizeof a->moss_colour);
  a->wet = (float)number_at(s, P_WET);
  a->water = (float)number_at(s, P_WATER);
  a->on = a->grime > 0.0f || a->moss > 0.0f || a->wet > 0.0f || a->water > -999.0f;
}

int32_t stone_build_paving(stone_constants *w, const settings *s, const float (*colours)[3],
                           stone_measure_laid *measure) {
  stone_paving *p = &w->paving;
  build_weather(&w->weather, s, colours);
  w->weather.seed = hash1(w->seed + 105u);
  layout_choice c = {.kind = (int32_t)number_at(s, P_LAYOUT),
                     .length = number_at(s, P_LENGTH),
                     .width = number_at(s, P_WIDTH),
                     .joint = number_at(s, P_JOINT_WIDTH),
                     .variation = number_at(s, P_LENGTH_VARIATION),
                     .stagger = number_at(s, P_STAGGER),
                     .angle = number_at(s, P_CHEVRON_ANGLE),
                     .turn = number_at(s, P_ROTATION)};
  double least, most;
  const char *wrong = layout_build(&p->layout, &c, &least, &most);
  if (wrong) return refuse(s, &p->layout, wrong, least, most);
  if (c.kind == LAYOUT_NONE) return SOZAI_OK;
  int32_t r = build_edges(p, s);
  if (r) return r;
  double width = (double)(p->layout.width < p->layout.length ? p->layout.width : p->layout.length);
  p->wander.amplitude = (float)(number_at(s, P_WANDER) * width);
  w->weather.moss_told = (float)(16.0 * width); /* eight parts, each of twice a stone's size */
  p->wander.frequency = (float)(number_at(s, P_DIVISIONS) / width);
  p->wander.seed = hash1(w->seed + 106u);
  double steep = number_at(s, P_WANDER) * number_at(s, P_DIVISIONS);
  if (steep > 0.3) {
    return fail(SOZAI_ERROR_RANGE,
                "joint_wander: %.9g with joint_divisions = %.9g would have joints cross; 0 to %.9g",
                number_at(s, P_WANDER), number_at(s, P_DIVISIONS), 0.3 / number_at(s, P_DIVISIONS));
  }
  p->tilt = (float)number_at(s, P_TILT);
  p->settle = (float)number_at(s, P_SETTLE);
  p->crown = (float)number_at(s, P_CROWN);
  p->tone = (float)number_at(s, P_TONE);
  p->tint = (float)number_at(s, P_TINT);
  memcpy(p->colour, colours[P_JOINT_COLOUR], sizeof p->colour);
  /* rounded corners are joint */
  const double corners = CORNER_LACKS * odd_corners(p->layout.kind) * (double)p->corner *
                         (double)p->corner / ((double)p->layout.length * (double)p->layout.width);
  p->corner_share = (float)(corners / (1.0 - (double)p->layout.share));
  p->layout.share += (float)corners;
  stone_laid_means m;
  measure(w, MEASURED, &m);
  p->mean = (float)m.height;
  p->slope2 = (float)m.slope2;
  p->occlusion = (float)m.occlusion;
  w->weather.moss_mean = (float)m.moss;
  return SOZAI_OK;
}
