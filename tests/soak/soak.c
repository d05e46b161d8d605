/* SPDX-License-Identifier: Apache-2.0
 *
 * Sixteen threads make, evaluate and destroy at random for as long as they are
 * told to: soak SECONDS [THREADS [SEED]].
 *
 * In generations of some seconds. Before each a few jobs are done on one thread
 * alone; what the many make of the same jobs must be the same to the bit. After
 * each, nothing of the host's memory may be held, and the process may not have
 * grown. A line a minute says what was done.
 */
#include <dlfcn.h>
#include <malloc.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "../resident.h"
#include "job.h"

#define GENERATION 4.0 /* seconds */
#define REFERENCES 24
#define SHARED 6
#define THREADS_MOST 64
#define SAMPLES 8192
#define RISE_MOST 2048 /* KiB, of the whole run after its first third */
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
#define OWN_SIZE 0 /* the sanitizer's books grow with what is done */
#else
#define OWN_SIZE 1
#endif

/* A texture that many threads evaluate at once, and any of them may destroy. */
typedef struct {
  pthread_mutex_t lock;
  sozai_texture *texture;
  void *keep;
  uint64_t seed, hash;
  uint32_t users;
} shared;

typedef struct {
  plugin plugin;
  tally tally;
  uint64_t seed;
  struct {
    uint64_t seed, hash;
  } references[REFERENCES];
  shared shared[SHARED];
  atomic_bool stop;
} soak;

typedef struct {
  soak *soak;
  uint64_t random;
  pthread_t thread;
} worker;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- a thread ----------------------------------------------------------- */

static void use_shared(soak *k, uint64_t *random) {
  shared *o = &k->shared[job_random(random) % SHARED];
  pthread_mutex_lock(&o->lock);
  if (!o->texture) {
    o->seed = job_random(random) | 1;
    o->texture = job_texture(&k->plugin, o->seed, &o->keep, &k->tally);
    if (o->texture) {
      o->hash = job_evaluate(&k->plugin, o->texture, o->seed, 0, &k->tally);
    } else {
      free(o->keep);
    }
  }
  sozai_texture *t = o->texture;
  uint64_t seed = o->seed, hash = o->hash;
  o->users += t != NULL;
  pthread_mutex_unlock(&o->lock);
  if (!t) return;
  uint64_t got = job_evaluate(&k->plugin, t, seed, job_random(random), &k->tally);
  atomic_fetch_add(&k->tally.checked, 1);
  if (got != hash)
    job_failed(&k->tally, "a texture many use: seed %llu gave another answer",
               (unsigned long long)seed);
  pthread_mutex_lock(&o->lock);
  if (--o->users == 0 && job_random(random) % 8 == 0) {
    k->plugin.textures->destroy(o->texture);
    free(o->keep);
    o->texture = NULL;
  }
  pthread_mutex_unlock(&o->lock);
}

static void *work(void *context) {
  worker *w = context;
  soak *k = w->soak;
  while (!atomic_load(&k->stop)) {
    uint32_t what = (uint32_t)(job_random(&w->random) % 16);
    if (what < 4) {
      uint32_t i = (uint32_t)(job_random(&w->random) % REFERENCES);
      uint64_t got = job_run(&k->plugin, k->references[i].seed, job_random(&w->random), &k->tally);
      atomic_fetch_add(&k->tally.checked, 1);
      if (got != k->references[i].hash)
        job_failed(&k->tally, "seed %llu gave another answer than on one thread",
                   (unsigned long long)k->references[i].seed);
    } else if (what < 7) {
      use_shared(k, &w->random);
    } else if (what == 7) {
      /* nested, while others work */
      if (k->plugin.entry->init(NULL) == SOZAI_OK)
        k->plugin.entry->deinit();
      else
        job_failed(&k->tally, "a nested init failed");
    } else {
      job_run(&k->plugin, job_random(&w->random), job_random(&w->random), &k->tally);
    }
  }
  return NULL;
}

/* ---- a generation ------------------------------------------------------- */

static int begin(soak *k) {
  if (k->plugin.entry->init(SOZAI_TEST_PLUGIN) != SOZAI_OK) return 0;
  k->plugin.textures = k->plugin.entry->get_factory(SOZAI_TEXTURES_1);
  k->plugin.geometry = k->plugin.entry->get_factory(SOZAI_GEOMETRY_1);
  for (int i = 0; i < REFERENCES; i++) {
    k->references[i].seed = job_random(&k->seed);
    if (i < 2) k->references[i].seed &= ~15ull; /* geometry */
    k->references[i].hash = job_run(&k->plugin, k->references[i].seed, 0, &k->tally);
  }
  return 1;
}

