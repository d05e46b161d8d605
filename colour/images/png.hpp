// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sozai::images {

// What is wrong with a PNG file's frame, or NULL: nothing, or it is no PNG. Under
// OpenImageIO 2.4 libpng prints to standard error what it thinks of a damaged one.
const char *png_damage(const char *path);

} // namespace sozai::images
