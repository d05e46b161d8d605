// SPDX-License-Identifier: Apache-2.0
#include "library.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <sys/stat.h>

namespace sozai::images {

using colour::Failure;

constexpr int pixels_between_reports = 1 << 18; // some hundredths of a second

namespace {

// Tells the caller from time to time how far it is, and stops where it says so.
class Reporter {
public:
  Reporter(const sozai_image_request &request, const Layout &layout)
      : request(request), height(layout.height),
        band(std::max(1, pixels_between_reports / layout.width)) {}

  void row() {
    done++;
    if (!request.progress || (done % band != 0 && done < height)) return;
    if (request.progress(request.user, float(done) / float(height)) != 0)
      throw Failure(SOZAI_ERROR_CANCELLED, "cancelled: reading a picture");
  }

private:
  const sozai_image_request &request;
  const int height, band;
  int done = 0;
};

// Says who reads a picture, for as long as it does.
class Reading {
public:
  explicit Reading(std::atomic<std::thread::id> &reader) : reader(reader) {
    reader = std::this_thread::get_id();
  }
  ~Reading() { reader = std::thread::id(); }
  Reading(const Reading &) = delete;
  Reading &operator=(const Reading &) = delete;

private:
  std::atomic<std::thread::id> &reader;
};

} // namespace

static Shape read_into(Source &source, const Stored &stored, const sozai_image_request &request,
                       const sozai_image_colours &colours,
                       const sozai_image_conversion &conversion) {
  PyramidWriter pyramid(stored.shape, stored.room);
  Linear linear(source.layout(), request.channels, colours, conversion);
  Reporter reporter(request, source.layout());
  source.read([&](float *pixels) {
    pyramid.row(linear.row(pixels));
    reporter.row();
  });
  return stored.shape;
}

Picture::Picture(Store &store, Cache &cache, Source &source, const sozai_image_request &request,
                 const sozai_image_colours &colours, const sozai_image_conversion &conversion)
    : orientation(source.layout().orientation), cache(cache),
      stored(store, shape_of(source.layout().width, source.layout().height, int(request.channels))),
      slot((read_into(source, stored, request, colours, conversion), cache.add(stored))) {}

std::shared_ptr<const Picture> Library::read(Source &source, const sozai_image_request &request,
                                             const sozai_image_conversion &conversion) {
  return std::make_shared<const Picture>(store, cache, source, request, colours, conversion);
}

sozai_image_conversion Library::conversion_of(const char *space, const char *path) const {
  sozai_image_conversion conversion = {};
  if (!space && !path) return conversion; // a buffer that says nothing is data
  char message[512];
  const int32_t result =
      colours.find(colours.self, space, path, &conversion, message, sizeof message);
  if (result == SOZAI_OK) return conversion;
  throw Failure(result, (path ? "picture " + std::string(path) + ": " : std::string()) + message);
}

static int64_t nanoseconds(const timespec &time) {
  return int64_t(time.tv_sec) * 1000000000 + time.tv_nsec;
}

Library::Claim::Claim(Library &library, const Key &key) : library(library) {
  const std::lock_guard<std::mutex> guard(library.lock);
  // Those that nobody has open any more.
  auto &entries = library.entries;
  for (auto e = entries.begin(); e != entries.end();)
    e = e->second.claims == 0 && e->second.picture.expired() ? entries.erase(e) : std::next(e);
  claimed = &entries[key];
  claimed->claims++;
}

Library::Claim::~Claim() {
  const std::lock_guard<std::mutex> guard(library.lock);
  claimed->claims--;
}

std::shared_ptr<const Picture> Library::read_file(const char *path,
                                                  const sozai_image_request &request,
                                                  const sozai_image_conversion &conversion) {
  const auto source = file_source(
      path, {request.first_channel, request.channels, conversion.colour != 0}, request.most_pixels);
  return read(*source, request, conversion);
}

std::shared_ptr<const Picture> Library::share(Entry &entry, const char *path,
                                              const sozai_image_request &request,
                                              const sozai_image_conversion &conversion) {
  const std::lock_guard<std::mutex> guard(entry.reading);
  if (auto already = entry.picture.lock()) {
    must_be_allowed(std::string("picture ") + path, uint64_t(already->width()),
                    uint64_t(already->height()), request.most_pixels);
    return already;
  }
  const Reading mark(entry.reader);
  auto picture = read_file(path, request, conversion);
  entry.picture = picture;
  return picture;
}

std::shared_ptr<const Picture> Library::open_file(const char *path,
                                                  const sozai_image_request &request) {
  struct stat status;
  if (stat(path, &status) != 0)
    throw Failure(SOZAI_ERROR_FILE, std::string("picture ") + path + ": " + std::strerror(errno));
  const sozai_image_conversion conversion = conversion_of(request.colour_space, path);
  Claim claim(*this, {uint64_t(status.st_dev), uint64_t(status.st_ino), uint64_t(status.st_size),
                      nanoseconds(status.st_mtim), nanoseconds(status.st_ctim),
                      request.first_channel, request.channels, conversion.colour, conversion.how});
  Entry &entry = claim.entry();
  // From within the progress of this very picture it would wait for itself.
  if (entry.reader == std::this_thread::get_id()) return read_file(path, request, conversion);
  return share(entry, path, request, conversion);
}

std::shared_ptr<const Picture> Library::open(const sozai_image_request &request) {
  if (request.path) return open_file(request.path, request);
  const sozai_buffer &buffer = *request.buffer;
  const char *space = request.colour_space ? request.colour_space : buffer.colour_space;
  if (!buffer.data) {
    sozai_image_request file = request;
    file.colour_space = space;
    return open_file(buffer.path, file);
  }
  const sozai_image_conversion conversion = conversion_of(space, nullptr);
  const auto source =
      buffer_source(buffer, {request.first_channel, request.channels, conversion.colour != 0},
                    request.most_pixels);
  return read(*source, request, conversion);
}

} // namespace sozai::images
