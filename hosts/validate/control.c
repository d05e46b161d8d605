/* SPDX-License-Identifier: Apache-2.0 */
#include "control.h"

#include <fenv.h>

#if defined(__x86_64__)
#define FLAGS 0x3fu
#define FLUSH 0x8040u /* FTZ and DAZ */

uint64_t control_word(void) {
  uint16_t x87;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  return (__builtin_ia32_stmxcsr() & ~FLAGS) | (uint64_t)x87 << 32;
}

bool control_flushes(void) { return true; }

uint64_t control_flush(void) {
  uint32_t kept = __builtin_ia32_stmxcsr();
  __builtin_ia32_ldmxcsr(kept | FLUSH);
  return kept;
}

void control_restore(uint64_t kept) { __builtin_ia32_ldmxcsr((uint32_t)kept); }

#elif defined(__aarch64__)

uint64_t control_word(void) {
  uint64_t fpcr;
  __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
  return fpcr;
}

bool control_flushes(void) { return true; }

uint64_t control_flush(void) {
  uint64_t kept = control_word();
  __asm__ volatile("msr fpcr, %0" : : "r"(kept | 1u << 24));
  return kept;
}

void control_restore(uint64_t kept) { __asm__ volatile("msr fpcr, %0" : : "r"(kept)); }

#else

uint64_t control_word(void) { return (uint64_t)fegetround(); }
bool control_flushes(void) { return false; }
uint64_t control_flush(void) { return 0; }
void control_restore(uint64_t kept) { (void)kept; }

#endif
