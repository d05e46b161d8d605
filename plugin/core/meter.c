/* SPDX-License-Identifier: Apache-2.0 */
#include "meter.h"

#include <stdlib.h>
#include <string.h>

#include "status.h"

/* 0: above the ceiling. */
static int count_up(meter *m, uint64_t bytes) {
  uint64_t most = m->ceilings[m->under];
  uint64_t before = atomic_fetch_add(&m->held, bytes), now = before + bytes;
  if (now > most || now < before) {
    atomic_fetch_sub(&m->held, bytes);
    atomic_store(&m->refused, now < before ? UINT64_MAX : now);
    return 0;
  }
  uint64_t peak = atomic_load(&m->peak);
  while (now > peak && !atomic_compare_exchange_weak(&m->peak, &peak, now)) {
  }
  return 1;
}

static void *take(void *user, size_t size, size_t align) {
  meter *m = user;
  if (!count_up(m, size)) return NULL;
  void *p = m->real.alloc && m->real.free
                ? m->real.alloc(m->real.user, size, align)
                : aligned_alloc(align, (size + align - 1) / align * align);
  if (!p) atomic_fetch_sub(&m->held, size);
  return p;
}

static void give_back(void *user, void *memory, size_t size, size_t align) {
  meter *m = user;
  host_free(&m->real, memory, size, align);
  atomic_fetch_sub(&m->held, size);
}

static void say(void *user, int32_t severity, const char *text) {
  const meter *m = user;
  m->real.log(m->real.user, severity, text);
}

static int32_t in_parallel(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                           void *context) {
  const meter *m = user;
  return m->real.parallel(m->real.user, count, task, context);
}

static int32_t progress(void *user, float fraction, const char *what) {
  const meter *m = user;
  return m->real.progress(m->real.user, m->begin + fraction * (1.0f - m->begin), what);
}

static const void *service(void *user, const char *id) {
  const meter *m = user;
  return m->real.get_service(m->real.user, id);
}

void meter_reopen(meter *m, const sozai_host *host, const uint64_t ceilings[LIMITS], limit under,
                  sozai_host *out) {
  memset(m, 0, sizeof *m);
  m->real = *host;
  m->under = under;
  memcpy(m->ceilings, ceilings, sizeof m->ceilings);
  *out = *host;
  out->user = m;
  out->alloc = take;
  out->free = give_back;
  if (out->log) out->log = say;
  if (out->parallel) out->parallel = in_parallel;
  if (out->progress) out->progress = progress;
  if (out->get_service) out->get_service = service;
}

int32_t meter_open(meter *m, const sozai_host *host, limit under, sozai_host *out) {
  uint64_t ceilings[LIMITS];
  int32_t r = limits_read(ceilings, host);
  if (!r) meter_reopen(m, host, ceilings, under, out);
  return r;
}

int32_t meter_result(const meter *m, int32_t r, const char *what) {
  uint64_t refused = atomic_load(&m->refused);
  if (r != SOZAI_ERROR_MEMORY || !refused) return r;
  return fail(SOZAI_ERROR_LIMIT, "%s: takes %llu B of memory or more: above the ceiling %s, %llu",
              what, (unsigned long long)refused, limit_infos[m->under].id,
              (unsigned long long)m->ceilings[m->under]);
}

meter *meter_of(const sozai_host *host) {
  return host && host->alloc == take ? (meter *)host->user : NULL;
}

sozai_host meter_real(const sozai_host *host) {
  const meter *m = meter_of(host);
  return m ? m->real : *host;
}

int host_rehearses(const sozai_host *host) {
  const meter *m = meter_of(host);
  return m && m->rehearsing;
}

int host_rehearse(const sozai_host *host, int rehearsing) {
  meter *m = meter_of(host);
  int before = m && m->rehearsing;
  if (m) m->rehearsing = rehearsing;
  return before;
}

void host_progress_from(const sozai_host *host, float begin) {
  meter *m = meter_of(host);
  if (m) m->begin = begin;
}

int32_t host_claim(const sozai_host *host, uint64_t bytes) {
  meter *m = meter_of(host);
  return !m || count_up(m, bytes) ? SOZAI_OK : SOZAI_ERROR_MEMORY;
}

void host_unclaim(const sozai_host *host, uint64_t bytes) {
  meter *m = meter_of(host);
  if (m) atomic_fetch_sub(&m->held, bytes);
}

int32_t host_has_room(const sozai_host *host, uint64_t bytes) {
  meter *m = meter_of(host);
  if (!m) return SOZAI_OK;
  uint64_t held = atomic_load(&m->held), most = m->ceilings[m->under];
  if (bytes <= most && held <= most - bytes) return SOZAI_OK;
  atomic_store(&m->refused, held > UINT64_MAX - bytes ? UINT64_MAX : held + bytes);
  return SOZAI_ERROR_MEMORY;
}

int32_t memory_clear(sozai_memory *out, const char *call) {
  if (!out) return fail(SOZAI_ERROR_ARGUMENT, "memory: %s: out is NULL", call);
  if (out->size < SIZE_WITH(sozai_memory, peak)) {
    return fail(SOZAI_ERROR_ARGUMENT, "memory: %s: out.size is %u: set it to sizeof(sozai_memory)",
                call, out->size);
  }
  const sozai_memory none = {.size = out->size};
  memcpy(out, &none, out->size < sizeof none ? out->size : sizeof none);
  return SOZAI_OK;
}
