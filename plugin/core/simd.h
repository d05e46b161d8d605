/* SPDX-License-Identifier: Apache-2.0
 *
 * Lanes: one source for every instruction set.
 *
 * A kernel's source is compiled several times, with SOZAI_LANES and one of
 * SOZAI_ISA_SCALAR, _SSE2, _AVX2, _AVX512, _NEON defined. Arithmetic is the
 * compiler's own on vector types; what the C operators lack (masks, minimum,
 * gather) is here. Every function gives the same bits for a lane whatever the
 * instruction set: IEEE single operations only, no reciprocal estimates, no
 * fused multiply-add, and the minimum of x86, "a < b ? a : b".
 */
#ifndef SOZAI_CORE_SIMD_H
#define SOZAI_CORE_SIMD_H

#include <stdint.h>
#include <string.h>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define LANES SOZAI_LANES
#ifdef __clang__
#define UNROLL(n) PRAGMA_(clang loop unroll_count(n))
#else
#define UNROLL(n) PRAGMA_(GCC unroll n)
#endif
#define PRAGMA_(x) _Pragma(#x)
#define INLINE static inline __attribute__((always_inline, unused))

/* ---- one lane: plain numbers ------------------------------------------ */

#if LANES == 1

typedef float vf;
typedef int32_t vi;
typedef uint32_t vu;
typedef int vm;

INLINE vf splat(float x) { return x; }
INLINE vi splati(int32_t x) { return x; }
INLINE vu splatu(uint32_t x) { return x; }
INLINE float lane(vf v, uint32_t k) {
  (void)k;
  return v;
}
INLINE void set_lane(vf *v, uint32_t k, float x) {
  (void)k;
  *v = x;
}
INLINE vi bits_of(vf x) {
  vi r;
  memcpy(&r, &x, sizeof r);
  return r;
}
INLINE vf float_of(vi x) {
  vf r;
  memcpy(&r, &x, sizeof r);
  return r;
}
INLINE vf to_float(vi x) { return (float)x; }
INLINE vi to_int(vf x) { return (int32_t)x; }
INLINE vf load(const float *p) { return *p; }
INLINE void store(float *p, vf x) { *p = x; }
INLINE vm lt(vf a, vf b) { return a < b; }
INLINE vm le(vf a, vf b) { return a <= b; }
INLINE vm eq(vf a, vf b) { return a == b; }
INLINE vm lti(vi a, vi b) { return a < b; }
INLINE vm eqi(vi a, vi b) { return a == b; }
INLINE vm and_(vm a, vm b) { return a & b; }
INLINE vm or_(vm a, vm b) { return a | b; }
INLINE vm not_(vm a) { return !a; }
INLINE int any(vm m) { return m; }
INLINE vf sel(vm m, vf a, vf b) { return m ? a : b; }
INLINE vi seli(vm m, vi a, vi b) { return m ? a : b; }
#if defined(__SSE2__)
/* As instructions: of the comparisons that a clamp is made of GCC makes branches, which
 * nobody can guess. The number stays where it is, in the lowest lane; to GCC
 * _mm_set_ss is an instruction. */
