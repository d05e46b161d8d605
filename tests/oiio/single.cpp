// SPDX-License-Identifier: Apache-2.0
// subimages: single: all outputs as the channels of one subimage, the same bits
// as in subimages of their own and as the material's own answers, in any range
// of channels, of every type; named and ordered as EXR files are read.
#include <Imath/half.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

const float up[3] = {0, 0, 1};

// "normal.x" is of normal; R, G and B are of the albedo.
std::string output_of(const std::string &channel) {
  return channel.size() == 1 ? "albedo" : channel.substr(0, channel.find('.'));
}

struct Pixels {
  ImageSpec spec;
  std::vector<float> data;
  float at(size_t texel, int channel) const {
    return data[texel * size_t(spec.nchannels) + size_t(channel)];
  }
};

// Tile by tile, since a level need not be of whole ones.
Pixels read(ImageInput *in, int subimage, int level) {
  Pixels p = {in->spec(subimage, level), {}};
  p.data.resize(size_t(p.spec.image_pixels()) * size_t(p.spec.nchannels));
  assert_true(in->read_image(subimage, level, 0, p.spec.nchannels, TypeFloat, p.data.data()));
  return p;
}

// At every level each channel is its own subimage's, and no channel is left out.
void compare_with_separate(const std::string &file, const std::string &query) {
  auto single = opened(file + "?subimages=single" + query),
       separate = opened(file + "?subimages=separate" + query);
  assert_false(single->seek_subimage(1, 0));
  int count = 0, levels = 0;
  for (int level = 0; single->seek_subimage(0, level); level++, levels++) {
    Pixels all = read(single.get(), 0, level);
    count = 0;
    for (int s = 0; separate->seek_subimage(s, 0); s++) {
      Pixels one = read(separate.get(), s, level);
      std::string id = separate->spec(s, 0).get_string_attribute("oiio:subimagename");
      int first = 0;
      while (first < all.spec.nchannels && output_of(all.spec.channelnames[size_t(first)]) != id)
        first++;
      assert_true(first < all.spec.nchannels);
      assert_true(all.spec.width == one.spec.width && all.spec.depth == one.spec.depth);
      for (int c = 0; c < one.spec.nchannels; c++, count++) {
        assert_true(all.spec.channelformat(first + c) == one.spec.format);
        for (size_t i = 0; i < size_t(one.spec.image_pixels()); i++) {
          float got = all.at(i, first + c), want = one.at(i, c);
          if (memcmp(&got, &want, sizeof got) != 0)
            fail_msg("%s%s %s level %d texel %zu: %.9g, not %.9g", file.c_str(), query.c_str(),
                     all.spec.channelnames[size_t(first + c)].c_str(), level, i, double(got),
                     double(want));
        }
      }
    }
    assert_int_equal(count, all.spec.nchannels);
  }
  std::printf("%s%s: %d channels at %d levels\n", file.c_str(), query.c_str(), count, levels);
}

const char wood[] = "material: wood\npreset: keyaki\n"
                    "params: {cut: flat, layout: herringbone, surface: planed}\n"
                    "surface: {shape: board, size: [300, 200, 30]}\n"
                    "image: {resolution: [150, 100]}\n";
const char stone[] = "material: stone\npreset: inada\nimage: {resolution: 120, size: 60}\n";
const char felt[] = "material: fiber\npreset: felt\nimage: {resolution: 80, size: 8}\n";

void every_level(void **) {
  std::string file = direct_write("wood.sozai", wood);
  for (const char *query : {"", "&format=float", "&format=half", "&normals=tangent"})
    compare_with_separate(file, query);
  compare_with_separate(direct_write("felt.sozai", felt), "");
  // three numbers: a volume, without what needs a normal
  compare_with_separate(file, "&res=24x24x24&size=30x30x30");
}

void seamless(void **) {
  std::string file = direct_write("stone.sozai", stone);
  for (const char *query : {"", "&wrap=periodic&finish=flamed", "&wrap=periodic&normals=tangent"})
    compare_with_separate(file, query);
}

void mesh(void **) {
  direct_write("square.obj", square_obj);
  std::string file =
      direct_write("mesh.sozai", "material: wood\npreset: buna\n"
                                 "surface: {shape: mesh, mesh: square.obj, scale: 10}\n"
                                 "image: {resolution: 100}\n");
  for (const char *query : {"&udim=1001", "&udim=1002"}) compare_with_separate(file, query);
}

