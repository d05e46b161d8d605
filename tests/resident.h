/* SPDX-License-Identifier: Apache-2.0
 *
 * How much memory this process holds, exactly. The sizes in statm and status
 * are sums of each processor's own counter and may be some hundred KiB off;
 * smaps_rollup walks the pages. */
#ifndef SOZAI_TESTS_RESIDENT_H
#define SOZAI_TESTS_RESIDENT_H

#include <stdio.h>

/* KiB of memory of its own: no pages of files. -1 where the system does not say. */
static inline long resident_kib(void) {
  FILE *f = fopen("/proc/self/smaps_rollup", "r");
  if (!f) return -1;
  char line[256];
  long size = -1;
  while (size < 0 && fgets(line, sizeof line, f))
    if (sscanf(line, "Anonymous: %ld kB", &size) != 1) size = -1;
  fclose(f);
  return size;
}

#endif
