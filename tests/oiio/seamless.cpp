// SPDX-License-Identifier: Apache-2.0
// wrap: periodic: the picture fits itself, is the material's own at every texel
// off the line, and has its statistics.
#include <OpenImageIO/imageio.h>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

constexpr int side = 256, beside = 8, blocks = 5;

struct Image {
  int width, height;
  std::vector<float> texels;
  float at(int x, int y, int c) const {
    return texels[size_t(((y % height) * width + x % width) * 3 + c)];
  }
};

Image read(const std::string &name, int level) {
  auto in = opened(name);
  const ImageSpec spec = in->spec(0, level);
  Image image = {spec.width, spec.height, {}};
  image.texels.resize(size_t(spec.width) * size_t(spec.height) * 3);
  assert_true(in->read_image(0, level, 0, 3, TypeFloat, image.texels.data()));
  return image;
}

// Mean square step from one texel to the next: across the seams, and on the lines beside them,
// which have as much of veins as the seams have.
void add_steps(const Image &i, double *seam, double *inner) {
  double across = 0, near = 0;
  int count = 0;
  for (int c = 0; c < 3; c++) {
    for (int y = 0; y < i.height; y++) {
      double s = i.at(i.width - 1, y, c) - i.at(0, y, c),
             t = i.at(y, i.height - 1, c) - i.at(y, 0, c);
      across += s * s + t * t;
      for (int k = 1; k <= beside; k++, count += 2) {
        for (int x : {k - 1, i.width - 1 - k}) {
          double u = i.at(x, y, c) - i.at(x + 1, y, c), v = i.at(y, x, c) - i.at(y, x + 1, c);
          near += u * u + v * v;
        }
      }
    }
  }
  *seam += across / (3 * i.height);
  *inner += near / count;
}

void moments(const Image &i, double mean[3], double deviation[3]) {
  for (int c = 0; c < 3; c++) {
    double sum = 0, squares = 0;
    for (int y = 0; y < i.height; y++)
      for (int x = 0; x < i.width; x++) {
        sum += double(i.at(x, y, c));
        squares += double(i.at(x, y, c)) * double(i.at(x, y, c));
      }
    double n = double(i.width) * i.height;
    mean[c] = sum / n;
    deviation[c] = std::sqrt(squares / n - mean[c] * mean[c]);
  }
}

std::string file(const char *preset, int size) {
  char text[300];
  std::snprintf(text, sizeof text,
                "material: stone\npreset: %s\nimage: {resolution: %d, size: %d, format: float, "
                "wrap: periodic}\n",
                preset, side, size);
  return direct_write("seamless.sozai", text);
}

void seams(void **) {
  const struct {
    const char *preset;
    int size;
    bool shows; // a seam would, as a step
  } stones[] = {{"inada", 100, true},  {"terrazzo", 200, true}, {"sandstone", 100, false},
                {"basalt", 60, false}, {"carrara", 400, true},  {"travertino", 400, true}};
  for (const auto &s : stones) {
    std::string name = file(s.preset, s.size);
    for (int level = 0; level < 3; level++) { // further on there are too few texels to tell
      double seam = 0, inner = 0, plain_seam = 0, plain_inner = 0;
      // One vein across a seam would be all of its steps: of several blocks' pictures.
      for (int seed = blocks; seed > 1; seed--) {
        std::string other = name + "?seed=" + std::to_string(seed);
        add_steps(read(other, level), &seam, &inner);
        add_steps(read(other + "&wrap=clamp", level), &plain_seam, &plain_inner);
      }
      Image fits = read(name, level), plain = read(name + "?wrap=clamp", level);
      add_steps(fits, &seam, &inner);
      add_steps(plain, &plain_seam, &plain_inner);
      double mean[3], deviation[3], plain_mean[3], plain_deviation[3];
      moments(fits, mean, deviation);
      moments(plain, plain_mean, plain_deviation);
      std::printf("%-12s level %d: step at the seam %.2f of beside it (without: %.2f); mean %+.4f, "
                  "deviation x %.3f\n",
                  s.preset, level, std::sqrt(seam / inner), std::sqrt(plain_seam / plain_inner),
                  mean[1] - plain_mean[1], deviation[1] / plain_deviation[1]);
      assert_true(std::sqrt(seam / inner) < 1.15);
      if (level == 0 && s.shows) assert_true(std::sqrt(plain_seam / plain_inner) > 1.3);
      for (int c = 0; c < 3; c++) {
        assert_true(std::fabs(mean[c] - plain_mean[c]) < 0.25 * plain_deviation[c]);
        assert_true(deviation[c] > 0.75 * plain_deviation[c] &&
                    deviation[c] < 1.3 * plain_deviation[c]);
      }
    }
  }
}

// Nearly every texel is the material's at one of the four places.
void genuine(void **) {
  std::string name = file("inada", 100);
  Image fits = read(name, 0);
  direct *d = direct_open(name.c_str());
  const float up[3] = {0, 0, 1};
  int mixed = 0, moved = 0;
  for (int y = 0; y < side; y += 3)
    for (int x = 0; x < side; x += 3) {
      bool own = false;
      for (int k = 0; k < 4 && !own; k++) {
        float point[3] = {direct_middle(uint32_t(x), side, 100) + (k & 1 ? 100.0f : 0),
                          -direct_middle(uint32_t(y), side, 100) + (k & 2 ? 100.0f : 0), 0},
              want[3];
        direct_at(d, "albedo", point, up, 100.0f / side, want);
        own = true;
        for (int c = 0; c < 3; c++)
          own = own && std::fabs(double(want[c] - fits.at(x, y, c))) < 1e-6;
        moved += own && k > 0;
      }
      mixed += !own;
    }
  std::printf("of %d texels %d from farther on, %d at the line\n", 86 * 86, moved, mixed);
  assert_true(moved > 86 * 86 / 10);
  assert_true(mixed < 86 * 86 / 50);
  direct_close(d);
}

// Names of crystals stay names, normals stay of length 1.
void channels(void **) {
  std::string name = file("inada", 100);
  auto in = opened(name + "?outputs=normal,grain,height&res=128");
  std::vector<float> normal(128 * 128 * 3), grain(128 * 128), height(128 * 128);
  assert_true(in->read_image(0, 0, 0, 3, TypeFloat, normal.data()));
  assert_true(in->read_image(1, 0, 0, 1, TypeFloat, grain.data()));
  assert_true(in->read_image(2, 0, 0, 1, TypeFloat, height.data()));
  for (size_t i = 0; i < grain.size(); i++) {
    double length = 0;
    for (size_t c = 0; c < 3; c++) length += double(normal[3 * i + c]) * double(normal[3 * i + c]);
    assert_true(std::fabs(length - 1) < 1e-5);
    assert_true(grain[i] >= 0 && grain[i] <= 1 && std::isfinite(height[i]));
  }
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(seams), cmocka_unit_test(genuine),
                              cmocka_unit_test(channels)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
