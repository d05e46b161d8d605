// SPDX-License-Identifier: Apache-2.0
// Whole pictures. OpenImageIO may throw, and so may the standard library; nothing
// gets past this file.
#include "image.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include "guarded.hpp"
#include "oiio.hpp"

namespace {

// Encoded in memory, then written here: OpenImageIO's writers of PNG and of EXR
// do not say when the disk is full.
bool put(const char *path, const std::vector<unsigned char> &bytes, failure *why) {
  std::unique_ptr<FILE, int (*)(FILE *)> file(std::fopen(path, "wbe"), std::fclose);
  bool ok = file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  int error = errno;
  if (file && std::fclose(file.release()) != 0) {
    if (ok) error = errno;
    ok = false;
  }
  return ok || fail(why, EXIT_FAILURE, "cannot write %s: %s", path, std::strerror(error));
}

bool write(const char *path, uint32_t width, uint32_t height, const image_channel *channels,
           size_t count, const image_colour *colour, failure *why) {
  auto output = OIIO::ImageOutput::create(path);
  if (!output)
    return fail(why, EXIT_FAILURE, "cannot write %s: %s", path, OIIO::geterror().c_str());
  OIIO::ImageSpec spec(int(width), int(height), int(count), oiio::type_of(channels[0].type));
  oiio::add_channels(spec, channels, count);
  oiio::add_writing(spec);
  if (colour) oiio::add_colour(spec, *colour);
  // 6, the writer's own, takes 2.5 times as long for pictures of materials, for 5 % of their size
  spec.attribute("png:compressionLevel", 4);

  size_t pixels = size_t(width) * height;
  std::vector<float> interleaved(pixels * count);
  for (size_t c = 0; c < count; c++)
    for (size_t i = 0; i < pixels; i++)
      interleaved[i * count + c] = channels[c].data[i * channels[c].stride];

  std::vector<unsigned char> encoded;
  OIIO::Filesystem::IOVecOutput memory(encoded);
  const bool through = output->supports("ioproxy") && output->set_ioproxy(&memory);
  bool ok =
      output->open(path, spec) && output->write_image(OIIO::TypeDesc::FLOAT, interleaved.data());
  ok = output->close() && ok;
  if (ok && through) return put(path, encoded, why);
  return ok || fail(why, EXIT_FAILURE, "cannot write %s: %s", path, output->geterror().c_str());
}

std::unique_ptr<OIIO::ImageInput> open(const char *path, failure *why) {
  struct stat status;
  /* of a pipe that nobody writes to OpenImageIO would wait for ever */
  if (stat(path, &status) == 0 && !S_ISREG(status.st_mode)) {
    fail(why, EXIT_BAD_INPUT, "cannot read %s: not a file", path);
    return nullptr;
  }
  auto input = OIIO::ImageInput::open(path);
  if (!input) {
    fail(why, EXIT_BAD_INPUT, "cannot read %s: %s", path, OIIO::geterror().c_str());
    return input;
  }
  const OIIO::ImageSpec &spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep) {
    fail(why, EXIT_BAD_INPUT, "cannot read %s: not a flat picture", path);
    input.reset();
  }
  return input;
}

bool probe(const char *path, uint32_t *width, uint32_t *height, uint32_t *channels, bool *integers,
           failure *why) {
  auto input = open(path, why);
  if (!input) return false;
  const OIIO::ImageSpec &spec = input->spec();
  *width = uint32_t(spec.width);
  *height = uint32_t(spec.height);
  *channels = uint32_t(spec.nchannels);
  *integers = !spec.format.is_floating_point();
  return true;
}

