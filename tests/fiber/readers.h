/* SPDX-License-Identifier: Apache-2.0
 * Files of curves read by what their formats' specifications say, not by the
 * project's own code. */
#ifndef SOZAI_TESTS_READERS_H
#define SOZAI_TESTS_READERS_H

#include <stdbool.h>
#include <stdint.h>

typedef struct strands_read {
  uint32_t curves, points;
  uint32_t *counts; /* points of each curve */
  float *at;        /* x y z each */
  float *widths;    /* diameters */
  uint32_t *ids;    /* or NULL */
  float colour[3];  /* the first one's */
} strands_read;

/* false: not a file of that format. */
bool read_hair(strands_read *s, const char *path);
bool read_usd(strands_read *s, const char *path);
bool read_obj(strands_read *s, const char *path);
void strands_read_free(strands_read *s);

#endif