INLINE __m128 alone_(vf x) {
#ifdef __clang__
  return _mm_set_ss(x);
#else
  __m128 v;
  __asm__("" : "=x"(v) : "0"(x));
  return v;
#endif
}
INLINE vf vmin(vf a, vf b) { return _mm_cvtss_f32(_mm_min_ss(alone_(a), alone_(b))); }
INLINE vf vmax(vf a, vf b) { return _mm_cvtss_f32(_mm_max_ss(alone_(a), alone_(b))); }
#else
INLINE vf vmin(vf a, vf b) { return a < b ? a : b; }
INLINE vf vmax(vf a, vf b) { return a > b ? a : b; }
#endif
#if defined(SOZAI_ISA_AVX512)
INLINE vf sel_lt(vf a, vf b, vf x, vf y) {
  __mmask8 m = _mm_cmp_ss_mask(alone_(a), alone_(b), _CMP_LT_OQ);
  return _mm_cvtss_f32(_mm_mask_move_ss(alone_(y), m, alone_(y), alone_(x)));
}
#define SEL_LT_
#elif defined(__SSE2__)
INLINE vf sel_lt(vf a, vf b, vf x, vf y) {
  __m128 m = _mm_cmplt_ss(alone_(a), alone_(b));
  return _mm_cvtss_f32(_mm_or_ps(_mm_and_ps(m, alone_(x)), _mm_andnot_ps(m, alone_(y))));
}
#define SEL_LT_
#endif
INLINE vf vsqrt(vf a) { return __builtin_sqrtf(a); }
INLINE vf gather(const float *t, vi i) { return t[i]; }
INLINE vi gatheri(const int32_t *t, vi i) { return t[i]; }
INLINE vf lookup16(const float *t, vu i) { return t[i & 15]; }
INLINE vf lookup8(const float *t, vu i) { return t[i & 7]; }
INLINE void gather2(const float (*t)[2], vi i, vf out[2]) {
  for (int c = 0; c < 2; c++) out[c] = t[i][c];
}
INLINE void gather4(const float (*t)[4], vi i, vf out[4]) {
  for (int c = 0; c < 4; c++) out[c] = t[i][c];
}
INLINE vf sel_top(vu m, vf a, vf b) { return m >> 31 ? a : b; }
#if defined(SOZAI_ISA_AVX2) || defined(SOZAI_ISA_AVX512)
INLINE vf ROUND_DOWN_(vf x) {
  __m128 v = alone_(x);
  return _mm_cvtss_f32(_mm_floor_ss(v, v));
}
#define ROUND_DOWN_ ROUND_DOWN_
#endif
#if defined(SOZAI_ISA_AVX512)
/* beside the rounding, not after it */
INLINE vi WHOLE_DOWN_(vf x) {
  return _mm_cvt_roundss_i32(alone_(x), _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}
#define WHOLE_DOWN_ WHOLE_DOWN_
#endif

/* Work of one point that is the same eight times over, in eight lanes: each
 * does what a lane would in its turn. */
#if defined(__AVX2__)
#define WITHIN_A_POINT
typedef float f4 __attribute__((vector_size(16)));
typedef int32_t i4 __attribute__((vector_size(16)));
typedef uint32_t u4 __attribute__((vector_size(16)));
typedef float f8 __attribute__((vector_size(32)));
typedef int32_t i8 __attribute__((vector_size(32)));
typedef uint32_t u8 __attribute__((vector_size(32)));

INLINE f4 all_f4(float x) { return (f4){x, x, x, x}; }
INLINE f4 load_f4(const float *p) { return (f4)_mm_loadu_ps(p); }
INLINE u4 load_u4(const uint32_t *p) {
  return (u4)_mm_loadu_si128((const __m128i *)(const void *)p);
}
INLINE f4 floor_f4(f4 x, i4 *whole) {
  f4 f = (f4)_mm_floor_ps((__m128)x);
  *whole = __builtin_convertvector(f, i4);
  return f;
}
INLINE f4 to_f4(i4 x) { return __builtin_convertvector(x, f4); }
INLINE f4 max_f4(f4 a, f4 b) { return (f4)_mm_max_ps((__m128)a, (__m128)b); }
/* The even lanes of a and the odd ones of b. */
INLINE f4 even_odd(f4 a, f4 b) { return (f4)_mm_blend_ps((__m128)a, (__m128)b, 0xa); }
/* a - b in the even lanes, a + b in the odd ones. */
INLINE f4 less_more(f4 a, f4 b) { return (f4)_mm_addsub_ps((__m128)a, (__m128)b); }
/* The sums of a's pairs of lanes, and of b's. */
INLINE f4 pairs_f4(f4 a, f4 b) { return (f4)_mm_hadd_ps((__m128)a, (__m128)b); }

INLINE f8 join_f4(f4 a, f4 b) { return (f8)_mm256_set_m128((__m128)b, (__m128)a); }
INLINE u8 join_u4(u4 a, u4 b) { return (u8)_mm256_set_m128i((__m128i)b, (__m128i)a); }
INLINE f4 half_f8(f8 a, int upper) {
  return upper ? (f4)_mm256_extractf128_ps((__m256)a, 1) : (f4)_mm256_castps256_ps128((__m256)a);
}
/* Every even lane's neighbour; and in each half the third lane in place of the first. */
INLINE f8 next_f8(f8 a) { return (f8)_mm256_movehdup_ps((__m256)a); }
INLINE f8 second_f8(f8 a) { return (f8)_mm256_permute_ps((__m256)a, 0x4e); }
INLINE f8 to_f8(i8 x) { return __builtin_convertvector(x, f8); }
INLINE f8 clamp01_f8(f8 x) {
  return (f8)_mm256_min_ps(_mm256_max_ps((__m256)x, _mm256_setzero_ps()), _mm256_set1_ps(1.0f));
}
INLINE f8 lookup8_f8(const float *t, u8 i) {
  return (f8)_mm256_permutevar8x32_ps(_mm256_loadu_ps(t), (__m256i)i);
}
#endif

#else

/* ---- several ---------------------------------------------------------- */

typedef float vf __attribute__((vector_size(4 * LANES)));
typedef int32_t vi __attribute__((vector_size(4 * LANES)));
typedef uint32_t vu __attribute__((vector_size(4 * LANES)));

#if LANES == 4
#define SPLAT_(T, x) ((T){(x), (x), (x), (x)})
#elif LANES == 8
#define SPLAT_(T, x) ((T){(x), (x), (x), (x), (x), (x), (x), (x)})
#elif LANES == 16
#define SPLAT_(T, x)                                                                               \
  ((T){(x), (x), (x), (x), (x), (x), (x), (x), (x), (x), (x), (x), (x), (x), (x), (x)})
#endif

INLINE vf splat(float x) { return SPLAT_(vf, x); }
INLINE vi splati(int32_t x) { return SPLAT_(vi, x); }
INLINE vu splatu(uint32_t x) { return SPLAT_(vu, x); }

INLINE float lane(vf v, uint32_t k) { return v[k]; }
INLINE void set_lane(vf *v, uint32_t k, float x) { (*v)[k] = x; }
INLINE vi bits_of(vf x) { return (vi)x; }
INLINE vf float_of(vi x) { return (vf)x; }
INLINE vf to_float(vi x) { return __builtin_convertvector(x, vf); }
/* Towards zero; |x| < 2^31, or the result is the machine's own. */
INLINE vi to_int(vf x) { return __builtin_convertvector(x, vi); }

/* Numbers, and no more than that: what writes them by memcpy may have written anything, and every
 * pointer would be read again. */
typedef float vf_at_ __attribute__((vector_size(4 * LANES), aligned(4)));
INLINE vf load(const float *p) { return *(const vf_at_ *)p; }
INLINE void store(float *p, vf x) { *(vf_at_ *)p = x; }

/* ---- masks ------------------------------------------------------------ */

#if defined(SOZAI_ISA_AVX512) && LANES == 16
typedef __mmask16 vm;
#define CMP_(a, b, op) _mm512_cmp_ps_mask((__m512)(a), (__m512)(b), op)
INLINE vf sel(vm m, vf a, vf b) { return (vf)_mm512_mask_blend_ps(m, (__m512)b, (__m512)a); }
INLINE vi seli(vm m, vi a, vi b) { return (vi)_mm512_mask_blend_epi32(m, (__m512i)b, (__m512i)a); }
INLINE vm lti(vi a, vi b) { return _mm512_cmplt_epi32_mask((__m512i)a, (__m512i)b); }
INLINE vm eqi(vi a, vi b) { return _mm512_cmpeq_epi32_mask((__m512i)a, (__m512i)b); }
#define MASK_ALL_ 0xffffu
#elif defined(SOZAI_ISA_AVX512) && LANES == 4
typedef __mmask8 vm;
#define CMP_(a, b, op) _mm_cmp_ps_mask((__m128)(a), (__m128)(b), op)
INLINE vf sel(vm m, vf a, vf b) { return (vf)_mm_mask_blend_ps(m, (__m128)b, (__m128)a); }
INLINE vi seli(vm m, vi a, vi b) { return (vi)_mm_mask_blend_epi32(m, (__m128i)b, (__m128i)a); }
INLINE vm lti(vi a, vi b) { return _mm_cmplt_epi32_mask((__m128i)a, (__m128i)b); }
INLINE vm eqi(vi a, vi b) { return _mm_cmpeq_epi32_mask((__m128i)a, (__m128i)b); }
#define MASK_ALL_ 0xfu
#else
typedef vi vm;
#endif

#ifdef MASK_ALL_
INLINE vm lt(vf a, vf b) { return CMP_(a, b, _CMP_LT_OQ); }
INLINE vm le(vf a, vf b) { return CMP_(a, b, _CMP_LE_OQ); }
INLINE vm eq(vf a, vf b) { return CMP_(a, b, _CMP_EQ_OQ); }
INLINE vm and_(vm a, vm b) { return (vm)(a & b); }
INLINE vm or_(vm a, vm b) { return (vm)(a | b); }
INLINE vm not_(vm a) { return (vm)(~a & MASK_ALL_); }
INLINE int any(vm m) { return m != 0; }
#else
INLINE vm lt(vf a, vf b) { return a < b; }
INLINE vm le(vf a, vf b) { return a <= b; }
INLINE vm eq(vf a, vf b) { return a == b; }
INLINE vm lti(vi a, vi b) { return a < b; }
INLINE vm eqi(vi a, vi b) { return a == b; }
INLINE vm and_(vm a, vm b) { return a & b; }
INLINE vm or_(vm a, vm b) { return a | b; }
INLINE vm not_(vm a) { return ~a; }
INLINE vi seli(vm m, vi a, vi b) { return (a & m) | (b & ~m); }
#if defined(SOZAI_ISA_AVX2) && LANES == 8
INLINE vf sel(vm m, vf a, vf b) {
  return (vf)_mm256_blendv_ps((__m256)b, (__m256)a, (__m256)(vf)m);
}
INLINE int any(vm m) { return _mm256_movemask_ps((__m256)(vf)m) != 0; }
#elif defined(SOZAI_ISA_AVX2) && LANES == 4
INLINE vf sel(vm m, vf a, vf b) { return (vf)_mm_blendv_ps((__m128)b, (__m128)a, (__m128)(vf)m); }
INLINE int any(vm m) { return _mm_movemask_ps((__m128)(vf)m) != 0; }
#else
INLINE vf sel(vm m, vf a, vf b) { return (vf)(((vi)a & m) | ((vi)b & ~m)); }
#if defined(SOZAI_ISA_SSE2)
INLINE int any(vm m) { return _mm_movemask_ps((__m128)(vf)m) != 0; }
#else
INLINE int any(vm m) {
  int32_t r = 0;
  for (int i = 0; i < LANES; i++) r |= m[i];
  return r != 0;
}
#endif
#endif
#endif

/* ---- minimum, maximum, root ------------------------------------------- */

#if defined(SOZAI_ISA_AVX512) && LANES == 16
INLINE vf vmin(vf a, vf b) { return (vf)_mm512_min_ps((__m512)a, (__m512)b); }
INLINE vf vmax(vf a, vf b) { return (vf)_mm512_max_ps((__m512)a, (__m512)b); }
INLINE vf vsqrt(vf a) { return (vf)_mm512_sqrt_ps((__m512)a); }
#elif defined(SOZAI_ISA_AVX2) && LANES == 8
INLINE vf vmin(vf a, vf b) { return (vf)_mm256_min_ps((__m256)a, (__m256)b); }
INLINE vf vmax(vf a, vf b) { return (vf)_mm256_max_ps((__m256)a, (__m256)b); }
INLINE vf vsqrt(vf a) { return (vf)_mm256_sqrt_ps((__m256)a); }
#elif LANES == 4 && !defined(SOZAI_ISA_NEON)
INLINE vf vmin(vf a, vf b) { return (vf)_mm_min_ps((__m128)a, (__m128)b); }
INLINE vf vmax(vf a, vf b) { return (vf)_mm_max_ps((__m128)a, (__m128)b); }
INLINE vf vsqrt(vf a) { return (vf)_mm_sqrt_ps((__m128)a); }
#else
INLINE vf vmin(vf a, vf b) { return sel(lt(a, b), a, b); }
INLINE vf vmax(vf a, vf b) { return sel(lt(b, a), a, b); }
INLINE vf vsqrt(vf a) {
  vf r = a;
  for (int i = 0; i < LANES; i++) r[i] = __builtin_sqrtf(a[i]);
  return r;
}
#endif

/* ---- rounding ---------------------------------------------------------- */

#if defined(SOZAI_ISA_AVX512) && LANES == 16
#define ROUND_DOWN_(x) ((vf)_mm512_roundscale_ps((__m512)(x), _MM_FROUND_FLOOR | _MM_FROUND_NO_EXC))
/* beside the rounding, not after it */
#define WHOLE_DOWN_(x)                                                                             \
  ((vi)_mm512_cvt_roundps_epi32((__m512)(x), _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC))
#elif defined(SOZAI_ISA_AVX2) && LANES == 8
#define ROUND_DOWN_(x) ((vf)_mm256_floor_ps((__m256)(x)))
#elif (defined(SOZAI_ISA_AVX2) || defined(SOZAI_ISA_AVX512)) && LANES == 4
#define ROUND_DOWN_(x) ((vf)_mm_floor_ps((__m128)(x)))
#endif

/* ---- tables ----------------------------------------------------------- */

#if defined(SOZAI_ISA_AVX512) && LANES == 16
INLINE vf gather(const float *t, vi i) { return (vf)_mm512_i32gather_ps((__m512i)i, t, 4); }
INLINE vi gatheri(const int32_t *t, vi i) { return (vi)_mm512_i32gather_epi32((__m512i)i, t, 4); }
INLINE vf lookup16(const float *t, vu i) {
  return (vf)_mm512_permutexvar_ps((__m512i)i, _mm512_loadu_ps(t));
}
INLINE vf lookup8(const float *t, vu i) {
  __m256d row = _mm256_castps_pd(_mm256_loadu_ps(t));
  return (vf)_mm512_permutexvar_ps((__m512i)i, _mm512_castpd_ps(_mm512_broadcast_f64x4(row)));
}
#define LOOKUP16_
/* Pairs of numbers are gathered as one of twice the size: half the loads. i: of pairs. */
INLINE void gather_pairs_(const float *t, vi i, vf out[2]) {
  __m256i low = _mm512_castsi512_si256((__m512i)i), high = _mm512_extracti64x4_epi64((__m512i)i, 1);
  __m512 a = _mm512_castpd_ps(_mm512_i32gather_pd(low, t, 8));
  __m512 b = _mm512_castpd_ps(_mm512_i32gather_pd(high, t, 8));
  const vi even = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30};
  out[0] = (vf)_mm512_permutex2var_ps(a, (__m512i)even, b);
  out[1] = (vf)_mm512_permutex2var_ps(a, (__m512i)(even + splati(1)), b);
}
INLINE void gather2(const float (*t)[2], vi i, vf out[2]) { gather_pairs_(t[0], i, out); }
INLINE void gather4(const float (*t)[4], vi i, vf out[4]) {
  for (int c = 0; c < 4; c += 2) gather_pairs_(t[0] + c, i + i, out + c);
}
#define GATHER_ROWS_
#elif defined(SOZAI_ISA_AVX2) && LANES == 8
INLINE vf gather(const float *t, vi i) { return (vf)_mm256_i32gather_ps(t, (__m256i)i, 4); }
INLINE vi gatheri(const int32_t *t, vi i) { return (vi)_mm256_i32gather_epi32(t, (__m256i)i, 4); }
INLINE vf lookup16(const float *t, vu i) {
  __m256 a = _mm256_permutevar8x32_ps(_mm256_loadu_ps(t), (__m256i)i);
  __m256 b = _mm256_permutevar8x32_ps(_mm256_loadu_ps(t + 8), (__m256i)i);
  return (vf)_mm256_blendv_ps(a, b, (__m256)(i << 28));
}
INLINE vf lookup8(const float *t, vu i) {
  return (vf)_mm256_permutevar8x32_ps(_mm256_loadu_ps(t), (__m256i)i);
}
#define LOOKUP16_
/* Whole rows of a table are loaded and transposed: gathers are slow on many. */
INLINE __m256 pair_(const float *a, const float *b) {
  return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(a)), _mm_loadu_ps(b), 1);
}
INLINE void gather4(const float (*t)[4], vi i, vf out[4]) {
  int32_t k[8];
  memcpy(k, &i, sizeof k);
  __m256 r0 = pair_(t[k[0]], t[k[4]]), r1 = pair_(t[k[1]], t[k[5]]);
  __m256 r2 = pair_(t[k[2]], t[k[6]]), r3 = pair_(t[k[3]], t[k[7]]);
  __m256d a = (__m256d)_mm256_unpacklo_ps(r0, r1), b = (__m256d)_mm256_unpackhi_ps(r0, r1);
  __m256d c = (__m256d)_mm256_unpacklo_ps(r2, r3), d = (__m256d)_mm256_unpackhi_ps(r2, r3);
  out[0] = (vf)_mm256_unpacklo_pd(a, c);
  out[1] = (vf)_mm256_unpackhi_pd(a, c);
  out[2] = (vf)_mm256_unpacklo_pd(b, d);
  out[3] = (vf)_mm256_unpackhi_pd(b, d);
}
INLINE void gather2(const float (*t)[2], vi i, vf out[2]) {
  int32_t k[8];
  double v[8];
  memcpy(k, &i, sizeof k);
  for (int c = 0; c < 8; c++) memcpy(&v[c], t[k[c]], sizeof v[c]);
  __m256 a = (__m256)_mm256_set_pd(v[5], v[4], v[1], v[0]);
  __m256 b = (__m256)_mm256_set_pd(v[7], v[6], v[3], v[2]);
  out[0] = (vf)_mm256_shuffle_ps(a, b, 0x88);
  out[1] = (vf)_mm256_shuffle_ps(a, b, 0xdd);
}
#define GATHER_ROWS_
#else
INLINE vf gather(const float *t, vi i) {
  vf r = splat(0.0f);
  for (int k = 0; k < LANES; k++) r[k] = t[i[k]];
  return r;
}
INLINE vi gatheri(const int32_t *t, vi i) {
  vi r = splati(0);
  for (int k = 0; k < LANES; k++) r[k] = t[i[k]];
  return r;
}
#endif

