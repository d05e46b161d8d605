/* SPDX-License-Identifier: Apache-2.0
 * Whether a text is fit to be shown. */
#ifndef SOZAI_VALIDATE_TEXT_H
#define SOZAI_VALIDATE_TEXT_H

#include <stdbool.h>

/* Well-formed UTF-8. */
bool utf8_valid(const char *text);
/* Without line ends or other controls. */
bool one_line(const char *text);
/* [a-z][a-z0-9_]* and, where `more`, any of those characters too. */
bool id_valid(const char *text, const char *more);

#endif
