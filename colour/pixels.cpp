// SPDX-License-Identifier: Apache-2.0
#include "pixels.hpp"

#include <cfloat>

namespace sozai::colour {

const Limits any_finite = {-FLT_MAX, FLT_MAX};
const Limits zero_to_one = {0, 1};

static float within(Limits limits, float value) {
  if (value != value) return 0;
  return value < limits.low ? limits.low : value > limits.high ? limits.high : value;
}

// Colour by colour, although OpenColorIO can take a whole picture: that way it
// allocates nothing, so it cannot fail with half of the colours converted.
void convert(const OCIO_NAMESPACE::CPUProcessor &processor, Limits limits, float *rgb,
             uint64_t count) {
  for (float *end = rgb + 3 * count; rgb != end; rgb += 3) {
    float pixel[4] = {within(any_finite, rgb[0]), within(any_finite, rgb[1]),
                      within(any_finite, rgb[2]), 1};
    processor.applyRGBA(pixel);
    for (int i = 0; i < 3; i++) rgb[i] = within(limits, pixel[i]);
  }
}

} // namespace sozai::colour
