// SPDX-License-Identifier: Apache-2.0
//
// sozai.imageio.so: what OpenImageIO loads to read .sozai files. Only what must
// be C++ is here; picture.h does the work.
//
// Reads hold no lock. OpenImageIO's own base class takes the reader's lock to
// look a spec up and to convert; so whatever its texture system calls is
// overridden: spec(), spec_dimensions(), read_tiles() and the native reads, all
// by subimage and level. Only seeking and opening change the reader.
//
// Written for OpenImageIO 2.4 to 3.1: the virtual functions that all of them
// have, with pointers for places in memory.
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <memory>
#include <new>
#include "picture.h"
#include "spec.h"

OIIO_NAMESPACE_USING

namespace {

struct Close {
  void operator()(picture *p) const { picture_close(p); }
};

class SozaiInput final : public ImageInput {
public:
  SozaiInput() = default;
  ~SozaiInput() override { close(); }
  const char *format_name() const override { return "sozai"; }
  int supports(string_view feature) const override {
    return feature == "procedural" || feature == "arbitrary_metadata";
  }
  bool valid_file(const std::string &name) const override;
  bool open(const std::string &name, ImageSpec &spec) override;
  using ImageInput::open;
  bool close() override;
  int current_subimage() const override { return subimage_; }
  int current_miplevel() const override { return level_; }
  bool seek_subimage(int subimage, int level) override;
  using ImageInput::spec;
  ImageSpec spec(int subimage, int level) override;
  ImageSpec spec_dimensions(int subimage, int level) override;

  bool read_native_scanline(int subimage, int level, int y, int z, void *data) override;
  bool read_native_tile(int subimage, int level, int x, int y, int z, void *data) override;
  bool read_native_tiles(int subimage, int level, int x0, int x1, int y0, int y1, int z0, int z1,
                         void *data) override;
  bool read_native_tiles(int subimage, int level, int x0, int x1, int y0, int y1, int z0, int z1,
                         int first, int end, void *data) override;
  using ImageInput::read_tiles;
  bool read_tiles(int subimage, int level, int x0, int x1, int y0, int y1, int z0, int z1,
                  int first, int end, TypeDesc format, void *data, stride_t xstride,
                  stride_t ystride, stride_t zstride) override;

private:
  std::unique_ptr<picture, Close> picture_;
  int subimage_ = 0, level_ = 0;

