/* SPDX-License-Identifier: Apache-2.0 */
#include "memory.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

#include "job.h"

atomic_int_fast64_t live_bytes, live_blocks;

static void *take(void *user, size_t size, size_t align) {
  soak_host *h = user;
  if (++h->calls == h->fail_at) return NULL;
  void *p = aligned_alloc(align, (size + align - 1) / align * align + align);
  if (!p) return NULL;
  /* rubbish: what counts on zeros shows as wrong bits */
  memset(p, 0xa5, size < 4096 ? size : 4096);
  atomic_fetch_add(&live_bytes, (int64_t)size);
  atomic_fetch_add(&live_blocks, 1);
  return p;
}

static void give_back(void *user, void *memory, size_t size, size_t align) {
  (void)user;
  (void)align;
  atomic_fetch_sub(&live_bytes, (int64_t)size);
  atomic_fetch_sub(&live_blocks, 1);
  free(memory);
}

static int32_t progress(void *user, float fraction, const char *what) {
  soak_host *h = user;
  (void)fraction;
  (void)what;
  return ++h->reports == h->cancel_at;
}

void soak_host_init(soak_host *h) {
  memset(h, 0, sizeof *h);
  h->host = (sozai_host){.size = sizeof(sozai_host),
                         .user = h,
                         .alloc = take,
                         .free = give_back,
                         .progress = progress};
}
