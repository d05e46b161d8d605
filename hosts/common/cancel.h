/* SPDX-License-Identifier: Apache-2.0
 * Ctrl-C (SIGINT) and SIGTERM ask for a clean end; a second one kills. */
#ifndef SOZAI_HOSTS_CANCEL_H
#define SOZAI_HOSTS_CANCEL_H

#include <stdbool.h>

void cancel_install(void);
bool cancel_requested(void);

#endif
