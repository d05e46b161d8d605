/* SPDX-License-Identifier: Apache-2.0 */
#include "bounded.h"

#include <stdatomic.h>
#include "fuzz.h"

static bounded_limits now;
static atomic_size_t held;
static atomic_uint calls, blocks;

static void *take(void *user, size_t size, size_t align) {
  (void)user;
  CHECK(align && (align & (align - 1)) == 0);
  if (size > now.bytes || atomic_fetch_add(&held, size) + size > now.bytes) {
    if (size <= now.bytes) atomic_fetch_sub(&held, size);
    return NULL;
  }
  atomic_fetch_add(&blocks, 1);
  void *memory = NULL;
  /* the very size, so that the byte behind is nobody's */
  CHECK(posix_memalign(&memory, align < sizeof(void *) ? sizeof(void *) : align, size ? size : 1) ==
        0);
  return memory;
}

static void give_back(void *user, void *memory, size_t size, size_t align) {
  (void)user, (void)align;
  atomic_fetch_sub(&blocks, 1);
  CHECK(atomic_fetch_sub(&held, size) >= size);
  free(memory);
}

static int32_t progress(void *user, float fraction, const char *what) {
  (void)user;
  CHECK(fraction >= 0 && fraction <= 1 && what);
  return atomic_fetch_add(&calls, 1) >= now.calls;
}

const sozai_host bounded_host = {
    .size = sizeof(sozai_host), .alloc = take, .free = give_back, .progress = progress};

void bounded_begin(const bounded_limits *limits) {
  now = *limits;
  atomic_store(&calls, 0);
}

void bounded_end(void) { CHECK(atomic_load(&blocks) == 0 && atomic_load(&held) == 0); }
