/* SPDX-License-Identifier: Apache-2.0
 * Numbers from text. A dot is the decimal point for everyone, also in a program
 * whose locale has a comma: sozai.imageio.so runs in other people's. */
#ifndef SOZAI_HOSTS_NUMBERS_H
#define SOZAI_HOSTS_NUMBERS_H

#include <stdbool.h>
#include <stddef.h>

/* The whole text must be one finite number. */
bool number_read(const char *text, double *out);
/* Between 1 and `most` finite numbers parted by the character `between`, "x" or
 * ","; how many, or 0 when the text is anything else. */
size_t numbers_read(const char *text, char between, double *out, size_t most);

#endif
