/* SPDX-License-Identifier: Apache-2.0
 * The texture `plain`: squares or bands of one colour. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <fenv.h>
#include <locale.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plugin.h"
#include "sozai_colour.h"

#define WEIGHTS 16

struct sozai_texture {
  sozai_host host;
  const sozai_texture_info *info;
  setting given[P_COUNT];
  float tint[3];
  float weights[WEIGHTS];
};

/* ---- make ---------------------------------------------------------------------------- */

static int32_t convert(sozai_texture *t) {
  const char *space = t->given[P_TINT].text;
  const sozai_colour_1 *service =
      t->host.get_service ? t->host.get_service(t->host.user, SOZAI_COLOUR_1) : NULL;
#ifdef COLOUR_FAILURE_IGNORED
  if (service) {
    service->to_working(service->self, space, t->tint, 1, NULL, 0);
    return SOZAI_OK;
  }
#endif
  for (int c = 0; c < 3; c++) t->tint[c] = (float)t->given[P_TINT].number[c];
  char why[100] = "";
  if (service && service->to_working(service->self, space, t->tint, 1, why, sizeof why) != SOZAI_OK)
    return say(SOZAI_ERROR_COLOUR, "tint: %s", why);
  for (int c = 0; c < 3 && !service && strcmp(space, "sRGB") == 0; c++) t->tint[c] *= t->tint[c];
  if (!service && strcmp(space, "sRGB") != 0 && strcmp(space, "lin_rec709") != 0)
    return say(SOZAI_ERROR_COLOUR, "tint: no colour space \"%.60s\"", space);
  for (int c = 0; c < 3; c++)
    if (!(t->tint[c] - t->tint[c] == 0)) return say(SOZAI_ERROR_COLOUR, "tint: is not finite");
  return SOZAI_OK;
}

static void weigh(void *context, uint32_t i) {
  sozai_texture *t = context;
  uint32_t h = (i + 1) * 0x9e3779b9u;
  t->weights[i] = (float)(h >> 8) * 0x1p-24f;
}

#ifdef LEAVES_THREAD
static void *idle(void *context) {
  for (;;) sleep(1000);
  return context;
}
#endif

/* What no create may do. */
static void misbehave(void) {
#ifdef HANGS
  for (volatile int i = 0; i == 0;) continue;
#endif
#ifdef EXITS
  exit(0);
#endif
#ifdef PRINTS
  puts("plain: made");
#endif
#ifdef CHANGES_LOCALE
  setlocale(LC_ALL, strcmp(setlocale(LC_ALL, NULL), "C") == 0 ? "C.UTF-8" : "C");
#endif
#ifdef CHANGES_SIGNALS
  signal(SIGFPE, SIG_IGN);
#endif
#ifdef CHANGES_UMASK
  umask(0);
#endif
#ifdef CHANGES_ENVIRONMENT
  setenv("PLAIN", "made", 1);
#endif
#ifdef LEAVES_FILE
  if (open("/dev/null", O_RDONLY) < 0) return;
#endif
#ifdef LEAVES_THREAD
  pthread_t thread;
  pthread_create(&thread, NULL, idle, NULL);
#endif
#ifdef DESCRIPTION_CHANGES
  plain_label[0] = 'C';
#endif
#ifdef LEAKS
  static void *volatile lost;
  lost = malloc(1000);
  if (!lost) return;
#endif
}

static void destroy(sozai_texture *t) {
#ifndef NULL_DESTROYED
  if (!t) return;
#endif
  sozai_host host = t->host;
  give_back(&host, t, sizeof *t);
}

