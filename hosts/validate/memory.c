/* SPDX-License-Identifier: Apache-2.0 */
#define _GNU_SOURCE
#include "memory.h"

#include <dlfcn.h>
#include <errno.h>
#include <malloc.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stddef.h>
#include <string.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SANITIZED 1
#endif
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif
#if defined(__GLIBC__) && !SANITIZED
#define WATCHED 1
#else
#define WATCHED 0
#endif

static _Thread_local uint64_t calls, locks;
static atomic_int_fast64_t live;
static atomic_bool scribbling;

bool memory_watched(void) { return WATCHED; }
bool memory_sanitized(void) { return SANITIZED; }
void memory_scribble(void) { atomic_store(&scribbling, true); }
uint64_t memory_calls(void) { return calls; }
int64_t memory_live(void) { return (int64_t)atomic_load(&live); }
uint64_t memory_locks(void) { return locks; }

#if WATCHED
#define EXPORT __attribute__((visibility("default"), noinline))

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *__libc_memalign(size_t align, size_t size);
void __libc_free(void *memory);

static void *had(void *memory) {
  calls++;
  if (memory) atomic_fetch_add(&live, (int_fast64_t)malloc_usable_size(memory));
  return memory;
}

static void *fresh(void *memory, size_t size) {
  if (memory && size && atomic_load(&scribbling)) memset(memory, 0x5a, size);
  return had(memory);
}

/* The compiler must not drop what is written to memory that is about to go. */
static void gone(void *memory) {
  if (!memory) return;
  size_t size = malloc_usable_size(memory);
  atomic_fetch_sub(&live, (int_fast64_t)size);
  if (!atomic_load(&scribbling)) return;
  memset(memory, 0xa5, size);
  __asm__ volatile("" : : "r"(memory) : "memory");
}

EXPORT void *malloc(size_t size) { return fresh(__libc_malloc(size), size); }
EXPORT void *calloc(size_t n, size_t size) { return had(__libc_calloc(n, size)); }
EXPORT void *aligned_alloc(size_t align, size_t size) {
  return fresh(__libc_memalign(align, size), size);
}
EXPORT void *memalign(size_t align, size_t size) {
  return fresh(__libc_memalign(align, size), size);
}

EXPORT void *realloc(void *memory, size_t size) {
  size_t before = memory ? malloc_usable_size(memory) : 0;
  void *now = __libc_realloc(memory, size);
  if (now || size == 0) atomic_fetch_sub(&live, (int_fast64_t)before);
  return had(now);
}

EXPORT int posix_memalign(void **out, size_t align, size_t size) {
  *out = fresh(__libc_memalign(align, size), size);
  return *out ? 0 : ENOMEM;
}

EXPORT void free(void *memory) {
  gone(memory);
  __libc_free(memory);
}

/* ---- locks ----------------------------------------------------------------- */

typedef int lock_function(void *);

/* The next of that name, that is libc's. */
static int next_lock(_Atomic(lock_function *) *kept, const char *name, void *lock) {
  lock_function *f = atomic_load(kept);
  if (!f) {
    void *found = dlsym(RTLD_NEXT, name);
    __builtin_memcpy(&f, &found, sizeof f);
    atomic_store(kept, f);
  }
  locks++;
  return f(lock);
}

#define LOCK(name, type)                                                                           \
  EXPORT int name(type *lock) {                                                                    \
    static _Atomic(lock_function *) kept;                                                          \
    return next_lock(&kept, #name, (void *)(uintptr_t)lock);                                       \
  }

LOCK(pthread_mutex_lock, pthread_mutex_t)
LOCK(pthread_mutex_trylock, pthread_mutex_t)
LOCK(pthread_rwlock_rdlock, pthread_rwlock_t)
LOCK(pthread_rwlock_wrlock, pthread_rwlock_t)
LOCK(pthread_spin_lock, pthread_spinlock_t)
#endif
