// SPDX-License-Identifier: Apache-2.0
#include "image.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace {

using Wrap = OIIO::TextureOpt::Wrap;

Wrap wrap_for(uint32_t wrap) {
  switch (wrap) {
  case SOZAI_WRAP_BLACK:
    return OIIO::TextureOpt::WrapBlack;
  case SOZAI_WRAP_PERIODIC:
    return OIIO::TextureOpt::WrapPeriodic;
  case SOZAI_WRAP_MIRROR:
    return OIIO::TextureOpt::WrapMirror;
  default:
    return OIIO::TextureOpt::WrapClamp;
  }
}

// How far from the picture OpenImageIO can count pixels in an int, with some to spare.
float far_of(int pixels) { return float(1 << 28) / float(pixels); }

// That place, or beyond what can be counted one that looks the same.
float within_reach(float at, float far, Wrap wrap) {
  if (std::fabs(at) < far) return at;
  if (!std::isfinite(at)) return 0;
  if (wrap == OIIO::TextureOpt::WrapPeriodic || wrap == OIIO::TextureOpt::WrapMirror)
    return std::fmod(at, 2.0f);
  return std::copysign(far, at);
}

float step_within(float step, float far) {
  if (std::fabs(step) < far) return step;
  return std::isfinite(step) ? std::copysign(far, step) : 0;
}

float finite(float value) {
  if (std::fabs(value) <= FLT_MAX) return value;
  return std::isnan(value) ? 0 : std::copysign(FLT_MAX, value);
}

} // namespace

// EXIF's orientations 5 to 8 exchange rows and columns. Rows run upwards in 3, 4, 7
// and 8, columns from right to left in 2, 3, 6 and 7; in the words of what is stored,
// that mirrors t in 3, 4, 6 and 7, and s in 2, 3, 7 and 8.
sozai_image::sozai_image(std::shared_ptr<const sozai::images::Picture> the_picture, uint32_t wrap_s,
                         uint32_t wrap_t)
    : picture(std::move(the_picture)), turned(picture->orientation >= 5),
      mirror_s(picture->orientation == 2 || picture->orientation == 3 ||
               picture->orientation == 7 || picture->orientation == 8),
      mirror_t(picture->orientation == 3 || picture->orientation == 4 ||
               picture->orientation == 6 || picture->orientation == 7),
      far_s(far_of(picture->width())), far_t(far_of(picture->height())) {
  options.swrap = wrap_for(turned ? wrap_t : wrap_s);
  options.twrap = wrap_for(turned ? wrap_s : wrap_t);
}

// The i-th place, in the coordinates of the picture as it is stored.
sozai_image::Place sozai_image::place(const sozai_image_points &points, uint32_t i) const {
  Place at = {points.s[i],    points.t[i],    points.dsdx[i],
              points.dtdx[i], points.dsdy[i], points.dtdy[i]};
  if (turned) {
    std::swap(at.s, at.t);
    std::swap(at.dsdx, at.dtdx);
    std::swap(at.dsdy, at.dtdy);
  }
  if (mirror_s) at.s = 1 - at.s, at.dsdx = -at.dsdx, at.dsdy = -at.dsdy;
  if (mirror_t) at.t = 1 - at.t, at.dtdx = -at.dtdx, at.dtdy = -at.dtdy;
  at.s = within_reach(at.s, far_s, options.swrap);
  at.t = within_reach(at.t, far_t, options.twrap);
  at.dsdx = step_within(at.dsdx, far_s);
  at.dtdx = step_within(at.dtdx, far_t);
  at.dsdy = step_within(at.dsdy, far_s);
  at.dtdy = step_within(at.dtdy, far_t);
  return at;
}

void sozai_image::sample(uint32_t count, const sozai_image_points &points,
                         float *const *out) const {
  OIIO::TextureSystem &textures = picture->cache.textures();
  OIIO::TextureSystem::Perthread *thread = textures.get_perthread_info();
  OIIO::TextureOpt opt = options; // OpenImageIO writes to it
  const int channels = int(picture->channels());
  for (uint32_t i = 0; i < count; i++) {
    const Place at = place(points, i);
    alignas(16) float found[4] = {};
    if (!textures.texture(picture->slot.handle, thread, opt, at.s, at.t, at.dsdx, at.dtdx, at.dsdy,
                          at.dtdy, channels, found)) {
      const std::string why = textures.geterror();
      for (int c = 0; c < channels; c++) std::fill_n(out[c], count, 0.0f);
      throw sozai::colour::Failure(SOZAI_ERROR_FILE, why);
    }
    for (int c = 0; c < channels; c++) out[c][i] = finite(found[c]);
  }
}
