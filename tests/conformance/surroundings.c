/* SPDX-License-Identifier: Apache-2.0
 *
 * What no call may change or use behind the host's back: the floating-point
 * environment, the locale, the standard streams, and memory in evaluate.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <fenv.h>
#include <locale.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cmocka.h>

#include "batch.h"

/* ---- every allocation of the process, counted -------------------------- */

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define COUNTED 0 /* the sanitizers have these functions to themselves */
static atomic_uint allocations;
#else
#define COUNTED 1
static atomic_uint allocations;
/* The program's own come before libc's for every library that it loads. */
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t n, size_t size);
void *__libc_realloc(void *memory, size_t size);
void *__libc_memalign(size_t align, size_t size);
void __libc_free(void *memory);
#define EXPORT __attribute__((visibility("default"), noinline))
EXPORT void *malloc(size_t size) {
  atomic_fetch_add(&allocations, 1);
  return __libc_malloc(size);
}
EXPORT void *calloc(size_t n, size_t size) {
  atomic_fetch_add(&allocations, 1);
  return __libc_calloc(n, size);
}
EXPORT void *realloc(void *memory, size_t size) {
  atomic_fetch_add(&allocations, 1);
  return __libc_realloc(memory, size);
}
EXPORT void *aligned_alloc(size_t align, size_t size) {
  atomic_fetch_add(&allocations, 1);
  return __libc_memalign(align, size);
}
EXPORT void *memalign(size_t align, size_t size) {
  atomic_fetch_add(&allocations, 1);
  return __libc_memalign(align, size);
}
EXPORT int posix_memalign(void **out, size_t align, size_t size) {
  atomic_fetch_add(&allocations, 1);
  *out = __libc_memalign(align, size);
  return *out ? 0 : ENOMEM;
}
EXPORT void free(void *memory) { __libc_free(memory); }
#endif

/* ---- a round through every function ------------------------------------ */

static plugin p;
static full_batch b;

static void *host_alloc(void *user, size_t size, size_t align) {
  ++*(uint32_t *)user;
  return aligned_alloc(align, (size + align - 1) / align * align);
}

static void host_free(void *user, void *memory, size_t size, size_t align) {
  (void)user, (void)size, (void)align;
  free(memory);
}

/* Called after every call, with its name. */
typedef void watcher(const char *call);

static void failing_calls(const sozai_textures_1 *t, sozai_texture *wood, watcher *watch) {
  sozai_texture *none;
  const sozai_value wrong = {.id = "ring_width", .kind = SOZAI_KIND_FLOAT, .number = {1e9}};
  t->create(NULL, "wood", NULL, &wrong, 1, &none);
  watch("create, refused");
  t->last_error();
  watch("last_error");
  sozai_batch empty = {.size = 3};
  t->evaluate(wood, &empty);
  watch("evaluate, refused");
  batch_make(&b, t->info(0), 8);
  b.batch.light[2] = NULL;
  t->evaluate(wood, &b.batch);
  watch("evaluate, refused for an input");
  t->create(NULL, "wood", "no such preset", NULL, 0, &none);
  t->create(NULL, "no such texture", NULL, NULL, 0, &none);
  watch("create of nothing known");
}

static void every_call(const sozai_host *host, watcher *watch) {
  p.entry->init(ALONE);
  watch("init");
  const sozai_textures_1 *t = p.entry->get_factory(SOZAI_TEXTURES_1);
  const sozai_wood_1 *w = p.entry->get_factory(SOZAI_WOOD_1);
  watch("get_factory");
  const sozai_texture_info *info = t->find("wood");
  t->count(), t->info(0);
  watch("find, count, info");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    const sozai_value value = {
        .id = "earlywood_colour", .kind = SOZAI_KIND_STRING, .text = "0.6 0.5 0.4"};
    sozai_texture *wood = NULL;
    t->create(host, "wood", info->presets[i]->id, &value, 1, &wood);
    watch("create");
    batch_make(&b, info, 1000);
    t->evaluate(wood, &b.batch);
    watch("evaluate");
    b.batch.count = 1;
    t->evaluate(wood, &b.batch);
    watch("evaluate, one point");
    w->ring_radius(wood, 100, b.in[15], b.in[1], b.in[2], b.out[0]);
    watch("ring_radius");
    w->pith(wood, 100, b.in[0], b.out[0], b.out[1]);
    watch("pith");
    sozai_value v;
    t->value(wood, "seed", &v);
    t->info_of(wood), t->bytes(wood), t->instruction_set(wood);
    watch("value, info_of, bytes, instruction_set");
    failing_calls(t, wood, watch);
    t->destroy(wood);
    watch("destroy");
  }
  p.entry->deinit();
  watch("deinit");
}

/* ---- floating point and locale ----------------------------------------- */

static int rounding;
static char locale_name[64];
static uint32_t control;

/* Rounding, masks, and what becomes of denormals; not the sticky flags, which
 * any arithmetic may raise. */
