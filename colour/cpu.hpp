// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace sozai::colour {

// The processor that this library converts with: lossless, where OpenColorIO's
// default replaces inverse tables and powers by approximations. What it throws
// says what is wrong with $OCIO_OPTIMIZATION_FLAGS, if that is.
OCIO_NAMESPACE::ConstCPUProcessorRcPtr cpu_of(const OCIO_NAMESPACE::ConstProcessorRcPtr &processor);

} // namespace sozai::colour
