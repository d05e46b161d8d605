// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config.hpp"

namespace sozai::colour {

struct View {
  std::string display, view;
};

// As sozai_display_1.to_display has them. Throws a Failure that says what there
// is, for a display, a view or a look that there is not.
View known_view(const Config &config, const char *display, const char *view, const char *look);

// From the working space to that view.
ocio::ConstTransformRcPtr transform_of(const Config &config, const View &view, const char *look);

} // namespace sozai::colour
