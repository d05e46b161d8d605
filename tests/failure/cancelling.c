/* SPDX-License-Identifier: Apache-2.0
 *
 * The host cancels at every one of its progress calls, of everything that
 * reports any: CANCELLED, nothing leaked, nothing half made.
 */
#include <string.h>

#include "cases.h"

typedef struct {
  allocator memory; /* first: the allocator's user */
  uint32_t reports, cancel_at;
  int backwards; /* not 0: a fraction was below the one before */
  float last;
} canceller;

static uint32_t cancelled;

static int32_t progress(void *user, float fraction, const char *what) {
  canceller *c = user;
  assert_non_null(what);
  assert_true(fraction >= 0.0f && fraction <= 1.0f);
  c->backwards |= fraction < c->last;
  c->last = fraction;
  return ++c->reports == c->cancel_at;
}

/* Jobs from the last to the first. */
static int32_t parallel(void *user, uint32_t count, void (*task)(void *context, uint32_t i),
                        void *context) {
  (void)user;
  for (uint32_t i = count; i--;) task(context, i);
  return 0;
}

static sozai_host host_of(canceller *c, uint32_t at, int in_parallel) {
  memset(c, 0, sizeof *c);
  sozai_host host = allocator_host(&c->memory);
  host.progress = progress;
  if (in_parallel) host.parallel = parallel;
  c->cancel_at = at;
  return host;
}

static void must_be_cancelled(const canceller *c, int32_t r) {
  assert_int_equal(r, SOZAI_ERROR_CANCELLED);
  assert_non_null(strstr(textures->last_error(), "cancelled"));
  assert_int_equal(c->memory.wrong, 0);
  cancelled++;
}

/* At the k-th of n: all of few, a spread of many. */
static uint32_t step_of(uint32_t n) { return n > 24 ? n / 12 : 1; }

static uint32_t cancel_making(const made *c, int in_parallel) {
  canceller k;
  thing t;
  sozai_host host = host_of(&k, 0, in_parallel);
  assert_int_equal(case_make(c, &host, &t), SOZAI_OK);
  case_free(&t);
  uint32_t n = k.reports;
  int pictures = c->texture && c->values && c->values[0].kind == SOZAI_KIND_IMAGE;
  assert_true(!pictures || n >= 2);       /* as it begins to be read, and as it has been */
  assert_true(!pictures || !k.backwards); /* nor does a tree after it begin the bar anew */
  for (uint32_t at = 1; at <= n; at += step_of(n)) {
    host = host_of(&k, at, in_parallel);
    must_be_cancelled(&k, case_make(c, &host, &t));
    assert_null(t.texture);
    assert_null(t.geometry);
    assert_int_equal(k.memory.live, 0);
  }
  return n;
}

static uint32_t cancel_blocks(const made *c) {
  canceller k;
  thing t;
  uint32_t all = 0;
  sozai_host host = host_of(&k, 0, 0);
  assert_int_equal(case_make(c, &host, &t), SOZAI_OK);
  uint32_t live = k.memory.live;
  for (int curves = 0; curves < 2; curves++) {
    uint32_t n = 0;
    for (uint32_t at = 0; at <= n; at++) {
      const sozai_mesh *m = NULL;
      const sozai_curves *l = NULL;
      k.reports = 0;
      k.cancel_at = at;
      int32_t r =
          curves ? geometry->curves(t.geometry, NULL, &l) : geometry->mesh(t.geometry, NULL, &m);
      if (at == 0) {
        assert_int_equal(r, SOZAI_OK);
        n = k.reports;
        assert_true(n >= 2); /* at its beginning and its end, at least */
        geometry->release_curves(l);
        geometry->release_mesh(m);
      } else {
        must_be_cancelled(&k, r);
        assert_null(l);
        assert_null(m);
      }
      assert_int_equal(k.memory.live, live);
    }
    all += n;
  }
  case_free(&t);
  assert_int_equal(k.memory.live, 0);
  return all;
}

static uint32_t cancel_planning(const made *c) {
  canceller k;
  sozai_host host = host_of(&k, 0, 0);
  sozai_memory m = {.size = sizeof m};
  uint32_t n = 0;
  for (uint32_t at = 0; at <= n; at += at ? step_of(n) : 1) {
    host = host_of(&k, at, 0);
    int32_t r = c->texture
                    ? memory->texture(&host, c->texture, c->preset, c->values, c->count, &m)
                    : memory->geometry(&host, c->generator, c->preset, c->values, c->count, &m);
    if (at) must_be_cancelled(&k, r);
    if (!at) assert_int_equal(r, SOZAI_OK);
    if (!at) n = k.reports;
    assert_int_equal(k.memory.live, 0);
  }
  return n;
}

static void each_report_cancels(void **unused) {
  (void)unused;
  for (const made *c = cases; c->name; c++) {
    uint32_t n = cancel_making(c, 0), p = cancel_making(c, 1), planned = cancel_planning(c);
    assert_int_equal(n, p);
    if (!c->generator && !n) continue; /* a texture of no long work */
    uint32_t blocks = c->generator ? cancel_blocks(c) : 0;
    assert_true(n >= 1);
    print_message("%-32s %4u reports, %u of its estimate, %u of its mesh and curves\n", c->name, n,
                  planned, blocks);
  }
  print_message("%u times cancelled\n", cancelled);
  assert_true(cancelled > 200);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(each_report_cancels)};
  return cmocka_run_group_tests(tests, cases_open, cases_close);
}
