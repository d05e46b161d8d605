// SPDX-License-Identifier: Apache-2.0
#include "cache.hpp"

#include "boundary.hpp"

#include <algorithm>
#include <string>

namespace sozai::images {

using colour::Failure;

constexpr uint64_t default_memory = uint64_t(1) << 30;
constexpr uint64_t least_memory = uint64_t(10) << 20; // OpenImageIO raises anything below

static OIIO::ustring name_of(size_t number) {
  return OIIO::ustring("sozai picture " + std::to_string(number));
}

Cache::Cache(uint64_t memory) : most(std::max(memory ? memory : default_memory, least_memory)) {
  cache = OIIO::ImageCache::create(false);
  if (!cache) throw Failure(SOZAI_ERROR_MEMORY, "no image cache: " + OIIO::geterror());
  system = OIIO::TextureSystem::create(false, cache);
  if (!system) {
    OIIO::ImageCache::destroy(cache);
    throw Failure(SOZAI_ERROR_MEMORY, "no texture system: " + OIIO::geterror());
  }
  cache->attribute("max_memory_MB", float(double(most) / (1 << 20)));
  // Whatever $OPENIMAGEIO_IMAGECACHE_OPTIONS and the like say: these change answers.
  cache->attribute("substitute_image", "");
  cache->attribute("max_mip_res", 1 << 30);
  system->attribute("flip_t", 0);
  system->attribute("gray_to_rgb", 0);
  system->attribute("stochastic", 0);
  system->attribute("max_tile_channels", 6);
}

Cache::~Cache() {
  (void)system->geterror();
  (void)cache->geterror();
  OIIO::TextureSystem::destroy(system);
  OIIO::ImageCache::destroy(cache);
}

Cache::Slot Cache::add(const Stored &stored) {
  const std::lock_guard<std::mutex> guard(lock);
  const bool again = !free_numbers.empty();
  const size_t number = again ? free_numbers.back() : numbers;
  if (!again) free_numbers.reserve(numbers + 1); // so that remove cannot fail
  const OIIO::ImageSpec config = input_config(stored);
  const OIIO::ustring name = name_of(number);
  if (!cache->add_file(name, make_input, &config, true))
    throw Failure(SOZAI_ERROR_FILE, "the image cache refused a picture: " + cache->geterror());
  Handle *handle = system->get_texture_handle(name);
  if (!handle || !system->good(handle)) {
    cache->invalidate(name, true);
    throw Failure(SOZAI_ERROR_FILE, "the image cache lost a picture: " + system->geterror());
  }
  if (again)
    free_numbers.pop_back();
  else
    numbers++;
  return {number, handle};
}

void Cache::remove(const Slot &slot) noexcept {
  try {
    const std::lock_guard<std::mutex> guard(lock);
    cache->invalidate(name_of(slot.number), true);
    free_numbers.push_back(slot.number);
  } catch (...) { // the name is not used again
  }
}

uint64_t Cache::used() const {
  long long bytes = 0;
  cache->getattribute("stat:cache_memory_used", OIIO::TypeDesc::INT64, &bytes);
  return bytes > 0 ? uint64_t(bytes) : 0;
}

} // namespace sozai::images
