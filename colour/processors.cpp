// SPDX-License-Identifier: Apache-2.0
#include "processors.hpp"

#include "boundary.hpp"
#include "quiet.hpp"

#include <cstdlib>

namespace sozai::colour {

// OpenColorIO reads this variable with std::stoul, whose exception says "stoul".
static std::string reason(const std::exception &error) {
  const bool of_number = dynamic_cast<const std::invalid_argument *>(&error) ||
                         dynamic_cast<const std::out_of_range *>(&error);
  const char *flags = std::getenv(ocio::OCIO_OPTIMIZATION_FLAGS_ENVVAR);
  if (!of_number || !flags) return error.what();
  return std::string("the environment variable ") + ocio::OCIO_OPTIMIZATION_FLAGS_ENVVAR +
         " is \"" + flags + "\", not a number";
}

template <class Make>
ocio::ConstCPUProcessorRcPtr Processors::cached(const std::string &key, const std::string &what,
                                                const Make &make) {
  const std::lock_guard<std::mutex> guard(lock);
  const auto found = made.find(key);
  if (found != made.end()) return found->second;
  const Quiet quiet;
  try {
    // Lossless: the default replaces inverse tables and powers by approximations.
    const ocio::ConstProcessorRcPtr processor = make();
    auto cpu = processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
    made.emplace(key, cpu);
    return cpu;
  } catch (const std::bad_alloc &) {
    throw;
  } catch (const std::exception &error) {
    throw Failure(SOZAI_ERROR_COLOUR,
                  what + " of colour config " + config.name + ": " + reason(error));
  }
}

// By its own name, so that a role or an alias shares the processor.
std::string Processors::known_space(const char *space) const {
  const auto known = config.ocio->getColorSpace(space);
  if (!known)
    throw Failure(SOZAI_ERROR_COLOUR,
                  std::string("no colour space \"") + space + "\" in colour config " + config.name);
  return known->getName();
}

ocio::ConstCPUProcessorRcPtr Processors::to_working(const char *space) {
  const std::string name = known_space(space);
  return cached("to " + name, "colour space \"" + name + "\"",
                [&] { return config.ocio->getProcessor(name.c_str(), config.working.c_str()); });
}

ocio::ConstCPUProcessorRcPtr Processors::from_working(const char *space) {
  const std::string name = known_space(space);
  return cached("from " + name, "colour space \"" + name + "\"",
                [&] { return config.ocio->getProcessor(config.working.c_str(), name.c_str()); });
}

ocio::ConstCPUProcessorRcPtr Processors::to_display(const char *display, const char *view) {
  const std::string display_name = display ? display : config.ocio->getDefaultDisplay();
  const std::string view_name = view ? view : config.ocio->getDefaultView(display_name.c_str());
  return cached("show " + display_name + '\n' + view_name,
                "view \"" + view_name + "\" on display \"" + display_name + "\"", [&] {
                  return config.ocio->getProcessor(config.working.c_str(), display_name.c_str(),
                                                   view_name.c_str(), ocio::TRANSFORM_DIR_FORWARD);
                });
}

} // namespace sozai::colour
