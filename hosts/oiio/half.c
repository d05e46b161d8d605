/* SPDX-License-Identifier: Apache-2.0 */
#include "half.h"

#include <string.h>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#define LARGEST_BITS 0x477fe000u /* 65504 */

/* Without branches, so that compilers make vectors of it. */
static uint16_t convert(float number) {
  uint32_t bits;
  memcpy(&bits, &number, sizeof bits);
  uint32_t sign = bits >> 16 & 0x8000u;
  bits &= 0x7fffffffu;
  bits = bits > LARGEST_BITS ? LARGEST_BITS : bits;
  /* Normal: the exponent moves by 112, and half a unit of the last place, less
   * one where that is even, carries the rest upwards. */
  uint32_t normal = (bits - 0x38000000u + 0xfffu + (bits >> 13 & 1u)) >> 13;
  /* Below 2^-14: adding 0.5 lets the processor shift and round. */
  float small, half = 0.5f;
  memcpy(&small, &bits, sizeof small);
  small += half;
  uint32_t small_bits;
  memcpy(&small_bits, &small, sizeof small_bits);
  uint32_t subnormal = small_bits - 0x3f000000u;
  return (uint16_t)(sign | (bits < 0x38800000u ? subnormal : normal));
}

#if defined(__x86_64__)
__attribute__((target("avx2,f16c"))) static size_t convert_eights(uint16_t *to, const float *from,
                                                                  size_t count) {
  const __m256 most = _mm256_set1_ps(65504.0f), least = _mm256_set1_ps(-65504.0f);
  size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    __m256 v = _mm256_max_ps(_mm256_min_ps(_mm256_loadu_ps(from + i), most), least);
    __m128i h = _mm256_cvtps_ph(v, _MM_FROUND_TO_NEAREST_INT);
    memcpy(to + i, &h, sizeof h);
  }
  return i;
}

/* shuffle[k][c]: which bytes of eight halves of component c are bytes of the
 * k-th sixteen of 24 halves; -1 is a zero. */
#define H(i) 2 * (i), 2 * (i) + 1
#define O -1, -1
static const int8_t shuffle[3][3][16] = {{{H(0), O, O, H(1), O, O, H(2), O},
                                          {O, H(0), O, O, H(1), O, O, H(2)},
                                          {O, O, H(0), O, O, H(1), O, O}},
                                         {{O, H(3), O, O, H(4), O, O, H(5)},
                                          {O, O, H(3), O, O, H(4), O, O},
                                          {H(2), O, O, H(3), O, O, H(4), O}},
                                         {{O, O, H(6), O, O, H(7), O, O},
                                          {H(5), O, O, H(6), O, O, H(7), O},
                                          {O, H(5), O, O, H(6), O, O, H(7)}}};
#undef H
#undef O

__attribute__((target("avx2,f16c"))) static size_t
weave_eights(uint16_t *to, const float *const from[3], size_t count) {
  size_t i = 0;
  for (; i + 8 <= count; i += 8) {
    uint16_t halves[3][8];
    __m128i h[3];
    for (int c = 0; c < 3; c++) {
      convert_eights(halves[c], from[c] + i, 8);
      memcpy(&h[c], halves[c], sizeof h[c]);
    }
    for (int k = 0; k < 3; k++) {
      __m128i woven = _mm_setzero_si128(), bytes;
      for (int c = 0; c < 3; c++) {
        memcpy(&bytes, shuffle[k][c], sizeof bytes);
        woven = _mm_or_si128(woven, _mm_shuffle_epi8(h[c], bytes));
      }
      memcpy(to + 3 * i + 8 * (size_t)k, &woven, sizeof woven);
    }
  }
  return i;
}
#endif

void half_from_float(uint16_t *to, const float *from, size_t count) {
  size_t i = 0;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) /* and so F16C, for which Clang has no name here */
    i = convert_eights(to, from, count);
#endif
  for (; i < count; i++) to[i] = convert(from[i]);
}

void half_from_rgb(uint16_t *to, const float *const from[3], size_t count) {
  size_t i = 0;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) i = weave_eights(to, from, count);
#endif
  for (; i < count; i++)
    for (size_t c = 0; c < 3; c++) to[3 * i + c] = convert(from[c][i]);
}

void half_weave(char *to, ptrdiff_t stride, const uint16_t *const from[4], size_t count) {
  size_t i = 0;
#if defined(__x86_64__)
  for (; i + 8 <= count; i += 8) {
    __m128i h[4];
    for (int c = 0; c < 4; c++) memcpy(&h[c], from[c] + i, sizeof h[c]);
    __m128i ab[2] = {_mm_unpacklo_epi16(h[0], h[1]), _mm_unpackhi_epi16(h[0], h[1])};
    __m128i cd[2] = {_mm_unpacklo_epi16(h[2], h[3]), _mm_unpackhi_epi16(h[2], h[3])};
    for (int k = 0; k < 2; k++) {
      __m128i two[2] = {_mm_unpacklo_epi32(ab[k], cd[k]), _mm_unpackhi_epi32(ab[k], cd[k])};
      for (int n = 0; n < 2; n++, to += 2 * stride) {
        _mm_storel_epi64((__m128i *)(void *)to, two[n]);
        /* _mm_storeh_pd is for places aligned as doubles are, which these need not be */
        _mm_storeh_pi((__m64 *)(void *)(to + stride), _mm_castsi128_ps(two[n]));
      }
    }
  }
#endif
  for (; i < count; i++, to += stride) {
    uint16_t four[4] = {from[0][i], from[1][i], from[2][i], from[3][i]};
    memcpy(to, four, sizeof four);
  }
}
