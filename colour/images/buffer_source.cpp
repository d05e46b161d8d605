// SPDX-License-Identifier: Apache-2.0
//
// A picture in the host's memory. Its fourth channel is alpha, and its colours are
// multiplied by it: what renderers keep in memory is.
#include "boundary.hpp"
#include "source.hpp"
#include "../ceilings.h"

#include <string>
#include <vector>

namespace sozai::images {

using colour::Failure;

namespace {

constexpr uint64_t most_channels = IMAGE_MOST_CHANNELS;

class BufferSource final : public Source {
public:
  BufferSource(const sozai_buffer &buffer, const Choice &choice, uint64_t most_pixels)
      : data(buffer.data), count(size_t(buffer.dims[2])) {
    must_be_sane("the buffer", buffer.dims[1], buffer.dims[0]);
    must_be_allowed("the buffer", buffer.dims[1], buffer.dims[0], most_pixels);
    if (buffer.dims[2] < 1 || buffer.dims[2] > most_channels)
      throw Failure(SOZAI_ERROR_ARGUMENT,
                    "the buffer has " + std::to_string(buffer.dims[2]) + " channels");
    if (choice.first >= buffer.dims[2])
      throw Failure(SOZAI_ERROR_FILE, "the buffer has no channel " + std::to_string(choice.first) +
                                          ", it has " + std::to_string(buffer.dims[2]));
    const int alpha = count == 4 ? 3 : -1;
    for (uint32_t i = 0; i < choice.channels; i++)
      from.push_back(channel_for(choice, i, int(count), alpha));
    about = {int(buffer.dims[1]), int(buffer.dims[0]), 1, false, true};
    about.alpha = choice.colour && choice.channels > 2 && alpha >= 0 && choice.first == 0;
    if (about.alpha) from.push_back(alpha);
  }

  const Layout &layout() const override { return about; }

  void read(const Row &sink) override {
    const float *in = data;
    std::vector<float> row(size_t(about.width) * from.size());
    for (int y = 0; y < about.height; y++) {
      float *out = row.data();
      for (int x = 0; x < about.width; x++, in += count)
        for (const int channel : from) *out++ = channel < 0 ? 1.0f : in[channel];
      sink(row.data());
    }
  }

private:
  const float *data;
  size_t count;
  std::vector<int> from; // the buffer's channel for each number of a row; -1: it is 1
  Layout about = {};
};

} // namespace

std::unique_ptr<Source> buffer_source(const sozai_buffer &buffer, const Choice &choice,
                                      uint64_t most_pixels) {
  return std::make_unique<BufferSource>(buffer, choice, most_pixels);
}

} // namespace sozai::images
