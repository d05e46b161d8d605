// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace sozai::colour {

struct Item {
  std::string name, detail;
};

// What a config offers, for sozai_display_1. Made once and never changed, so that
// its strings can be handed out and read from any thread.
class Lists {
public:
  explicit Lists(const OCIO_NAMESPACE::Config &config);

  // NULL: no such list. list: SOZAI_LIST_*; display: for VIEWS, NULL for the default.
  const std::vector<Item> *find(uint32_t list, const char *display) const;

private:
  std::vector<Item> spaces, roles, displays, looks;
  std::map<std::string, std::vector<Item>> views; // of displays that are hidden, too
};

} // namespace sozai::colour
