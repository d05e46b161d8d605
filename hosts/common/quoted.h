/* SPDX-License-Identifier: Apache-2.0
 * Text (UTF-8) in double quotes, as YAML has it: in recipes that the programs write. */
#ifndef SOZAI_HOSTS_QUOTED_H
#define SOZAI_HOSTS_QUOTED_H

#include <stdio.h>

void print_quoted(FILE *to, const char *text);

#endif
