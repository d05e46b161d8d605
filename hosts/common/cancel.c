/* SPDX-License-Identifier: Apache-2.0 */
#include "cancel.h"

#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static atomic_int requested; /* the signal; lock-free, so allowed in a signal handler */

static void on_signal(int number) {
  atomic_store(&requested, number);
  signal(number, SIG_DFL);
}

static void install(int number) {
  struct sigaction action;
  if (sigaction(number, NULL, &action) == 0 && action.sa_handler == SIG_IGN) return;
  memset(&action, 0, sizeof action);
  action.sa_handler = on_signal; /* no SA_RESTART: a blocked read must wake up */
  sigaction(number, &action, NULL);
}

void cancel_install(void) {
  install(SIGINT);
  install(SIGTERM);
  install(SIGHUP);
}

bool cancel_requested(void) { return atomic_load(&requested) != 0; }

void cancel_end(void) {
  int number = atomic_load(&requested);
  if (!number) return;
  fflush(NULL);
  signal(number, SIG_DFL);
  raise(number);
}
