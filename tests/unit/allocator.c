/* SPDX-License-Identifier: Apache-2.0 */
#include "allocator.h"

#include <stdlib.h>
#include <string.h>

#define MARK 0x50f7a110c8ed5a1eu
#define GUARD 64u

/* Before every block: what was asked for. After it: a guard. */
typedef struct {
  uint64_t mark, size, align;
  void *whole;
} head;

static void *take(void *user, size_t size, size_t align) {
  allocator *a = user;
  a->calls++;
  if (a->calls == a->fail_at || (a->fail_on && a->calls >= a->fail_on)) return NULL;
  char *whole = malloc(sizeof(head) + align + size + GUARD);
  if (!whole) return NULL;
  char *at = whole + sizeof(head);
  at += (align - (uintptr_t)at % align) % align;
  head h = {MARK, size, align, whole};
  memcpy(at - sizeof h, &h, sizeof h);
  memset(at, 0xa5, size);
  memset(at + size, 0x5a, GUARD);
  a->live++;
  a->bytes += size;
  return at;
}

static void give_back(void *user, void *memory, size_t size, size_t align) {
  allocator *a = user;
  char *at = memory;
  head h;
  memcpy(&h, at - sizeof h, sizeof h);
  int right = h.mark == MARK && h.size == size && h.align == align;
  for (uint32_t i = 0; right && i < GUARD; i++) right = at[size + i] == 0x5a;
  if (!right) {
    a->wrong++;
    return;
  }
  h.mark = 0;
  memcpy(at - sizeof h, &h, sizeof h);
  a->live--;
  a->bytes -= size;
  free(h.whole);
}

sozai_host allocator_host(allocator *a) {
  memset(a, 0, sizeof *a);
  return (sozai_host){.size = sizeof(sozai_host), .user = a, .alloc = take, .free = give_back};
}
