/* SPDX-License-Identifier: Apache-2.0
 * From a photograph to the palette of a material: docs/match.md. */
#ifndef SOZAI_MATCH_H
#define SOZAI_MATCH_H

#include "board.h"
#include "fit.h"
#include "photo.h"
#include "recipe.h"
#include "regions.h"
#include "roles.h"
#include "shares.h"

#define MOST_COLOURS (2 * MOST_ROLES)

/* A colour proposed. */
typedef struct match_colour {
  const char *parameter;
  double working[3];
  float srgb[3];
  char text[128]; /* as the plugin reads it */
  bool derived;   /* by the preset's ratio, since the photograph does not show it */
  bool given;     /* by -p, and kept */
  bool unseen;    /* the material shows none of it: the preset's, and not written */
} match_colour;

/* One part of the material: what the photograph shows of it, and what the
 * material shows with the palette proposed. */
typedef struct match_part {
  const char *name; /* "heartwood"; "" where there is one part */
  double share;     /* of the photograph */
  moments photo, result;
  double mean_difference;       /* CIEDE2000 */
  double covariance_difference; /* relative Frobenius norm */
} match_part;

typedef struct match_result {
  match_material material;
  match_colour colours[MOST_COLOURS];
  size_t colour_count;
  match_part parts[2];
  size_t part_count;
  regions regions;
  match_shares shares;
  bool second_ignored; /* two parts, and the material has no colours for the second */
  bool brightness_free, brightness_changed;
  double brightness, preset_brightness;
  double residual, preset_residual; /* with either, where they were compared */
  bool has_boundary;
  double boundary;
} match_result;

/* r: the material, its preset and what was given; the proposal is added to it.
 * m: an entry of match_materials. */
bool match_run(match_result *out, recipe *r, const match_material *m, photo *p, const board *b,
               const colour *c, failure *why);

#endif
