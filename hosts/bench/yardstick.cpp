// SPDX-License-Identifier: Apache-2.0
// OpenImageIO may throw, and so may the standard library; nothing gets past this
// file.
#include "yardstick.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>

#include <cstdlib>
#include <cstring>
#include <sstream>

#include "clock.h"
#include "guarded.hpp"

struct yardstick {
  // a pointer, or in later versions a shared one
  decltype(OIIO::TextureSystem::create(false)) system;
  OIIO::ustring name;
  volatile float sink; // so that no look-up is left out
};

namespace {

constexpr float cache_megabytes = 2048;

bool write(const char *path, uint32_t side, const float *rgb, failure *why) {
  const int size = int(side);
  OIIO::ImageSpec spec(size, size, 3, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf picture(spec);
  if (!picture.localpixels()) return fail(why, EXIT_FAILURE, "out of memory");
  std::memcpy(picture.localpixels(), rgb, sizeof(float) * 3 * side * side);
  OIIO::ImageSpec config;
  config.set_format(OIIO::TypeDesc::HALF);
  std::ostringstream said;
  if (OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, picture, path, config,
                                       &said))
    return true;
  return fail(why, EXIT_FAILURE, "cannot make the texture %s: %s %s", path, said.str().c_str(),
              OIIO::geterror().c_str());
}

bool run(yardstick *y, const board *b, double *ns, failure *why) {
  const float texel = 1.0f / float(b->side);
  float sum = 0;
  bool ok = true;
  double begin = thread_ns();
  for (uint32_t row = 0; row < b->rows; row++) {
    float t = (float(b->row + row) + 0.5f) * texel;
    for (uint32_t column = 0; column < b->columns; column++) {
      float s = (float(b->column + column) + 0.5f) * texel, rgb[3];
      OIIO::TextureOpt options;
      ok &= y->system->texture(y->name, options, s, t, texel, 0, 0, texel, 3, rgb);
      sum += rgb[0] + rgb[1] + rgb[2];
    }
  }
  *ns = thread_ns() - begin;
  y->sink = sum;
  return ok || fail(why, EXIT_FAILURE, "a look-up failed: %s", y->system->geterror().c_str());
}

} // namespace

bool yardstick_write(const char *path, uint32_t side, const float *rgb, failure *why) {
  return guarded(why, [=] { return write(path, side, rgb, why); });
}

yardstick *yardstick_open(const char *path, failure *why) {
  yardstick *y = nullptr;
  bool ok = guarded(why, [&] {
    y = new yardstick{};
    y->system = OIIO::TextureSystem::create(false);
    if (!y->system)
      return fail(why, EXIT_FAILURE, "no texture system: %s", OIIO::geterror().c_str());
    y->system->attribute("max_memory_MB", cache_megabytes);
    y->name = OIIO::ustring(path);
    return true;
  });
  if (ok) return y;
  yardstick_close(y);
  return nullptr;
}

void yardstick_close(yardstick *y) {
  if (!y) return;
  failure ignored;
  guarded(&ignored, [=] {
    if (y->system) OIIO::TextureSystem::destroy(y->system);
    delete y;
    return true;
  });
}

bool yardstick_run(yardstick *y, const board *b, double *ns, failure *why) {
  return guarded(why, [=] { return run(y, b, ns, why); });
}