static int32_t create(const sozai_host *host, const char *id, const char *preset,
                      const sozai_value *values, uint32_t count, sozai_texture **out) {
  if (!out) return say(SOZAI_ERROR_ARGUMENT, "create: out is NULL");
#ifndef OUT_KEPT
  *out = NULL;
#endif
  if (!ready()) return say(SOZAI_ERROR_STATE, "create: called before init");
  if (!id) return say(SOZAI_ERROR_ARGUMENT, "create: no id");
  if (strcmp(id, "plain") != 0)
    return say(SOZAI_ERROR_UNKNOWN, "there is no texture \"%.60s\"", id);
  if (host && host->size < 8) return say(SOZAI_ERROR_ARGUMENT, "create: the host has no size");
  misbehave();
  sozai_host h = host_of(host);
#ifdef SIZE_OF_HOST_IGNORED
  if (host) h = *host;
#endif
  sozai_texture *t = take(&h, sizeof *t);
  if (!t) return SOZAI_ERROR_MEMORY;
  t->host = h;
  t->info = plain_info();
  int32_t r = settings_read(t->given, "plain", t->info->parameters, P_COUNT, t->info->presets, 2,
                            preset, values, count);
  if (!r) r = convert(t);
  if (!r && host_cancels(&h, 0.5f)) r = say(SOZAI_ERROR_CANCELLED, "cancelled");
  if (r) {
#ifndef KEPT_ON_FAILURE
    destroy(t);
#endif
    return r;
  }
  run_all(&h, WEIGHTS, weigh, t);
  if (host_cancels(&h, 1.0f)) {
    destroy(t);
    return say(SOZAI_ERROR_CANCELLED, "cancelled");
  }
  *out = t;
  return SOZAI_OK;
}

/* ---- read ------------------------------------------------------------------------------- */

static float finite_or(float x, float otherwise) { return x - x == 0 ? x : otherwise; }

static float clamped(float x, float low, float high) { return x < low ? low : x > high ? high : x; }

static float coordinate(float x) {
#ifdef NAN_POINT
  return clamped(x, -1e6f, 1e6f);
#endif
  return x == x ? clamped(x, -1e6f, 1e6f) : 0;
}

/* Of unit length; false: it has no direction. */
static bool unit(const float *const in[3], uint32_t i, float v[3]) {
  if (!in[0] || !in[1] || !in[2]) return false;
  float big = 0;
  for (int c = 0; c < 3; c++) {
    v[c] = in[c][i];
    if (!(v[c] - v[c] == 0)) return false;
    if (v[c] > big) big = v[c];
    if (-v[c] > big) big = -v[c];
  }
#ifdef SHORT_VECTORS
  if (big < 1e-10f) return false;
#endif
  if (!(big > 1e-37f)) return false;
  for (int c = 0; c < 3; c++) v[c] /= big;
  float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  float root = 1;
  for (int k = 0; k < 20; k++) root = 0.5f * (root + square / root);
  for (int c = 0; c < 3; c++) v[c] /= root;
  return true;
}

static void direction(const float *const in[3], uint32_t i, const float otherwise[3], float v[3]) {
  if (!unit(in, i, v)) memcpy(v, otherwise, 3 * sizeof *v);
}

/* ---- answer ------------------------------------------------------------------------------- */

static int parity(float x, float *part) {
  int64_t n = (int64_t)x;
  if ((float)n > x) n--;
  *part = x - (float)n;
  return (int)(n & 1);
}

/* A huge product is no infinity. */
static float bounded(float x) { return x == x ? clamped(x, -1e38f, 1e38f) : 0; }

static void answer(const sozai_texture *t, const sozai_batch *b, uint32_t i,
                   float out[COMPONENTS]) {
  static const float up[3] = {0, 0, 1};
  float part[3], normal[3], light[3], view[3], scale = (float)t->given[P_SCALE].number[0];
  int odd = 0;
  for (int c = 0; c < 3; c++) {
    float x = coordinate(b->point[c][i]) + (float)t->given[P_OFFSET].number[c];
    int p = parity(x / scale, &part[c]);
    odd += c == 0 || t->given[P_PATTERN].number[0] == 0 ? p : 0;
  }
  direction(b->normal, i, up, normal);
  direction(b->light, i, up, light);
  direction(b->view, i, normal, view);
  float size = b->footprint ? b->footprint[i] : 0;
  size = size > 0 ? clamped(size, 0, 1e4f) : 0;
#ifdef FOOTPRINT_ABSENT
  if (!b->footprint) size = 1;
#endif
  float far = size / (size + scale), shade = odd & 1 ? 1.0f : 0.5f;
  shade += far * (0.75f - shade);
  float facing = 0, seen = 0;
  for (int c = 0; c < 3; c++) {
    facing += normal[c] * light[c];
    seen += normal[c] * view[c];
  }
  facing = clamped(facing, 0, 1);
  seen = clamped(seen, 0, 1);
  for (int c = 0; c < 3; c++) {
    float of = b->light_colour[0] && b->light_colour[1] && b->light_colour[2]
                   ? finite_or(b->light_colour[c][i], 0)
                   : 1;
    out[C_ALBEDO + c] = bounded(t->tint[c] * shade);
    out[C_RADIANCE + c] =
        bounded(out[C_ALBEDO + c] * facing * (1 + 0.1f * seen) * clamped(of, -1e30f, 1e30f));
  }
  float level = t->given[P_SMOOTH].number[0] != 0 ? part[0] * (1 - part[0]) : part[0];
  out[C_HEIGHT] =
      level * (float)t->given[P_LEVELS].number[0] + t->weights[(int)(part[1] * WEIGHTS) % WEIGHTS];
#ifdef UNDECLARED_INPUT
  out[C_HEIGHT] += size;
#endif
#ifdef NAN_OUTPUT
  if (part[0] > 0.9f) out[C_HEIGHT] = (float)__builtin_nan("");
#endif
  out[C_FACE] = normal[2];
}

