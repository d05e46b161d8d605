/* SPDX-License-Identifier: Apache-2.0
 * What a picture is made of: for picture.c and read.c. */
#ifndef SOZAI_OIIO_PICTURE_PARTS_H
#define SOZAI_OIIO_PICTURE_PARTS_H

#include "library.h"
#include "picture.h"
#include "shared.h"

struct picture {
  recipe recipe;
  const library *library;
  shared *texture_use;
  const sozai_texture *texture;
  surface *surface;
  output *outputs;
  subimage *subimages;
  picture_about about;
};

#endif
