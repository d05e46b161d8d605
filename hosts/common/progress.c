/* SPDX-License-Identifier: Apache-2.0 */
#include "progress.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define BAR_WIDTH 40

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static int shown = -1; /* the percentage on the screen; -1: no bar */

void progress_show(float fraction, const char *what) {
  if (!isatty(STDERR_FILENO)) return;
  if (pthread_mutex_trylock(&lock) != 0) return; /* another thread is printing: as good */
  float clamped = fraction < 0 ? 0 : fraction > 1 ? 1 : fraction;
  int percent = (int)(clamped * 100);
  if (percent != shown) {
    char bar[BAR_WIDTH + 1];
    int filled = (int)(clamped * BAR_WIDTH);
    memset(bar, ' ', BAR_WIDTH);
    memset(bar, '#', (size_t)filled);
    bar[BAR_WIDTH] = '\0';
    fprintf(stderr, "\r\033[K[%s] %3d%% %s", bar, percent, what ? what : "");
    fflush(stderr);
    shown = percent;
  }
  pthread_mutex_unlock(&lock);
}

void progress_clear(void) {
  pthread_mutex_lock(&lock);
  if (shown >= 0) fputs("\r\033[K", stderr);
  shown = -1;
  pthread_mutex_unlock(&lock);
}
