/* SPDX-License-Identifier: Apache-2.0
 * What a file's name ends in, which says its format. */
#ifndef SOZAI_HOSTS_ENDING_H
#define SOZAI_HOSTS_ENDING_H

#include <stdbool.h>

/* ".png" and the like, in capitals or not; a name that is nothing else does not. */
bool ends_in(const char *path, const char *ending);

#endif