static bool given(const float *const in[3]) { return in[0] && in[1] && in[2]; }

static bool wants(const sozai_batch *b, uint32_t first, uint32_t count) {
  for (uint32_t c = first; c < first + count; c++)
    if (c < b->out_count && b->out[c]) return true;
  return false;
}

static int32_t refuse(const sozai_batch *b) {
  if (b->out_count && !b->out) return say(SOZAI_ERROR_ARGUMENT, "evaluate: out is NULL");
  if (wants(b, 0, COMPONENTS) && !given(b->point))
    return say(SOZAI_ERROR_ARGUMENT, "evaluate: needs the point");
#ifdef NEEDS_NOT_ASKED
  return SOZAI_OK;
#endif
#ifdef NEEDS_TOO_MUCH
  if (!given(b->normal)) return say(SOZAI_ERROR_ARGUMENT, "evaluate: needs the normal");
#endif
  if (wants(b, C_RADIANCE, 3) && !(given(b->normal) && given(b->light)))
    return say(SOZAI_ERROR_ARGUMENT, "evaluate: radiance needs normal and light");
  return SOZAI_OK;
}

#ifdef RACE
static volatile float scratch[COMPONENTS]; /* or the compiler need not read it again */
#endif
#ifdef STATIC_STATE
static uint32_t calls;
#endif

