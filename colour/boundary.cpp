// SPDX-License-Identifier: Apache-2.0
#include "boundary.hpp"

#include <algorithm>
#include <cstring>
#include <new>

namespace sozai::colour {

// The length of the character that text begins with, or 0: it is not UTF-8. Names
// of files are bytes, and reach messages.
static size_t character(const char *text) noexcept {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  for (size_t i = 1; i < length; i++)
    if ((byte(i) & 0xC0) != 0x80) return 0; // which the end of the text is, too
  // Not the shortest form, a surrogate, or past the last character.
  const unsigned second = byte(1);
  const bool wrong = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                     (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return wrong ? 0 : length;
}

void write(Message message, const char *text) noexcept {
  if (!message.text || message.size == 0) return;
  size_t room = message.size - 1;
  char *out = message.text;
  while (*text) {
    const size_t length = character(text);
    const size_t bytes = std::max<size_t>(length, 1);
    if (bytes > room) break; // cut between characters, not inside one
    std::memcpy(out, text, bytes);
    if (length == 0)
      *out = '?';
    else if (static_cast<unsigned char>(*out) < ' ')
      *out = ' '; // a line is a line
    out += bytes;
    text += bytes;
    room -= bytes;
  }
  *out = '\0';
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