/* From a table of 16, by the lowest four bits; from one of 8, by three. */
#ifndef LOOKUP16_
INLINE vf lookup16(const float *t, vu i) { return gather(t, (vi)(i & splatu(15))); }
INLINE vf lookup8(const float *t, vu i) { return gather(t, (vi)(i & splatu(7))); }
#endif

/* All of a row of a table. */
#ifndef GATHER_ROWS_
INLINE void gather2(const float (*t)[2], vi i, vf out[2]) {
  for (int c = 0; c < 2; c++) out[c] = gather(t[0] + c, i << 1);
}
INLINE void gather4(const float (*t)[4], vi i, vf out[4]) {
  for (int c = 0; c < 4; c++) out[c] = gather(t[0] + c, i << 2);
}
#endif

/* a where m's top bit is set. */
#if defined(SOZAI_ISA_AVX2) && LANES == 8
INLINE vf sel_top(vu m, vf a, vf b) {
  return (vf)_mm256_blendv_ps((__m256)b, (__m256)a, (__m256)m);
}
#else
INLINE vf sel_top(vu m, vf a, vf b) { return sel(lti((vi)m, splati(0)), a, b); }
#endif

#endif /* several lanes */

/* ---- for any number of lanes ------------------------------------------ */

/* Whether a small piece of work is for nobody. With many lanes somebody nearly
 * always wants it, and a branch that guesses wrong costs more than the work. */
