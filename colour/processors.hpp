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

  // All throw Failure.
  ocio::ConstCPUProcessorRcPtr to_working(const char *space);
  ocio::ConstCPUProcessorRcPtr from_working(const char *space);
  // NULL for the config's own display, and the display's own view.
  ocio::ConstCPUProcessorRcPtr to_display(const char *display, const char *view);

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
