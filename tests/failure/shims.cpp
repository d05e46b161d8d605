// SPDX-License-Identifier: Apache-2.0
//
// The colour and picture services while operator new throws: at each of its
// first calls, and a spread of the later ones. Whatever OpenColorIO or
// OpenImageIO makes of it, an error and a line come out of the C functions, and
// the services work afterwards.
#include <dlfcn.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "sozai_colour.h"

namespace {

thread_local long countdown = 0; // 0: let all be
thread_local long calls = 0;
int failures = 0;

void check(bool good, const char *what, long at) {
  if (good) return;
  std::fprintf(stderr, "FAILED: %s, with the %ld-th allocation failing\n", what, at);
  failures++;
}

struct Outcome {
  int32_t result;
  bool failed; // somewhere an error came out
};

// Opens the services, converts a colour, looks a picture up, closes it all.
Outcome use(const sozai_services_1 *services, long at) {
  calls = 0;
  countdown = at;
  char message[256] = "";
  sozai_services *s = nullptr;
  int32_t r = services->open(nullptr, &s, message, sizeof message);
  Outcome o = {r, r != SOZAI_OK};
  if (r != SOZAI_OK) {
    countdown = 0;
    check(s == nullptr, "a failed open gave services", at);
    check(message[0] != 0, "open failed without a reason", at);
    return o;
  }
  auto colour = static_cast<const sozai_colour_1 *>(services->get(s, SOZAI_COLOUR_1));
  auto images = static_cast<const sozai_images_1 *>(services->get(s, SOZAI_IMAGES_1));
  float rgb[3] = {0.2f, 0.4f, 0.6f};
  if (colour) {
    message[0] = 0;
    r = colour->to_working(colour->self, "ACEScg", rgb, 1, message, sizeof message);
    if (r != SOZAI_OK) check(message[0] != 0, "a conversion failed without a reason", at);
    o.failed = o.failed || r != SOZAI_OK;
  }
  static const float pixels[4 * 4 * 3] = {0.5f};
  sozai_buffer buffer = {};
  buffer.size = sizeof buffer;
  buffer.kind = SOZAI_BUFFER_IMAGE;
  buffer.dims[0] = buffer.dims[1] = 4;
  buffer.dims[2] = 3;
  buffer.data = pixels;
  sozai_image_request request = {};
  request.size = sizeof request;
  request.channels = 3;
  request.buffer = &buffer;
  sozai_image *image = nullptr;
  if (images) {
    message[0] = 0;
    r = images->open(images->self, &request, &image, message, sizeof message);
    if (r != SOZAI_OK) {
      check(image == nullptr, "a failed open gave a picture", at);
      check(message[0] != 0, "a picture failed without a reason", at);
    } else {
      float at_s = 0.5f, zero = 0, out[3];
      float *to[3] = {out, out + 1, out + 2};
      r = images->sample(images->self, image, 1, &at_s, &at_s, &zero, &zero, &zero, &zero, to);
    }
    o.failed = o.failed || r != SOZAI_OK;
    images->close(images->self, image);
  }
  countdown = 0;
  services->close(s);
  return o;
}

} // namespace

// In place of the library's own, for all that is loaded.
void *operator new(size_t size) {
  calls++;
  if (countdown && --countdown == 0) throw std::bad_alloc();
  void *p = std::malloc(size ? size : 1);
  if (!p) throw std::bad_alloc();
  return p;
}
void operator delete(void *p) noexcept { std::free(p); }
void operator delete(void *p, size_t) noexcept { std::free(p); }

int main(int argc, char **argv) {
  void *library = argc > 1 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : nullptr;
  auto entry = library
                   ? static_cast<const sozai_entry_v1 *>(dlsym(library, SOZAI_COLOUR_ENTRY_SYMBOL))
                   : nullptr;
  if (!entry || entry->init(argv[1]) != SOZAI_OK) {
    std::fprintf(stderr, "cannot load: %s\n", dlerror());
    return 1;
  }
  auto services = static_cast<const sozai_services_1 *>(entry->get_factory(SOZAI_SERVICES_1));
  check(!use(services, 0).failed, "without any failure it fails", 0);
  const Outcome whole = use(services, 0);
  const long all = calls;
  check(whole.result == SOZAI_OK, "it does not work twice", 0);
  long injected = 0, errors = 0;
  for (long at = 1; at <= all; at += at < 60 ? 1 : at / 12) {
    errors += use(services, at).failed;
    injected++;
    if (injected % 16 == 0) check(!use(services, 0).failed, "it does not work afterwards", at);
  }
  check(!use(services, 0).failed, "it does not work afterwards", all);
  std::printf(
      "%ld allocations by operator new, %ld failed in turn, %ld of them came out as errors\n", all,
      injected, errors);
  check(errors > 20, "hardly any failure came out", errors);
  entry->deinit();
  return failures != 0;
}
