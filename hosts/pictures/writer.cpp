// SPDX-License-Identifier: Apache-2.0
// Pictures band by band. OpenImageIO may throw, and so may the standard library;
// nothing gets past this file.
#include "writer.h"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <string>
#include <vector>

#include "guarded.hpp"
#include "oiio.hpp"

struct bake_writer {
  std::string path;
  std::unique_ptr<OIIO::ImageOutput> output;
  OIIO::ImageSpec spec; // of the level being written
  int level = 0;
  bool mixed = false; // layers of several types
};

namespace {

bool failed(const bake_writer &w, failure *why) {
  std::string message = w.output->geterror();
  return fail(why, EXIT_FAILURE, "cannot write %s: %s", w.path.c_str(),
              message.empty() ? "OpenImageIO does not say why" : message.c_str());
}

void describe(OIIO::ImageSpec &spec, const writer_spec &s) {
  oiio::add_writing(spec);
  spec.attribute("DateTime", ""); // else the clock's, and no two bakes would be the same
  oiio::add_colour(spec, s.colour);
  for (uint32_t i = 0; i < s.word_count; i++) spec.attribute(s.words[i].name, s.words[i].text);
  if (s.mm_per_pixel[0] > 0)
    spec.attribute("sozai_mm_per_pixel", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 2), s.mm_per_pixel);
  if (s.level_count > 1) spec.attribute("openexr:levelmode", 1); // MIPMAP_LEVELS
}

OIIO::ImageSpec spec_of(const writer_spec &s, bool *mixed) {
  const bake_layer *layers = s.file->layers;
  OIIO::ImageSpec spec(int(s.width), int(s.height), int(s.file->layer_count),
                       oiio::type_of(layers[0].type));
  *mixed = oiio::add_channels(spec, layers, s.file->layer_count);
  if (s.tile > 0) spec.tile_width = spec.tile_height = int(s.tile), spec.tile_depth = 1;
  // beyond what a 32-bit offset reaches, with room for what does not compress
  if (spec.image_bytes(true) > (uint64_t(3) << 30)) spec.attribute("tiff:bigtiff", 1);
  describe(spec, s);
  return spec;
}

bool open(bake_writer &w, const char *path, const writer_spec &s, failure *why) {
  w.path = path;
  w.output = OIIO::ImageOutput::create(path);
  if (!w.output)
    return fail(why, EXIT_FAILURE, "cannot write %s: %s", path, OIIO::geterror().c_str());
  w.spec = spec_of(s, &w.mixed);
  return w.output->open(path, w.spec) || failed(w, why);
}

bool next_level(bake_writer &w, uint32_t width, uint32_t height, failure *why) {
  w.level++;
  w.spec.width = w.spec.full_width = int(width);
  w.spec.height = w.spec.full_height = int(height);
  return w.output->open(w.path, w.spec, OIIO::ImageOutput::AppendMIPLevel) || failed(w, why);
}

bool rows(bake_writer &w, uint32_t row, uint32_t count, const uint8_t *pixels, failure *why) {
  // the file's own types, layer after layer, is what an unknown type means
  OIIO::TypeDesc type = w.mixed ? OIIO::TypeDesc(OIIO::TypeDesc::UNKNOWN) : w.spec.format;
  int y = int(row), end = int(row + count);
  bool ok = w.spec.tile_width > 0
                ? w.output->write_tiles(0, w.spec.width, y, end, 0, 1, type, pixels)
                : w.output->write_scanlines(y, end, 0, type, pixels);
  return ok || failed(w, why);
}

bool unreadable(const bake_writer &w, const std::string &message, failure *why) {
  return fail(why, EXIT_FAILURE, "cannot write %s: it does not read back: %s", w.path.c_str(),
              message.c_str());
}

bool read_back(const bake_writer &w, failure *why) {
  auto input = OIIO::ImageInput::open(w.path);
  if (!input) return unreadable(w, OIIO::geterror(), why);
  if (!input->seek_subimage(0, w.level)) return unreadable(w, input->geterror(), why);
  const OIIO::ImageSpec spec = input->spec_dimensions(0, w.level);
  int tile = spec.tile_height;
  int y = tile > 0 ? (spec.height - 1) / tile * tile : spec.height - 1;
  int x = tile > 0 ? (spec.width - 1) / spec.tile_width * spec.tile_width : 0;
  size_t texels = tile > 0 ? size_t(spec.tile_pixels()) : size_t(spec.width);
  std::vector<float> pixels(texels * size_t(spec.nchannels));
  bool ok = tile > 0 ? input->read_tiles(0, w.level, x, spec.width, y, spec.height, 0, 1, 0,
                                         spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())
                     : input->read_scanlines(0, w.level, y, y + 1, 0, 0, spec.nchannels,
                                             OIIO::TypeDesc::FLOAT, pixels.data());
  return ok || unreadable(w, input->geterror(), why);
}

bool close(bake_writer &w, failure *why) {
  if (!w.output->close()) return failed(w, why);
  w.output.reset(); // which alone ends a file of mipmaps
  return read_back(w, why);
}

} // namespace

bake_writer *writer_open(const char *path, const writer_spec *spec, failure *why) {
  bake_writer *w = nullptr;
  bool ok = guarded(why, [&] {
    w = new bake_writer;
    return open(*w, path, *spec, why);
  });
  if (ok) return w;
  writer_drop(w);
  return nullptr;
}

bool writer_next_level(bake_writer *w, uint32_t width, uint32_t height, failure *why) {
  return guarded(why, [&] { return next_level(*w, width, height, why); });
}

bool writer_rows(bake_writer *w, uint32_t row, uint32_t count, const uint8_t *pixels,
                 failure *why) {
  return guarded(why, [&] { return rows(*w, row, count, pixels, why); });
}

bool writer_close(bake_writer *w, failure *why) {
  bool ok = guarded(why, [&] { return close(*w, why); });
  writer_drop(w);
  return ok;
}

void writer_drop(bake_writer *w) {
  failure ignored;
  guarded(&ignored, [&] {
    if (w && w->output) w->output->close();
    delete w;
    return true;
  });
}
