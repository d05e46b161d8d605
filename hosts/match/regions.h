/* SPDX-License-Identifier: Apache-2.0
 * Whether a photograph shows two parts of a material, as heartwood and sapwood,
 * and where each lies. */
#ifndef SOZAI_MATCH_REGIONS_H
#define SOZAI_MATCH_REGIONS_H

#include "photo.h"

typedef struct regions {
  bool two;
  double separation;          /* of the two means, over the standard deviation about them */
  double difference;          /* CIEDE2000 of the means */
  double share, second_share; /* of the pixels kept; what lies between is neither */
} regions;

/* Marks the pixels of the lighter part PIXEL_SECOND where there are two. */
bool regions_find(regions *r, photo *p, const colour *c, failure *why);

#endif
