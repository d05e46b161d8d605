// SPDX-License-Identifier: Apache-2.0
//
// What file and buffer have in common.
#include "boundary.hpp"
#include "source.hpp"
#include "../ceilings.h"

#include <string>

namespace sozai::images {

constexpr uint64_t largest_side = IMAGE_LARGEST_SIDE;
constexpr uint64_t most_pixels = IMAGE_MOST_PIXELS;

void must_be_sane(const std::string &name, uint64_t width, uint64_t height) {
  if (width >= 1 && height >= 1 && width <= largest_side && height <= largest_side &&
      width * height <= most_pixels)
    return;
  throw colour::Failure(SOZAI_ERROR_FILE,
                        name + " claims " + std::to_string(width) + " x " + std::to_string(height) +
                            " pixels; taken are sides of 1 to " + std::to_string(largest_side) +
                            " and " + std::to_string(most_pixels) + " in all");
}

void must_be_allowed(const std::string &name, uint64_t width, uint64_t height,
                     uint64_t most_pixels) {
  if (most_pixels == 0 || width * height <= most_pixels) return;
  throw colour::Failure(SOZAI_ERROR_LIMIT, name + ": " + std::to_string(width * height) +
                                               " is above the ceiling image_pixels, " +
                                               std::to_string(most_pixels));
}

int channel_for(const Choice &choice, uint32_t index, int count, int alpha) {
  const int first = int(choice.first), there = count - first;
  if (int(index) < there && !(choice.channels > 2 && there == 2 && first + 1 == alpha))
    return first + int(index);
  if (index == 3) return there == 2 && first + 1 == alpha ? alpha : -1;
  // Grey is repeated, and so is the last of two that are no grey and alpha.
  return there == 2 && first + 1 != alpha ? first + 1 : first;
}

} // namespace sozai::images
