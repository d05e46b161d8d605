// SPDX-License-Identifier: Apache-2.0
#include "quiet.hpp"

#include <OpenColorIO/OpenColorIO.h>

#include <mutex>

namespace ocio = OCIO_NAMESPACE;

namespace sozai::colour {

static std::mutex lock;
static unsigned holders = 0;
static ocio::LoggingLevel level_before = ocio::LOGGING_LEVEL_DEFAULT;

Quiet::Quiet() {
  const std::lock_guard<std::mutex> guard(lock);
  if (holders == 0) {
    level_before = ocio::GetLoggingLevel();
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
  }
  holders++;
}

Quiet::~Quiet() {
  const std::lock_guard<std::mutex> guard(lock);
  if (--holders == 0) ocio::SetLoggingLevel(level_before);
}

} // namespace sozai::colour
