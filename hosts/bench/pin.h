/* SPDX-License-Identifier: Apache-2.0
 * Staying on one CPU. */
#ifndef SOZAI_BENCH_PIN_H
#define SOZAI_BENCH_PIN_H

#include <stdbool.h>

/* How many CPUs this process could use when it began. */
int pin_cpu_count(void);
/* Keep the calling thread on one of them: which = 0 is the one that the
 * process stays on, 1 another. False: there is none, or it was refused. */
bool pin_to(int which);
/* Let the calling thread go back to all of them. */
void pin_release(void);

#endif
