// SPDX-License-Identifier: Apache-2.0
// usage: test-oiio-reads [READS]
// Random texels of several files, outputs and levels, read by 16 threads from
// one image cache that holds a part of them, some hundred from each tile in
// turn, every 32nd compared with the material itself; while others open and
// close the same files. A quarter are read past the cache, from readers that
// all threads share: ThreadSanitizer is told to overlook what OpenImageIO's own
// code takes part in, and there it does not. 300,000 reads unless READS says
// another number; the target oiio-reads makes 10 million.
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"
#include "opened.h"

using namespace OIIO;

namespace {

constexpr int threads = 16, side = 512;
constexpr double mm = 200;
const float up[3] = {0, 0, 1};
const char *const channels[] = {"albedo", "height", "roughness"};
const int components[] = {3, 1, 1};
const int firsts[] = {0, 3, 4}; // of those in one subimage
long reads = 300000;

struct File {
  ustring name;
  direct *material;
  std::shared_ptr<ImageInput> input; // one that all threads read from
  bool single;
  int subimage(int output) const { return single ? 0 : output; }
  int first(int output) const { return single ? firsts[output] : 0; }
};

struct Shared {
  ImageCache *cache;
  std::vector<File> files;
  std::atomic<long> wrong{0}, failed{0};
};

void run(Shared *shared, int thread) {
  uint64_t state = uint64_t(thread) * 1234567;
  const File *file = nullptr;
  int output = 0;
  uint32_t n = 1, tile_x = 0, tile_y = 0;
  int level = 0;
  bool by_itself = false; // not through the cache
  std::vector<float> tile(64 * 64 * 3);
  for (long k = 0; k < reads / threads; k++) {
    if (k % 150 == 0) {
      file = &shared->files[direct_random(&state) % shared->files.size()];
      output = int(direct_random(&state) % 3);
      level = int(direct_random(&state) % 4);
      n = uint32_t(side >> level);
      tile_x = direct_random(&state) % (n / 64) * 64;
      tile_y = direct_random(&state) % (n / 64) * 64;
      by_itself = direct_random(&state) % 4 == 0;
      // A virtual function: from here straight into the reader.
      int first = file->first(output), end = first + components[output];
      if (by_itself && !file->input->read_tiles(file->subimage(output), level, int(tile_x),
                                                int(tile_x) + 64, int(tile_y), int(tile_y) + 64, 0,
                                                1, first, end, TypeFloat, tile.data()))
        shared->failed++;
    }
    uint32_t x = tile_x + direct_random(&state) % 64, y = tile_y + direct_random(&state) % 64;
    float got[3], want[3];
    size_t at = size_t((y - tile_y) * 64 + (x - tile_x)) * size_t(components[output]);
    if (by_itself)
      std::copy_n(&tile[at], components[output], got);
    else if (!shared->cache->get_pixels(file->name, file->subimage(output), level, int(x),
                                        int(x) + 1, int(y), int(y) + 1, 0, 1, file->first(output),
                                        file->first(output) + components[output], TypeFloat, got)) {
      shared->failed++;
      continue;
    }
    if (k % 32) continue;
    float point[3] = {direct_middle(x, n, mm), -direct_middle(y, n, mm), 0};
    direct_at(file->material, channels[output], point, up, float(mm / n), want);
    for (int c = 0; c < components[output]; c++)
      if (got[c] != want[c]) shared->wrong++;
  }
}

// Readers of their own, opened again and again, beside them.
void open_again(Shared *shared, std::atomic<bool> *end) {
  std::vector<float> tile(64 * 64 * 3);
  auto in = ImageInput::create("sozai");
  for (int k = 0; !*end; k++) {
    ImageSpec spec;
    if (!in->open(shared->files[size_t(k) % shared->files.size()].name.string(), spec) ||
        !in->read_tiles(0, 1, 64, 128, 0, 64, 0, 1, 0, 3, TypeFloat, tile.data(), AutoStride,
                        AutoStride, AutoStride) ||
        !in->seek_subimage(in->spec().nchannels == 5 ? 0 : 1, 2) || !in->close())
      shared->failed++;
  }
}

void random_reads(void **) {
  Shared shared;
  shared.cache = ImageCache::create(false);
  shared.cache->attribute("max_memory_MB", 12.0f);
  const char *const materials[] = {
      "wood\npreset: keyaki", "wood\npreset: sugi\nparams: {layout: strip}",
      "stone\npreset: oya",   "stone\npreset: carrara",
      "wood\npreset: keyaki", "stone\npreset: oya"};
  for (int i = 0; i < 6; i++) {
    std::string text = std::string("material: ") + materials[i] +
                       "\nimage: {resolution: 512, size: 200, format: float, outputs: [albedo, "
                       "height, roughness], subimages: " +
                       (i < 4 ? "separate" : "single") + "}\n";
    std::string name = "reads" + std::to_string(i) + ".sozai";
    const char *path = direct_write(name.c_str(), text.c_str());
    shared.files.push_back({ustring(path), direct_open(path), opened(path), i >= 4});
  }
  std::atomic<bool> end{false};
  std::vector<std::thread> running, openers;
  for (int i = 0; i < threads; i++) running.emplace_back(run, &shared, i);
  for (int i = 0; i < 2; i++) openers.emplace_back(open_again, &shared, &end);
  for (std::thread &t : running) t.join();
  end = true;
  for (std::thread &t : openers) t.join();
  int misses = 0;
  assert_true(shared.cache->getattribute("stat:tiles_created", TypeInt, &misses));
  std::printf("%ld reads, %d tiles evaluated, %ld failed, %ld numbers wrong\n", reads, misses,
              shared.failed.load(), shared.wrong.load());
  if (shared.failed) std::printf("%s\n", shared.cache->geterror().c_str());
  assert_int_equal(shared.failed.load(), 0);
  assert_int_equal(shared.wrong.load(), 0);
  ImageCache::destroy(shared.cache);
  for (File &f : shared.files) direct_close(f.material);
}

} // namespace

int main(int count, char **arguments) {
  if (count > 1) reads = std::atol(arguments[1]);
  const CMUnitTest tests[] = {cmocka_unit_test(random_reads)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
