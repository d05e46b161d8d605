// SPDX-License-Identifier: Apache-2.0
//
// sozai.images/1: hands on to sozai-images.so.
#include "images.hpp"

#include "boundary.hpp"
#include "service.hpp"

#include <dlfcn.h>

namespace sozai::colour {

void Images::open_library() {
  if (library) return;
  const char *path = sozai_colour_images_library();
  if (!path) throw Failure(SOZAI_ERROR_STATE, "sozai-colour: no longer initialised");
  void *opened = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (!opened) {
    const char *why = dlerror();
    throw Failure(SOZAI_ERROR_UNSUPPORTED, std::string("pictures need sozai-images.so: ") +
                                               (why ? why : "it cannot be loaded"));
  }
  const auto found =
      static_cast<const sozai_images_module *>(dlsym(opened, SOZAI_IMAGES_MODULE_SYMBOL));
  if (!found || found->version != SOZAI_IMAGES_MODULE) {
    dlclose(opened);
    throw Failure(SOZAI_ERROR_UNSUPPORTED,
                  std::string(path) + " belongs to another version of sozai-colour.so");
  }
  library = opened;
  module = found;
}

const sozai_images_1 &Images::load() {
  if (const sozai_images_1 *already = loaded()) return *already;
  const std::lock_guard<std::mutex> guard(lock);
  if (const sozai_images_1 *already = loaded()) return *already;
  open_library();
  const sozai_image_colours colours = conversions(this);
  char message[512] = "";
  const int32_t result = module->open(&colours, bytes, &table, message, sizeof message);
  if (result != SOZAI_OK) throw Failure(result, message);
  ready.store(&table, std::memory_order_release);
  return table;
}

Images::~Images() {
  if (loaded()) module->close(&table);
  if (library) dlclose(library);
}

namespace {
extern "C" {

static int32_t open_image(void *self, const sozai_image_request *request, sozai_image **out,
                          char *message, size_t message_size) {
  const sozai_images_1 *images = nullptr;
  if (out) *out = nullptr;
  const int32_t result = guarded({message, message_size}, SOZAI_ERROR_FILE, [&] {
    need(self && request && out, "open: self, request or out is NULL");
    images = &of(self).image_library.load();
  });
  if (result != SOZAI_OK) return result;
  return images->open(images->self, request, out, message, message_size);
}

// An image is there only where the library is.
static void close_image(void *self, sozai_image *image) {
  if (!self || !image) return;
  const sozai_images_1 *images = of(self).image_library.loaded();
  images->close(images->self, image);
}

static int32_t resolution(void *self, const sozai_image *image, uint32_t *width, uint32_t *height) {
  if (!self || !image) return SOZAI_ERROR_ARGUMENT;
  const sozai_images_1 *images = of(self).image_library.loaded();
  return images->resolution(images->self, image, width, height);
}

static int32_t sample(void *self, const sozai_image *image, uint32_t count, const float *s,
                      const float *t, const float *dsdx, const float *dtdx, const float *dsdy,
                      const float *dtdy, float *const *out) {
  if (!self || !image) return SOZAI_ERROR_ARGUMENT;
  const sozai_images_1 *images = of(self).image_library.loaded();
  return images->sample(images->self, image, count, s, t, dsdx, dtdx, dsdy, dtdy, out);
}

static void memory(void *self, uint64_t *out_used, uint64_t *out_limit) {
  if (out_used) *out_used = 0;
  if (out_limit) *out_limit = 0;
  if (!self) return;
  // Asked before the first picture, the limit is worth the library.
  guarded({}, SOZAI_ERROR_FILE, [&] {
    const sozai_images_1 &images = of(self).image_library.load();
    images.memory(images.self, out_used, out_limit);
  });
}

} // extern "C"
} // namespace

sozai_images_1 images_table(sozai_services *self) {
  sozai_images_1 t = {};
  t.size = sizeof t;
  t.self = self;
  t.open = open_image;
  t.close = close_image;
  t.resolution = resolution;
  t.sample = sample;
  t.memory = memory;
  return t;
}

} // namespace sozai::colour
