// SPDX-License-Identifier: Apache-2.0
//
// It has tiles and levels of its own, so that the cache makes none: OpenImageIO's
// "automip" raises the memory limit to twice the largest picture, and reads a
// picture of rows from its beginning for a tile of its end.
#include "stored_input.hpp"

namespace sozai::images {

namespace {

constexpr const char *key = "sozai:stored"; // of the config, a pointer

class StoredInput final : public OIIO::ImageInput {
public:
  const char *format_name() const override { return "sozai"; }

  bool open(const std::string &, OIIO::ImageSpec &) override { return false; }

  bool open(const std::string &, OIIO::ImageSpec &out, const OIIO::ImageSpec &config) override {
    const OIIO::ParamValue *found = config.find_attribute(key, OIIO::TypeDesc::PTR);
    if (!found) return false;
    stored = *static_cast<const Stored *const *>(found->data());
    level = 0;
    m_spec = spec_of(0);
    out = m_spec;
    return true;
  }

  bool close() override {
    stored = nullptr;
    return true;
  }

  int current_subimage() const override { return 0; }
  int current_miplevel() const override { return level; }

  bool seek_subimage(int subimage, int miplevel) override {
    if (!exists(subimage, miplevel)) return false;
    level = miplevel;
    m_spec = spec_of(miplevel);
    return true;
  }

  OIIO::ImageSpec spec(int subimage, int miplevel) override { return any_spec(subimage, miplevel); }
  OIIO::ImageSpec spec_dimensions(int subimage, int miplevel) override {
    return any_spec(subimage, miplevel);
  }

  bool read_native_scanline(int, int, int, int, void *) override { return false; }

  bool read_native_tile(int subimage, int miplevel, int x, int y, int, void *data) override {
    if (!exists(subimage, miplevel)) return false;
    const Shape &shape = stored->shape;
    const Level &at = shape.levels[size_t(miplevel)];
    const uint64_t tile = at.first_tile +
                          uint64_t(y / shape.tile_height) * uint64_t(at.tiles_across) +
                          uint64_t(x / shape.tile_width);
    const size_t bytes = shape.tile_floats() * sizeof(float);
    return stored->room.store.read(stored->room.offset + tile * bytes, data, bytes);
  }

private:
  bool exists(int subimage, int miplevel) const {
    return stored && subimage == 0 && miplevel >= 0 &&
           size_t(miplevel) < stored->shape.levels.size();
  }

  OIIO::ImageSpec spec_of(int miplevel) const {
    const Level &at = stored->shape.levels[size_t(miplevel)];
    OIIO::ImageSpec spec(at.width, at.height, stored->shape.channels, OIIO::TypeDesc::FLOAT);
    spec.tile_width = stored->shape.tile_width;
    spec.tile_height = stored->shape.tile_height;
    spec.tile_depth = 1;
    return spec;
  }

  OIIO::ImageSpec any_spec(int subimage, int miplevel) const {
    return exists(subimage, miplevel) ? spec_of(miplevel) : OIIO::ImageSpec();
  }

  const Stored *stored = nullptr;
  int level = 0;
};

} // namespace

OIIO::ImageSpec input_config(const Stored &stored) {
  OIIO::ImageSpec config;
  const Stored *pointer = &stored;
  config.attribute(key, OIIO::TypeDesc::PTR, &pointer);
  return config;
}

OIIO::ImageInput *make_input() { return new StoredInput; }

} // namespace sozai::images
