// SPDX-License-Identifier: Apache-2.0
//
// Where a picture's numbers come from, row by row from the top: a file, through
// OpenImageIO, or memory of the host's.
#pragma once

#include "sozai_colour.h"

#include <functional>
#include <memory>

namespace sozai::images {

// Which numbers of a picture are wanted.
struct Choice {
  uint32_t first, channels;
  bool colour; // the others are data, for which alpha has no meaning
};

// What stands before the numbers asked for and behind them. Rows hold, pixel by
// pixel, Choice::channels numbers and, with `alpha`, the picture's alpha.
struct Layout {
  int width, height;
  int orientation;    // as EXIF has it: 1, as stored, to 8
  bool alpha;         // there is one, and it is not among the first three channels chosen
  bool premultiplied; // the colours have been multiplied by it
};

class Source {
public:
  using Row = std::function<void(float *)>; // may be written to
  virtual ~Source() = default;
  virtual const Layout &layout() const = 0;
  virtual void read(const Row &row) = 0; // throws Failure
};

// All throw Failure. most_pixels: the caller's ceiling, 0 for none, which is looked at
// before any row is read.
std::unique_ptr<Source> file_source(const char *path, const Choice &choice, uint64_t most_pixels);
// The buffer must live as long as the source.
std::unique_ptr<Source> buffer_source(const sozai_buffer &buffer, const Choice &choice,
                                      uint64_t most_pixels);

// Refuses what is larger than any real picture: a damaged head may claim anything.
void must_be_sane(const std::string &name, uint64_t width, uint64_t height);
// Refuses what is above the caller's ceiling.
void must_be_allowed(const std::string &name, uint64_t width, uint64_t height,
                     uint64_t most_pixels);

// Which channel of `count`, of which `alpha` (-1: none) is one, becomes the index-th
// of those wanted; -1: none, it is 1.
int channel_for(const Choice &choice, uint32_t index, int count, int alpha);

} // namespace sozai::images
