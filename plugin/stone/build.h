/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_STONE_BUILD_H
#define SOZAI_STONE_BUILD_H

#include "../core/params.h"
#include "stone.h"

/* From settings to what the kernel reads. colours: in the working space.
 * kernel: any, since all measure the same. */
int32_t stone_build(stone_constants *w, const sozai_host *host, const settings *s,
                    const float (*colours)[3], const stone_kernel *kernel);

/* After what varies slowly, whose seeds beds' bodies have. */
void stone_build_layers(stone_constants *w, const settings *s, stone_measure *measure);

/* The paving and the weather, after all else but the paper's. */
int32_t stone_build_paving(stone_constants *w, const settings *s, const float (*colours)[3],
                           stone_measure_laid *measure);

#endif
