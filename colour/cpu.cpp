// SPDX-License-Identifier: Apache-2.0
#include "cpu.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ocio = OCIO_NAMESPACE;

namespace sozai::colour {

// OpenColorIO reads this variable with std::stoul, whose exception says "stoul".
[[noreturn]] static void bad_flags(const std::exception &error) {
  const char *flags = std::getenv(ocio::OCIO_OPTIMIZATION_FLAGS_ENVVAR);
  if (!flags) throw std::runtime_error(error.what());
  throw std::runtime_error(std::string("the environment variable ") +
                           ocio::OCIO_OPTIMIZATION_FLAGS_ENVVAR + " is \"" + flags +
                           "\", not a number");
}

ocio::ConstCPUProcessorRcPtr cpu_of(const ocio::ConstProcessorRcPtr &processor) {
  try {
    return processor->getOptimizedCPUProcessor(ocio::OPTIMIZATION_LOSSLESS);
  } catch (const std::invalid_argument &error) {
    bad_flags(error);
  } catch (const std::out_of_range &error) {
    bad_flags(error);
  }
}

} // namespace sozai::colour
