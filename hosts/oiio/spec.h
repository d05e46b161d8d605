// SPDX-License-Identifier: Apache-2.0
// What OpenImageIO is told of a subimage at a mip level.
#ifndef SOZAI_OIIO_SPEC_H
#define SOZAI_OIIO_SPEC_H

#include <OpenImageIO/imageio.h>
#include "picture.h"

OIIO::ImageSpec spec_make(const picture *p, uint32_t subimage, uint32_t level);
// Sizes, tiles and types alone: no names, no metadata.
OIIO::ImageSpec spec_make_dimensions(const picture *p, uint32_t subimage, uint32_t level);

#endif
