// SPDX-License-Identifier: Apache-2.0
// subimages: single: a texel is evaluated once for all channels, and channels
// that are not asked for are not evaluated. Read with a plugin that counts.
#include <OpenImageIO/imageio.h>
#include <dlfcn.h>
#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"
#include "watch.h"

using namespace OIIO;

namespace {

watch_take_function *take;

// How many numbers of a texel were wanted of the plugin.
int asked(const watch &w) { return __builtin_popcountll(w.asked); }

std::unique_ptr<ImageInput> watched(const char *name, const std::string &text) {
  auto in = opened(direct_write(name, text.c_str()));
  in->threads(1);
  if (!take) {
    void *library = dlopen(SOZAI_TEST_WATCH, RTLD_NOW | RTLD_NOLOAD);
    assert_non_null(library); // the reader has loaded it
    take = reinterpret_cast<watch_take_function *>(dlsym(library, WATCH_SYMBOL));
    assert_non_null(take);
  }
  return in;
}

// A tile of channels first to end: how many points, and numbers of them.
watch read(ImageInput *in, int level, int x, int first, int end) {
  const ImageSpec spec = in->spec(0, level);
  std::vector<float> tile(64 * 64 * size_t(spec.nchannels));
  take();
  assert_true(in->read_tiles(0, level, x, x + 64, 0, 64, 0, 1, first, end, TypeFloat, tile.data()));
  return take();
}

void once(void **) {
  for (const char *material : {"wood\npreset: keyaki", "stone\npreset: inada"}) {
    auto in =
        watched("once.sozai", std::string("material: ") + material +
                                  "\nimage: {resolution: 256, size: 100, subimages: single}\n");
    int channels = in->spec().nchannels;
    for (int level : {0, 1, 2, 4}) {
      int side = std::min(64, 256 >> level);
      watch all = read(in.get(), level, 0, 0, channels);
      assert_int_equal(all.points, side * side);
      assert_int_equal(asked(all), channels);
    }
    for (int first = 0; first < channels; first++)
      for (int end : {first + 1, channels}) {
        watch some = read(in.get(), 0, 64, first, end);
        assert_int_equal(some.points, 64 * 64);
        assert_int_equal(asked(some), end - first);
      }
  }
}

// Each copy once, and only where there is any of it.
void seamless(void **) {
  const std::string text = "material: stone\npreset: inada\nimage: {resolution: 256, size: 100, "
                           "wrap: periodic, subimages: single";
  auto all = watched("all.sozai", text + "}\n"),
       albedo = watched("albedo.sozai", text + ", outputs: albedo}\n");
  watch corner = read(all.get(), 0, 0, 0, all->spec().nchannels);
  assert_true(corner.points > 64 * 64 && corner.points <= 4 * 64 * 64);
  assert_int_equal(asked(corner), all->spec().nchannels);
  assert_true(corner.points <= read(albedo.get(), 0, 0, 0, 3).points);
  assert_int_equal(read(all.get(), 2, 0, 0, 3).points, read(albedo.get(), 2, 0, 0, 3).points);
}

} // namespace

int main() {
  setenv("SOZAI_PLUGIN", SOZAI_TEST_WATCH, 1);
  const CMUnitTest tests[] = {cmocka_unit_test(once), cmocka_unit_test(seamless)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
