/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_HOSTS_UTF8_H
#define SOZAI_HOSTS_UTF8_H

/* Bytes of the UTF-8 character at s, or 0 when it is none, or cut off by the text's end. Overlong
 * forms and surrogates are none. */
int utf8_length(const unsigned char *s);

#endif
