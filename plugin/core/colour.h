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

/* How strong a colour of the working space is: the largest of its linear
 * Rec.709 numbers, and so the same whatever the working space. Where the colour
 * service knows neither linear Rec.709 nor sRGB, the largest of its own. After
 * colour_convert. */
double colour_peak(const sozai_host *host, const float rgb[3]);

#endif
