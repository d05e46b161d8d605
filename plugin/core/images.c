/* SPDX-License-Identifier: Apache-2.0 */
#include "images.h"

#include <string.h>

#include "colour.h"
#include "limits.h"
#include "meter.h"
#include "services.h"
#include "status.h"

static uint32_t wrap_of(const sozai_parameter *p, const sozai_buffer *b) {
  return b->wrap ? b->wrap : (uint32_t)p->default_number[1];
}

static int32_t find_service(image_set *set, const sozai_host *host, const char *id) {
  if (set->service) return SOZAI_OK;
  const void *found;
  int32_t r = services_find(host, SOZAI_IMAGES_1, &found);
  if (r) return r;
  set->service = found;
  if (!set->service) {
    return fail(SOZAI_ERROR_UNSUPPORTED,
                "%s: a picture needs an image service, and there is none: neither the host has "
                "one, nor is there sozai-colour.so beside sozai.so",
                id);
  }
  if (set->service->size < sizeof *set->service) {
    return fail(SOZAI_ERROR_UNSUPPORTED, "%s: the image service is of %u bytes, not %zu", id,
                set->service->size, sizeof *set->service);
  }
  return SOZAI_OK;
}

/* ---- progress ------------------------------------------------------------- */

/* Of a bar from 0 to 1. A tree, grown for its knots, has the rest. */
#define PICTURES_SHARE 0.9f

/* Pictures that are read one after the other. */
typedef struct {
  const sozai_host *host;
  uint32_t done, count;
  int stopped; /* whatever the service made of that */
} reading;

/* As sozai_image_request.progress; fraction comes from a service, which may be the host's. */
static int32_t report(void *user, float fraction) {
  reading *r = user;
  float part = !(fraction > 0.0f) ? 0.0f : fraction < 1.0f ? fraction : 1.0f;
  float all = ((float)r->done + part) / (float)r->count;
  const sozai_host *h = r->host;
  if (h->progress && h->progress(h->user, PICTURES_SHARE * all, "reading pictures")) r->stopped = 1;
  return r->stopped;
}

static int32_t cancelled(void) {
  return fail(SOZAI_ERROR_CANCELLED, "cancelled by the host: reading pictures");
}

static int has_picture(const sozai_texture_info *info, const settings *s, uint32_t i) {
  return info->parameters[i]->kind == SOZAI_KIND_IMAGE && s->list[i].buffer;
}

static uint32_t count_pictures(const sozai_texture_info *info, const settings *s) {
  uint32_t n = 0;
  for (uint32_t i = 0; i < info->parameter_count; i++) n += has_picture(info, s, i) != 0;
  return n;
}

int32_t image_result(int32_t r) {
  return r < SOZAI_OK && r >= SOZAI_ERROR_LIMIT ? r : SOZAI_ERROR_FILE;
}

/* ---- opening -------------------------------------------------------------- */

/* After a service that knows of no most_pixels, an older one: it is as large as it is only once it
 * is open. */
static int32_t check_pixels(const image_set *set, uint32_t i, const sozai_host *host,
                            const char *id) {
  uint32_t width = 0, height = 0;
  int32_t r = set->service->resolution(set->service->self, set->list[i], &width, &height);
  if (r) {
    return fail(image_result(r), "%s: the image service does not say how large the picture is", id);
  }
  return limit_check(host, LIMIT_IMAGE_PIXELS, (uint64_t)width * height, id);
}

static sozai_image_request request_of(const sozai_parameter *p, const sozai_buffer *b,
                                      reading *progress) {
  sozai_image_request q;
  memset(&q, 0, sizeof q);
  q.size = sizeof q;
  q.wrap_s = q.wrap_t = wrap_of(p, b);
  q.first_channel = b->first_channel;
  q.channels = (uint32_t)p->default_number[0];
  q.path = b->path;
  q.buffer = b->path ? NULL : b;
  if (b->colour_space && b->colour_space[0]) q.colour_space = b->colour_space;
  q.most_pixels = limit_of(progress->host, LIMIT_IMAGE_PIXELS);
  if (progress->host->progress) {
    q.user = progress;
    q.progress = report;
  }
  return q;
}

static int32_t ask_service(image_set *set, uint32_t i, const sozai_image_request *q, const char *id,
                           reading *progress) {
  if (report(progress, 0)) return cancelled();
  char message[512] = "";
  int32_t r = set->service->open(set->service->self, q, &set->list[i], message, sizeof message);
  if (r) set->list[i] = NULL;
  if (progress->stopped) return cancelled();
  if (r == SOZAI_OK && set->list[i]) return check_pixels(set, i, progress->host, id);
  return fail(image_result(r), "%s: %s", id,
              message[0] ? message : "the image service refused the picture");
}

static int32_t open_one(image_set *set, uint32_t i, const sozai_parameter *p, const sozai_buffer *b,
                        reading *progress) {
  const sozai_host *host = progress->host;
  int32_t r = find_service(set, host, p->id);
  /* Any picture has a pixel; to a service a ceiling of 0 means that there is none. */
  if (!r) r = limit_check(host, LIMIT_IMAGE_PIXELS, 1, p->id);
  if (r) return r;
  sozai_image_request q = request_of(p, b, progress);
  if (q.colour_space && strcmp(q.colour_space, "data") != 0) {
    r = colour_name(host, q.colour_space, &q.colour_space);
  }
  return r ? r : ask_service(set, i, &q, p->id, progress);
}

int32_t images_open(image_set *set, const sozai_host *host, const sozai_texture_info *info,
                    const settings *s) {
  memset(set, 0, sizeof *set);
  reading progress = {.host = host, .count = count_pictures(info, s)};
  if (!progress.count) return SOZAI_OK;
  set->list = host_alloc(host, info->parameter_count * sizeof *set->list, 64);
  if (!set->list) return SOZAI_ERROR_MEMORY;
  set->count = info->parameter_count;
  int32_t r = SOZAI_OK;
  for (uint32_t i = 0; i < info->parameter_count && !r; i++) {
    if (!has_picture(info, s, i)) continue;
    r = open_one(set, i, info->parameters[i], s->list[i].buffer, &progress);
    progress.done++;
  }
  if (r) images_close(set, host);
  if (!r) host_progress_from(host, PICTURES_SHARE);
  return r;
}

static _Thread_local int32_t unanswered;

void images_answered(int32_t result) {
  if (result != SOZAI_OK && unanswered == SOZAI_OK) unanswered = result;
}

void images_forget(void) { unanswered = SOZAI_OK; }

int32_t images_looked(void) {
  if (unanswered == SOZAI_OK) return SOZAI_OK;
  return fail(SOZAI_ERROR_FILE, "evaluate: a picture could not be looked up; it is black there");
}

uint64_t images_bytes(const image_set *set) { return set->count * sizeof *set->list; }

void images_close(image_set *set, const sozai_host *host) {
  for (uint32_t i = 0; i < set->count; i++) {
    if (set->list[i]) set->service->close(set->service->self, set->list[i]);
  }
  host_free(host, set->list, set->count * sizeof *set->list, 64);
  memset(set, 0, sizeof *set);
}
