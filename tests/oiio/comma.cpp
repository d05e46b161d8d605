// SPDX-License-Identifier: Apache-2.0
// A program's locale may have a decimal comma; files and what is asked after
// their names read alike, and answers are the same. Run by comma.sh.
#include <OpenImageIO/imageio.h>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

struct Read {
  ImageSpec spec;
  std::vector<float> texels;
};

Read read_all(const std::string &name) {
  auto in = opened(name);
  Read r;
  r.spec = in->spec();
  r.texels.resize(size_t(r.spec.image_pixels()) * size_t(r.spec.nchannels));
  assert_true(in->read_image(0, 0, 0, r.spec.nchannels, TypeFloat, r.texels.data()));
  return r;
}

void same(const std::string &name) {
  assert_non_null(setlocale(LC_ALL, "C"));
  Read dot = read_all(name);
  assert_non_null(setlocale(LC_ALL, "de_DE.UTF-8"));
  char text[16];
  (void)snprintf(text, sizeof text, "%.1f", 0.5);
  assert_string_equal(text, "0,5"); // it is such a locale
  Read comma = read_all(name);
  assert_non_null(setlocale(LC_ALL, "C"));
  assert_int_equal(dot.spec.width, comma.spec.width);
  assert_int_equal(dot.spec.height, comma.spec.height);
  assert_true(dot.texels == comma.texels);
}

void boards(void **) {
  same(direct_write("comma.sozai",
                    "material: wood\npreset: sugi\nparams: {ring_width: 2.5, spiral_slope: 0.125}\n"
                    "surface: {shape: board, size: [100.5, 50.25, 20]}\n"
                    "image: {resolution: [64, 32], size: [100.5, 50.25], format: float}\n"));
}

void planes(void **) {
  std::string file = direct_write(
      "comma.sozai", "material: stone\npreset: inada\n"
                     "image: {resolution: [64, 32], size: [1000, 500], format: float}\n");
  same(file);
  same(file + "?size=2.5x1.25");
}

void meshes(void **) {
  (void)direct_write("comma.obj", "v 0.5 0.25 1.5\nv 8.5 0.25 1.5\nv 8.5 8.25 1.5\n"
                                  "vt 0.125 0.125\nvt 0.875 0.125\nvt 0.875 0.875\n"
                                  "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\n");
  same(direct_write("comma.sozai", "material: stone\npreset: inada\n"
                                   "surface: {shape: mesh, mesh: comma.obj, scale: 2.5}\n"
                                   "image: {resolution: 64, format: float}\n"));
}

} // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(boards),
      cmocka_unit_test(planes),
      cmocka_unit_test(meshes),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
