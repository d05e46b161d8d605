// SPDX-License-Identifier: Apache-2.0
#include "boundary.hpp"

#include <algorithm>
#include <cstring>
#include <new>

namespace sozai::colour {

// Cut between characters, not inside one; and a line is a line.
static void write(Message message, const char *text) noexcept {
  if (!message.text || message.size == 0) return;
  size_t length = std::strlen(text);
  if (length >= message.size) {
    length = message.size - 1;
    while (length > 0 && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) length--;
  }
  std::replace_copy_if(
      text, text + length, message.text, [](char c) { return static_cast<unsigned char>(c) < ' '; },
      ' ');
  message.text[length] = '\0';
}

int32_t report(Message message, int32_t otherwise) noexcept {
  try {
    throw;
  } catch (const Failure &failure) {
    write(message, failure.what());
    return failure.result;
  } catch (const std::bad_alloc &) {
    write(message, "out of memory");
    return SOZAI_ERROR_MEMORY;
  } catch (const std::exception &error) {
    write(message, error.what());
    return otherwise;
  } catch (...) {
    write(message, "a library threw something unknown");
    return otherwise;
  }
}

} // namespace sozai::colour
