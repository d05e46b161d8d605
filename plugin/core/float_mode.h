/* SPDX-License-Identifier: Apache-2.0
 *
 * A thread's rounding and floating-point traps are its program's, and answers
 * do not depend on them: while the plugin works it rounds to nearest and
 * nothing traps. What becomes of denormals stays as it is. Some five cycles where
 * nothing is to be changed, which leaves flags of exceptions raised; where
 * something was, flags too are as they were.
 */
#ifndef SOZAI_CORE_FLOAT_MODE_H
#define SOZAI_CORE_FLOAT_MODE_H

#include <stdint.h>

#if defined(__x86_64__)
#include <immintrin.h>

/* MXCSR: rounding and masks. */
#define FLOAT_MODE_BITS UINT64_C(0x7f80)
#define FLOAT_MODE_WANTED 0x1f80u
static inline uint64_t float_mode_read(void) { return _mm_getcsr(); }
static inline void float_mode_write(uint64_t mode) { _mm_setcsr((uint32_t)mode); }
#elif defined(__aarch64__)
/* FPCR: rounding, and what traps. */
#define FLOAT_MODE_BITS UINT64_C(0xc09f00)
#define FLOAT_MODE_WANTED 0u
static inline uint64_t float_mode_read(void) {
  uint64_t mode;
  __asm__ volatile("mrs %0, fpcr" : "=r"(mode));
  return mode;
}
static inline void float_mode_write(uint64_t mode) {
  __asm__ volatile("msr fpcr, %0" : : "r"(mode) : "memory");
}
#else
#error "the rounding mode of this machine is not known"
#endif

/* Returns what float_mode_leave puts back. */
static inline uint64_t float_mode_enter(void) {
  uint64_t was = float_mode_read();
  if (__builtin_expect((was & FLOAT_MODE_BITS) != FLOAT_MODE_WANTED, 0)) {
    float_mode_write((was & ~FLOAT_MODE_BITS) | FLOAT_MODE_WANTED);
  }
  return was;
}

static inline void float_mode_leave(uint64_t was) {
  if (__builtin_expect((was & FLOAT_MODE_BITS) != FLOAT_MODE_WANTED, 0)) float_mode_write(was);
}

/* The same for the C library's decimal numbers, which on x86 go by the rounding of the x87 unit,
 * that code of our own never uses. */
typedef struct {
  uint64_t mode;
  uint16_t x87;
} float_mode_all;

#if defined(__x86_64__)
#define FLOAT_MODE_X87 0x37fu /* to nearest, 64 bits, nothing traps */
static inline uint16_t float_mode_x87(uint16_t wanted) {
  uint16_t was;
  __asm__ volatile("fnstcw %0" : "=m"(was));
  if (was != wanted) __asm__ volatile("fldcw %0" : : "m"(wanted));
  return was;
}
#else
#define FLOAT_MODE_X87 0u
static inline uint16_t float_mode_x87(uint16_t wanted) { return wanted; }
#endif

static inline float_mode_all float_mode_enter_all(void) {
  float_mode_all was = {float_mode_enter(), float_mode_x87(FLOAT_MODE_X87)};
  return was;
}

static inline void float_mode_leave_all(float_mode_all was) {
  float_mode_x87(was.x87);
  float_mode_leave(was.mode);
}

#endif
