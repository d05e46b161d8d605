/* SPDX-License-Identifier: Apache-2.0
 * Growing something of a generator of which nothing is known but what it says. */
#ifndef SOZAI_VALIDATE_GEOMETRY_H
#define SOZAI_VALIDATE_GEOMETRY_H

#include "subject.h"

typedef struct grown {
  sozai_geometry *geometry;
  sozai_value values[4]; /* what it was grown of, beside the defaults */
  uint32_t value_count;
} grown;

/* Of its defaults; where those are refused, with a box of 20 mm for what takes
 * a mesh. */
int32_t grow_plain(subject *s, const sozai_generator_info *info, const sozai_host *host,
                   grown *out);

/* A place that nothing lies at: what a call has to write over. */
#define POISON ((void *)(uintptr_t)0x10)

/* Started, with the table of generators; false, with the reason said. */
bool generators_start(subject *s);

/* Run for every generator that is judged, on what it grows of its defaults. */
typedef void grown_test(subject *s, const sozai_generator_info *info, grown *g);
void each_grown(subject *s, grown_test *test);

/* ---- checks "geometry.mesh" and so on ---------------------------------- */

/* geometry_shapes.c */
void geometry_mesh(subject *s);
void geometry_curves(subject *s);
void geometry_tables(subject *s);
void geometry_levels(subject *s);
/* geometry_host.c */
void geometry_same(subject *s);
void geometry_outlives(subject *s);
void geometry_cancelled(subject *s);
void geometry_allocator_fails(subject *s);
void geometry_values(subject *s);
void geometry_leaks(subject *s);

#endif