INLINE int idle(vm m) { return LANES < 4 && !any(m); }

INLINE vm gt(vf a, vf b) { return lt(b, a); }

/* x where a < b, else y: for where a point alone could not guess which. */
#ifndef SEL_LT_
INLINE vf sel_lt(vf a, vf b, vf x, vf y) { return sel(lt(a, b), x, y); }
#endif

/* Whether all lanes hold the same number. Never with one lane, which has nothing to
 * share. */
INLINE int alike(vi i) {
#if LANES == 1
  (void)i;
  return 0;
#elif defined(SOZAI_ISA_AVX512) && LANES == 16
  __m512i first = _mm512_broadcastd_epi32(_mm512_castsi512_si128((__m512i)i));
  return _mm512_cmpneq_epi32_mask((__m512i)i, first) == 0;
#elif defined(SOZAI_ISA_AVX2) && LANES == 8
  __m256i first = _mm256_broadcastd_epi32(_mm256_castsi256_si128((__m256i)i));
  return _mm256_movemask_ps((__m256)_mm256_cmpeq_epi32((__m256i)i, first)) == 255;
#elif !defined(SOZAI_ISA_NEON) && LANES == 4
  __m128i first = _mm_shuffle_epi32((__m128i)i, 0);
  return _mm_movemask_ps((__m128)_mm_cmpeq_epi32((__m128i)i, first)) == 15;
#else
  int32_t differ = 0;
  for (int k = 1; k < LANES; k++) differ |= i[k] ^ i[0];
  return !differ;
#endif
}

