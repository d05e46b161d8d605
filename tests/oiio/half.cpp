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

// Every 509th float there is, and both neighbours of each half and half-way.
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

} // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(halves)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
