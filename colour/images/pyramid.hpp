// SPDX-License-Identifier: Apache-2.0
//
// A picture and its coarser levels, written row by row as the rows come, so that no
// more than a row of tiles of each level is in memory.
#pragma once

#include "shape.hpp"
#include "store.hpp"

#include <memory>
#include <vector>

namespace sozai::images {

class Stage; // one level

class PyramidWriter {
public:
  PyramidWriter(const Shape &shape, const Room &room);
  ~PyramidWriter();
  // The next row of the picture, from the top. Throws Failure.
  void row(const float *pixels);

private:
  std::unique_ptr<Stage> finest;
};

} // namespace sozai::images
