// SPDX-License-Identifier: Apache-2.0
//
// OpenImageIO's tile cache and texture system, of our own and not the process's
// shared ones, whose settings are the host's.
#pragma once

#include "stored_input.hpp"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>

#include <mutex>
#include <vector>

namespace sozai::images {

class Cache {
public:
  using Handle = OIIO::TextureSystem::TextureHandle;

  explicit Cache(uint64_t memory); // bytes; throws Failure
  ~Cache();
  Cache(const Cache &) = delete;
  Cache &operator=(const Cache &) = delete;

  // A stored picture's place in the cache. [thread-safe]
  struct Slot {
    size_t number;
    Handle *handle;
  };
  Slot add(const Stored &stored); // throws Failure
  // Nobody may be looking it up.
  void remove(const Slot &slot) noexcept;

  uint64_t used() const;
  uint64_t limit() const { return most; }
  OIIO::TextureSystem &textures() { return *system; }

private:
  // pointers, or in later versions shared ones
  using CachePointer = decltype(OIIO::ImageCache::create(false));
  using SystemPointer = decltype(OIIO::TextureSystem::create(false));

  CachePointer cache{};
  SystemPointer system{};
  uint64_t most = 0;

  // OpenImageIO forgets no name, so names are used again.
  std::mutex lock;
  std::vector<size_t> free_numbers;
  size_t numbers = 0;
};

} // namespace sozai::images