// Every channel at texels of every level, to the bit.
void against_the_material(void **) {
  std::string file = direct_write("direct.sozai", wood);
  auto in = opened(file + "?subimages=single&format=float");
  direct *d = direct_open(file.c_str());
  uint64_t state = 9;
  for (int level = 0; in->seek_subimage(0, level); level++) {
    Pixels p = read(in.get(), 0, level);
    for (int k = 0; k < 30; k++) {
      uint32_t w = uint32_t(p.spec.width), h = uint32_t(p.spec.height);
      uint32_t x = direct_random(&state) % w, y = direct_random(&state) % h;
      float point[3] = {direct_middle(x, w, 300), -direct_middle(y, h, 200), 15};
      for (int c = 0; c < p.spec.nchannels;) {
        std::string id = output_of(p.spec.channelnames[size_t(c)]);
        float want[3];
        direct_at(d, id.c_str(), point, up, float(std::sqrt(300.0 / w * (200.0 / h))), want);
        for (int n = 0; c < p.spec.nchannels && output_of(p.spec.channelnames[size_t(c)]) == id;
             n++, c++) {
          float got = p.at(size_t(y) * w + x, c);
          if (memcmp(&got, &want[n], sizeof got) != 0 && got != want[n])
            fail_msg("%s level %d: %.9g, not %.9g", p.spec.channelnames[size_t(c)].c_str(), level,
                     double(got), double(want[n]));
        }
      }
    }
  }
  direct_close(d);
}

// Any of the channels, as floats, halves and in the file's own types.
void ranges(void **) {
  for (const char *text : {wood, stone}) {
    std::string file = direct_write("ranges.sozai", text);
    if (text == stone)
      file += "?wrap=periodic&subimages=single";
    else
      file += "?subimages=single";
    auto in = opened(file);
    const ImageSpec spec = in->spec();
    assert_true(spec.format == TypeFloat && spec.channelformats.size() == size_t(spec.nchannels));
    Pixels all = read(in.get(), 0, 0);
    uint64_t state = 3;
    for (int k = 0; k < 60; k++) {
      int first = int(direct_random(&state) % uint32_t(spec.nchannels));
      int end = first + 1 + int(direct_random(&state) % uint32_t(spec.nchannels - first));
      size_t texel = spec.pixel_bytes(first, end, true);
      std::vector<char> native(64 * 64 * texel);
      std::vector<float> floats(64 * 64 * size_t(end - first));
      std::vector<Imath::half> halves(floats.size());
      assert_true(in->read_tiles(0, 0, 0, 64, 64, 128, 0, 1, first, end, TypeFloat, floats.data()));
      assert_true(in->read_tiles(0, 0, 0, 64, 64, 128, 0, 1, first, end, TypeHalf, halves.data()));
      assert_true(
          in->read_tiles(0, 0, 0, 64, 64, 128, 0, 1, first, end, TypeUnknown, native.data()));
      for (size_t i = 0; i < 64 * 64; i++) {
        size_t x = i % 64, y = 64 + i / 64;
        const char *at = &native[i * texel];
        for (int c = first; c < end; c++) {
          float want = y < size_t(spec.height) ? all.at(y * size_t(spec.width) + x, c) : 0;
          size_t place = i * size_t(end - first) + size_t(c - first);
          assert_memory_equal(&floats[place], &want, sizeof want);
          Imath::half rounded = std::max(-65504.0f, std::min(65504.0f, want));
          assert_memory_equal(&halves[place], &rounded, sizeof rounded);
          bool half = spec.channelformat(c) == TypeHalf;
          assert_memory_equal(at, half ? static_cast<void *>(&rounded) : &want, half ? 2 : 4);
          at += half ? 2 : 4;
        }
      }
    }
  }
}

