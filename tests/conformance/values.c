/* SPDX-License-Identifier: Apache-2.0 */
#include "values.h"

#include <string.h>

uint32_t values_split(char *text, sozai_value *to, uint32_t most) {
  uint32_t count = 0;
  while (*text && count < most) {
    char *equals = strchr(text, '='), *end = strstr(text, "; ");
    if (!equals) break;
    *equals = '\0';
    if (end) *end = '\0';
    to[count++] = (sozai_value){.id = text, .kind = SOZAI_KIND_STRING, .text = equals + 1};
    if (!end) break;
    text = end + 2;
  }
  return count;
}