static void end(soak *k) {
  for (int i = 0; i < SHARED; i++) {
    shared *o = &k->shared[i];
    if (!o->texture) continue;
    k->plugin.textures->destroy(o->texture);
    free(o->keep);
    o->texture = NULL;
  }
  long long bytes = (long long)atomic_load(&live_bytes),
            blocks = (long long)atomic_load(&live_blocks);
  if (bytes || blocks) job_failed(&k->tally, "%lld bytes in %lld blocks are left", bytes, blocks);
  k->plugin.entry->deinit();
  if (k->plugin.entry->get_factory(SOZAI_TEXTURES_1))
    job_failed(&k->tally, "still initialised after the last deinit");
}

static int generation(soak *k, uint32_t threads, double seconds) {
  static worker workers[THREADS_MOST];
  if (!begin(k)) return 0;
  atomic_store(&k->stop, false);
  for (uint32_t i = 0; i < threads; i++) {
    workers[i] = (worker){.soak = k, .random = job_random(&k->seed)};
    if (pthread_create(&workers[i].thread, NULL, work, &workers[i]) != 0) return 0;
  }
  const struct timespec nap = {(time_t)seconds, (long)(1e9 * (seconds - (double)(time_t)seconds))};
  nanosleep(&nap, NULL);
  atomic_store(&k->stop, true);
  for (uint32_t i = 0; i < threads; i++) pthread_join(workers[i].thread, NULL);
  end(k);
  return 1;
}

/* ---- judging ------------------------------------------------------------ */

static void print_row(const soak *k, double elapsed, long kib) {
  const tally *t = &k->tally;
  printf("%7.1f  %10llu  %12llu  %9llu  %8llu  %9llu  %6lld  %8ld  %8llu\n", elapsed / 60,
         (unsigned long long)atomic_load(&t->created), (unsigned long long)atomic_load(&t->points),
         (unsigned long long)atomic_load(&t->refused), (unsigned long long)atomic_load(&t->grown),
         (unsigned long long)atomic_load(&t->checked), (long long)atomic_load(&live_bytes), kib,
         (unsigned long long)atomic_load(&t->failures));
  fflush(stdout);
}

/* Whether the process grew: a line through its sizes after the first third. */
static int flat(const double *at, const double *kib, int n) {
  if (!OWN_SIZE) return 1;
  int from = n / 3;
  double m = n - from, sx = 0, sy = 0, sxx = 0, sxy = 0;
  if (m < 4) {
    printf("too short to judge its size\n");
    return 1;
  }
  for (int i = from; i < n; i++)
    sx += at[i], sy += kib[i], sxx += at[i] * at[i], sxy += at[i] * kib[i];
  double slope = (m * sxy - sx * sy) / (m * sxx - sx * sx), rise = slope * (at[n - 1] - at[from]);
  printf("size: mean %.0f KiB, %+.1f KiB a minute after the first third, %+.0f KiB in all "
         "(at most %+d)\n",
         sy / m, 60 * slope, rise, RISE_MOST);
  return rise <= RISE_MOST;
}

int main(int argc, char **argv) {
  double seconds = argc > 1 ? atof(argv[1]) : 60;
  uint32_t threads = argc > 2 ? (uint32_t)atoi(argv[2]) : 16;
  /* one heap for all threads: a heap each has gaps that look like growth */
  mallopt(M_ARENA_MAX, 1);
  static soak k;
  k.seed = argc > 3 ? strtoull(argv[3], NULL, 10) : (uint64_t)time(NULL);
  if (!(seconds > 0) || threads < 1 || threads > THREADS_MOST) {
    fprintf(stderr, "usage: soak SECONDS [THREADS, 1 to %d [SEED]]\n", THREADS_MOST);
    return 2;
  }
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  k.plugin.entry = library ? dlsym(library, SOZAI_ENTRY_SYMBOL) : NULL;
  if (!k.plugin.entry) {
    fprintf(stderr, "soak: %s\n", dlerror());
    return 1;
  }
  for (int i = 0; i < SHARED; i++) pthread_mutex_init(&k.shared[i].lock, NULL);
  printf("%.0f s, %u threads, seed %llu\n", seconds, threads, (unsigned long long)k.seed);
  printf("minutes    textures        points   refusals     grown    checked    live  size KiB  "
         "failures\n");
  static double at[SAMPLES], kib[SAMPLES];
  double start = now(), said = 0, each = seconds / SAMPLES;
  int n = 0;
  each = each > GENERATION ? each : GENERATION;
  while (now() - start < seconds) {
    double left = seconds - (now() - start);
    if (!generation(&k, threads, left < each ? left : each)) {
      job_failed(&k.tally, "a generation could not begin");
      break;
    }
    malloc_trim(0);
    double elapsed = now() - start;
    long size = resident_kib();
    if (n < SAMPLES) at[n] = elapsed, kib[n++] = (double)size;
    if (elapsed - said >= 60 || now() - start >= seconds) {
      print_row(&k, elapsed, size);
      said = elapsed;
    }
  }
  int ok = flat(at, kib, n);
  dlclose(library);
  if (!ok) fprintf(stderr, "soak: its memory grew\n");
  return ok && !atomic_load(&k.tally.failures) ? 0 : 1;
}
