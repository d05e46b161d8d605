/* SPDX-License-Identifier: Apache-2.0
 *
 * The services' ceilings on pictures and configs: all of them, in one place.
 */
#ifndef SOZAI_COLOUR_CEILINGS_H
#define SOZAI_COLOUR_CEILINGS_H

#include "../api/sozai.h"

#define IMAGE_LARGEST_SIDE (1u << 17)
#define IMAGE_MOST_PIXELS (1u << 30)
#define IMAGE_MOST_CHANNELS 1024
#define CONFIG_MOST_STEPS 100000
#define CONFIG_DEEPEST 100

#ifdef __cplusplus
extern "C" {
#endif

extern const sozai_limits_1 sozai_colour_limits;

#ifdef __cplusplus
}
#endif

#endif
