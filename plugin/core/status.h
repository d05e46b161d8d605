/* SPDX-License-Identifier: Apache-2.0
 *
 * Results, messages, and the host's services behind one small face.
 */
#ifndef SOZAI_CORE_STATUS_H
#define SOZAI_CORE_STATUS_H

#include <stddef.h>

#include "../../api/sozai.h"

/* Keep a message for last_error() on this thread, numbers written as in C
 * whatever the locale. Returns code, so that a failure is one line. */
__attribute__((format(printf, 2, 3))) int32_t fail(int32_t code, const char *format, ...);
const char *fail_message(void);

/* A double from text as in the C locale; the whole of [text, end) or 0. */
int read_number(const char *text, const char *end, double *out);

/* Bytes to copy of a struct that the host says is `size` long and this plugin knows `known` bytes
 * of: a member that would be cut in two, half a pointer, is left out. pairs: bit k of it says that
 * two members of four bytes stand at byte 8 k, of which the first alone may be there. */
static inline size_t whole_members(uint32_t size, size_t known, uint64_t pairs) {
  if (size >= known) return known;
  size_t eights = size / 8u;
  return eights * 8u + (size % 8u >= 4u && eights < 64u && pairs >> eights & 1u ? 4u : 0u);
}
/* Bytes of a struct up to a member and with it: what a host of an older minor gives. */
#define SIZE_WITH(type, last) (offsetof(type, last) + sizeof(((type *)0)->last))
#define PAIR_AT(type, first) (1ull << offsetof(type, first) / 8u)

/* The host's members, zero where its struct is older. */
sozai_host host_copy(const sozai_host *host);
/* Zeroed memory, from the host or libc; NULL with the message set. */
void *host_alloc(const sozai_host *host, size_t size, size_t align);
void host_free(const sozai_host *host, void *memory, size_t size, size_t align);
__attribute__((format(printf, 3, 4))) void host_log(const sozai_host *host, int32_t severity,
                                                    const char *format, ...);

/* The C locale object, made by the first init. */
int status_open(void);
void status_close(void);

#endif
