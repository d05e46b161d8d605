// SPDX-License-Identifier: Apache-2.0
//
// The pictures that are open, each once, however many textures use it.
#pragma once

#include "boundary.hpp"
#include "cache.hpp"
#include "linear.hpp"
#include "pyramid.hpp"

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <tuple>

namespace sozai::images {

// A picture in the store and in the cache.
class Picture {
public:
  Picture(Store &store, Cache &cache, Source &source, const sozai_image_request &request,
          const sozai_image_colours &colours, const sozai_image_conversion &conversion);
  ~Picture() { cache.remove(slot); }
  Picture(const Picture &) = delete;
  Picture &operator=(const Picture &) = delete;

  int width() const { return stored.shape.levels[0].width; } // as it lies in the file
  int height() const { return stored.shape.levels[0].height; }
  uint32_t channels() const { return uint32_t(stored.shape.channels); }

  const int orientation;
  Cache &cache;

private:
  Stored stored;

public:
  const Cache::Slot slot; // after what it is made of
};

class Library {
public:
  Library(const sozai_image_colours &colours, uint64_t memory) : colours(colours), cache(memory) {}

  // All throw Failure. [thread-safe]
  std::shared_ptr<const Picture> open(const sozai_image_request &request);
  const Cache &used_cache() const { return cache; }

private:
  // What makes two requests one: the file as it is now, and what is made of it.
  using Key = std::tuple<uint64_t, uint64_t, uint64_t, int64_t, int64_t, uint32_t, uint32_t,
                         int32_t, const void *>;
  // One that is being opened or has been; `reading` is held while it is read.
  struct Entry {
    std::mutex reading;
    std::atomic<std::thread::id> reader{}; // whose it is
    std::weak_ptr<const Picture> picture;
    unsigned claims = 0; // by those who open it just now
  };
  // The entry of a key, which stays while this lives.
  class Claim {
  public:
    Claim(Library &library, const Key &key);
    ~Claim();
    Claim(const Claim &) = delete;
    Claim &operator=(const Claim &) = delete;
    Entry &entry() { return *claimed; }

  private:
    Library &library;
    Entry *claimed;
  };

  std::shared_ptr<const Picture> open_file(const char *path, const sozai_image_request &request);
  std::shared_ptr<const Picture> share(Entry &entry, const char *path,
                                       const sozai_image_request &request,
                                       const sozai_image_conversion &conversion);
  std::shared_ptr<const Picture> read_file(const char *path, const sozai_image_request &request,
                                           const sozai_image_conversion &conversion);
  std::shared_ptr<const Picture> read(Source &source, const sozai_image_request &request,
                                      const sozai_image_conversion &conversion);
  sozai_image_conversion conversion_of(const char *space, const char *path) const;

  const sozai_image_colours colours;
  Store store;
  Cache cache; // after the store it reads from
  std::mutex lock;
  std::map<Key, Entry> entries;
};

} // namespace sozai::images