/* Whether all lanes hold that number. */
INLINE int all_are(vi i, int32_t x) {
#if defined(SOZAI_ISA_AVX512) && LANES == 16
  return _mm512_cmpneq_epi32_mask((__m512i)i, _mm512_set1_epi32(x)) == 0;
#else
  return !any(not_(eqi(i, splati(x))));
#endif
}

/* What one lane holds, for all: by way of memory, whence a wide unit loads it into every
 * lane at no cost to the ports that calculate. The compiler would rather permute. HOLDS: where it
 * pays if it is held for several blocks; SPREADS: even for one. */
#if (defined(SOZAI_ISA_AVX512) && LANES == 16) || (defined(SOZAI_ISA_AVX2) && LANES == 8)
#define HOLDS
typedef struct {
  float of[LANES] __attribute__((aligned(4 * LANES)));
} spread;

INLINE spread spread_of(vf x) {
  spread s;
  store(s.of, x);
  __asm__("" : "+m"(s));
  return s;
}
#endif
/* Every even lane's neighbour; in each four the third lane in place of all; and the upper two in
 * place of the lower. */
#if defined(SOZAI_ISA_AVX512) && LANES == 16
#define SPREADS
INLINE vf next_lane(vf x) { return (vf)_mm512_movehdup_ps((__m512)x); }
INLINE vf third_lane(vf x) { return (vf)_mm512_permute_ps((__m512)x, 0xaa); }
INLINE vf upper_lanes(vf x) { return (vf)_mm512_permute_ps((__m512)x, 0xee); }
#elif defined(HOLDS)
INLINE vf next_lane(vf x) { return (vf)_mm256_movehdup_ps((__m256)x); }
INLINE vf third_lane(vf x) { return (vf)_mm256_permute_ps((__m256)x, 0xaa); }
#endif

