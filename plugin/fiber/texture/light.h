/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_FIBERTEX_LIGHT_H
#define SOZAI_FIBERTEX_LIGHT_H

#include "../../core/params.h"
#include "texture.h"

/* The constants of light, and the palette as it looks after many strands; when all others
 * stand. depth: the shell's optical depth, seen squarely. */
int32_t fibertex_build_light(fibertex_constants *w, const sozai_host *host, const settings *s,
                             double depth);

/* How much more of a pile light from around meets than of strands that lie flat. */
double fibertex_pile_met(const fibertex_constants *w);

#endif
