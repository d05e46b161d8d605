// SPDX-License-Identifier: Apache-2.0
//
// Alpha: a space's curve is for colours, not for colours times alpha, so they are
// divided before the conversion and multiplied after. Multiplied they are filtered,
// or the colour of what is not there would bleed in.
#include "linear.hpp"

#include "boundary.hpp"

#include <cfloat>
#include <cmath>
#include <cstdint>

namespace sozai::images {

static float finite(float value) { return std::isfinite(value) ? value : 0; }

// A conversion may overflow.
static float within(float value) {
  if (std::isnan(value)) return 0;
  return value < -FLT_MAX ? -FLT_MAX : value > FLT_MAX ? FLT_MAX : value;
}

Linear::Linear(const Layout &layout, uint32_t channels, const sozai_image_colours &colours,
               const sozai_image_conversion &conversion)
    : layout(layout), channels(channels), stride(channels + (layout.alpha ? 1 : 0)),
      colours(colours), conversion(conversion), rgba(size_t(layout.width) * 4),
      out(size_t(layout.width) * channels) {}

void Linear::convert(const float *pixels) {
  if (!conversion.how) return;
  const size_t width = size_t(layout.width);
  char message[512];
  int32_t result = colours.apply(conversion.how, rgba.data(), width, message, sizeof message);
  if (result != SOZAI_OK) throw colour::Failure(result, message);
  for (size_t x = 0; x < width; x++) // alpha is no colour
    rgba[x * 4 + 3] = layout.alpha ? pixels[x * stride + channels] : 1;
}

const float *Linear::row(float *pixels) {
  const size_t width = size_t(layout.width);
  for (size_t i = 0; i < width * stride; i++) pixels[i] = finite(pixels[i]);
  if (channels < 3 || !conversion.colour) return pixels;

  for (size_t x = 0; x < width; x++) {
    const float *in = pixels + x * stride;
    const float alpha = layout.alpha ? in[channels] : 1;
    const bool divide = conversion.how && layout.premultiplied && alpha > 0 && alpha != 1;
    for (size_t c = 0; c < 3; c++) rgba[x * 4 + c] = divide ? within(in[c] / alpha) : in[c];
    rgba[x * 4 + 3] = alpha;
  }
  convert(pixels);
  for (size_t x = 0; x < width; x++) {
    const float *in = pixels + x * stride, alpha = rgba[x * 4 + 3];
    const bool divided = conversion.how && layout.premultiplied && alpha > 0 && alpha != 1;
    const bool multiply = layout.alpha && (divided || !layout.premultiplied);
    float *to = out.data() + x * channels;
    for (size_t c = 0; c < 3; c++) {
      const float colour = within(rgba[x * 4 + c]);
      to[c] = multiply ? within(colour * alpha) : colour;
    }
    if (channels == 4) to[3] = in[3];
  }
  return out.data();
}

} // namespace sozai::images
