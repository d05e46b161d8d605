/* SPDX-License-Identifier: Apache-2.0
 *
 * Where to look: random, and the same every time.
 */
#ifndef SOZAI_TEST_IMAGES_PLACES_H
#define SOZAI_TEST_IMAGES_PLACES_H

#include <stdint.h>

#include "library.h"

enum { PLACES = 10000 };

typedef struct places {
  float s[PLACES], t[PLACES], dsdx[PLACES], dtdx[PLACES], dsdy[PLACES], dtdy[PLACES];
} places;

/* 0 to 1, 1 excluded. */
float random_unit(uint64_t *seed);
/* s and t from low to high; footprints from a fiftieth of a pixel to the whole
 * picture, of all shapes and directions. */
void places_make(places *p, uint64_t seed, int pixels, float low, float high);
/* Look count of them up from first; out: `channels` arrays of PLACES. */
int32_t places_look(const services *s, const sozai_image *image, const places *p, uint32_t first,
                    uint32_t count, float (*out)[PLACES], uint32_t channels);
/* Random numbers, to be freed. */
float *random_pixels(size_t count, uint64_t seed);

#endif
