// SPDX-License-Identifier: Apache-2.0
#include "spec.h"

#include <string>

using OIIO::ImageSpec;
using OIIO::TypeDesc;

namespace {

// From object space, mm, to the volume's 0 to 1: texture3d then takes places in
// object space.
void add_matrix(ImageSpec &spec, const double *size) {
  float m[16] = {0};
  for (int c = 0; c < 3; c++) {
    m[5 * c] = static_cast<float>(1 / size[c]);
    m[12 + c] = 0.5f;
  }
  m[15] = 1;
  spec.attribute("worldtolocal", TypeDesc(TypeDesc::FLOAT, TypeDesc::MATRIX44), m);
}

// Pixels per cm, as other formats say it.
void add_scale(ImageSpec &spec, const picture_about *about, const uint32_t *pixels) {
  const double *size = about->shape.size;
  if (size[0] <= 0) return; // a mesh's texels are of many sizes
  float mm[2];
  for (int c = 0; c < 2; c++) mm[c] = static_cast<float>(size[c] / pixels[c]);
  spec.attribute("XResolution", 10 / mm[0]);
  spec.attribute("YResolution", 10 / mm[1]);
  spec.attribute("ResolutionUnit", "cm");
  spec.attribute("PixelAspectRatio", mm[0] / mm[1]);
  spec.attribute("sozai_mm_per_pixel", TypeDesc(TypeDesc::FLOAT, 2), mm);
}

void add_metadata(ImageSpec &spec, const picture_about *about, const subimage *s) {
  bool volume = about->shape.kind == SURFACE_VOLUME;
  std::string wrap = about->wrap;
  bool colour = false, encoded = false;
  for (uint32_t i = 0; i < s->output_count; i++) {
    colour = colour || s->outputs[i].colour;
    encoded = encoded || s->outputs[i].encoded;
  }
  if (s->output_count == 1) spec.attribute("oiio:subimagename", s->outputs[0].id);
  spec.attribute("oiio:ColorSpace", colour ? "scene_linear" : "data");
  spec.attribute("wrapmodes", wrap + "," + wrap);
  spec.attribute("textureformat", volume ? "Volume Texture" : "Plain Texture");
  spec.attribute("sozai_material", about->material);
  if (*about->preset) spec.attribute("sozai_preset", about->preset);
  if (colour && *about->working) spec.attribute("sozai_ColorSpace", about->working);
  if (about->shape.udim) spec.attribute("sozai_udim", about->shape.udim);
  if (about->shape.samples > 1) spec.attribute("sozai_samples", int(about->shape.samples));
  if (encoded) spec.attribute("sozai_normals", "tangent");
}

} // namespace

ImageSpec spec_make_dimensions(const picture *p, uint32_t subimage, uint32_t level) {
  const picture_about *about = picture_about_of(p);
  const struct subimage *s = &about->subimages[subimage];
  uint32_t pixels[3];
  picture_level(p, level, pixels);
  ImageSpec spec;
  spec.full_width = spec.width = static_cast<int>(pixels[0]);
  spec.full_height = spec.height = static_cast<int>(pixels[1]);
  spec.full_depth = spec.depth = static_cast<int>(pixels[2]);
  spec.tile_width = static_cast<int>(about->tile[0]);
  spec.tile_height = static_cast<int>(about->tile[1]);
  spec.tile_depth = static_cast<int>(about->tile[2]);
  spec.nchannels = static_cast<int>(s->components);
  // of several types the widest, as everywhere in OpenImageIO
  spec.format = s->half ? TypeDesc::HALF : TypeDesc::FLOAT;
  for (uint32_t i = 0; s->mixed && i < s->output_count; i++)
    spec.channelformats.insert(spec.channelformats.end(), s->outputs[i].components,
                               s->outputs[i].half ? TypeDesc::HALF : TypeDesc::FLOAT);
  return spec;
}

ImageSpec spec_make(const picture *p, uint32_t subimage, uint32_t level) {
  const picture_about *about = picture_about_of(p);
  const struct subimage *s = &about->subimages[subimage];
  ImageSpec spec = spec_make_dimensions(p, subimage, level);
  for (uint32_t i = 0; i < s->output_count; i++)
    for (uint32_t k = 0; k < s->outputs[i].components; k++)
      spec.channelnames.push_back(s->outputs[i].names[k]);
  add_metadata(spec, about, s);
  uint32_t pixels[3];
  picture_level(p, level, pixels);
  add_scale(spec, about, pixels);
  if (about->shape.kind == SURFACE_VOLUME) add_matrix(spec, about->shape.size);
  return spec;
}