  bool known(int subimage, int level) const;
  bool read(int subimage, int level, const picture_box &box, const picture_place &to);
};

uint32_t whole(int number) { return number > 0 ? static_cast<uint32_t>(number) : 0; }

picture_box make_box(int x0, int x1, int y0, int y1, int z0, int z1) {
  return {{whole(x0), whole(y0), whole(z0)}, {whole(x1), whole(y1), whole(z1)}};
}

bool SozaiInput::known(int subimage, int level) const {
  if (!picture_ || subimage < 0 || level < 0) return false;
  const picture_about *about = picture_about_of(picture_.get());
  return whole(subimage) < about->subimage_count && whole(level) < about->shape.levels;
}

bool SozaiInput::valid_file(const std::string &name) const {
  failure why;
  picture *p = nullptr;
  bool ok = picture_open(&p, name.c_str(), &why);
  picture_close(p);
  return ok;
}

bool SozaiInput::open(const std::string &name, ImageSpec &newspec) {
  close();
  failure why;
  picture *p = nullptr;
  if (name.size() != std::char_traits<char>::length(name.c_str())) {
    errorfmt("a file's name with a zero in it");
    return false;
  }
  if (!picture_open(&p, name.c_str(), &why)) {
    errorfmt("{}", why.text);
    return false;
  }
  picture_.reset(p);
  m_spec = spec_make(p, 0, 0);
  newspec = m_spec;
  return true;
}

bool SozaiInput::close() {
  picture_.reset();
  m_spec = ImageSpec();
  subimage_ = level_ = 0;
  return true;
}

bool SozaiInput::seek_subimage(int subimage, int level) {
  lock_guard guard(*this);
  if (!known(subimage, level)) return false;
  if (subimage == subimage_ && level == level_) return true;
  m_spec = spec_make(picture_.get(), whole(subimage), whole(level));
  subimage_ = subimage;
  level_ = level;
  return true;
}

ImageSpec SozaiInput::spec(int subimage, int level) {
  if (!known(subimage, level)) return {};
  return spec_make(picture_.get(), whole(subimage), whole(level));
}

ImageSpec SozaiInput::spec_dimensions(int subimage, int level) {
  if (!known(subimage, level)) return {};
  return spec_make_dimensions(picture_.get(), whole(subimage), whole(level));
}

bool SozaiInput::read(int subimage, int level, const picture_box &box, const picture_place &to) {
  failure why;
  int most = threads();
  if (most == 0) OIIO::getattribute("threads", most);
  if (picture_read(picture_.get(), whole(subimage), whole(level), &box, &to, whole(most), &why))
    return true;
  errorfmt("{}", why.text);
  return false;
}

bool SozaiInput::read_tiles(int subimage, int level, int x0, int x1, int y0, int y1, int z0, int z1,
                            int first, int end, TypeDesc format, void *data, stride_t xstride,
                            stride_t ystride, stride_t zstride) {
  if (!known(subimage, level)) {
    errorfmt("no subimage {} with mip level {}", subimage, level);
    return false;
  }
  ImageSpec spec = spec_make_dimensions(picture_.get(), whole(subimage), whole(level));
  if (end < 0 || end > spec.nchannels) end = spec.nchannels;
  bool there = x0 >= 0 && x0 < x1 && x0 < spec.width && y0 >= 0 && y0 < y1 && y0 < spec.height &&
               z0 >= 0 && z0 < z1 && z0 < spec.depth;
  if (first < 0 || first >= end || !there || !spec.valid_tile_range(x0, x1, y0, y1, z0, z1)) {
    errorfmt("a rectangle that is not of whole tiles, or channels that there are not");
    return false;
  }
  int form = format == TypeDesc::UNKNOWN ? PICTURE_NATIVE
             : format == TypeDesc::HALF  ? PICTURE_HALF
                                         : PICTURE_FLOAT;
  if (form == PICTURE_NATIVE && xstride == AutoStride)
    xstride = stride_t(spec.pixel_bytes(first, end, true));
  spec.auto_stride(xstride, ystride, zstride, format, end - first, x1 - x0, y1 - y0);
  picture_place to = {data, form, whole(first), whole(end - first), {xstride, ystride, zstride}};
  picture_box box = make_box(x0, x1, y0, y1, z0, z1);
  if (form != PICTURE_FLOAT || format == TypeDesc::FLOAT) return read(subimage, level, box, to);

  // Any other type: through float, slice by slice in rows of tiles.
  try {
    stride_t texel = stride_t(end - first) * stride_t(sizeof(float)), row = texel * (x1 - x0);
    std::unique_ptr<char[]> floats(new char[size_t(row) * size_t(spec.tile_height)]);
    for (int z = z0; z < z1; z++)
      for (int y = y0; y < y1; y += spec.tile_height) {
        int rows = std::min(spec.tile_height, y1 - y);
        to.data = floats.get();
        to.stride[0] = texel;
        to.stride[1] = row;
        to.stride[2] = row * rows;
        if (!read(subimage, level, make_box(x0, x1, y, y + rows, z, z + 1), to)) return false;
        char *at = static_cast<char *>(data) + (z - z0) * zstride + (y - y0) * ystride;
        if (!convert_image(end - first, x1 - x0, rows, 1, floats.get(), TypeDesc::FLOAT, texel, row,
                           AutoStride, at, format, xstride, ystride, AutoStride)) {
          errorfmt("no texels of type {}", format.c_str());
          return false;
        }
      }
    return true;
  } catch (const std::bad_alloc &) {
    errorfmt("out of memory");
    return false;
  }
}

bool SozaiInput::read_native_tiles(int subimage, int level, int x0, int x1, int y0, int y1, int z0,
                                   int z1, int first, int end, void *data) {
  return read_tiles(subimage, level, x0, x1, y0, y1, z0, z1, first, end, TypeDesc::UNKNOWN, data,
                    AutoStride, AutoStride, AutoStride);
}

bool SozaiInput::read_native_tiles(int subimage, int level, int x0, int x1, int y0, int y1, int z0,
                                   int z1, void *data) {
  return read_native_tiles(subimage, level, x0, x1, y0, y1, z0, z1, 0, -1, data);
}

bool SozaiInput::read_native_tile(int subimage, int level, int x, int y, int z, void *data) {
  if (!known(subimage, level)) {
    errorfmt("no subimage {} with mip level {}", subimage, level);
    return false;
  }
  const uint32_t *tile = picture_about_of(picture_.get())->tile;
  return read_native_tiles(subimage, level, x, x + int(tile[0]), y, y + int(tile[1]), z,
                           z + int(tile[2]), data);
}

bool SozaiInput::read_native_scanline(int subimage, int level, int y, int z, void *data) {
  if (!known(subimage, level)) {
    errorfmt("no subimage {} with mip level {}", subimage, level);
    return false;
  }
  ImageSpec spec = spec_make_dimensions(picture_.get(), whole(subimage), whole(level));
  if (y < 0 || y >= spec.height || z < 0 || z >= spec.depth) {
    errorfmt("no row {} of slice {}: there are {} of {}", y, z, spec.height, spec.depth);
    return false;
  }
  stride_t texel = stride_t(spec.pixel_bytes(true));
  picture_place to = {data,
                      PICTURE_NATIVE,
                      0,
                      whole(spec.nchannels),
                      {texel, texel * spec.width, texel * spec.width}};
  return read(subimage, level, make_box(0, spec.width, y, y + 1, z, z + 1), to);
}

} // namespace

extern "C" {

OIIO_EXPORT extern const int sozai_imageio_version;
const int sozai_imageio_version = OIIO_PLUGIN_VERSION;

OIIO_EXPORT const char *sozai_imageio_library_version() { return "sozai"; }

OIIO_EXPORT ImageInput *sozai_input_imageio_create() {
  try {
    return new SozaiInput;
  } catch (...) {
    return nullptr;
  }
}

OIIO_EXPORT extern const char *sozai_input_extensions[];
const char *sozai_input_extensions[] = {"sozai", nullptr};
}
