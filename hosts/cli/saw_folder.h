/* SPDX-License-Identifier: Apache-2.0
 * A folder of files that appear together, once all of them are whole. */
#ifndef SOZAI_CLI_SAW_FOLDER_H
#define SOZAI_CLI_SAW_FOLDER_H

#include <stdio.h>
#include "failure.h"

#define FOLDER_PATH 4096

typedef struct saw_folder {
  char path[FOLDER_PATH];    /* where the files will be */
  char working[FOLDER_PATH]; /* where they are until then; "": nowhere */
  bool existed;              /* path did, before */
} saw_folder;

/* Also checks that it can be written, before any work is done. */
bool saw_folder_begin(saw_folder *f, const char *path, failure *why);
/* Where to write a file of that name. */
bool saw_folder_file(const saw_folder *f, const char *name, char out[FOLDER_PATH], failure *why);
/* Give the files their names, over those of an earlier plan, whose further
 * boards go. Ends the folder either way. */
bool saw_folder_commit(saw_folder *f, failure *why);
/* Forget the files. Harmless after a commit. */
void saw_folder_discard(saw_folder *f);

#endif