/* gather2 and gather4 where lanes mostly ask for the same row. */
INLINE void gather2_near(const float (*t)[2], vi i, vf out[2]) {
#if LANES > 1
  if (alike(i)) {
    const float *row = t[i[0]];
    for (int c = 0; c < 2; c++) out[c] = splat(row[c]);
    return;
  }
#endif
  gather2(t, i, out);
}
INLINE void gather4_near(const float (*t)[4], vi i, vf out[4]) {
#if LANES > 1
  if (alike(i)) {
    const float *row = t[i[0]];
    for (int c = 0; c < 4; c++) out[c] = splat(row[c]);
    return;
  }
#endif
  gather4(t, i, out);
}

/* With one lane the compiler takes what is done to a number's bits to the unit for whole
 * numbers and back, which takes six cycles more. */
#if LANES == 1 && defined(__SSE2__)
INLINE __m128 bits1_(int32_t x) { return _mm_castsi128_ps(_mm_cvtsi32_si128(x)); }
INLINE vf vabs(vf a) { return _mm_cvtss_f32(_mm_and_ps(alone_(a), bits1_(0x7fffffff))); }
/* a, which has no sign, with that of b. */
INLINE vf signed_as(vf a, vf b) {
  return _mm_cvtss_f32(_mm_or_ps(alone_(a), _mm_and_ps(alone_(b), bits1_(INT32_MIN))));
}
#else
INLINE vf vabs(vf a) { return float_of(bits_of(a) & splati(0x7fffffff)); }
INLINE vf signed_as(vf a, vf b) { return float_of(bits_of(a) | (bits_of(b) & splati(INT32_MIN))); }
#endif
INLINE vf clamp(vf x, vf lo, vf hi) { return vmin(vmax(x, lo), hi); }
INLINE vf clamp01(vf x) { return vmin(vmax(x, splat(0.0f)), splat(1.0f)); }
/* a where t = 0, b where t = 1. */
INLINE vf mix(vf a, vf b, vf t) { return a + (b - a) * t; }

