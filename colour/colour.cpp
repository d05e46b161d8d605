// SPDX-License-Identifier: Apache-2.0
//
// sozai.colour/1: colours into the working space and back.
#include "boundary.hpp"
#include "pixels.hpp"
#include "service.hpp"

namespace sozai::colour {
namespace {

extern "C" {

static const char *config_name(void *self) { return self ? of(self).config.name.c_str() : ""; }

static const char *working_space(void *self) { return self ? of(self).config.working.c_str() : ""; }

static int32_t has_space(void *self, const char *space) {
  bool known = false;
  guarded({}, [&] { known = self && space && of(self).processors.knows(space); });
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

} // extern "C"
} // namespace

sozai_colour_1 colour_table(sozai_services *self) {
  sozai_colour_1 t = {};
  t.size = sizeof t;
  t.self = self;
  t.config_name = config_name;
  t.working_space = working_space;
  t.has_space = has_space;
  t.to_working = to_working;
  t.from_working = from_working;
  return t;
}

} // namespace sozai::colour
