/* SPDX-License-Identifier: Apache-2.0
 * Who uses a folder of pieces: any number of bakes that add to it, or one alone
 * that throws away, puts together or removes. A file `lock` in it carries the
 * lock, which ends with its process. File systems without locks have none to
 * respect. */
#ifndef SOZAI_BAKE_FOLDER_LOCK_H
#define SOZAI_BAKE_FOLDER_LOCK_H

#include <stdbool.h>
#include "failure.h"

typedef struct folder_lock {
  int file; /* -1: none */
  char *path;
} folder_lock;

/* The folder is made where it is missing and `make` says so. Refused, without
 * waiting, while others' use is in the way. */
bool folder_lock_take(folder_lock *l, const char *folder, bool make, bool alone, failure *why);
/* From one of many to alone. false: others are there, and the lock may be lost. */
bool folder_lock_alone(folder_lock *l);
/* remove: the file too, and the folder where nothing else is in it; alone only. */
void folder_lock_end(folder_lock *l, bool remove);

#endif
