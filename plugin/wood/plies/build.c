/* SPDX-License-Identifier: Apache-2.0
 *
 * From parameters to a lay-up. How many plies a thickness takes was set against
 * the table of the Handbook of Finnish Plywood (Finnish Forest Industries
 * Federation, 2002): birch veneers of 1.4 mm make 4 mm of 3, 6.5 of 5, 9 of 7, 12
 * of 9, 15 of 11, 18 of 13 and so on to 30 of 21 plies, sanded. Terms and the
 * kinds of core after EN 313-1 and -2; LVL after EN 14374; lathe checks reach up
 * to 70 or 80 % of the thickness (Rohumaa et al., Holzforschung 67, 2013).
 */
#include "build.h"

#include <string.h>

#include "../../core/status.h"
#include "../parameters.h"
#include "parameters.h"

/* As many as fill the thickness best. */
static int32_t count_of(const settings *s, int construction) {
  int32_t count = (int32_t)number_at(s, P_PLIES);
  double thick = number_at(s, P_SHEET_THICKNESS), core = number_at(s, P_CORE_VENEER);
  double left = thick - 2.0 * number_at(s, P_FACE_VENEER);
  if (count) return count;
  if (construction == CONSTRUCTION_BLOCKBOARD) return 5;
  if (construction == CONSTRUCTION_LVL) {
    double n = thick / core + 0.5;
    return n < 2.0 ? 2 : n > 1e6 ? 1000000 : (int32_t)n;
  }
  /* odd: one and so many pairs between the faces */
  double pairs = 0.5 * (left / core - 1.0) + 0.5;
  return pairs < 1.0 ? 3 : pairs > 1e6 ? 1000001 : 3 + 2 * (int32_t)pairs;
}

static int32_t check_count(const settings *s, int construction, int32_t count) {
  const char *what = s->list[P_CONSTRUCTION].text;
  if (count > PLIES_MOST) {
    return fail(SOZAI_ERROR_RANGE,
                "core_veneer: %.9g mm makes more than %d plies of sheet_thickness = %.9g mm; at "
                "least %.9g mm",
                number_at(s, P_CORE_VENEER), PLIES_MOST, number_at(s, P_SHEET_THICKNESS),
                number_at(s, P_SHEET_THICKNESS) / (PLIES_MOST - 1));
  }
  if (construction == CONSTRUCTION_PLYWOOD && (count < 3 || count % 2 == 0)) {
    return fail(SOZAI_ERROR_RANGE, "plies: %d of %s; an odd number, 3 to %d, or 0", (int)count,
                what, PLIES_MOST);
  }
  if (construction == CONSTRUCTION_BLOCKBOARD && count != 3 && count != 5) {
    return fail(SOZAI_ERROR_RANGE, "plies: %d of %s; 3, or 5 with crossbands, or 0", (int)count,
                what);
  }
  if (construction == CONSTRUCTION_LVL && count < 2) {
    return fail(SOZAI_ERROR_RANGE, "plies: %d of %s; 2 to %d, or 0", (int)count, what, PLIES_MOST);
  }
  return SOZAI_OK;
}

/* Thicknesses from the face down. */
static int32_t lay(wood_plies *p, const settings *s, int construction) {
  double thick = number_at(s, P_SHEET_THICKNESS), face = number_at(s, P_FACE_VENEER);
  double band =
      construction == CONSTRUCTION_BLOCKBOARD && p->count == 5 ? number_at(s, P_CORE_VENEER) : 0.0;
  int all_alike = construction == CONSTRUCTION_LVL;
  double outer = all_alike ? 0.0 : 2.0 * face + 2.0 * band;
  double rest = (thick - outer) / (all_alike ? p->count : band > 0.0 ? 1 : p->count - 2);
  if (rest < 0.05) {
    return fail(SOZAI_ERROR_RANGE,
                "sheet_thickness: %.9g mm leaves no core within the %.9g mm of its outer plies "
                "(face_veneer%s); above %.9g mm",
                thick, outer, band > 0.0 ? ", core_veneer" : "", outer + 0.05 * (p->count - 2));
  }
  double at = 0.0, least = 1e30;
  for (int i = 0; i < p->count; i++) {
    int from_side = i < p->count - 1 - i ? i : p->count - 1 - i;
    double deep = rest;
    if (!all_alike && from_side == 0) deep = face;
    if (band > 0.0 && from_side == 1) deep = band;
    p->top[i] = (float)at;
    at += deep;
    p->deep[i] = (float)(at - (double)p->top[i]);
    if (deep < least) least = deep;
    p->kind[i] = i == 0 ? PLY_FACE : i == p->count - 1 ? PLY_BACK : PLY_CORE;
    p->crossed[i] = all_alike ? 0 : i & 1;
    if (construction == CONSTRUCTION_BLOCKBOARD && 2 * i + 1 == p->count) p->kind[i] = PLY_STRIPS;
  }
  p->thick = (float)thick;
  double glue = number_at(s, P_GLUE_LINE);
  if (glue > 0.5 * least) {
    return fail(SOZAI_ERROR_RANGE,
                "glue_line: %.9g mm is more than half of the thinnest ply, %.9g mm; 0 to %.9g mm",
                glue, least, 0.5 * least);
  }
  p->glue = (float)glue;
  return SOZAI_OK;
}

