// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sozai::colour {

// While one exists OpenColorIO logs nothing: it would print to the host's
// standard error. Its log level belongs to the process, so it is put back when
// the last one goes. Whoever sets OCIO_LOGGING_LEVEL still sees the log.
class Quiet {
public:
  Quiet();
  ~Quiet();
  Quiet(const Quiet &) = delete;
  Quiet &operator=(const Quiet &) = delete;
};

} // namespace sozai::colour
