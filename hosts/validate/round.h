/* SPDX-License-Identifier: Apache-2.0
 * A round through every function, for what no call may do. */
#ifndef SOZAI_VALIDATE_ROUND_H
#define SOZAI_VALIDATE_ROUND_H

#include "subject.h"

/* Called after every call, with its name. */
typedef void watcher(const char *call);

/* From init to deinit; the library is loaded and not initialised. grow: also
 * grow what generators there are. */
void every_call(subject *s, bool grow, watcher *watch);

#endif
