// SPDX-License-Identifier: Apache-2.0
//
// A stored picture, as OpenImageIO's cache asks for it.
#pragma once

#include "shape.hpp"
#include "store.hpp"

#include <OpenImageIO/imageio.h>

namespace sozai::images {

// A picture, linearised, with its levels.
struct Stored {
  Stored(Store &store, const Shape &shape) : shape(shape), room(store, shape.bytes()) {}
  const Shape shape;
  const Room room;
};

// What to hand to ImageCache::add_file for it. It must outlive the file in the cache.
OIIO::ImageSpec input_config(const Stored &stored);
OIIO::ImageInput *make_input();

} // namespace sozai::images
