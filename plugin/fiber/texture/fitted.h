/* SPDX-License-Identifier: Apache-2.0
 *
 * What of the light on fibres is fitted, not derived: how amounts go by what a cloth or an
 * aggregate is made of, from rays followed through the fibres of presets and of what lies between
 * and beside them. The target `fit-fiber-light` prints fitted.c; fiber.cloth and fiber.radiance
 * hold it against other rays.
 */
#ifndef SOZAI_FIBERTEX_FITTED_H
#define SOZAI_FIBERTEX_FITTED_H

/* What a cloth is made of. */
enum {
  CLOTH_ONE,    /* 1 */
  CLOTH_DEPTH,  /* optical depth of its yarns seen squarely, the mean; its logarithm */
  CLOTH_DULL,   /* of its strands: 1 - transmission, its logarithm */
  CLOTH_ROUGH,  /* roughness along the strand, radians, its logarithm */
  CLOTH_RISE,   /* tangent of how far strands rise out of their yarn */
  CLOTH_FLOWN,  /* share that strands standing off its yarns cover */
  CLOTH_LEAN,   /* of its yarns' faces: how far they lean to the side, the mean square's root */
  CLOTH_SLOPE,  /* and how they rise and fall */
  CLOTH_TWIST,  /* tangent of the strands' angle to their yarn */
  CLOTH_SLUB,   /* how uneven its yarns are */
  CLOTH_COARSE, /* a strand's diameter over its yarn's thickness */
  CLOTH_FEATURES
};

/* Amounts, each e to the sum of its row over those. */
enum {
  FIT_SLAB,    /* Kubelka and Munk's S, over the optical depth */
  FIT_COLOUR,  /* power of the colour in bulk: how much more of its absorption light meets */
  FIT_ALBEDO,  /* of light from all around, to an eye above: over what is beyond the first */
  FIT_OFTEN,   /* scattered often */
  FIT_BROAD,   /* variance of that, over twice the roughness squared */
  FIT_NARROW,  /* width of a lobe along the strand, over the roughness */
  FIT_GLANCE,  /* reflected */
  FIT_THROUGH, /* transmitted, of a yarn */
  FIT_FLOWN,   /* and of single strands over it */
  FIT_HAIR,    /* single strands that stand off a yarn, over their slope's variance */
  FIT_SHADED,  /* how far they shade one another, over what of the cloth they cover */
  FIT_AMOUNTS
};

/* What an aggregate is made of. */
enum {
  BULK_ONE,   /* 1 */
  BULK_THIN,  /* 1 over (1 + a quarter of its optical depth) */
  BULK_DULL,  /* of its strands: 1 - transmission, its logarithm */
  BULK_ROUGH, /* roughness along the strand, radians, its logarithm */
  BULK_RISE,  /* tangent of how far strands rise out of the surface */
  BULK_FEATURES
};

/* Its amounts, likewise. */
enum {
  BULK_GLANCE,  /* reflected, of one strand's */
  BULK_THROUGH, /* transmitted by the strand that is seen, likewise */
  BULK_SINGLE,  /* scattered within it */
  BULK_CHAIN,   /* gone on through strand after strand */
  BULK_MORE,    /* how many follow the first */
  BULK_OFTEN,   /* scattered often */
  BULK_SLAB,    /* Kubelka and Munk's S of that, over the optical depth */
  BULK_LINEAR,  /* how soon it comes back: u^2 / (u^2 + LINEAR u + SQUARE) */
  BULK_SQUARE,
  BULK_GRAZE, /* its loss where light or view is at a slant, and where both are */
  BULK_GRAZE_BOTH,
  BULK_AMOUNTS
};

typedef struct {
  double least[CLOTH_FEATURES], most[CLOTH_FEATURES],
      middle[CLOTH_FEATURES]; /* of what was fitted */
  double amount[FIT_AMOUNTS][CLOTH_FEATURES];
  /* the logarithms of the cloths that were fitted: a cloth of features that none of them had
   * together has no more and no less */
  double low[FIT_AMOUNTS], high[FIT_AMOUNTS];
  double bulk_least[BULK_FEATURES], bulk_most[BULK_FEATURES], bulk_middle[BULK_FEATURES];
  double bulk[BULK_AMOUNTS][BULK_FEATURES];
} fibertex_fitted;

/* What was fitted to all of them is the same for each. */
const fibertex_fitted *fibertex_fit(const double *made_of);

/* The sum of a row over what it is made of, no further than was fitted. */
static inline double fitted_sum(const double *row, const double *made_of, const double *least,
                                const double *most, const double *middle, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; i++) {
    double x = made_of[i] < least[i] ? least[i] : made_of[i] > most[i] ? most[i] : made_of[i];
    sum += row[i] * (x - middle[i]);
  }
  return sum;
}

#endif
