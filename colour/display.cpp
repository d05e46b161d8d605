// SPDX-License-Identifier: Apache-2.0
//
// sozai.display/1: what the config offers, and what a display shows.
#include "boundary.hpp"
#include "pixels.hpp"
#include "service.hpp"

namespace sozai::colour {
namespace {

extern "C" {

static uint32_t count(void *, uint32_t, const char *) { return 0; }

static int32_t item(void *, uint32_t, const char *, uint32_t, const char **, const char **) {
  return SOZAI_ERROR_UNKNOWN;
}

static int32_t to_display(void *self, const char *display, const char *view, const char *look,
                          float *rgb, uint64_t count, char *message, size_t message_size) {
  (void)look;
  return guarded({message, message_size}, [&] {
    need(self && (rgb || count == 0), "to_display: self or rgb is NULL");
    convert(*of(self).processors.to_display(display, view), zero_to_one, rgb, count);
  });
}

static int32_t chromaticities(void *, const char *, float *, char *, size_t) {
  return SOZAI_ERROR_COLOUR;
}

} // extern "C"
} // namespace

sozai_display_1 display_table(sozai_services *self) {
  sozai_display_1 t = {};
  t.size = sizeof t;
  t.self = self;
  t.count = count;
  t.item = item;
  t.to_display = to_display;
  t.chromaticities = chromaticities;
  return t;
}

} // namespace sozai::colour
