// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <string>

namespace sozai::colour {

namespace ocio = OCIO_NAMESPACE;

// A config that has been checked and has a working space.
struct Config {
  std::string name;    // where it came from
  std::string working; // the working space's own name
  std::string warning; // "", or what was wrong with the config
  bool raw = false;    // the working space is data: nothing says what its colours are
  ocio::ConstConfigRcPtr ocio;
};

// path: NULL for $OCIO, else the shipped config. Throws Failure.
Config open_config(const char *path);

} // namespace sozai::colour
