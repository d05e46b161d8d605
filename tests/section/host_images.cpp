// SPDX-License-Identifier: Apache-2.0
#include "host_images.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/texture.h>

#include <atomic>
#include <cstdio>
#include <cstring>

struct sozai_image {
  OIIO::ustring name;
  OIIO::TextureOpt options;
  int channels;
  int width, height;
};

namespace {

using System = decltype(OIIO::TextureSystem::create(false));
System textures{};
std::atomic<uint64_t> lookups{0};

OIIO::TextureOpt::Wrap wrap_of(uint32_t wrap) {
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

int32_t open(void *, const sozai_image_request *q, sozai_image **out, char *message, size_t size) {
  OIIO::ustring name(q->path ? q->path : "");
  int resolution[2] = {0, 0};
  if (!q->path || !textures->get_texture_info(name, 0, OIIO::ustring("resolution"),
                                              OIIO::TypeDesc(OIIO::TypeDesc::INT, 2), resolution)) {
    std::snprintf(message, size, "the host cannot read %s", name.c_str());
    textures->geterror();
    return SOZAI_ERROR_FILE;
  }
  auto *image = new sozai_image;
  image->name = name;
  image->options.swrap = wrap_of(q->wrap_s);
  image->options.twrap = wrap_of(q->wrap_t);
  image->options.firstchannel = int(q->first_channel);
  image->channels = int(q->channels);
  image->width = resolution[0];
  image->height = resolution[1];
  *out = image;
  return SOZAI_OK;
}

void close(void *, sozai_image *image) { delete image; }

int32_t resolution(void *, const sozai_image *image, uint32_t *width, uint32_t *height) {
  *width = uint32_t(image->width);
  *height = uint32_t(image->height);
  return SOZAI_OK;
}

int32_t sample(void *, const sozai_image *image, uint32_t count, const float *s, const float *t,
               const float *dsdx, const float *dtdx, const float *dsdy, const float *dtdy,
               float *const *out) {
  for (uint32_t i = 0; i < count; i++) {
    float value[4] = {0, 0, 0, 0};
    OIIO::TextureOpt options = image->options;
    if (!textures->texture(image->name, options, s[i], t[i], dsdx[i], dtdx[i], dsdy[i], dtdy[i],
                           image->channels, value))
      return SOZAI_ERROR_FILE;
    for (int c = 0; c < image->channels; c++) out[c][i] = value[c];
  }
  lookups += count;
  return SOZAI_OK;
}

void memory(void *, uint64_t *used, uint64_t *limit) {
  if (used) *used = 0;
  if (limit) *limit = 0;
}

const sozai_images_1 table = {
    sizeof(sozai_images_1), 0, nullptr, open, close, resolution, sample, memory};

} // namespace

const sozai_images_1 *host_images_open(void) {
  textures = OIIO::TextureSystem::create(false);
  textures->attribute("automip", 1);
  textures->attribute("autotile", 64);
  textures->attribute("max_memory_MB", 512.0f);
  return &table;
}

void host_images_close(void) {
  OIIO::TextureSystem::destroy(textures);
  textures = System{};
}

uint64_t host_images_lookups(void) { return lookups; }

int host_images_write(const char *path, int width, int height, const float *rgb) {
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
  OIIO::ImageBuf picture(spec);
  if (!picture.localpixels()) return -1;
  std::memcpy(picture.localpixels(), rgb, sizeof(float) * 3 * size_t(width) * size_t(height));
  const size_t length = std::strlen(path);
  const bool is_float = length > 4 && std::strcmp(path + length - 4, ".exr") == 0;
  if (!is_float) picture = OIIO::ImageBufAlgo::colorconvert(picture, "linear", "sRGB");
  if (picture.write(path, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8)) return 0;
  std::fprintf(stderr, "%s: %s\n", path, picture.geterror().c_str());
  return -1;
}
