// SPDX-License-Identifier: Apache-2.0
#include "shape.hpp"

#include <algorithm>

namespace sozai::images {

constexpr int tile_side = 64; // what OpenImageIO's own textures have

// Smaller for a picture that is narrow or low, which would waste most of a tile.
static int side_for(int size) {
  int side = 1;
  while (side < size && side < tile_side) side *= 2;
  return side;
}

Shape shape_of(int width, int height, int channels) {
  Shape shape = {channels, side_for(width), side_for(height), {}, 0};
  for (;;) {
    Level level = {width, height, (width + shape.tile_width - 1) / shape.tile_width,
                   (height + shape.tile_height - 1) / shape.tile_height, shape.tiles};
    shape.levels.push_back(level);
    shape.tiles += uint64_t(level.tiles_across) * uint64_t(level.tiles_down);
    if (width == 1 && height == 1) return shape;
    width = std::max(1, width / 2);
    height = std::max(1, height / 2);
  }
}

} // namespace sozai::images
