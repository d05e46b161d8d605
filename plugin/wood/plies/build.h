/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_PLIES_BUILD_H
#define SOZAI_WOOD_PLIES_BUILD_H

#include "../../core/params.h"
#include "../wood.h"

/* The lay-up, if the wood is of plies. colours: in the working space. */
int32_t plies_build(wood_constants *w, const settings *s, const float (*colours)[3]);

#endif