/* The greatest whole number not above x, as a number and as an integer;
 * |x| < 2^31. It has the sign of x, be it -0, as the unit's own rounding keeps it;
 * SSE2 has no rounding. */
INLINE vf vfloor(vf x, vi *whole) {
#if defined(WHOLE_DOWN_)
  *whole = WHOLE_DOWN_(x);
  return ROUND_DOWN_(x);
#elif defined(ROUND_DOWN_)
  vf f = ROUND_DOWN_(x);
  *whole = to_int(f);
  return f;
#else
  vi i = to_int(x);
  vf f = to_float(i);
  vm above = gt(f, x);
  *whole = seli(above, i - splati(1), i);
  f = sel(above, f - splat(1.0f), f);
  return float_of(bits_of(f) | (bits_of(x) & splati(INT32_MIN)));
#endif
}

/* vfloor of x + 1/2, which is never -0. */
INLINE vf vnearest(vf x, vi *whole) {
  vf up = x + splat(0.5f);
#if defined(WHOLE_DOWN_) && LANES > 1
  *whole = WHOLE_DOWN_(up);
  return to_float(*whole);
#else
  return vfloor(up, whole);
#endif
}

/* x with its sign changed where bit `bit` of k is set. */
INLINE vf flip_by_bit(vf x, vi k, int bit) {
#if defined(SOZAI_ISA_AVX512) && LANES == 16
  return (vf)_mm512_ternarylogic_epi32((__m512i)x, (__m512i)(k << (31 - bit)),
                                       _mm512_set1_epi32(INT32_MIN), 0x78); /* a ^ (b & c) */
#elif LANES == 1 && defined(__SSE2__)
  return _mm_cvtss_f32(_mm_xor_ps(alone_(x), bits1_((k & 1 << bit) << (31 - bit))));
#else
  return float_of(bits_of(x) ^ ((k & splati(1 << bit)) << (31 - bit)));
#endif
}

/* a where x is odd, else b. */
INLINE vf sel_odd(vi x, vf a, vf b) {
#if defined(SOZAI_ISA_AVX512) && LANES == 16
  return sel(_mm512_test_epi32_mask((__m512i)x, _mm512_set1_epi32(1)), a, b);
#elif LANES == 1 && defined(__SSE2__)
  __m128 m = _mm_castsi128_ps(_mm_cvtsi32_si128(-(x & 1))); /* as in sel_lt */
  return _mm_cvtss_f32(_mm_or_ps(_mm_and_ps(m, alone_(a)), _mm_andnot_ps(m, alone_(b))));
#else
  return sel(eqi(x & splati(1), splati(1)), a, b);
#endif
}

#endif
