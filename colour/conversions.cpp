// SPDX-License-Identifier: Apache-2.0
//
// What sozai-images.so asks for: the conversion of a picture's space.
#include "boundary.hpp"
#include "images.hpp"

#include <algorithm>

namespace sozai::colour {
namespace {

// Rules are patterns, in which no dot stands for a line's end.
std::string one_line(std::string path) {
  std::replace_if(
      path.begin(), path.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, '_');
  return path;
}

sozai_image_conversion conversion(Images &images, const std::string &space) {
  sozai_image_conversion found = {};
  if (space == "data") return found; // with a config that has no such role, too
  const auto known = images.config.ocio->getColorSpace(space.c_str());
  if (known && known->isData()) return found;
  // The processors live as long as the images, so the pointer does.
  const auto processor = images.processors.to_working(space.c_str());
  found.colour = 1;
  found.how = processor->isNoOp() ? nullptr : processor.get();
  return found;
}

extern "C" {

static int32_t find(void *self, const char *space, const char *path, sozai_image_conversion *out,
                    char *message, size_t message_size) {
  return guarded({message, message_size}, [&] {
    Images &images = *static_cast<Images *>(self);
    *out = conversion(
        images,
        space ? space : images.config.ocio->getColorSpaceFromFilepath(one_line(path).c_str()));
  });
}

static int32_t apply(const void *how, float *rgba, uint64_t count, char *message,
                     size_t message_size) {
  return guarded({message, message_size}, [&] {
    // A row of a picture at a time: in one go it is many times as fast as by pixel.
    ocio::PackedImageDesc row(rgba, long(count), 1, 4);
    static_cast<const ocio::CPUProcessor *>(how)->apply(row);
  });
}

} // extern "C"
} // namespace

sozai_image_colours conversions(Images *self) { return {self, find, apply}; }

} // namespace sozai::colour
