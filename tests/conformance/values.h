/* SPDX-License-Identifier: Apache-2.0
 *
 * Values of parameters from text.
 */
#ifndef SOZAI_TESTS_VALUES_H
#define SOZAI_TESTS_VALUES_H

#include "sozai.h"

/* "id=text; id=text": the first `most` of them, which stay in the text. How many. */
uint32_t values_split(char *text, sozai_value *to, uint32_t most);

#endif
