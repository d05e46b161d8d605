/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

#define MAGIC 0x736f7a6169u

/* Before each block, what it was asked with. */
typedef struct head {
  uint64_t magic, size, align;
  void *base;
} head;

static recorder *of(void *user) {
  recorder *r = user;
  if (r->abi.user != user) atomic_fetch_add(&r->wrong_user, 1);
  return r;
}

static void *take(void *user, size_t size, size_t align) {
  recorder *r = of(user);
  if (!align || (align & (align - 1))) {
    atomic_fetch_add(&r->wrong_align, 1);
    return NULL;
  }
  if (atomic_fetch_add(&r->allocations, 1) + 1 == r->fail_at) return NULL;
  size_t step = align < sizeof(head) ? sizeof(head) : align;
  bool fits = step <= SIZE_MAX / 4 && size <= SIZE_MAX - 2 * step;
  char *base = fits ? malloc(size + 2 * step) : NULL;
  if (!base) return NULL;
  char *memory = base + step;
  memory += (step - (uintptr_t)memory % step) % step;
  *(head *)(void *)(memory - sizeof(head)) = (head){MAGIC, size, align, base};
  atomic_fetch_add(&r->bytes, (int_fast64_t)size);
  return memory;
}

static void give_back(void *user, void *memory, size_t size, size_t align) {
  recorder *r = of(user);
  if (!memory) return;
  head *h = (head *)(void *)((char *)memory - sizeof(head));
  if (h->magic != MAGIC || h->size != size || h->align != align)
    atomic_fetch_add(&r->wrong_free, 1);
  if (h->magic != MAGIC) return;
  atomic_fetch_add(&r->frees, 1);
  atomic_fetch_sub(&r->bytes, (int_fast64_t)h->size);
  h->magic = 0;
  free(h->base);
}

static void log_line(void *user, int32_t severity, const char *text) {
  recorder *r = of(user);
  atomic_fetch_add(&r->log_calls, 1);
  if (severity < SOZAI_LOG_DEBUG || severity > SOZAI_LOG_ERROR || !text || !utf8_valid(text))
    atomic_fetch_add(&r->wrong_text, 1);
}

static int32_t progress(void *user, float fraction, const char *what) {
  recorder *r = of(user);
  uint64_t n = atomic_fetch_add(&r->progress_calls, 1) + 1;
  if (!(fraction >= 0 && fraction <= 1)) atomic_fetch_add(&r->wrong_fraction, 1);
  if (!what || !utf8_valid(what)) atomic_fetch_add(&r->wrong_text, 1);
  return r->cancel_at && n >= r->cancel_at;
}

/* ---- threads ------------------------------------------------------------------ */

typedef struct work {
  void (*task)(void *context, uint32_t i);
  void *context;
  uint32_t count;
  atomic_uint next;
} work;

static void *run_tasks(void *context) {
  work *w = context;
  for (uint32_t i; (i = atomic_fetch_add(&w->next, 1)) < w->count;)
    w->task(w->context, w->count - 1 - i);
  return NULL;
}

const char *const parallel_words[PARALLEL_WAYS] = {"in order", "backwards", "on three threads",
                                                   "refused", "dropped in silence"};

static int32_t parallel(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                        void *context) {
  recorder *r = of(user);
  atomic_fetch_add(&r->parallel_calls, 1);
  work w = {.task = task, .context = context, .count = count};
  pthread_t threads[3];
  switch (r->parallel) {
  case PARALLEL_REFUSED:
    return 1;
  case PARALLEL_DROPPED:
    for (uint32_t i = 0; i < count; i += 2) task(context, i);
    return 0;
  case PARALLEL_FORWARD:
    for (uint32_t i = 0; i < count; i++) task(context, i);
    return 0;
  case PARALLEL_BACKWARD:
    run_tasks(&w);
    return 0;
  default:
    for (int i = 0; i < 3; i++)
      if (pthread_create(&threads[i], NULL, run_tasks, &w) != 0) abort();
    for (int i = 0; i < 3; i++) pthread_join(threads[i], NULL);
    return 0;
  }
}

/* ---- services ------------------------------------------------------------------- */

static const void *service(void *user, const char *id) {
  recorder *r = of(user);
  atomic_fetch_add(&r->service_calls, 1);
  if (!id) {
    atomic_fetch_add(&r->wrong_text, 1);
    return NULL;
  }
  if (r->colour && strcmp(id, SOZAI_COLOUR_1) == 0) return &r->colour_service;
  if (r->images && strcmp(id, SOZAI_IMAGES_1) == 0) return &r->image_service;
  return NULL;
}

static const char *space_name(void *self) { return of(self) ? "validate" : NULL; }

static int32_t has_space(void *self, const char *space) { return of(self) && space ? 1 : 0; }

static int32_t convert(void *self, const char *space, float *rgb, uint64_t count, char *message,
                       size_t message_size) {
  recorder *r = of(self);
  atomic_fetch_add(&r->colour_calls, 1);
  if (!space || !*space || (count && !rgb)) atomic_fetch_add(&r->wrong_request, 1);
  if (message && message_size) snprintf(message, message_size, "validate: as told");
  if (r->colour_result != SOZAI_OK) return r->colour_result;
  if (message && message_size) *message = '\0';
  for (uint64_t i = 0; rgb && i < 3 * count; i++) rgb[i] *= r->colour_scale;
  return SOZAI_OK;
}

