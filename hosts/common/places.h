/* SPDX-License-Identifier: Apache-2.0
 * Where the libraries that belong to a program are. */
#ifndef SOZAI_HOSTS_PLACES_H
#define SOZAI_HOSTS_PLACES_H

#include <stddef.h>
#include "failure.h"

/* The path of the library of that name that belongs to this program: the first
 * that exists of: ../lib and the install libdir beside the program, so that
 * build trees and moved installations work, then the configured libdir; in
 * each, the library itself or in a folder sozai. [thread-safe] */
bool places_find(char *found, size_t size, const char *name, failure *why);
/* The same for a library that other programs load: beside its file, else in the
 * configured libdir. [thread-safe] */
bool places_find_beside(char *found, size_t size, const char *name, const char *library,
                        failure *why);

#endif
