/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_FIBERTEX_PARAMETERS_H
#define SOZAI_FIBERTEX_PARAMETERS_H

#include "../../../api/sozai.h"

/* Places in the table of parameters; colours stand together, in the order of
 * texture.h's. */
/* clang-format off */
enum {
  P_SEED, P_OBJECT, P_OFFSET, P_STRUCTURE, P_AXIS, P_DIAMETER, P_DIAMETER_SPREAD, P_CRIMP,
  P_CRIMP_HEIGHT, P_WAVER, P_PACKING, P_THICKNESS, P_BUNDLE, P_ALIGNMENT, P_ELEVATION,
  P_ELEVATION_SPREAD, P_NAP_DRIFT, P_NAP_REACH, P_FLYAWAY, P_FLYAWAY_HEIGHT, P_WEAVE, P_YARN_SPACING, P_WEFT_SPACING,
  P_YARN_WIDTH, P_YARN_FLATNESS, P_YARN_SWELL, P_TWIST, P_SLUB, P_HOLLOW, P_COLOUR, P_SECOND, P_WEFT,
  P_SECOND_SHARE, P_VARIATION, P_MOTTLE, P_MOTTLE_SIZE, P_IOR, P_ROUGHNESS, P_TILT, P_TRANSMISSION, P_DARKENING,
  FIBERTEX_PARAMETERS
};
/* clang-format on */

enum {
  WEAVE_PLAIN,
  WEAVE_BASKET,
  WEAVE_TWILL_2_1,
  WEAVE_TWILL_3_1,
  WEAVE_TWILL_2_2,
  WEAVE_SATIN,
  WEAVES
};

extern const sozai_parameter *const fibertex_parameters[FIBERTEX_PARAMETERS];
extern const sozai_channel *const fibertex_channels[];
extern const uint32_t fibertex_channel_count;

#endif
