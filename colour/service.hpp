// SPDX-License-Identifier: Apache-2.0
//
// The services of one config, and what each of their tables needs.
#pragma once

#include "internal.h"
#include "images.hpp"
#include "lists.hpp"
#include "processors.hpp"

#include <stdexcept>

// The handle of sozai_colour.h. Every table's `self` is this.
struct sozai_services {
  explicit sozai_services(const sozai_services_options &options);
  ~sozai_services();
  sozai_services(const sozai_services &) = delete;
  sozai_services &operator=(const sozai_services &) = delete;

  const sozai::colour::Config config;
  sozai::colour::Processors processors{config};
  const sozai::colour::Lists lists{*config.ocio};
  sozai_colour_1 colour;
  sozai_display_1 display;
  sozai_images_1 images;
  sozai::colour::Images image_library; // last: it uses the others
};

namespace sozai::colour {

inline sozai_services &of(void *self) { return *static_cast<sozai_services *>(self); }

// A missing argument is told before anything is tried.
void need(bool given, const char *text);

sozai_colour_1 colour_table(sozai_services *self);
sozai_display_1 display_table(sozai_services *self);
sozai_images_1 images_table(sozai_services *self);

} // namespace sozai::colour