static sozai_image *const image = (sozai_image *)(uintptr_t)0x100;

static int32_t image_open(void *self, const sozai_image_request *q, sozai_image **out,
                          char *message, size_t message_size) {
  recorder *r = of(self);
  /* as long as it was in ABI 1.0: a plugin of before knows no more */
  if (!q || q->size < offsetof(sozai_image_request, most_pixels) || q->channels < 1 ||
      q->channels > 4 || q->wrap_s > SOZAI_WRAP_MIRROR || q->wrap_t > SOZAI_WRAP_MIRROR ||
      !q->path == !q->buffer || !out) {
    atomic_fetch_add(&r->wrong_request, 1);
    return SOZAI_ERROR_ARGUMENT;
  }
  *out = NULL;
  if (message && message_size) snprintf(message, message_size, "validate: as told");
  if (r->image_result != SOZAI_OK) return r->image_result;
  atomic_fetch_add(&r->image_opens, 1);
  *out = image;
  return SOZAI_OK;
}

static void image_close(void *self, sozai_image *i) {
  recorder *r = of(self);
  if (i) atomic_fetch_add(&r->image_closes, 1);
  if (i && i != image) atomic_fetch_add(&r->wrong_request, 1);
}

static int32_t image_resolution(void *self, const sozai_image *i, uint32_t *w, uint32_t *h) {
  if (!of(self) || i != image || !w || !h) return SOZAI_ERROR_ARGUMENT;
  *w = *h = 64;
  return SOZAI_OK;
}

static int32_t image_sample(void *self, const sozai_image *i, uint32_t count, const float *s,
                            const float *t, const float *dsdx, const float *dtdx, const float *dsdy,
                            const float *dtdy, float *const *out) {
  recorder *r = of(self);
  (void)dsdx, (void)dtdx, (void)dsdy, (void)dtdy;
  atomic_fetch_add(&r->samples, 1);
  if (i != image || !s || !t || !out || !out[0]) {
    atomic_fetch_add(&r->wrong_request, 1);
    return SOZAI_ERROR_ARGUMENT;
  }
  for (uint32_t k = 0; k < count; k++) out[0][k] = 0.5f + 0.25f * (s[k] - (float)(int32_t)s[k]);
  return SOZAI_OK;
}

static void image_memory(void *self, uint64_t *used, uint64_t *limit) {
  if (of(self) && used) *used = 0;
  if (limit) *limit = 1u << 30;
}

/* ---- ------------------------------------------------------------------------------ */

void recorder_init(recorder *r) {
  memset(r, 0, sizeof *r);
  r->colour_scale = 1;
  r->abi = (sozai_host){.size = sizeof r->abi,
                        .user = r,
                        .log = log_line,
                        .alloc = take,
                        .free = give_back,
                        .parallel = parallel,
                        .progress = progress,
                        .get_service = service};
  r->colour_service = (sozai_colour_1){.size = sizeof r->colour_service,
                                       .self = r,
                                       .config_name = space_name,
                                       .working_space = space_name,
                                       .has_space = has_space,
                                       .to_working = convert,
                                       .from_working = convert};
  r->image_service = (sozai_images_1){.size = sizeof r->image_service,
                                      .self = r,
                                      .open = image_open,
                                      .close = image_close,
                                      .resolution = image_resolution,
                                      .sample = image_sample,
                                      .memory = image_memory};
}

uint64_t recorder_calls(const recorder *r) {
  return atomic_load(&r->allocations) + atomic_load(&r->frees) + atomic_load(&r->progress_calls) +
         atomic_load(&r->log_calls) + atomic_load(&r->parallel_calls) +
         atomic_load(&r->service_calls) + atomic_load(&r->colour_calls);
}

void recorder_judge(const recorder *r, const char *name) {
  EXPECT(!atomic_load(&r->wrong_user), "%s: a service was handed another user", name);
  EXPECT(!atomic_load(&r->wrong_free), "%s: free got another size or alignment than alloc", name);
  EXPECT(!atomic_load(&r->wrong_align), "%s: alloc was asked for no power of two", name);
  EXPECT(!atomic_load(&r->wrong_fraction), "%s: progress was told a fraction outside of 0 to 1",
         name);
  EXPECT(!atomic_load(&r->wrong_text), "%s: log, progress or get_service got no text in UTF-8",
         name);
  EXPECT(!atomic_load(&r->wrong_request), "%s: a service of colour or pictures was asked wrongly",
         name);
}

void recorder_empty(const recorder *r, const char *name, const char *what) {
  EXPECT(atomic_load(&r->bytes) == 0,
         "%s: %lld bytes of the host's allocator are not given back, %s", name,
         (long long)atomic_load(&r->bytes), what);
  EXPECT(atomic_load(&r->image_opens) == atomic_load(&r->image_closes),
         "%s: %u pictures opened, %u closed, %s", name, (unsigned)atomic_load(&r->image_opens),
         (unsigned)atomic_load(&r->image_closes), what);
}
