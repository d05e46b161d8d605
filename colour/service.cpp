// SPDX-License-Identifier: Apache-2.0
//
// The function tables of sozai_colour.h.
#include "boundary.hpp"
#include "pixels.hpp"
#include "processors.hpp"

#include <memory>

namespace sozai::colour {
namespace {

struct Service {
  explicit Service(const char *path) : config(open_config(path)) {}

  sozai_colour_1 table = {};
  const Config config;
  Processors processors{config};
};

Service &of(void *self) { return *static_cast<Service *>(self); }

// A missing argument is told before anything is tried.
void need(bool given, const char *text) {
  if (!given) throw Failure(SOZAI_ERROR_ARGUMENT, text);
}

extern "C" {

static const char *config_name(void *self) { return self ? of(self).config.name.c_str() : ""; }

static const char *working_space(void *self) { return self ? of(self).config.working.c_str() : ""; }

static int32_t has_space(void *self, const char *space) {
  bool known = false;
  guarded({}, [&] { known = self && space && of(self).config.ocio->getColorSpace(space); });
  return known;
}

static int32_t to_working(void *self, const char *space, float *rgb, uint64_t count, char *message,
                          size_t message_size) {
  return guarded({message, message_size}, [&] {
    need(self && space && (rgb || count == 0), "to_working: self, space or rgb is NULL");
    convert(*of(self).processors.to_working(space), any_finite, rgb, count);
  });
}

static int32_t from_working(void *self, const char *space, float *rgb, uint64_t count,
                            char *message, size_t message_size) {
  return guarded({message, message_size}, [&] {
    need(self && space && (rgb || count == 0), "from_working: self, space or rgb is NULL");
    convert(*of(self).processors.from_working(space), any_finite, rgb, count);
  });
}

static int32_t to_display(void *self, const char *display, const char *view, float *rgb,
                          uint64_t count, char *message, size_t message_size) {
  return guarded({message, message_size}, [&] {
    need(self && (rgb || count == 0), "to_display: self or rgb is NULL");
    convert(*of(self).processors.to_display(display, view), zero_to_one, rgb, count);
  });
}

static int32_t open_service(const char *config, const sozai_colour_1 **out, char *message,
                            size_t message_size) {
  if (out) *out = nullptr;
  return guarded({message, message_size}, [&] {
    need(out, "open: out is NULL");
    if (!sozai_colour_shipped_config())
      throw Failure(SOZAI_ERROR_STATE, "open: called before init or after the last deinit");
    auto service = std::make_unique<Service>(config);
    service->table.size = sizeof service->table;
    service->table.self = service.get();
    service->table.config_name = config_name;
    service->table.working_space = working_space;
    service->table.has_space = has_space;
    service->table.to_working = to_working;
    service->table.from_working = from_working;
    service->table.to_display = to_display;
    *out = &service.release()->table;
  });
}

static void close_service(const sozai_colour_1 *service) {
  if (service) delete static_cast<Service *>(service->self);
}

} // extern "C"
} // namespace
} // namespace sozai::colour

const sozai_colour_factory_1 sozai_colour_factory = {sozai::colour::open_service,
                                                     sozai::colour::close_service};
