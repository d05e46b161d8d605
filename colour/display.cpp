// SPDX-License-Identifier: Apache-2.0
//
// sozai.display/1: what the config offers, and what a display shows.
#include "boundary.hpp"
#include "chromaticities.hpp"
#include "pixels.hpp"
#include "service.hpp"

namespace sozai::colour {
namespace {

extern "C" {

// Both look a list up, which may run out of memory for the display's name.
static uint32_t count(void *self, uint32_t list, const char *display) {
  uint32_t found = 0;
  guarded({}, [&] {
    const auto *items = self ? of(self).lists.find(list, display) : nullptr;
    if (items) found = static_cast<uint32_t>(items->size());
  });
  return found;
}

static int32_t item(void *self, uint32_t list, const char *display, uint32_t index,
                    const char **out_name, const char **out_detail) {
  if (out_name) *out_name = nullptr;
  if (out_detail) *out_detail = nullptr;
  return guarded({}, [&] {
    const auto *items = self ? of(self).lists.find(list, display) : nullptr;
    if (!items || index >= items->size()) throw Failure(SOZAI_ERROR_UNKNOWN, "no such item");
    const Item &found = (*items)[index];
    if (out_name) *out_name = found.name.c_str();
    if (out_detail) *out_detail = found.detail.c_str();
  });
}

static int32_t to_display(void *self, const char *display, const char *view, const char *look,
                          float *rgb, uint64_t count, char *message, size_t message_size) {
  return guarded({message, message_size}, [&] {
    need(self && (rgb || count == 0), "to_display: self or rgb is NULL");
    convert(*of(self).processors.to_display(display, view, look), zero_to_one, rgb, count);
  });
}

static int32_t chromaticities(void *self, const char *space, float *out_xy, char *message,
                              size_t message_size) {
  return guarded({message, message_size}, [&] {
    need(self && out_xy, "chromaticities: self or out_xy is NULL");
    find_chromaticities(of(self).config, of(self).processors, space, out_xy);
  });
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
