// SPDX-License-Identifier: Apache-2.0
// Tiles read through OpenImageIO are the material's own answers: to the bit in
// float, to the nearest half in half; at every level, size, stride and type.
#include <Imath/half.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

const char wood[] = "material: wood\npreset: keyaki\nparams: {cut: flat, layout: herringbone}\n"
                    "surface: {shape: board, size: [300, 200, 30]}\n"
                    "image: {resolution: [150, 100], format: float}\n";
const char stone[] = "material: stone\npreset: inada\n"
                     "image: {resolution: [70, 130], size: [90, 40], format: float}\n";
const float up[3] = {0, 0, 1};

struct Picture {
  const char *name;
  double size[2];
  float z;
};

void expected(const direct *d, const Picture &p, const ImageSpec &spec, const char *channel, int x,
              int y, float *out) {
  double wide = p.size[0] / spec.width, high = p.size[1] / spec.height;
  float point[3] = {direct_middle(uint32_t(x), uint32_t(spec.width), p.size[0]),
                    -direct_middle(uint32_t(y), uint32_t(spec.height), p.size[1]), p.z};
  direct_at(d, channel, point, up, float(std::sqrt(wide * high)), out);
}

// Every output at every level, whole tiles with what lies past the picture.
void check_picture(const char *file, const Picture &p) {
  auto in = opened(file);
  direct *d = direct_open(file);
  uint64_t state = 5;
  for (int s = 0; in->seek_subimage(s, 0); s++) {
    std::string channel = in->spec().get_string_attribute("oiio:subimagename");
    int side = std::max(in->spec().width, in->spec().height), levels = 0;
    for (int m = 0; in->seek_subimage(s, m); m++, levels++) {
      const ImageSpec spec = in->spec();
      assert_int_equal(spec.width, std::max(1, in->spec(s, 0).width >> m));
      assert_int_equal(spec.height, std::max(1, in->spec(s, 0).height >> m));
      assert_true(spec.format == TypeFloat);
      std::vector<float> tile(size_t(64 * 64 * spec.nchannels), -7.0f);
      for (int ty = 0; ty < spec.height; ty += 64)
        for (int tx = 0; tx < spec.width; tx += 64) {
          assert_true(in->read_tile(tx, ty, 0, TypeFloat, tile.data()));
          for (int k = 0; k < 40; k++) {
            int x = int(direct_random(&state) % 64), y = int(direct_random(&state) % 64);
            float want[3] = {0, 0, 0};
            if (tx + x < spec.width && ty + y < spec.height)
              expected(d, p, spec, channel.c_str(), tx + x, ty + y, want);
            for (int c = 0; c < spec.nchannels; c++) {
              float got = tile[size_t((y * 64 + x) * spec.nchannels + c)];
              if (memcmp(&got, &want[c], sizeof got) != 0 && got != want[c])
                fail_msg("%s %s level %d texel %d %d: %.9g, not %.9g", file, channel.c_str(), m,
                         tx + x, ty + y, double(got), double(want[c]));
            }
          }
        }
    }
    int wanted = 1;
    while (side >> wanted) wanted++;
    assert_int_equal(levels, wanted); // down to one texel
    assert_true(in->spec(s, levels - 1).width == 1 && in->spec(s, levels - 1).height == 1);
  }
  direct_close(d);
}

void wood_board(void **) {
  check_picture(direct_write("wood.sozai", wood), {"wood", {300, 200}, 15});
}
void stone_plane(void **) {
  check_picture(direct_write("stone.sozai", stone), {"stone", {90, 40}, 0});
}

// The same texels whatever they are asked for as.
void types(void **) {
  std::string file = direct_write("types.sozai", stone);
  auto in = opened(file), half_in = opened(file + "?format=half");
  const ImageSpec spec = in->spec();
  assert_true(half_in->spec().format == TypeHalf);
  size_t count = size_t(spec.width * spec.height);
  std::vector<float> whole(count * 3);
  assert_true(in->read_image(0, 0, 0, 3, TypeFloat, whole.data()));

  std::vector<Imath::half> halves(count * 3), native(count * 3);
  assert_true(in->read_image(0, 0, 0, 3, TypeHalf, halves.data()));
  assert_true(half_in->read_image(0, 0, 0, 3, TypeUnknown, native.data()));
  std::vector<uint8_t> bytes(count * 3);
  assert_true(in->read_image(0, 0, 0, 3, TypeUInt8, bytes.data()));
  std::vector<float> green(count * 2, -1.0f); // one channel, every other place
  assert_true(in->read_image(0, 0, 1, 2, TypeFloat, green.data(), stride_t(2 * sizeof(float)),
                             stride_t(2 * sizeof(float)) * spec.width));
  for (size_t i = 0; i < count * 3; i++) {
    assert_true(halves[i] == Imath::half(whole[i]));
    assert_true(native[i] == halves[i]);
    int wanted = int(std::min(1.0f, std::max(0.0f, whole[i])) * 255 + 0.5f);
    assert_true(std::abs(bytes[i] - wanted) <= 1);
  }
  for (size_t i = 0; i < count; i++) {
    assert_true(green[2 * i] == whole[3 * i + 1]);
    assert_true(green[2 * i + 1] == -1.0f);
  }
}

