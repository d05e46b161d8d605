/* SPDX-License-Identifier: Apache-2.0
 *
 * Woods whose section is a picture, for the tests of this folder.
 */
#ifndef SOZAI_TEST_SECTION_H
#define SOZAI_TEST_SECTION_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "host_images.h"

extern const sozai_textures_1 *textures;
extern const sozai_wood_1 *woods;
/* Where pictures may be written; removed at the end. */
extern char folder[256];

/* cmocka group fixtures: the plugin, with the host's own image service. */
int section_setup(void **state);
int section_teardown(void **state);

/* A wood of a preset (NULL: none), with parameters as "a=1; b=2". NULL: refused, and
 * textures->last_error() says why. */
sozai_texture *section_wood(const char *preset, const char *parameters);
/* The same, or a failed test. */
sozai_texture *section_make(const char *preset, const char *parameters);
/* What the plugin last said at creation, "" for nothing. */
const char *section_log(void);
/* No image service from now on, or the host's again. */
void section_serve(int yes);

/* A path in the folder; valid until the call after next. */
const char *section_path(const char *name);

/* Points and their answers. Components of wood, as describe lists them. */
enum { ALBEDO = 0, RADIANCE = 3, FIBER = 6, TIME = 12, LATEWOOD, VESSEL, REFERENCE, OUTS = 17 };
typedef struct {
  uint32_t count, room;
  float *in[7]; /* point, normal, footprint */
  float *out[OUTS];
} points;

void points_clear(points *p);
void points_free(points *p);
/* normal: 'x', 'y' or 'z'. */
void points_add(points *p, double x, double y, double z, char normal, double footprint);
void points_ask(points *p, const sozai_texture *t);

/* Numbers in 0..1, the same in every run. */
double uniform(void);

#endif
