/* SPDX-License-Identifier: Apache-2.0
 * The names of files: <UDIM> and <output> in the one that is given. */
#ifndef SOZAI_BAKE_NAMES_H
#define SOZAI_BAKE_NAMES_H

#include <stdbool.h>

/* Allocated; NULL: out of memory. output: NULL where the name has none. */
char *bake_file_name(const char *path, int udim, const char *output);
/* The folder of the pieces, beside the files: NAME.bake, its <UDIM> and
 * <output> without brackets; where that is too long for a name, cut, with a sum. */
char *bake_folder_name(const char *path);
bool bake_has_udim(const char *path);

#endif
