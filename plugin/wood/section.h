/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_SECTION_H
#define SOZAI_WOOD_SECTION_H

#include "../core/images.h"
#include "wood.h"

/* The constants of a section from a picture; the rest has been built. */
int32_t section_build(wood_constants *w, const sozai_host *host, const settings *s,
                      const sozai_images_1 *images, const sozai_image *picture);

#endif