/* How wide veneer's pieces are, and the gaps between the core's. */
static int32_t cut_pieces(wood_plies *p, const settings *s, int construction) {
  double leaf = number_at(s, P_LEAF_WIDTH), core = number_at(s, P_CORE_WIDTH);
  int strips = construction == CONSTRUCTION_BLOCKBOARD;
  p->width[0] = (float)(core > 0.0 ? core : strips ? 24.0 : 640.0);
  p->width[1] = (float)(leaf > 0.0 ? leaf : p->face_cut == FACE_ROTARY ? 2500.0 : 180.0);
  for (int i = 0; i < 2; i++) {
    if (p->width[i] >= 2.0f) continue;
    return fail(SOZAI_ERROR_RANGE, "%s: %.9g mm; 0, or 2 to 10000 mm",
                i ? "leaf_width" : "core_width", (double)p->width[i]);
  }
  double gap = number_at(s, P_CORE_GAP);
  if (gap > 0.25 * (double)p->width[0]) {
    return fail(SOZAI_ERROR_RANGE,
                "core_gap: %.9g mm is more than a quarter of core_width, %.9g mm; 0 to %.9g mm",
                gap, (double)p->width[0], 0.25 * (double)p->width[0]);
  }
  p->gap = (float)gap;
  return SOZAI_OK;
}

/* What its lines add to a surface, and how they stray: none wanders through a ply. */
static void spread_glue(wood_plies *p, const settings *s) {
  p->step = (float)number_at(s, P_GLUE_STEP);
  p->step_ramp = p->glue > 0.02f ? 0.5f * p->glue : 0.01f;
  double uneven = number_at(s, P_GLUE_UNEVENNESS), least = 1e30;
  for (int i = 0; i < p->count; i++) {
    if ((double)p->deep[i] < least) least = (double)p->deep[i];
  }
  double most = 0.07 * least;
  p->wander = (float)(uneven * (most < 0.12 ? most : 0.12));
  p->swell = (float)(0.6 * uneven);
}

int32_t plies_build(wood_constants *w, const settings *s, const float (*colours)[3]) {
  int construction = choice_at(s, P_CONSTRUCTION);
  if (construction == CONSTRUCTION_SOLID) return SOZAI_OK;
  wood_plies *p = &w->plies;
  p->count = count_of(s, construction);
  int32_t r = check_count(s, construction, p->count);
  if (!r) r = lay(p, s, construction);
  if (r) return r;
  p->sheets = (int32_t)number_at(s, P_SHEETS);
  p->face = (float)number_at(s, P_FACE_HEIGHT);
  double radius = number_at(s, P_CUT_DISTANCE);
  if (radius < 0.0) radius = -radius;
  /* what a lathe's chucks leave, at the least */
  p->radius = (float)(radius > 40.0 ? radius : 40.0);
  p->tone = (float)number_at(s, P_TONE_SPREAD);
  p->face_cut = choice_at(s, P_FACE_CUT);
  p->match = choice_at(s, P_LEAF_MATCH);
  r = cut_pieces(p, s, construction);
  if (r) return r;
  p->check_depth = (float)number_at(s, P_LATHE_CHECKS);
  spread_glue(p, s);
  memcpy(p->glue_colour, colours[P_GLUE_COLOUR], sizeof p->glue_colour);
  for (int c = 0; c < 3; c++) {
    p->hollow_colour[c] = (float)PLIES_HOLLOW * w->early[c];
  }
  p->seed = w->seeds[SEED_PLIES];
  return SOZAI_OK;
}
