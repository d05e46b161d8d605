// SPDX-License-Identifier: Apache-2.0
//
// The handle of sozai_colour.h: a picture, and how it is looked up.
#pragma once

#include "library.hpp"

// Where to look, as sozai_images_1::sample takes it.
struct sozai_image_points {
  const float *s, *t, *dsdx, *dtdx, *dsdy, *dtdy;
};

struct sozai_image {
  sozai_image(std::shared_ptr<const sozai::images::Picture> picture, uint32_t wrap_s,
              uint32_t wrap_t);
  // Throws Failure, with 0 everywhere in out. [thread-safe]
  void sample(uint32_t count, const sozai_image_points &points, float *const *out) const;

  const std::shared_ptr<const sozai::images::Picture> picture;
  const bool turned; // seen with rows and columns exchanged

private:
  struct Place {
    float s, t, dsdx, dtdx, dsdy, dtdy;
  };
  Place place(const sozai_image_points &points, uint32_t i) const;

  const bool mirror_s, mirror_t; // as stored, after the exchange
  OIIO::TextureOpt options;
  float far_s, far_t;
};
