/* SPDX-License-Identifier: Apache-2.0
 *
 * Palettes into the working space, by whichever colour service there is.
 */
#ifndef SOZAI_CORE_COLOUR_H
#define SOZAI_CORE_COLOUR_H

#include "params.h"

/* At the last deinit: the next warning is the first again. */
void colour_close(void);

/* Convert the numbers of every COLOUR setting into the working space: out has
 * a float[3] for each parameter, filled for colours only. */
int32_t colour_convert(const sozai_host *host, const sozai_texture_info *info, const settings *s,
                       float (*out)[3]);

/* A colour at its brightest: scaled, in the space it was given in, until its
 * largest component is 1, then converted. White for black. Scaled in the working
 * space, it would be another colour in another working space. */
int32_t colour_hue(const sozai_host *host, const sozai_parameter *p, const setting *s,
                   float out[3]);

/* count colours of a space by its name in the texture's own tongue ("sRGB"), in
 * place, into the working space. */
int32_t colour_list(const sozai_host *host, const char *space, float (*rgb)[3], uint32_t count);

/* What the colour service at hand calls that space: configs agree on what sRGB
 * is, not on its name. The name itself where there is no service. */
int32_t colour_name(const sozai_host *host, const char *space, const char **out);

#endif