// One texel, one row, one column; many texels of a huge picture.
void extremes(void **) {
  std::string file =
      direct_write("extremes.sozai", "material: stone\npreset: aji\n"
                                     "image: {size: 500, outputs: [albedo, height]}");
  for (const char *size : {"1", "1x300", "300x1", "63x65"}) {
    auto in = opened(file + "?res=" + size);
    const ImageSpec spec = in->spec();
    std::vector<float> all(size_t(spec.width * spec.height * 3));
    assert_true(in->read_image(0, 0, 0, 3, TypeFloat, all.data()));
    for (float v : all) assert_true(v > 0 && v < 1);
  }
  direct *d = direct_open(file.c_str());
  for (int side : {65536, 1048576}) {
    auto in = opened(file + "?format=float&res=" + std::to_string(side));
    assert_int_equal(in->spec().width, side);
    std::vector<float> tile(64 * 64 * 3);
    for (int at : {0, side / 2, side - 64}) {
      assert_true(in->read_tile(at, side - 64 - at, 0, TypeFloat, tile.data()));
      float want[3];
      expected(d, {"", {500, 500}, 0}, in->spec(), "albedo", at + 9, side - 64 - at + 5, want);
      assert_memory_equal(want, &tile[(5 * 64 + 9) * 3], sizeof want);
    }
  }
  direct_close(d);
}

// As normal maps are encoded, and only the normal.
void tangent(void **) {
  std::string file = direct_write("normals.sozai", stone);
  auto object = opened(file + "?outputs=normal,albedo"),
       encoded = opened(file + "?outputs=normal,albedo&normals=tangent");
  std::vector<float> a(70 * 130 * 3), b(a.size());
  for (int s = 0; s < 2; s++) {
    assert_true(object->read_image(s, 0, 0, 3, TypeFloat, a.data()));
    assert_true(encoded->read_image(s, 0, 0, 3, TypeFloat, b.data()));
    for (size_t i = 0; i < a.size(); i++) assert_true(b[i] == (s == 0 ? 0.5f + 0.5f * a[i] : a[i]));
  }
}

// A sheet of 80 mm over two tiles of UVs: the texel's own point, whose grain goes on across.
void mesh(void **) {
  direct_write("square.obj", square_obj);
  std::string file =
      direct_write("mesh.sozai", "material: wood\npreset: buna\n"
                                 "surface: {shape: mesh, mesh: square.obj, scale: 10}\n"
                                 "image: {resolution: 128, format: float, outputs: albedo}\n");
  direct *d = direct_open(file.c_str());
  for (int udim : {1001, 1002}) {
    auto in = opened(file + "?udim=" + std::to_string(udim));
    assert_int_equal(in->spec().get_int_attribute("sozai_udim"), udim);
    for (int level = 0; level < 8; level += 3) {
      int n = 128 >> level;
      std::vector<float> all(size_t(n * n * 3));
      assert_true(in->read_image(0, level, 0, 3, TypeFloat, all.data()));
      double worst = 0;
      for (int y = 0; y < n; y++)
        for (int x = 0; x < n; x++) {
          float point[3] = {direct_middle(uint32_t(x), uint32_t(n), 40) +
                                (udim == 1001 ? -20.0f : 20.0f),
                            -direct_middle(uint32_t(y), uint32_t(n), 40), 10},
                want[3];
          direct_at(d, "albedo", point, up, 40.0f / float(n), want);
          for (int c = 0; c < 3; c++)
            worst = std::max(worst, double(std::fabs(want[c] - all[size_t((y * n + x) * 3 + c)])));
        }
      std::printf("udim %d level %d: at most %.2g off\n", udim, level, worst);
      assert_true(worst < 1e-3); // points that differ by a rounding
    }
  }
  direct_close(d);
}

// Rows alone; and none that there are not.
void rows(void **) {
  auto in = opened(direct_write("rows.sozai", stone));
  const ImageSpec spec = in->spec();
  size_t texel = spec.pixel_bytes(true);
  std::vector<char> row(texel * size_t(spec.width)), tile(texel * size_t(spec.tile_pixels()));
  assert_true(in->read_native_tile(0, 0, 0, 0, 0, tile.data()));
  assert_true(in->read_native_scanline(0, 0, 3, 0, row.data()));
  assert_memory_equal(row.data(), tile.data() + 3 * texel * size_t(spec.tile_width),
                      texel * size_t(spec.tile_width));
  const int nowhere[][2] = {{-1, 0}, {spec.height, 0}, {1 << 30, 0}, {0, -1}, {0, 1}};
  for (const auto &at : nowhere) {
    assert_false(in->read_native_scanline(0, 0, at[0], at[1], row.data()));
    assert_false(in->geterror().empty());
  }
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(wood_board), cmocka_unit_test(stone_plane),
                              cmocka_unit_test(types),      cmocka_unit_test(extremes),
                              cmocka_unit_test(tangent),    cmocka_unit_test(mesh),
                              cmocka_unit_test(rows)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
