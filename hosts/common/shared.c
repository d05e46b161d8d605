/* SPDX-License-Identifier: Apache-2.0 */
#include "shared.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

struct shared {
  shared *next; /* newest use first */
  char *key;
  void *object;
  uint64_t bytes;
  void (*destroy)(void *object);
  uint32_t uses;
};

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static shared *all;

/* ---- with the lock held ----------------------------------------------- */

static shared *find(const char *key) {
  for (shared **at = &all; *at; at = &(*at)->next) {
    shared *s = *at;
    if (strcmp(s->key, key) != 0) continue;
    *at = s->next;
    s->next = all;
    all = s;
    s->uses++;
    return s;
  }
  return NULL;
}

/* Take the idle ones that are too many out of the list. */
static shared *surplus(void) {
  shared *out = NULL;
  uint32_t count = 0;
  uint64_t bytes = 0;
  for (shared **at = &all; *at;) {
    shared *s = *at;
    if (s->uses == 0) {
      count++;
      bytes += s->bytes;
    }
    if (s->uses > 0 || (count <= SHARED_IDLE && bytes <= SHARED_IDLE_BYTES)) {
      at = &s->next;
      continue;
    }
    *at = s->next;
    bytes -= s->bytes;
    count--;
    s->next = out;
    out = s;
  }
  return out;
}

/* ---- without it ------------------------------------------------------- */

static void destroy(shared *s) {
  s->destroy(s->object);
  free(s->key);
  free(s);
}

shared *shared_find(const char *key) {
  pthread_mutex_lock(&lock);
  shared *s = find(key);
  pthread_mutex_unlock(&lock);
  return s;
}

shared *shared_add(const char *key, void *object, uint64_t bytes, void (*destroyer)(void *object)) {
  shared *s = malloc(sizeof *s);
  char *copy = strdup(key);
  if (!s || !copy) {
    free(s);
    free(copy);
    destroyer(object);
    return NULL;
  }
  *s = (shared){.key = copy, .object = object, .bytes = bytes, .destroy = destroyer, .uses = 1};
  pthread_mutex_lock(&lock);
  shared *faster = find(key);
  if (!faster) {
    s->next = all;
    all = s;
  }
  pthread_mutex_unlock(&lock);
  if (!faster) return s;
  destroy(s);
  return faster;
}

void *shared_object(const shared *s) { return s->object; }

void shared_release(shared *s) {
  if (!s) return;
  pthread_mutex_lock(&lock);
  s->uses--;
  shared *gone = surplus();
  pthread_mutex_unlock(&lock);
  while (gone) {
    shared *next = gone->next;
    destroy(gone);
    gone = next;
  }
}
