// SPDX-License-Identifier: Apache-2.0
#include "formula.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace ocio = OCIO_NAMESPACE;

namespace sozai::colour {

// The names of plugin/core/colour.c.
static const char *const srgb_names[] = {"sRGB",
                                         "sRGB - Texture",
                                         "srgb_texture",
                                         "Utility - sRGB - Texture",
                                         "sRGB Encoded Rec.709 (sRGB)",
                                         "srgb_rec709_scene"};
static const char *const linear_names[] = {"scene_linear", "lin_rec709", "lin_srgb",
                                           "Linear Rec.709 (sRGB)", "Linear Rec.709"};

template <size_t N> static bool among(const char *const (&names)[N], const std::string &name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

ocio::ConstTransformRcPtr by_formula(const char *space) {
  if (among(linear_names, space)) return ocio::MatrixTransform::Create();
  if (!among(srgb_names, space)) return nullptr;
  // IEC 61966-2-1, mirrored for negative numbers.
  const auto srgb = ocio::ExponentWithLinearTransform::Create();
  srgb->setGamma({2.4, 2.4, 2.4, 1});
  srgb->setOffset({0.055, 0.055, 0.055, 0});
  srgb->setNegativeStyle(ocio::NEGATIVE_MIRROR);
  return srgb;
}

} // namespace sozai::colour
