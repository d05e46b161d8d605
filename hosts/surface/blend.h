/* SPDX-License-Identifier: Apache-2.0
 * Evaluating a seamless picture's texels. */
#ifndef SOZAI_SURFACE_BLEND_H
#define SOZAI_SURFACE_BLEND_H

#include "evaluate.h"
#include "periodic.h"

/* As evaluate(), for at most SURFACE_BLOCK texels of a seamless plane and
 * SURFACE_COMPONENTS outputs, without light, view or mask. */
int32_t blend_evaluate(const periodic *p, const surface_material *m, const sozai_batch *batch);

#endif
