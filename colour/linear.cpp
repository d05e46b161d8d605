// SPDX-License-Identifier: Apache-2.0
#include "linear.hpp"

#include <cmath>

namespace sozai::colour {

using Colour = std::array<double, 3>;

static Colour through(const OCIO_NAMESPACE::CPUProcessor &processor, const Colour &in) {
  float pixel[4] = {static_cast<float>(in[0]), static_cast<float>(in[1]), static_cast<float>(in[2]),
                    1};
  processor.applyRGBA(pixel);
  return {pixel[0], pixel[1], pixel[2]};
}

std::optional<Matrix> matrix_of(const OCIO_NAMESPACE::CPUProcessor &processor) {
  Matrix m;
  double largest = 0;
  for (size_t j = 0; j < 3; j++) {
    Colour unit = {};
    unit[j] = 1;
    const Colour column = through(processor, unit);
    for (size_t i = 0; i < 3; i++) {
      m[i][j] = column[i];
      largest = std::fmax(largest, std::fabs(column[i]));
    }
  }
  if (!(largest > 0 && largest < 1e6)) return {};
  // The corners and the middle of the cube at several brightnesses, black among them.
  static const double scales[] = {0, 1.0 / 1024, 1.0 / 16, 0.18, 0.5, 1, 4, 16};
  for (const double scale : scales)
    for (unsigned corner = 1; corner <= 8; corner++) {
      const double low = corner == 8 ? 0.5 : 0;
      Colour in;
      for (unsigned k = 0; k < 3; k++) in[k] = scale * (corner >> k & 1 ? 1 : low);
      const Colour out = through(processor, in);
      for (size_t i = 0; i < 3; i++) {
        const double want = m[i][0] * in[0] + m[i][1] * in[1] + m[i][2] * in[2];
        // A table of 16 bits is still taken for linear, half a percent off is not.
        if (!(std::fabs(out[i] - want) <= 1e-3 * scale * largest + 1e-6)) return {};
      }
    }
  return m;
}

} // namespace sozai::colour
