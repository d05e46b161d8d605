// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace sozai::colour {

// For a config that says nothing of colours: the transform to linear Rec.709 from
// a space that everyone knows by this name, or null: it is none of them. They are
// sRGB and linear Rec.709 itself, as in sozai.so when it has no colour service.
OCIO_NAMESPACE::ConstTransformRcPtr by_formula(const char *space);

} // namespace sozai::colour
