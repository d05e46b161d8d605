// SPDX-License-Identifier: Apache-2.0
//
// The frame of a PNG file: a signature, then chunks of length, type, data and CRC, as
// ISO/IEC 15948 has it, to IEND.
#include "png.hpp"

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace sozai::images {

namespace {

using Table = std::array<std::array<uint32_t, 256>, 4>;

// CRC-32 of four bytes at a time.
Table make_table() {
  Table table = {};
  for (uint32_t n = 0; n < 256; n++) {
    uint32_t c = n;
    for (int k = 0; k < 8; k++) c = c & 1 ? 0xEDB88320u ^ (c >> 1) : c >> 1;
    table[0][n] = c;
  }
  for (size_t n = 0; n < 256; n++)
    for (size_t k = 1; k < 4; k++)
      table[k][n] = table[0][table[k - 1][n] & 255] ^ (table[k - 1][n] >> 8);
  return table;
}

uint32_t crc(uint32_t c, const unsigned char *data, size_t size) {
  static const Table table = make_table();
  for (; size >= 4; size -= 4, data += 4) {
    c ^= uint32_t(data[0]) | uint32_t(data[1]) << 8 | uint32_t(data[2]) << 16 |
         uint32_t(data[3]) << 24;
    c = table[3][c & 255] ^ table[2][c >> 8 & 255] ^ table[1][c >> 16 & 255] ^ table[0][c >> 24];
  }
  for (; size > 0; size--, data++) c = table[0][(c ^ *data) & 255] ^ (c >> 8);
  return c;
}

uint32_t big_endian(const unsigned char *b) {
  return uint32_t(b[0]) << 24 | uint32_t(b[1]) << 16 | uint32_t(b[2]) << 8 | b[3];
}

struct Close {
  void operator()(std::FILE *file) const { std::fclose(file); }
};

} // namespace

const char *png_damage(const char *path) {
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path, "rbe"));
  if (!file) return nullptr; // the reader says why
  unsigned char head[8];
  const auto get = [&](void *to, size_t size) {
    return std::fread(to, 1, size, file.get()) == size;
  };
  if (!get(head, 8) || std::memcmp(head, "\x89PNG", 4) != 0) return nullptr;
  // OpenImageIO looks at seven bytes of it; libpng at the eighth, and prints.
  if (std::memcmp(head, "\x89PNG\r\n\x1a\n", 8) != 0) return "damaged, its signature is not PNG's";
  std::vector<unsigned char> piece(1 << 16);
  for (;;) {
    if (!get(head, 8)) return "cut off, it has no end";
    const uint32_t size = big_endian(head);
    uint32_t sum = crc(~0u, head + 4, 4);
    for (uint32_t left = size; left > 0;) {
      const uint32_t some = left < piece.size() ? left : uint32_t(piece.size());
      if (!get(piece.data(), some)) return "cut off, it cannot be read to its end";
      sum = crc(sum, piece.data(), some);
      left -= some;
    }
    const bool end = std::memcmp(head + 4, "IEND", 4) == 0;
    unsigned char given[4];
    if (!get(given, 4)) return "cut off, it cannot be read to its end";
    if (big_endian(given) != ~sum) return "damaged, a check sum is wrong";
    if (end) return nullptr;
  }
}

} // namespace sozai::images
