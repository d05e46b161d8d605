/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_HOSTS_FOLDER_H
#define SOZAI_HOSTS_FOLDER_H

#include <stdbool.h>

/* Whether there is a folder of that name now; false: errno says why not. */
bool folder_make(const char *folder);

#endif
