/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_HOSTS_UTF8_H
#define SOZAI_HOSTS_UTF8_H

#include <stdbool.h>
#include <stdint.h>

/* Bytes of the UTF-8 character at s, or 0 when it is none, or cut off by the text's end. Overlong
 * forms and surrogates are none. */
int utf8_length(const unsigned char *s);
/* The character of that length, above 1. */
uint32_t utf8_code(const unsigned char *s, int length);
/* Whether all of a text is. */
bool utf8_whole(const char *text);
/* Whether YAML takes a character beyond ASCII as it stands: no control, and no line's end. */
bool utf8_plain(uint32_t code);

#endif
