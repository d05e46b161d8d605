// SPDX-License-Identifier: Apache-2.0
//
// The C boundary: whatever is thrown inside becomes a result and one line of text.
#pragma once

#include "internal.h"

#include <stdexcept>
#include <string>

namespace sozai::colour {

// An error with the SOZAI_ERROR_* it is to be reported as.
class Failure : public std::runtime_error {
public:
  Failure(int32_t result, const std::string &text) : std::runtime_error(text), result(result) {}
  const int32_t result;
};

// The caller's room for the reason of a failure.
struct Message {
  char *text;
  size_t size;
};

// Text into a message: one line, of UTF-8, as much as there is room for.
void write(Message message, const char *text) noexcept;

// The result that the exception being handled stands for, its reason written to
// message. To be called in a catch block. `otherwise` is for exceptions that do
// not say what they are.
int32_t report(Message message, int32_t otherwise) noexcept;

// Run body, which gives nothing or throws.
template <class Body> int32_t guarded(Message message, int32_t otherwise, Body &&body) noexcept {
  try {
    body();
    return SOZAI_OK;
  } catch (...) {
    return report(message, otherwise);
  }
}

template <class Body> int32_t guarded(Message message, Body &&body) noexcept {
  return guarded(message, SOZAI_ERROR_COLOUR, body);
}

} // namespace sozai::colour
