/* SPDX-License-Identifier: Apache-2.0
 * Curves into files, one writer each. Lengths are mm in all of them. */
#ifndef SOZAI_HOSTS_CURVE_FILES_H
#define SOZAI_HOSTS_CURVE_FILES_H

#include "failure.h"
#include "sozai.h"

/* USD as text: one linear BasisCurves; widths are diameters, ids and colours
 * are primvars. */
bool curves_write_usda(const sozai_curves *c, const char *path, failure *why);
/* Cem Yuksel's .hair: segments, points, thickness (a diameter), colours. */
bool curves_write_hair(const sozai_curves *c, const char *path, failure *why);
/* OBJ: v and l; no radii, for it has none. */
bool curves_write_obj(const sozai_curves *c, const char *path, failure *why);
/* pbrt: a cylinder curve each, Bezier through the points. */
bool curves_write_pbrt(const sozai_curves *c, const char *path, failure *why);

#endif
