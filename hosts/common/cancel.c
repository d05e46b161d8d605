/* SPDX-License-Identifier: Apache-2.0 */
#include "cancel.h"

#include <signal.h>
#include <stdatomic.h>
#include <string.h>

static atomic_int requested; /* lock-free, so allowed in a signal handler */

static void on_signal(int number) {
  atomic_store(&requested, 1);
  signal(number, SIG_DFL);
}

void cancel_install(void) {
  struct sigaction action;
  memset(&action, 0, sizeof action);
  action.sa_handler = on_signal; /* no SA_RESTART: a blocked read must wake up */
  sigaction(SIGINT, &action, NULL);
  sigaction(SIGTERM, &action, NULL);
}

bool cancel_requested(void) { return atomic_load(&requested) != 0; }
