/* SPDX-License-Identifier: Apache-2.0
 *
 * OpenImageIO as it is: to write pictures, and its own look-ups to compare with.
 */
#ifndef SOZAI_TEST_IMAGES_PLAIN_H
#define SOZAI_TEST_IMAGES_PLAIN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct plain_picture {
  int width, height, channels;
  const char *format; /* "uint8", "uint16", "half", "float" */
  int tile;           /* side, 0: rows */
  int orientation;    /* 0: none */
  bool unassociated;  /* the numbers are not multiplied by alpha */
  bool windowed;      /* the next four count */
  int x, y;           /* of the pixels in the window to be seen */
  int full_width, full_height;
} plain_picture;

/* Whether it worked; else it says why on standard error. */
bool plain_write(const char *path, const plain_picture *picture, const float *data);

bool plain_write_deep(const char *path); /* several numbers at a pixel */

typedef struct plain plain;
plain *plain_open(const char *path, uint32_t wrap); /* wrap: SOZAI_WRAP_* */
void plain_close(plain *p);
bool plain_look(plain *p, float s, float t, float dsdx, float dtdx, float dsdy, float dtdy,
                int channels, float *out);
/* Nanoseconds for each of count look-ups, one after the other. */
double plain_time(plain *p, uint32_t count, const float *s, const float *t, float footprint,
                  int channels);

#ifdef __cplusplus
}
#endif

#endif
