// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace sozai::colour {

// The names in a text such as "a, -b | c", read as OpenColorIO reads it: bars
// between alternatives; between looks commas, or colons where there is no comma;
// a sign before a name for its direction.
std::vector<std::string> look_names(const char *looks);

} // namespace sozai::colour
