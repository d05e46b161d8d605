// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "processors.hpp"

namespace sozai::colour {

// CIE 1931 x y of red, green, blue and white of a linear space (NULL: the working
// space), as sozai_display_1.chromaticities. Throws Failure.
void find_chromaticities(const Config &config, Processors &processors, const char *space,
                         float out_xy[8]);

} // namespace sozai::colour
