/* SPDX-License-Identifier: Apache-2.0
 * The floating-point unit's control words of this thread. */
#ifndef SOZAI_VALIDATE_CONTROL_H
#define SOZAI_VALIDATE_CONTROL_H

#include <stdbool.h>
#include <stdint.h>

/* Rounding, masks, and what becomes of denormals; not the flags that any
 * arithmetic may raise. */
uint64_t control_word(void);
/* Whether flushing of denormals is known on this machine. */
bool control_flushes(void);
/* Flush denormals to zero, read and written; what to restore. */
uint64_t control_flush(void);
void control_restore(uint64_t kept);

#endif
