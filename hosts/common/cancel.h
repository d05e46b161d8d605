/* SPDX-License-Identifier: Apache-2.0
 * Ctrl-C (SIGINT), SIGTERM and SIGHUP ask for a clean end; a second one kills. */
#ifndef SOZAI_HOSTS_CANCEL_H
#define SOZAI_HOSTS_CANCEL_H

#include <stdbool.h>

/* A signal that whoever started this has it ignore stays ignored. */
void cancel_install(void);
bool cancel_requested(void);
/* When all is cleaned up: die of the signal that asked, if one did, so that a shell sees that and
 * ends its loop too. */
void cancel_end(void);

#endif
