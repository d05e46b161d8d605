/* SPDX-License-Identifier: Apache-2.0
 * Aggregates from text. */
#ifndef SOZAI_TESTS_FIBER_H
#define SOZAI_TESTS_FIBER_H

#include "hulls.h" /* before cmocka, which calls a macro `fail` */

#include "../growing.h"

/* "count=100 length=4 ..."; the result's code. */
int32_t grow_code(const sozai_host *host, const mesh *hull, const char *values,
                  sozai_geometry **out);
/* The same with a preset, or a hull that is a buffer of any kind, or none. */
int32_t grow_buffer(const sozai_host *host, const char *preset, const sozai_buffer *hull,
                    const char *values, sozai_geometry **out);
/* Which must work; on two threads. */
sozai_geometry *grow(const mesh *hull, const char *values);

sozai_buffer buffer_of(const mesh *m);
mesh hull_of(const char *name);
/* A box of twelve triangles. */
mesh box_of(double x, double y, double z);

const sozai_curves *curves_of(const sozai_geometry *g);
sozai_host two_threads(void);

/* ---- by brute force, in double: brute.c -------------------------------- */

double brute_distance(const mesh *m, const float p[3]);
/* How often the surface winds round a point, by solid angles. */
double brute_winding(const mesh *m, const float p[3]);
/* Between two segments, by bisection over one and a formula over the other. */
double brute_segments(const float a[6], const float b[6]);

#endif
