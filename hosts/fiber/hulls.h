/* SPDX-License-Identifier: Apache-2.0
 * Hulls made here, for pictures, the bench and tests: closed meshes, mm, +y up. */
#ifndef SOZAI_HOSTS_HULLS_H
#define SOZAI_HOSTS_HULLS_H

#include "failure.h"
#include "mesh.h"

/* Standing for the paper's bunny: a body, a head, and two thin ears; 45 mm high.
 * cells along its height: 106 gives about 35,000 triangles. */
bool hull_make_bunny(mesh *m, uint32_t cells, failure *why);
/* For its dragon: one tube, thick and thin, in coils; 46 mm long. around: sides. */
bool hull_make_serpent(mesh *m, uint32_t around, failure *why);
/* A ball, squashed by `height`, with lumps of that share of its radius. */
bool hull_make_ball(mesh *m, double radius, double height, double lumps, uint32_t seed,
                    uint32_t around, failure *why);
/* A box about the origin, each side cut into `cuts`. */
bool hull_make_box(mesh *m, const double size[3], uint32_t cuts, failure *why);
/* By name: bunny, serpent, ball, slab, lump, of about 35,000 triangles; or
 * box:WxHxD, lump:RADIUS. */
bool hull_make_named(mesh *m, const char *name, failure *why);

#endif
