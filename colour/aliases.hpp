// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sozai::colour {

// The name of an alias in YAML text that stands inside the very node it repeats,
// or "". OpenColorIO follows such a node until its stack runs out, and before it
// has a config that could be looked at.
std::string circular_alias(const std::string &yaml);

} // namespace sozai::colour
