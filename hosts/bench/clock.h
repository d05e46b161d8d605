/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_BENCH_CLOCK_H
#define SOZAI_BENCH_CLOCK_H

#ifdef __cplusplus
extern "C" {
#endif

/* Nanoseconds that this thread has run: what others do on the machine does not
 * count, though it still takes from caches and clock rate. */
double thread_ns(void);
/* Nanoseconds that have passed. */
double wall_ns(void);

#ifdef __cplusplus
}
#endif

#endif
