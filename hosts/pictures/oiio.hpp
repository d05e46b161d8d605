// SPDX-License-Identifier: Apache-2.0
// What whole pictures and pictures written band by band ask of OpenImageIO alike.
#ifndef SOZAI_PICTURES_OIIO_HPP
#define SOZAI_PICTURES_OIIO_HPP

#include <OpenImageIO/imageio.h>

#include "image.h"

namespace oiio {

// Of an IMAGE_* type.
inline OIIO::TypeDesc type_of(int type) {
  switch (type) {
  case IMAGE_UINT8:
    return OIIO::TypeDesc::UINT8;
  case IMAGE_UINT16:
    return OIIO::TypeDesc::UINT16;
  case IMAGE_HALF:
    return OIIO::TypeDesc::HALF;
  default:
    return OIIO::TypeDesc::FLOAT;
  }
}

// Of a picture whose channels have each a name and a type, in order: true where they
// are of several types.
template <typename Channel>
bool add_channels(OIIO::ImageSpec &spec, const Channel *channels, size_t count) {
  bool mixed = false;
  spec.channelnames.clear();
  for (size_t c = 0; c < count; c++) {
    spec.channelnames.emplace_back(channels[c].name);
    spec.channelformats.push_back(type_of(channels[c].type));
    mixed = mixed || channels[c].type != channels[0].type;
  }
  if (!mixed) spec.channelformats.clear();
  return mixed;
}

inline void add_writing(OIIO::ImageSpec &spec) {
  spec.attribute("Software", "sozai");
  spec.attribute("compression", "zip"); // lossless; PNG's own is the same
}

inline void add_colour(OIIO::ImageSpec &spec, const image_colour &colour) {
  if (colour.space) spec.attribute("colorSpace", colour.space);
  if (colour.chromaticities)
    spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8),
                   colour.chromaticities);
  if (colour.srgb) spec.attribute("oiio:ColorSpace", "sRGB");
}

} // namespace oiio

#endif
