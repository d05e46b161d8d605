/* SPDX-License-Identifier: Apache-2.0
 *
 * Photographs of logs that never stood: the grown section of a wood of the
 * plugin's own, on a background, with its pith off the middle.
 */
#ifndef SOZAI_TEST_PHOTOGRAPH_H
#define SOZAI_TEST_PHOTOGRAPH_H

#include "section.h"

typedef struct {
  const char *preset, *parameters; /* of the wood */
  int width, height;               /* pixels */
  double mm;                       /* the picture's width */
  double pith_s, pith_t;
  double years;     /* the log ends with that ring; 0: the picture is all wood */
  float background; /* grey */
  float noise;      /* of every pixel, as a share */
  int cracks;       /* radial, black */
} photograph;

/* Writes it; the name's ending says the format. */
const char *photograph_take(const photograph *p, const char *name);

#endif
