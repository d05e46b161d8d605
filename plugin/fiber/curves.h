/* SPDX-License-Identifier: Apache-2.0
 *
 * An aggregate on its way out: as curves, or as tubes.
 */
#ifndef SOZAI_FIBER_CURVES_H
#define SOZAI_FIBER_CURVES_H

#include "../generator.h"
#include "fiber.h"

/* Each level keeps every other vertex, both ends among them, down to two; then
 * every other strand. */
int32_t fiber_curves(const fiber *f, const sozai_host *host, uint32_t level, curves_block **out);
/* Tubes of six sides, of three from level 2 on, closed at both ends. */
int32_t fiber_mesh(const fiber *f, const sozai_host *host, uint32_t level, mesh_block **out);

#endif
