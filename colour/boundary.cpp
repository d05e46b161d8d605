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

// Whether a terminal or a log would take it for more than text: ASCII's controls,
// those from U+0080 to U+009F, and U+2028 and U+2029, which end lines as well.
static bool steers(const char *text, size_t length) noexcept {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  if (length == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
  if (length == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;
  return length == 3 && byte(0) == 0xE2 && byte(1) == 0x80 && (byte(2) & 0xFE) == 0xA8;
}

void write(Message message, const char *text) noexcept {
  if (!message.text || message.size == 0) return;
  char *out = message.text;
  const char *const last = out + message.size - 1;
  while (*text) {
    const size_t length = character(text);
    const bool whole = length > 0 && !steers(text, length);
    const size_t bytes = whole ? length : 1;
    if (bytes > size_t(last - out)) break; // cut between characters, not inside one
    if (whole)
      std::memcpy(out, text, bytes);
    else
      *out = length ? ' ' : '?'; // a line is a line
    out += bytes;
    text += std::max<size_t>(length, 1);
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
