/* SPDX-License-Identifier: Apache-2.0
 * Files that appear under their name only once they are whole. */
#ifndef SOZAI_HOSTS_OUTPUT_FILE_H
#define SOZAI_HOSTS_OUTPUT_FILE_H

#include "failure.h"

typedef struct output_file {
  char *path;    /* where the file will be */
  char *writing; /* the name to write to: hidden, in the same folder, with the ending asked for */
  bool in_place; /* a device or a pipe: written directly, never renamed over or removed */
} output_file;

/* The file that path stands for: where it is a link what that points to, there or not, so
 * that it is replaced and not the link. To be freed; NULL: none can be there, as why says. */
char *output_target(const char *path, failure *why);
/* Also checks that the folder can be written, before hours of work. */
bool output_begin(output_file *o, const char *path, failure *why);
/* Give the file its name. Ends the output either way. */
bool output_commit(output_file *o, failure *why);
/* It could not be written, as why says: forget it, and name the file that was asked
 * for where why names the one that was written to. Always false. */
bool output_failed(output_file *o, failure *why);
/* Forget the file. Harmless after a commit, or on a zeroed struct. */
void output_discard(output_file *o);

/* Whether what was printed to standard output was taken; if not, that is said. */
bool output_printed(failure *why);
/* It was not, as errno says: say so, or nothing of a pipe that nobody reads any more. Always false.
 */
bool output_unprinted(failure *why);

#endif
