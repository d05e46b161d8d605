/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_STONE_BUILD_H
#define SOZAI_STONE_BUILD_H

#include "../core/params.h"
#include "stone.h"

/* From settings to what the kernel reads. colours: in the working space.
 * measure: of any kernel, since all measure the same. */
int32_t stone_build(stone_constants *w, const sozai_host *host, const settings *s,
                    const float (*colours)[3], stone_measure *measure);

#endif