bool read(image *picture, const char *path, failure *why) {
  auto input = open(path, why);
  if (!input) return false;
  const OIIO::ImageSpec spec = input->spec();
  size_t count = size_t(spec.nchannels);
  picture->width = uint32_t(spec.width);
  picture->height = uint32_t(spec.height);
  picture->names = static_cast<char **>(std::calloc(count, sizeof(char *)));
  picture->data =
      static_cast<float *>(std::malloc(sizeof(float) * count * picture->width * picture->height));
  if (!picture->names || !picture->data) return fail(why, EXIT_FAILURE, "out of memory");
  for (picture->channels = 0; picture->channels < count; picture->channels++) {
    char *name = strdup(spec.channelnames[picture->channels].c_str());
    if (!name) return fail(why, EXIT_FAILURE, "out of memory");
    picture->names[picture->channels] = name;
  }
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture->data))
    return fail(why, EXIT_BAD_INPUT, "cannot read %s: %s", path, input->geterror().c_str());
  // a JPEG file cut short is filled up with grey, and only a warning says so
  if (input->has_error())
    return fail(why, EXIT_BAD_INPUT, "cannot read %s: %s", path, input->geterror().c_str());
  return true;
}

} // namespace

bool image_write(const char *path, uint32_t width, uint32_t height, const image_channel *channels,
                 size_t count, const image_colour *colour, failure *why) {
  return guarded(why, [&] { return write(path, width, height, channels, count, colour, why); });
}

bool image_read(image *picture, const char *path, failure *why) {
  std::memset(picture, 0, sizeof *picture);
  bool ok = guarded(why, [&] { return read(picture, path, why); });
  if (!ok) image_free(picture);
  return ok;
}

bool image_probe(const char *path, uint32_t *width, uint32_t *height, uint32_t *channels,
                 bool *integers, failure *why) {
  return guarded(why, [&] { return probe(path, width, height, channels, integers, why); });
}

namespace {

// OpenImageIO looks for fonts of other names than Debian's.
const char *font() {
  static const char *const paths[] = {
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
      "/usr/share/fonts/TTF/DejaVuSans.ttf",
      "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
      "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf"};
  for (const char *path : paths)
    if (access(path, R_OK) == 0) return path;
  return nullptr;
}

bool fits(const std::string &text, int size, int room) {
  return OIIO::ImageBufAlgo::text_size(text, size, font()).width() <= room;
}

/* As much of a text as fits: up to a comma, or to a word with dots after it, or as many letters. */
std::string fitting(const std::string &text, int size, int room) {
  if (fits(text, size, room)) return text;
  for (size_t at = text.rfind(','); at != std::string::npos && at; at = text.rfind(',', at - 1))
    if (fits(text.substr(0, at), size, room)) return text.substr(0, at);
  for (size_t at = text.rfind(' '); at != std::string::npos && at; at = text.rfind(' ', at - 1))
    if (fits(text.substr(0, at) + "...", size, room)) return text.substr(0, at) + "...";
  std::string letters = text;
  while (!letters.empty() && !fits(letters, size, room)) do
      letters.pop_back();
    while (!letters.empty() && (letters.back() & 0xC0) == 0x80); // the whole of an UTF-8 letter
  return letters;
}

} // namespace

bool image_has_text() {
  bool has = false;
  failure unused;
  guarded(&unused, [&] {
    has = font() && OIIO::ImageBufAlgo::text_size("x", 16, font()).defined();
    return true;
  });
  return has;
}

void image_text(float *rgb, uint32_t width, uint32_t height, uint32_t x, uint32_t y, uint32_t end,
                uint32_t size, const char *text) {
  failure unused;
  guarded(&unused, [&] {
    if (!font()) return false;
    OIIO::ImageBuf picture(OIIO::ImageSpec(int(width), int(height), 3, OIIO::TypeDesc::FLOAT), rgb);
    const std::string shown = fitting(text, int(size), int(end) - int(x));
    const float dark[3] = {0.05f, 0.05f, 0.05f};
    return OIIO::ImageBufAlgo::render_text(picture, int(x), int(y), shown, int(size), font(), dark);
  });
}

void image_free(image *picture) {
  for (uint32_t c = 0; c < picture->channels; c++) std::free(picture->names[c]);
  std::free(picture->names);
  std::free(picture->data);
  std::memset(picture, 0, sizeof *picture);
}
