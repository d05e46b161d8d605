// SPDX-License-Identifier: Apache-2.0
//
// sozai.images/1, and the one symbol that this library exports.
#include "module.h"

#include "boundary.hpp"
#include "image.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

namespace sozai::images {
namespace {

using colour::Failure;

void need(bool given, const char *text) {
  if (!given) throw Failure(SOZAI_ERROR_ARGUMENT, text);
}

// The caller's, which may be shorter than ours; what it lacks is 0.
template <class Struct> Struct whole(const Struct &given, const char *what) {
  need(given.size >= 8, what);
  Struct copy = {};
  std::memcpy(&copy, &given, std::min<size_t>(given.size, sizeof copy));
  return copy;
}

std::shared_ptr<const Picture> open_request(Library &library, const sozai_image_request &request) {
  need(request.channels >= 1 && request.channels <= 4, "open: channels must be 1 to 4");
  need(request.first_channel <= INT32_MAX, "open: first_channel is too large");
  need(request.wrap_s <= SOZAI_WRAP_MIRROR && request.wrap_t <= SOZAI_WRAP_MIRROR,
       "open: no such wrap");
  need(request.path || request.buffer, "open: neither path nor buffer");
  if (request.path) return library.open(request);
  const sozai_buffer buffer = whole(*request.buffer, "open: buffer.size is not set");
  need(buffer.kind == SOZAI_BUFFER_IMAGE, "open: the buffer is no image");
  need(buffer.data || buffer.path, "open: the buffer has neither data nor a path");
  sozai_image_request with_copy = request;
  with_copy.buffer = &buffer;
  return library.open(with_copy);
}

extern "C" {

static int32_t open_image(void *self, const sozai_image_request *request, sozai_image **out,
                          char *message, size_t message_size) {
  if (out) *out = nullptr;
  if (message && message_size) *message = '\0';
  return colour::guarded({message, message_size}, SOZAI_ERROR_FILE, [&] {
    need(self && request && out, "open: self, request or out is NULL");
    const sozai_image_request r = whole(*request, "open: request.size is not set");
    *out = new sozai_image{open_request(*static_cast<Library *>(self), r), r.wrap_s, r.wrap_t};
  });
}

static void close_image(void *, sozai_image *image) { delete image; }

static int32_t resolution(void *, const sozai_image *image, uint32_t *width, uint32_t *height) {
  if (!image) return SOZAI_ERROR_ARGUMENT;
  if (width) *width = uint32_t(image->turned ? image->picture->height() : image->picture->width());
  if (height)
    *height = uint32_t(image->turned ? image->picture->width() : image->picture->height());
  return SOZAI_OK;
}

static int32_t sample(void *, const sozai_image *image, uint32_t count, const float *s,
                      const float *t, const float *dsdx, const float *dtdx, const float *dsdy,
                      const float *dtdy, float *const *out) {
  if (count == 0) return SOZAI_OK;
  if (!image || !s || !t || !dsdx || !dtdx || !dsdy || !dtdy || !out) return SOZAI_ERROR_ARGUMENT;
  return colour::guarded({}, SOZAI_ERROR_FILE, [&] {
    image->sample(count, {s, t, dsdx, dtdx, dsdy, dtdy}, out);
  });
}

static void memory(void *self, uint64_t *out_used, uint64_t *out_limit) {
  colour::guarded({}, SOZAI_ERROR_FILE, [&] {
    const Cache &cache = static_cast<Library *>(self)->used_cache();
    if (out_used) *out_used = cache.used();
    if (out_limit) *out_limit = cache.limit();
  });
}

static int32_t open_images(const sozai_image_colours *colours, uint64_t bytes, sozai_images_1 *out,
                           char *message, size_t message_size) {
  return colour::guarded({message, message_size}, SOZAI_ERROR_FILE, [&] {
    sozai_images_1 table = {};
    table.size = sizeof table;
    table.self = new Library(*colours, bytes);
    table.open = open_image;
    table.close = close_image;
    table.resolution = resolution;
    table.sample = sample;
    table.memory = memory;
    *out = table;
  });
}

static void close_images(sozai_images_1 *images) { delete static_cast<Library *>(images->self); }

} // extern "C"
} // namespace
} // namespace sozai::images

extern "C" {
extern __attribute__((visibility("default"))) const sozai_images_module sozai_images_entry;
const sozai_images_module sozai_images_entry = {SOZAI_IMAGES_MODULE, sozai::images::open_images,
                                                sozai::images::close_images};
}
