/* SPDX-License-Identifier: Apache-2.0
 * How much of a face each mineral and each kind of speck covers, from a
 * photograph. */
#ifndef SOZAI_MATCH_SHARES_H
#define SOZAI_MATCH_SHARES_H

#include "fit.h"
#include "photo.h"
#include "weights.h"

typedef struct match_share {
  const char *parameter;
  double preset, value;
  bool given; /* by -p, and kept */
} match_share;

typedef struct match_shares {
  match_share of[MOST_SHARES];
  size_t count;
  bool found, has_brightness;
  double brightness; /* that goes with them */
  /* How far apart the colours of the photograph and of the material lie, rank
   * by rank, in the photograph's standard deviations: with the preset's shares,
   * and with those found. */
  double preset_distance, distance;
} match_shares;

typedef struct share_search {
  const weighing *weighing;
  const photo *photo;
  uint8_t pixel;              /* which of its pixels */
  const fit_problem *problem; /* its weights aside */
  const sozai_texture_info *info;
} share_search;

/* Those found, and the brightness that goes with them, are set in the recipe. */
bool shares_fit(const share_search *q, recipe *r, match_shares *out, failure *why);

#endif
