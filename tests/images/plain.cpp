// SPDX-License-Identifier: Apache-2.0
#include "plain.h"

#include "sozai_colour.h"

#include <OpenImageIO/deepdata.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include <chrono>
#include <cstdio>
#include <cstring>

struct plain {
  decltype(OIIO::TextureSystem::create(false)) system; // in later versions a shared pointer
  OIIO::TextureSystem::TextureHandle *handle;
  OIIO::TextureOpt options;
};

bool plain_write(const char *path, const plain_picture *p, const float *data) {
  auto output = OIIO::ImageOutput::create(path);
  if (!output) {
    std::fprintf(stderr, "%s: %s\n", path, OIIO::geterror().c_str());
    return false;
  }
  OIIO::ImageSpec spec(p->width, p->height, p->channels, OIIO::TypeDesc(p->format));
  spec.tile_width = spec.tile_height = p->tile;
  if (p->windowed) {
    spec.x = p->x, spec.y = p->y;
    spec.full_width = p->full_width, spec.full_height = p->full_height;
  }
  if (p->orientation) spec.attribute("Orientation", p->orientation);
  if (p->unassociated) spec.attribute("oiio:UnassociatedAlpha", 1);
  if (std::strcmp(p->format, "uint8") == 0) spec.attribute("oiio:dither", 0);
  const bool ok = output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, data) &&
                  output->close();
  if (!ok) std::fprintf(stderr, "%s: %s\n", path, output->geterror().c_str());
  return ok;
}

bool plain_write_deep(const char *path) {
  auto output = OIIO::ImageOutput::create(path);
  OIIO::ImageSpec spec(4, 4, 5, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"R", "G", "B", "A", "Z"};
  spec.alpha_channel = 3;
  spec.z_channel = 4;
  spec.deep = true;
  OIIO::DeepData data(spec);
  for (int pixel = 0; pixel < 16; pixel++) {
    data.set_samples(pixel, 1);
    for (int c = 0; c < 5; c++) data.set_deep_value(pixel, c, 0, 0.5f);
  }
  return output && output->open(path, spec) && output->write_deep_image(data) && output->close();
}

plain *plain_open(const char *path, uint32_t wrap) {
  static const OIIO::TextureOpt::Wrap wraps[] = {
      OIIO::TextureOpt::WrapClamp, OIIO::TextureOpt::WrapBlack, OIIO::TextureOpt::WrapClamp,
      OIIO::TextureOpt::WrapPeriodic, OIIO::TextureOpt::WrapMirror};
  plain *p = new plain{};
  p->system = OIIO::TextureSystem::create(false);
  p->system->attribute("max_memory_MB", 2048.0f);
  p->system->attribute("automip", 1);
  p->system->attribute("autotile", 64);
  p->options.swrap = p->options.twrap = wraps[wrap];
  p->handle = p->system->get_texture_handle(OIIO::ustring(path));
  return p;
}

void plain_close(plain *p) {
  OIIO::TextureSystem::destroy(p->system);
  delete p;
}

bool plain_look(plain *p, float s, float t, float dsdx, float dtdx, float dsdy, float dtdy,
                int channels, float *out) {
  OIIO::TextureOpt options = p->options;
  if (p->system->texture(p->handle, p->system->get_perthread_info(), options, s, t, dsdx, dtdx,
                         dsdy, dtdy, channels, out))
    return true;
  std::fprintf(stderr, "%s\n", p->system->geterror().c_str());
  return false;
}

double plain_time(plain *p, uint32_t count, const float *s, const float *t, float footprint,
                  int channels) {
  const auto begin = std::chrono::steady_clock::now();
  OIIO::TextureSystem::Perthread *thread = p->system->get_perthread_info();
  OIIO::TextureOpt options = p->options;
  volatile float sink = 0;
  float sum = 0;
  for (uint32_t i = 0; i < count; i++) {
    float out[4];
    p->system->texture(p->handle, thread, options, s[i], t[i], footprint, 0, 0, footprint, channels,
                       out);
    sum += out[0];
  }
  sink = sum;
  (void)sink;
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
  return took.count() / count;
}
