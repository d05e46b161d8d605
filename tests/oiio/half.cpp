// SPDX-License-Identifier: Apache-2.0
// Floats into halves, one by one (without vectors) and many at a time, against
// Imath's: all there are of small ones and every rounding in between.
#include "../../hosts/oiio/half.h"
#include <Imath/half.h>
#include <cmath>
#include <cstring>
#include <vector>
#include "cmocka_cpp.h"

namespace {

// Every 509th float there is; and of every two halves in turn the first, the place
// half-way between them, and its neighbours on both sides.
std::vector<float> numbers() {
  std::vector<float> all;
  for (uint64_t bits = 0; bits < 1ull << 32; bits += 509) {
    uint32_t some = uint32_t(bits);
    float number;
    std::memcpy(&number, &some, sizeof number);
    if (std::isfinite(number)) all.push_back(number);
  }
  for (uint32_t bits = 0; bits < 0x7bff; bits++) {
    Imath::half low, high;
    low.setBits(uint16_t(bits));
    high.setBits(uint16_t(bits + 1));
    float a = low, b = high, middle = 0.5f * (a + b);
    for (float n : {a, middle, std::nextafter(middle, a), std::nextafter(middle, b)}) {
      all.push_back(n);
      all.push_back(-n);
    }
  }
  return all;
}

uint16_t wanted(float number) {
  return Imath::half(std::fmax(-65504.0f, std::fmin(65504.0f, number))).bits();
}

void halves(void **) {
  const std::vector<float> all = numbers();
  std::vector<uint16_t> many(all.size());
  half_from_float(many.data(), all.data(), all.size());
  for (size_t i = 0; i < all.size(); i++) {
    uint16_t one, want = wanted(all[i]);
    half_from_float(&one, &all[i], 1);
    if (one != want || many[i] != want)
      fail_msg("%.9g: %04x alone, %04x among many, not %04x", double(all[i]), one, many[i], want);
  }
}

// Side by side, whatever the count; and nothing past them is written.
void woven(void **) {
  const std::vector<float> all = numbers();
  for (size_t count = 0; count < 80; count++) {
    const float *rgb[3] = {&all[count * 7], &all[count * 77 + 5000000], &all[count * 13 + 100000]};
    std::vector<uint16_t> three(3 * count + 1, 0x5555);
    half_from_rgb(three.data(), rgb, count);
    for (size_t i = 0; i < 3 * count; i++) assert_int_equal(three[i], wanted(rgb[i % 3][i / 3]));
    assert_int_equal(three[3 * count], 0x5555);

    std::vector<uint16_t> arrays[4];
    const uint16_t *from[4];
    for (size_t c = 0; c < 4; c++) {
      for (size_t i = 0; i < count; i++) arrays[c].push_back(uint16_t(1000 * c + i));
      from[c] = arrays[c].data();
    }
    for (size_t stride : {size_t(8), size_t(9), size_t(14)}) { // bytes
      std::vector<char> four(stride * count + 8, 'x');
      half_weave(four.data(), ptrdiff_t(stride), from, count);
      for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 4; c++)
          assert_memory_equal(&four[i * stride + 2 * c], &arrays[c][i], 2);
      for (size_t i = 0; i < four.size(); i++)
        if (i >= stride * count || i % stride >= 8) assert_int_equal(four[i], 'x');
    }
  }
}

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(halves), cmocka_unit_test(woven)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
