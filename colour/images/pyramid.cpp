// SPDX-License-Identifier: Apache-2.0
//
// A pixel of a coarser level is the mean of the area that it covers of the finer: of
// 2 x 2 pixels where the finer's size is even, of a bit more than that where it is
// odd. So every level has the picture's mean. (OpenImageIO's own "automip" samples
// odd sizes between two pixels and leaves out others.)
#include "pyramid.hpp"

#include <algorithm>
#include <array>

namespace sozai::images {

namespace {

// The share that pixel `from` of `size` has in pixel `to` of `half`.
float share(int size, int half, int from, int to) {
  const int64_t low = std::max(int64_t(from) * half, int64_t(to) * size);
  const int64_t high = std::min((int64_t(from) + 1) * half, (int64_t(to) + 1) * size);
  return high > low ? float(high - low) / float(size) : 0.0f;
}

int first_in(int size, int half, int to) { return int(int64_t(to) * size / half); }

int last_in(int size, int half, int to) {
  return int(((int64_t(to) + 1) * size + half - 1) / half) - 1;
}

// What one pixel across is made of.
struct Taps {
  int first;
  std::array<float, 3> weight;
};

std::vector<Taps> taps_for(int size, int half) {
  std::vector<Taps> taps(static_cast<size_t>(half));
  for (int to = 0; to < half; to++) {
    Taps &t = taps[size_t(to)];
    t.first = first_in(size, half, to);
    for (int k = 0; k < 3; k++)
      t.weight[size_t(k)] = t.first + k < size ? share(size, half, t.first + k, to) : 0;
  }
  return taps;
}

} // namespace

class Stage {
public:
  Stage(const Shape &shape, const Room &room, size_t index)
      : shape(shape), level(shape.levels[index]), room(room),
        tiles(shape.tile_floats() * size_t(level.tiles_across)) {
    if (index + 1 == shape.levels.size()) return;
    coarser = std::make_unique<Stage>(shape, room, index + 1);
    taps = taps_for(level.width, coarser->level.width);
    narrow.resize(taps.size() * size_t(shape.channels));
    for (auto &sum : sums) sum.assign(narrow.size(), 0.0f);
  }

  void row(const float *pixels) {
    into_tiles(pixels);
    if (coarser) into_coarser(pixels);
    rows++;
    if (rows % shape.tile_height == 0 || rows == level.height) flush();
  }

private:
  void into_tiles(const float *pixels) {
    const size_t across = size_t(shape.tile_width) * size_t(shape.channels);
    const size_t whole = size_t(level.width) * size_t(shape.channels);
    float *to = tiles.data() + size_t(rows % shape.tile_height) * across;
    for (size_t done = 0; done < whole; done += across, to += shape.tile_floats())
      std::copy_n(pixels + done, std::min(across, whole - done), to);
  }

  void flush() {
    const int tile_row = (rows - 1) / shape.tile_height;
    const uint64_t first = level.first_tile + uint64_t(tile_row) * uint64_t(level.tiles_across);
    room.store.write(room.offset + first * shape.tile_floats() * sizeof(float), tiles.data(),
                     tiles.size() * sizeof(float));
    std::fill(tiles.begin(), tiles.end(), 0.0f);
  }

  void across(const float *pixels) {
    const size_t channels = size_t(shape.channels);
    float *to = narrow.data();
    for (const Taps &t : taps) {
      const float *from = pixels + size_t(t.first) * channels;
      for (size_t c = 0; c < channels; c++) {
        float sum = t.weight[0] * from[c];
        for (size_t k = 1; k < 3; k++)
          if (t.weight[k] != 0) sum += t.weight[k] * from[k * channels + c];
        *to++ = sum;
      }
    }
  }

  void into_coarser(const float *pixels) {
    across(pixels);
    const int height = level.height, half = coarser->level.height;
    // A row has a share in one coarser row, or in two.
    for (int to = next; to < half && first_in(height, half, to) <= rows; to++) {
      std::vector<float> &sum = sums[size_t(to % 2)];
      const float weight = share(height, half, rows, to);
      for (size_t i = 0; i < sum.size(); i++) sum[i] += weight * narrow[i];
      if (last_in(height, half, to) > rows) continue;
      coarser->row(sum.data());
      std::fill(sum.begin(), sum.end(), 0.0f);
      next = to + 1;
    }
  }

  const Shape &shape;
  const Level &level;
  const Room &room;
  std::vector<float> tiles; // a row of them
  int rows = 0;             // that have come

  std::unique_ptr<Stage> coarser;
  std::vector<Taps> taps;
  std::vector<float> narrow;              // the row, halved across
  std::array<std::vector<float>, 2> sums; // the coarser rows under way, even and odd
  int next = 0;                           // coarser row to be finished
};

PyramidWriter::PyramidWriter(const Shape &shape, const Room &room)
    : finest(std::make_unique<Stage>(shape, room, 0)) {}

PyramidWriter::~PyramidWriter() = default;

void PyramidWriter::row(const float *pixels) { finest->row(pixels); }

} // namespace sozai::images
