// SPDX-License-Identifier: Apache-2.0
// Every mip level is the material averaged over its own texels: against 64
// points in each texel, without a footprint. And a level shrunk from the one
// above, or looked up at points, would not do.
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

constexpr int samples = 8, texels = 300;
constexpr double mm = 256;
const float up[3] = {0, 0, 1};

struct Bound {
  const char *recipe;
  double mean, rms; // of the albedo's three components, at any level
};

// Root mean square and mean of what differs; points: of the texels' middles alone.
void compare(const direct *d, ImageInput *in, int level, double *rms, double *mean,
             double *points) {
  const ImageSpec spec = in->spec(0, level);
  std::vector<float> all(size_t(spec.width) * size_t(spec.height) * 3);
  assert_true(in->read_image(0, level, 0, 3, TypeFloat, all.data()));
  uint64_t state = 11;
  double sum[3] = {0}, squares = 0, point_squares = 0;
  for (int t = 0; t < texels; t++) {
    uint32_t x = direct_random(&state) % uint32_t(spec.width);
    uint32_t y = direct_random(&state) % uint32_t(spec.height);
    double truth[3] = {0};
    float one[3], point[3] = {0, 0, 0};
    for (uint32_t k = 0; k < samples * samples; k++) {
      uint32_t n = uint32_t(spec.width) * samples;
      point[0] = direct_middle(x * samples + k % samples, n, mm);
      point[1] = -direct_middle(y * samples + k / samples, n, mm);
      direct_at(d, "albedo", point, up, 0, one);
      for (int c = 0; c < 3; c++) truth[c] += double(one[c]) / (samples * samples);
    }
    point[0] = direct_middle(x, uint32_t(spec.width), mm);
    point[1] = -direct_middle(y, uint32_t(spec.width), mm);
    direct_at(d, "albedo", point, up, 0, one);
    for (size_t c = 0; c < 3; c++) {
      double off = double(all[(y * size_t(spec.width) + x) * 3 + c]) - truth[c];
      sum[c] += off / texels;
      squares += off * off / (3 * texels);
      point_squares += (double(one[c]) - truth[c]) * (double(one[c]) - truth[c]) / (3 * texels);
    }
  }
  *rms = std::sqrt(squares);
  *points = std::sqrt(point_squares);
  *mean = std::max(std::fabs(sum[0]), std::max(std::fabs(sum[1]), std::fabs(sum[2])));
}

void levels(void **) {
  const Bound bounds[] = {
      {"material: wood\npreset: keyaki\nparams: {cut: flat}\n", 0.006, 0.03},
      {"material: wood\npreset: mizunara\nparams: {layout: strip}\n", 0.006, 0.03},
      {"material: stone\npreset: inada\n", 0.006, 0.03},
  };
  for (const Bound &b : bounds) {
    std::string file = direct_write(
        "levels.sozai", (std::string(b.recipe) +
                         "image: {resolution: 1024, size: 256, format: float, outputs: albedo}\n")
                            .c_str());
    auto in = opened(file);
    direct *d = direct_open(file.c_str());
    for (int level = 0; level <= 6; level++) {
      double rms, mean, points;
      compare(d, in.get(), level, &rms, &mean, &points);
      std::printf("%-60.50s level %d: rms %.4f mean %.4f; unfiltered %.4f\n", b.recipe, level, rms,
                  mean, points);
      assert_true(rms < b.rms);
      assert_true(mean < b.mean);
      if (level >= 2) assert_true(rms < 0.6 * points);
    }
    direct_close(d);
  }
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(levels)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
