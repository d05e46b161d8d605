// SPDX-License-Identifier: Apache-2.0
// OpenImageIO's texture system over a .sozai file: 8 threads, a tile cache of
// 64 MB, trilinear and anisotropic, against the material evaluated at the same
// place under the same footprint.
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <cmath>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>
#include "cmocka_cpp.h"
#include "direct.h"

using namespace OIIO;

namespace {

constexpr int threads = 8, lookups = 400;
constexpr double mm = 512;
constexpr int side = 8192;
const float up[3] = {0, 0, 1};

struct Job {
  TextureSystem *system;
  const direct *material;
  ustring file;
  TextureOpt::MipMode mode;
  double texels; // the footprint's side at level 0; anisotropic: the short one's
  double aspect; // the long one's over it
  uint64_t seed;
  double sum[3], squares;
  bool failed;
};

// The mean over a rectangle, of squares that the kernel filters itself.
void truth(const direct *d, double x, double y, double wide, double high, double out[3]) {
  int n = std::max(1, int(wide / high + 0.5));
  for (int c = 0; c < 3; c++) out[c] = 0;
  for (int i = 0; i < n; i++) {
    float point[3] = {float(x + wide * ((i + 0.5) / n - 0.5)), float(y), 0}, one[3];
    direct_at(d, "albedo", point, up, float(high), one);
    for (int c = 0; c < 3; c++) out[c] += double(one[c]) / n;
  }
}

void run(Job *j) {
  uint64_t state = j->seed;
  TextureOpt options;
  options.mipmode = j->mode;
  options.anisotropic = 16;
  for (int k = 0; k < lookups; k++) {
    float s = 0.1f + 0.8f * float(direct_random(&state)) * 0x1p-32f;
    float t = 0.1f + 0.8f * float(direct_random(&state)) * 0x1p-32f, got[3];
    float high = float(j->texels / side), wide = float(j->texels * j->aspect / side);
    if (!j->system->texture(j->file, options, s, t, wide, 0, 0, high, 3, got)) {
      j->failed = true;
      return;
    }
    double want[3];
    truth(j->material, (double(s) - 0.5) * mm, (0.5 - double(t)) * mm,
          j->texels * j->aspect / side * mm, j->texels / side * mm, want);
    for (int c = 0; c < 3; c++) {
      double off = double(got[c]) - want[c];
      j->sum[c] += off;
      j->squares += off * off;
    }
  }
}

void compare(const char *what, TextureOpt::MipMode mode, double texels, double aspect,
             double bound) {
  std::string file =
      direct_write("texture.sozai", "material: wood\npreset: keyaki\nparams: {cut: flat}\n"
                                    "image: {resolution: 8192, size: 512}\n");
  direct *d = direct_open(file.c_str());
  TextureSystem *system = TextureSystem::create(false);
  system->attribute("max_memory_MB", 64.0f);
  std::vector<Job> jobs;
  for (int i = 0; i < threads; i++)
    jobs.push_back(
        {system, d, ustring(file), mode, texels, aspect, uint64_t(77 * i + 1), {0}, 0, false});
  std::vector<std::thread> running;
  for (Job &j : jobs) running.emplace_back(run, &j);
  for (std::thread &t : running) t.join();
  double sum[3] = {0}, squares = 0;
  for (const Job &j : jobs) {
    if (j.failed) fail_msg("%s", system->geterror().c_str());
    for (int c = 0; c < 3; c++) sum[c] += j.sum[c];
    squares += j.squares;
  }
  double rms = std::sqrt(squares / (3 * threads * lookups)), mean = 0;
  for (int c = 0; c < 3; c++) mean = std::max(mean, std::fabs(sum[c] / (threads * lookups)));
  long long held = 0;
  system->getattribute("stat:cache_memory_used", TypeInt64, &held);
  std::printf("%-36s rms %.4f, mean %.4f, cache %lld MB\n", what, rms, mean, held >> 20);
  assert_true(rms < bound);
  assert_true(mean < 0.004);
  assert_true(held <= 70 << 20);
  TextureSystem::destroy(system);
  direct_close(d);
}

void trilinear(void **) {
  compare("trilinear, 1 texel", TextureOpt::MipModeTrilinear, 1, 1, 0.035);
  compare("trilinear, 8 texels", TextureOpt::MipModeTrilinear, 8, 1, 0.02);
  compare("trilinear, 100 texels", TextureOpt::MipModeTrilinear, 100, 1, 0.02);
}

void anisotropic(void **) {
  compare("anisotropic, 8 x 2 texels", TextureOpt::MipModeAniso, 2, 4, 0.03);
  compare("anisotropic, 64 x 8 texels", TextureOpt::MipModeAniso, 8, 8, 0.02);
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(trilinear), cmocka_unit_test(anisotropic)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
