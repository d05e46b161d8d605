// SPDX-License-Identifier: Apache-2.0
//
// sozai.services/1: the services of a config, opened and closed together.
#include "service.hpp"

#include "boundary.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

sozai_services::sozai_services(const sozai_services_options &options)
    : config(sozai::colour::open_config(options.config)), colour(sozai::colour::colour_table(this)),
      display(sozai::colour::display_table(this)), images(sozai::colour::images_table(this)),
      image_library(config, processors, options.image_memory) {}

sozai_services::~sozai_services() = default;

namespace sozai::colour {

void need(bool given, const char *text) {
  if (!given) throw Failure(SOZAI_ERROR_ARGUMENT, text);
}

namespace {
extern "C" {

static int32_t open_services(const sozai_services_options *options, sozai_services **out,
                             char *message, size_t message_size) {
  if (out) *out = nullptr;
  if (message && message_size) *message = '\0';
  return guarded({message, message_size}, [&] {
    need(out, "open: out is NULL");
    need(!options || options->size >= 8, "open: options.size is not set");
    if (!sozai_colour_shipped_config())
      throw Failure(SOZAI_ERROR_STATE, "open: called before init or after the last deinit");
    sozai_services_options whole = {};
    if (options) std::memcpy(&whole, options, std::min<size_t>(options->size, sizeof whole));
    *out = std::make_unique<sozai_services>(whole).release();
    write({message, message_size}, (*out)->config.warning.c_str());
  });
}

static const void *get_service(sozai_services *services, const char *id) {
  if (!services || !id) return nullptr;
  if (std::strcmp(id, SOZAI_COLOUR_1) == 0) return &services->colour;
  if (std::strcmp(id, SOZAI_DISPLAY_1) == 0) return &services->display;
  if (std::strcmp(id, SOZAI_IMAGES_1) == 0) return &services->images;
  return nullptr;
}

static void close_services(sozai_services *services) { delete services; }

} // extern "C"
} // namespace
} // namespace sozai::colour

const sozai_services_1 sozai_colour_services = {
    sozai::colour::open_services, sozai::colour::get_service, sozai::colour::close_services};
