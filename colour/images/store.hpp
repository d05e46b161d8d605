// SPDX-License-Identifier: Apache-2.0
//
// Where linearised pictures lie while they are not in the cache: one file without a
// name, in $TMPDIR or /tmp. It is gone when the process is, however it ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace sozai::images {

class Store {
public:
  Store() = default;
  ~Store();
  Store(const Store &) = delete;
  Store &operator=(const Store &) = delete;

  // Room for so many bytes; its offset. Throws Failure. [thread-safe]
  uint64_t take(uint64_t bytes);
  void give_back(uint64_t offset, uint64_t bytes) noexcept;

  void write(uint64_t offset, const void *data, size_t bytes); // throws Failure. [thread-safe]
  bool read(uint64_t offset, void *data, size_t bytes) const noexcept; // [thread-safe]

private:
  void open();
  uint64_t reserve(uint64_t bytes);

  std::mutex lock;
  int file = -1;
  std::string folder; // for messages
  uint64_t end = 0;
  std::map<uint64_t, uint64_t> free_room; // offset to bytes; never two that touch
};

// Room in a store, given back at the end.
class Room {
public:
  Room(Store &store, uint64_t bytes) : store(store), offset(store.take(bytes)), bytes(bytes) {}
  ~Room() { store.give_back(offset, bytes); }
  Room(const Room &) = delete;
  Room &operator=(const Room &) = delete;

  Store &store;
  const uint64_t offset, bytes;
};

} // namespace sozai::images
