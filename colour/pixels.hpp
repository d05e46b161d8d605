// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <cstdint>

namespace sozai::colour {

// What may be written.
struct Limits {
  float low, high;
};
extern const Limits any_finite;
extern const Limits zero_to_one;

// count colours, r g b each, in place. A NaN is read as 0, and every number
// written is finite and within the limits.
void convert(const OCIO_NAMESPACE::CPUProcessor &processor, Limits limits, float *rgb,
             uint64_t count);

} // namespace sozai::colour
