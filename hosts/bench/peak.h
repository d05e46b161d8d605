/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_BENCH_PEAK_H
#define SOZAI_BENCH_PEAK_H

typedef struct peak {
  int lanes;
  double gops; /* single-precision operations a nanosecond, on one core */
} peak;

/* The most multiplications and additions that this core was seen to do with an
 * instruction set, none waiting for another: measured at each asking, and the
 * best so far given. {0} for one that it lacks, or an unknown name. */
peak peak_of(const char *instruction_set);

#endif