static uint32_t control_word(void) {
#if defined(__x86_64__)
  uint16_t x87;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  return (__builtin_ia32_stmxcsr() & ~0x3fu) | (uint32_t)x87 << 16;
#elif defined(__aarch64__)
  uint64_t fpcr;
  __asm__ volatile("mrs %0, fpcr" : "=r"(fpcr));
  return (uint32_t)fpcr;
#else
  return (uint32_t)fegetround();
#endif
}

static void environment_same(const char *call) {
  if (fegetround() != rounding || control_word() != control) {
    fail_msg("%s changed the floating-point environment: %08x, not %08x", call, control_word(),
             control);
  }
  if (strcmp(setlocale(LC_ALL, NULL), locale_name) != 0 ||
      uselocale((locale_t)0) != LC_GLOBAL_LOCALE) {
    fail_msg("%s changed the locale", call);
  }
}

static void environment(void **unused) {
  (void)unused;
  static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_TOWARDZERO};
  for (int i = 0; i < 6; i++) {
    setlocale(LC_ALL, i % 2 ? "C.UTF-8" : "C");
    snprintf(locale_name, sizeof locale_name, "%s", setlocale(LC_ALL, NULL));
    rounding = modes[i / 2];
    fesetround(rounding);
#if defined(__x86_64__)
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() ^ 0x8040u); /* denormals to zero, or not */
#endif
    control = control_word();
    every_call(NULL, environment_same);
    fesetround(FE_TONEAREST);
  }
  setlocale(LC_ALL, "C");
}

/* ---- streams ----------------------------------------------------------- */

static void ignore(const char *call) { (void)call; }

static void streams(void **unused) {
  (void)unused;
  fflush(NULL);
  int kept[2] = {dup(1), dup(2)};
  FILE *file = tmpfile();
  assert_non_null(file);
  dup2(fileno(file), 1);
  dup2(fileno(file), 2);
  every_call(NULL, ignore);
  fflush(NULL);
  struct stat now;
  fstat(fileno(file), &now);
  dup2(kept[0], 1);
  dup2(kept[1], 2);
  close(kept[0]);
  close(kept[1]);
  fclose(file);
  assert_int_equal(now.st_size, 0);
}

/* ---- signals ----------------------------------------------------------- */

static void handlers(void **unused) {
  (void)unused;
  struct sigaction before[32], after;
  sigset_t mask, mask_after;
  for (int s = 1; s < 32; s++) sigaction(s, NULL, &before[s]);
  sigprocmask(SIG_SETMASK, NULL, &mask);
  every_call(NULL, ignore);
  for (int s = 1; s < 32; s++) {
    sigaction(s, NULL, &after);
    assert_true(after.sa_handler == before[s].sa_handler);
  }
  sigprocmask(SIG_SETMASK, NULL, &mask_after);
  for (int s = 1; s < 32; s++) {
    assert_int_equal(sigismember(&mask, s), sigismember(&mask_after, s));
  }
}

/* ---- memory ------------------------------------------------------------ */

static void evaluate_allocates_nothing(void **unused) {
  (void)unused;
  uint32_t asked = 0;
  const sozai_host host = {
      .size = sizeof host, .user = &asked, .alloc = host_alloc, .free = host_free};
  p.entry->init(ALONE);
  const sozai_textures_1 *t = p.entry->get_factory(SOZAI_TEXTURES_1);
  const sozai_wood_1 *w = p.entry->get_factory(SOZAI_WOOD_1);
  sozai_texture *wood = NULL;
  unsigned at_first = atomic_load(&allocations);
  assert_int_equal(t->create(&host, "wood", "keyaki", NULL, 0, &wood), SOZAI_OK);
  assert_true(asked > 0);
  if (COUNTED) assert_true(atomic_load(&allocations) > at_first); /* the counting counts */
  batch_make(&b, t->find("wood"), BATCH_MAX);
  unsigned before = atomic_load(&allocations), asked_before = asked;
  for (uint32_t n = 0; n < 200; n++) {
    b.batch.count = n * 5;
    t->evaluate(wood, &b.batch);
    b.batch.size = n; /* refused, or the long way */
    t->evaluate(wood, &b.batch);
    b.batch.size = sizeof b.batch;
    w->pith(wood, 10, b.in[0], b.out[0], b.out[1]);
    w->ring_radius(wood, 10, b.in[15], b.in[1], b.in[2], b.out[0]);
  }
  unsigned after = atomic_load(&allocations);
  t->destroy(wood);
  p.entry->deinit();
  assert_int_equal(after - before, 0);
  assert_int_equal(asked, asked_before);
  if (!COUNTED) print_message("the host's allocator alone was watched\n");
}

static int start(void **unused) {
  (void)unused;
  return plugin_open(&p, SOZAI_TEST_PLUGIN);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(environment), cmocka_unit_test(streams),
                                     cmocka_unit_test(handlers),
                                     cmocka_unit_test(evaluate_allocates_nothing)};
  return cmocka_run_group_tests(tests, start, NULL);
}
