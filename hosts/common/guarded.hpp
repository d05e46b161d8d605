// SPDX-License-Identifier: Apache-2.0
// OpenImageIO may throw, and so may the standard library; C that called must get a
// failure instead.
#ifndef SOZAI_HOSTS_GUARDED_HPP
#define SOZAI_HOSTS_GUARDED_HPP

#include <cstdlib>
#include <exception>

#include "failure.h"

// What work() answers; false and why, where it threw.
template <typename Work> bool guarded(failure *why, Work work) {
  try {
    return work();
  } catch (const std::exception &e) {
    return fail(why, EXIT_FAILURE, "OpenImageIO: %s", e.what());
  } catch (...) {
    return fail(why, EXIT_FAILURE, "OpenImageIO: an unknown exception");
  }
}

#endif
