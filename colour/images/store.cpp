// SPDX-License-Identifier: Apache-2.0
#include "store.hpp"

#include "boundary.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace sozai::images {

using colour::Failure;

// Nothing is wrong with the picture, which a FILE would say: what there is to keep it in is too
// small.
constexpr int32_t no_room = SOZAI_ERROR_MEMORY;
constexpr uint64_t page = 4096; // holes are punched in whole pages

static uint64_t whole_pages(uint64_t bytes) { return (bytes + page - 1) / page * page; }

static int nameless(const std::string &folder) {
  int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0) return file;
  // Not every file system has O_TMPFILE.
  std::string name = folder + "/sozai-XXXXXX";
  file = mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) unlink(name.c_str());
  return file;
}

void Store::open() {
  if (file >= 0) return;
  const char *wanted = std::getenv("TMPDIR");
  for (const char *place : {wanted, "/tmp"}) {
    if (!place || !*place) continue;
    folder = place;
    file = nameless(folder);
    if (file >= 0) return;
  }
  // Nowhere to write: memory then, which the system may still swap.
  folder = "memory";
  file = memfd_create("sozai-images", MFD_CLOEXEC);
  if (file < 0)
    throw Failure(no_room, std::string("no temporary file for pictures: ") + std::strerror(errno));
}

Store::~Store() {
  if (file >= 0) ::close(file);
}

uint64_t Store::reserve(uint64_t bytes) {
  for (auto room = free_room.begin(); room != free_room.end(); ++room) {
    if (room->second < bytes) continue;
    const auto [offset, size] = *room;
    if (size > bytes) free_room.emplace(offset + bytes, size - bytes);
    free_room.erase(room);
    return offset;
  }
  const uint64_t offset = end;
  end += bytes;
  return offset;
}

uint64_t Store::take(uint64_t bytes) {
  bytes = whole_pages(bytes);
  const std::lock_guard<std::mutex> guard(lock);
  open();
  const uint64_t offset = reserve(bytes);
  int error = 0;
  // Writing past this limit would be a signal, which kills.
  rlimit most = {};
  if (getrlimit(RLIMIT_FSIZE, &most) == 0 && most.rlim_cur != RLIM_INFINITY &&
      offset + bytes > most.rlim_cur)
    error = EFBIG;
  // A disk that is too full is told before the picture is read.
  else if (fallocate(file, 0, off_t(offset), off_t(bytes)) != 0 && errno != EOPNOTSUPP)
    error = errno;
  if (error == 0) return offset;
  try {
    free_room.emplace(offset, bytes);
  } catch (...) { // the room is lost until the store goes
  }
  throw Failure(no_room, "no room for " + std::to_string(bytes >> 20) + " MiB of pictures in " +
                             folder + ": " + std::strerror(error));
}

void Store::give_back(uint64_t offset, uint64_t bytes) noexcept {
  bytes = whole_pages(bytes);
  const std::lock_guard<std::mutex> guard(lock);
  // Where holes cannot be punched the room is still used again.
  (void)fallocate(file, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, off_t(offset), off_t(bytes));
  try {
    auto room = free_room.emplace(offset, bytes).first;
    const auto next = std::next(room);
    if (next != free_room.end() && room->first + room->second == next->first) {
      room->second += next->second;
      free_room.erase(next);
    }
    if (room != free_room.begin()) {
      const auto before = std::prev(room);
      if (before->first + before->second == room->first) {
        before->second += room->second;
        free_room.erase(room);
        room = before;
      }
    }
    if (room->first + room->second == end && ftruncate(file, off_t(room->first)) == 0) {
      end = room->first;
      free_room.erase(room);
    }
  } catch (...) { // the room is lost until the store goes
  }
}

void Store::write(uint64_t offset, const void *data, size_t bytes) {
  const char *from = static_cast<const char *>(data);
  while (bytes > 0) {
    const ssize_t done = pwrite(file, from, bytes, off_t(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0)
      throw Failure(no_room, "cannot write pictures to " + folder + ": " +
                                 std::strerror(done < 0 ? errno : ENOSPC));
    from += done;
    offset += uint64_t(done);
    bytes -= size_t(done);
  }
}

bool Store::read(uint64_t offset, void *data, size_t bytes) const noexcept {
  char *to = static_cast<char *>(data);
  while (bytes > 0) {
    const ssize_t done = pread(file, to, bytes, off_t(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    to += done;
    offset += uint64_t(done);
    bytes -= size_t(done);
  }
  return true;
}

} // namespace sozai::images
