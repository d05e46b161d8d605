// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "config.hpp"

#include <map>
#include <mutex>

namespace sozai::colour {

// The transforms of one config, each made when first asked for. [thread-safe]
class Processors {
public:
  explicit Processors(const Config &config) : config(config) {}

  // Whether to_working and from_working have a meaning for it.
  bool knows(const char *space) const;

  // All throw Failure.
  ocio::ConstCPUProcessorRcPtr to_working(const char *space);
  ocio::ConstCPUProcessorRcPtr from_working(const char *space);
  // Between two spaces of the config.
  ocio::ConstCPUProcessorRcPtr between(const char *from, const char *to);
  // display, view: NULL for the config's own, and the display's own. look: NULL
  // for the view's own looks, "" for none.
  ocio::ConstCPUProcessorRcPtr to_display(const char *display, const char *view, const char *look);

private:
  std::string known_space(const char *space) const;
  template <class Make>
  ocio::ConstCPUProcessorRcPtr cached(const std::string &key, const std::string &what,
                                      const Make &make);

  const Config &config;
  std::mutex lock;
  std::map<std::string, ocio::ConstCPUProcessorRcPtr> made;
};

} // namespace sozai::colour
