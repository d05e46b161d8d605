// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <array>
#include <optional>

namespace sozai::colour {

using Matrix = std::array<std::array<double, 3>, 3>;

// The matrix that a conversion is, or nothing: it is not linear from black up to
// 16. What it does to negative numbers is not asked.
std::optional<Matrix> matrix_of(const OCIO_NAMESPACE::CPUProcessor &processor);

} // namespace sozai::colour
