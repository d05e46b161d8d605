// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace sozai::colour {

// Throws Failure when a space, a look or a view is defined by itself, or by so
// many others that making it would not end in reasonable time. OpenColorIO
// follows such references until its stack runs out, which ends the process.
void must_end(const OCIO_NAMESPACE::Config &config);

} // namespace sozai::colour
