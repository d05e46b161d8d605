// SPDX-License-Identifier: Apache-2.0
//
// From a source's rows to the rows that are filtered: finite, in the working space,
// multiplied by alpha.
#pragma once

#include "module.h"
#include "source.hpp"

#include <vector>

namespace sozai::images {

class Linear {
public:
  Linear(const Layout &layout, uint32_t channels, const sozai_image_colours &colours,
         const sozai_image_conversion &conversion);
  // Of a row as Source has it: `channels` numbers a pixel. Throws Failure.
  const float *row(float *pixels);

private:
  void convert(const float *pixels);

  const Layout layout;
  const size_t channels, stride;
  const sozai_image_colours &colours;
  const sozai_image_conversion conversion;
  std::vector<float> rgba, out;
};

} // namespace sozai::images