// A file written of it is read as the same channels under the same numbers.
void as_exr(void **) {
  for (const char *text : {wood, stone, felt}) {
    std::string file = direct_write("exr.sozai", text), exr = direct_path("exr.exr");
    for (const char *format : {"auto", "half", "float"}) {
      auto in = opened(file + "?subimages=single&format=" + format);
      ImageSpec spec(in->spec().width, in->spec().height, in->spec().nchannels, in->spec().format);
      spec.channelnames = in->spec().channelnames;
      spec.channelformats = in->spec().channelformats;
      std::vector<char> native(spec.image_bytes(true)), back(native.size());
      assert_true(in->read_image(0, 0, 0, spec.nchannels, TypeUnknown, native.data()));
      auto out = ImageOutput::create(exr);
      assert_true(out && out->open(exr, spec) &&
                  out->write_scanlines(0, spec.height, 0, TypeUnknown, native.data()) &&
                  out->close());
      auto read_back = opened(exr);
      const ImageSpec &exr_spec = read_back->spec();
      assert_int_equal(exr_spec.nchannels, spec.nchannels);
      for (int c = 0; c < spec.nchannels; c++) {
        assert_string_equal(exr_spec.channelnames[size_t(c)].c_str(),
                            spec.channelnames[size_t(c)].c_str());
        assert_true(exr_spec.channelformat(c) == spec.channelformat(c));
      }
      if (!read_back->read_scanlines(0, 0, 0, spec.height, 0, 0, spec.nchannels, TypeUnknown,
                                     back.data()))
        fail_msg("%s: %s", format, read_back->geterror().c_str());
      assert_true(native == back);
    }
  }
  // the albedo is R, G, B wherever it is asked for
  auto in = opened(direct_write("exr.sozai", stone) +
                   std::string("?outputs=normal,roughness,albedo&subimages=single"));
  const char *const names[] = {"R", "G", "B", "roughness", "normal.x", "normal.y", "normal.z"};
  assert_int_equal(in->spec().nchannels, 7);
  for (size_t c = 0; c < 7; c++) assert_string_equal(in->spec().channelnames[c].c_str(), names[c]);
  assert_string_equal(in->spec().get_string_attribute("oiio:ColorSpace").c_str(), "scene_linear");
  assert_string_equal(in->spec().get_string_attribute("oiio:subimagename").c_str(), "");
}

// TextureSystem's firstchannel: what the subimages give. And what it takes for
// a tile to be evaluated once.
void check_texture_system(const char *format, float error) {
  std::string file = direct_write("look.sozai", wood) +
                     std::string("?res=600x400&outputs=albedo,fiber,height,normal&format=") +
                     format;
  ustring single(file + "&subimages=single"), separate(file);
  const struct {
    const char *id;
    int first, count;
  } parts[] = {{"albedo", 0, 3}, {"height", 3, 1}, {"fiber", 4, 3}, {"normal", 7, 3}};
  for (int most : {6, 10}) { // 6: OpenImageIO's own
    TextureSystem *system = TextureSystem::create(false);
    assert_true(system->attribute("max_tile_channels", most));
    uint64_t state = 21;
    for (int k = 0; k < 60; k++) {
      float s = float(direct_random(&state)) * 0x1p-32f,
            t = float(direct_random(&state)) * 0x1p-32f;
      float texels = k % 3 == 0 ? 1.0f : k % 3 == 1 ? 5.0f : 40.0f;
      for (const auto &p : parts) {
        float got[3] = {0}, want[3] = {0};
        TextureOpt options, own;
        options.firstchannel = p.first;
        own.subimagename = ustring(p.id);
        assert_true(
            system->texture(single, options, s, t, texels / 600, 0, 0, texels / 400, p.count, got));
        assert_true(
            system->texture(separate, own, s, t, texels / 600, 0, 0, texels / 400, p.count, want));
        for (int c = 0; c < p.count; c++)
          assert_true(std::fabs(got[c] - want[c]) <= error * std::fabs(want[c]) + 1e-7f);
      }
    }
    // one place: one tile of all channels, or one of each range
    system->invalidate_all(true);
    int before = 0, after = 0;
    system->getattribute("stat:tiles_created", TypeInt, &before);
    for (const auto &p : parts) {
      float got[3];
      TextureOpt options;
      options.firstchannel = p.first;
      options.mipmode = TextureOpt::MipModeNoMIP;
      options.interpmode = TextureOpt::InterpClosest;
      assert_true(system->texture(single, options, 0.04f, 0.04f, 0, 0, 0, 0, p.count, got));
    }
    system->getattribute("stat:tiles_created", TypeInt, &after);
    std::printf("max_tile_channels %d: %d tiles\n", most, after - before);
    assert_int_equal(after - before, most == 6 ? 4 : 1);
    TextureSystem::destroy(system);
  }
}

void texture_system(void **) {
  check_texture_system("float", 1e-6f);
  // colours as float beside the others, and as half in a subimage of their own
  check_texture_system("auto", 1e-3f);
}

} // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_level),          cmocka_unit_test(seamless), cmocka_unit_test(mesh),
      cmocka_unit_test(against_the_material), cmocka_unit_test(ranges),   cmocka_unit_test(as_exr),
      cmocka_unit_test(texture_system)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
