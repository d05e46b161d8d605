/* SPDX-License-Identifier: Apache-2.0
 * A progress bar on standard error, only when that is a terminal. */
#ifndef SOZAI_HOSTS_PROGRESS_H
#define SOZAI_HOSTS_PROGRESS_H

/* fraction from 0 to 1. From any thread. */
void progress_show(float fraction, const char *what);
/* Wipe the bar: before any other line is printed. */
void progress_clear(void);

#endif
