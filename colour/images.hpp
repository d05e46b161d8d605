// SPDX-License-Identifier: Apache-2.0
//
// sozai-images.so, loaded when the first picture is opened (images/module.h).
#pragma once

#include "module.h"
#include "processors.hpp"

#include <atomic>
#include <mutex>

namespace sozai::colour {

class Images {
public:
  Images(const Config &config, Processors &processors, uint64_t memory)
      : config(config), processors(processors), bytes(memory) {}
  ~Images();
  Images(const Images &) = delete;
  Images &operator=(const Images &) = delete;

  // Throws Failure. [thread-safe]
  const sozai_images_1 &load();
  // NULL: not yet. [thread-safe]
  const sozai_images_1 *loaded() const { return ready.load(std::memory_order_acquire); }
  uint64_t memory() const { return bytes; }

  const Config &config;
  Processors &processors;

private:
  void open_library();

  const uint64_t bytes;
  std::mutex lock;
  void *library = nullptr;
  const sozai_images_module *module = nullptr;
  sozai_images_1 table = {};
  std::atomic<const sozai_images_1 *> ready{nullptr};
};

// What sozai-images.so converts with. self: an Images.
sozai_image_colours conversions(Images *self);

} // namespace sozai::colour