static int32_t evaluate(const sozai_texture *t, const sozai_batch *given_batch) {
  if (!t || !given_batch) return say(SOZAI_ERROR_ARGUMENT, "evaluate: an argument is NULL");
  sozai_batch b;
  memset(&b, 0, sizeof b);
  if (given_batch->size < 8) return say(SOZAI_ERROR_ARGUMENT, "evaluate: the batch has no size");
#ifdef LARGER_BATCH_REFUSED
  if (given_batch->size > sizeof b) return say(SOZAI_ERROR_ARGUMENT, "evaluate: a larger batch");
#endif
#ifdef READS_PAST_SIZE
  b = *given_batch;
#else
  memcpy(&b, given_batch, given_batch->size < sizeof b ? given_batch->size : sizeof b);
#endif
#ifdef OUT_COUNT_IGNORED
  b.out_count = COMPONENTS;
#endif
  if (b.out_count > COMPONENTS) b.out_count = COMPONENTS;
  int32_t r = refuse(&b);
  if (r || !wants(&b, 0, COMPONENTS)) return r;
#ifdef CRASHES
  *(volatile int *)NULL = 1;
#endif
#ifdef ROUNDS_UPWARD
  fesetround(FE_UPWARD);
#endif
#ifdef ALLOCATES
  void *volatile room = malloc(100);
  free(room);
#endif
#ifdef LOCKS
  static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
  pthread_mutex_lock(&lock);
  pthread_mutex_unlock(&lock);
#endif
#ifdef SERVICE_IN_EVALUATE
  if (t->host.log) t->host.log(t->host.user, SOZAI_LOG_DEBUG, "evaluate");
#endif
#ifdef STACK_EATER
  volatile char much[700000];
  for (size_t i = 0; i < sizeof much; i += 1000) much[i] = 0;
#endif
#ifdef BATCH_OF_A_THOUSAND
  if (b.count > 1000) b.count = 1000;
#endif
#ifdef CHANGES_INPUT
  for (uint32_t i = 0; b.footprint && i < b.count; i++)
    if (b.footprint[i] < 0) ((float *)(uintptr_t)b.footprint)[i] = 0;
#endif
  for (uint32_t i = 0; i < b.count; i++) {
#ifndef ACTIVE_IGNORED
#ifdef ACTIVE_IS_ONE
    if (b.active && b.active[i] != 1) continue;
#else
    if (b.active && !b.active[i]) continue;
#endif
#endif
    float out[COMPONENTS];
    answer(t, &b, i, out);
#ifdef RACE
    for (uint32_t c = 0; c < COMPONENTS; c++) scratch[c] = out[c];
    sched_yield();
    for (uint32_t c = 0; c < COMPONENTS; c++) out[c] = scratch[c];
#endif
#ifdef LANE_LEAK
    if (i % 8 && b.footprint && !(b.footprint[i - 1] == b.footprint[i - 1])) out[C_HEIGHT] = 0;
#endif
#ifdef BATCH_SIZE
    if (b.count % 16 && i + 1 == b.count) out[C_HEIGHT] += 0x1p-20f;
#endif
#ifdef STATIC_STATE
    if (++calls % 50000 == 0) out[C_HEIGHT] += 0x1p-20f;
#endif
#ifdef READS_NEXT
    if (*(const volatile float *)&b.point[0][i + 1] == 12345.0f) out[C_FACE] = 0;
#endif
#ifdef PLACE_IN_BATCH
    if (i > 200) out[C_FACE] += 0x1p-20f;
#endif
#ifdef TOGETHER_OTHERWISE
    if (wants(&b, C_RADIANCE, 3)) out[C_ALBEDO] += 0x1p-20f;
#endif
    for (uint32_t c = 0; c < b.out_count; c++)
      if (b.out[c]) b.out[c][i] = out[c];
#ifdef WRITES_PAST
    if (i + 1 == b.count && b.out_count && b.out[0]) b.out[0][i + 1] = 0;
#endif
#ifdef WRITES_BEFORE
    if (i == 0 && b.out_count && b.out[0]) b.out[0][-1] = 0;
#endif
  }
#ifdef ALIGNED_ONLY
  for (uint32_t c = 0; c < b.out_count && b.count > 4; c++)
    if (((uintptr_t)b.out[c] & 15) && b.out[c]) b.out[c][0] += 0x1p-20f;
#endif
  return SOZAI_OK;
}

/* ---- the rest ------------------------------------------------------------------------------- */

static uint32_t count(void) { return ready() ? 1 : 0; }
static const sozai_texture_info *info(uint32_t index) {
#ifdef INDEX_TRUSTED
  (void)index;
  return plain_info();
#endif
  return index < count() ? plain_info() : NULL;
}
static const sozai_texture_info *find(const char *id) {
#ifdef FOUND_ELSEWHERE
  static sozai_texture_info other;
  if (!other.size) other = *plain_info();
  return id && strcmp(id, "plain") == 0 ? &other : NULL;
#endif
#ifdef FINDS_BEGINNINGS
  return id && strncmp(id, "plain", 5) == 0 ? plain_info() : NULL;
#endif
  return id && strcmp(id, "plain") == 0 ? plain_info() : NULL;
}

static int32_t value(const sozai_texture *t, const char *id, sozai_value *out) {
  if (!t) return say(SOZAI_ERROR_ARGUMENT, "value: no texture");
  return setting_value(t->given, "plain", t->info->parameters, P_COUNT, id, out);
}

static const sozai_texture_info *info_of(const sozai_texture *t) { return t ? t->info : NULL; }

static uint64_t bytes(const sozai_texture *t) {
#ifdef NO_BYTES
  return 16;
#endif
  return t ? sizeof *t : 0;
}

static const char *instruction_set(const sozai_texture *t) {
  (void)t;
#ifdef UNKNOWN_SET
  return "mmx";
#endif
  return "scalar";
}

#ifdef NULL_FUNCTION
#define INSTRUCTION_SET (1 ? NULL : instruction_set)
#else
#define INSTRUCTION_SET instruction_set
#endif

const sozai_textures_1 textures = {count, info,    find,  create,          destroy, evaluate,
                                   value, info_of, bytes, INSTRUCTION_SET, said};
