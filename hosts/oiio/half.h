/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_OIIO_HALF_H
#define SOZAI_OIIO_HALF_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* To the nearest half, ties to even; what is past the largest becomes the
 * largest, so that finite numbers stay finite. */
void half_from_float(uint16_t *to, const float *from, size_t count);

/* The same of three arrays, to three halves side by side: count of each. */
void half_from_rgb(uint16_t *to, const float *const from[3], size_t count);

/* Four halves side by side at every `stride` bytes: count of each array. */
void half_weave(char *to, ptrdiff_t stride, const uint16_t *const from[4], size_t count);

#ifdef __cplusplus
}
#endif

#endif
