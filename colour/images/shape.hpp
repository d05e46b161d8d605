// SPDX-License-Identifier: Apache-2.0
//
// How a picture and its coarser levels lie in the store: level after level, each in
// tiles, row by row, and a tile's pixels row by row.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sozai::images {

struct Level {
  int width, height;
  int tiles_across, tiles_down;
  uint64_t first_tile; // of all levels together
};

struct Shape {
  int channels;
  int tile_width, tile_height; // powers of two: OpenImageIO is faster then
  std::vector<Level> levels;   // the picture first; each next half as wide and high, to 1 x 1
  uint64_t tiles;

  size_t tile_floats() const { return size_t(tile_width) * size_t(tile_height) * size_t(channels); }
  uint64_t bytes() const { return tiles * tile_floats() * sizeof(float); }
};

Shape shape_of(int width, int height, int channels);

} // namespace sozai::images
