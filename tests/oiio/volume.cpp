// SPDX-License-Identifier: Apache-2.0
// A volume, looked up with texture3d at places in object space.
#include <Imath/ImathVec.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

void look_ups(void **) {
  std::string file = direct_write(
      "volume.sozai", "material: wood\npreset: keyaki\n"
                      "image: {resolution: [40, 50, 30], size: [20, 25, 60], format: float,"
                      " outputs: albedo}\n");
  direct *d = direct_open(file.c_str());
  TextureSystem *system = TextureSystem::create(false);
  TextureOpt options;
  const float texel = float(std::cbrt(0.5 * 0.5 * 2)), size[3] = {20, 25, 60};
  const uint32_t n[3] = {40, 50, 30};
  double worst = 0, between = 0;
  uint64_t state = 3;
  for (int k = 0; k < 2000; k++) {
    uint32_t at[3];
    float p[3], want[3], got[3];
    for (int c = 0; c < 3; c++) {
      at[c] = direct_random(&state) % n[c];
      p[c] = direct_middle(at[c], n[c], double(size[c]));
    }
    direct_at(d, "albedo", p, nullptr, texel, want);
    assert_true(system->texture3d(ustring(file), options, Imath::V3f(p[0], p[1], p[2]),
                                  Imath::V3f(0.0f), Imath::V3f(0.0f), Imath::V3f(0.0f), 3, got));
    for (int c = 0; c < 3; c++) worst = std::max(worst, double(std::fabs(got[c] - want[c])));
    // Half-way to the next slice: their mean.
    if (at[2] + 1 == n[2]) continue;
    float next[3], half_way[3], q[3] = {p[0], p[1], direct_middle(at[2] + 1, n[2], 60)};
    direct_at(d, "albedo", q, nullptr, texel, next);
    assert_true(system->texture3d(ustring(file), options,
                                  Imath::V3f(p[0], p[1], 0.5f * (p[2] + q[2])), Imath::V3f(0.0f),
                                  Imath::V3f(0.0f), Imath::V3f(0.0f), 3, half_way));
    for (int c = 0; c < 3; c++)
      between = std::max(between, double(std::fabs(half_way[c] - 0.5f * (want[c] + next[c]))));
  }
  std::printf("at the voxels' middles %.2g, between them %.2g\n", worst, between);
  assert_true(worst < 2e-4); // the look-up's own arithmetic, in float from mm
  assert_true(between < 2e-4);
  TextureSystem::destroy(system);
  direct_close(d);
}

void what_it_says(void **) {
  std::string file =
      direct_write("said.sozai", "material: wood\nimage: {resolution: 20, size: [10, 10, 5]}\n");
  auto in = opened(file);
  assert_int_equal(in->spec().depth, 10);
  assert_int_equal(in->spec().tile_depth, 16);
  assert_string_equal(in->spec().get_string_attribute("textureformat").c_str(), "Volume Texture");
  assert_false(in->seek_subimage(0, 1));
  for (int s = 0; in->seek_subimage(s, 0); s++) // none that wants a normal
    assert_true(in->spec().get_string_attribute("oiio:subimagename") != "specular");
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(look_ups), cmocka_unit_test(what_it_says)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
