/* SPDX-License-Identifier: Apache-2.0
 *
 * Every allocation through the host's allocator fails in turn, alone and with
 * all that follow, while everything is made that the plugin makes: a clean
 * error, nothing leaked, and the next that is made is as it should be.
 */
#include <string.h>

#include "cases.h"

static uint32_t injected;

/* With the k-th failing, and if `on`, all later. */
static sozai_host failing_host(allocator *a, uint32_t k, int on) {
  sozai_host host = allocator_host(a);
  if (on)
    a->fail_on = k;
  else
    a->fail_at = k;
  return host;
}

static void must_be_clean(const allocator *a, int32_t r) {
  assert_int_equal(r, SOZAI_ERROR_MEMORY);
  assert_non_null(strstr(textures->last_error(), "memory"));
  assert_int_equal(a->live, 0);
  assert_int_equal(a->wrong, 0);
  injected++;
}

/* Its mesh and its curves, likewise. */
static uint32_t fail_blocks(const made *c) {
  allocator a;
  sozai_host host = allocator_host(&a);
  thing t;
  uint32_t fails = 0;
  assert_int_equal(case_make(c, &host, &t), SOZAI_OK);
  uint32_t live = a.live;
  for (int curves = 0; curves < 2; curves++) {
    int32_t r = SOZAI_ERROR_MEMORY;
    for (uint32_t k = 1; r; k++) {
      assert_true(k < 100);
      a.fail_on = a.calls + k;
      const sozai_mesh *m = (const sozai_mesh *)(uintptr_t)1;
      const sozai_curves *l = (const sozai_curves *)(uintptr_t)1;
      r = curves ? geometry->curves(t.geometry, NULL, &l) : geometry->mesh(t.geometry, NULL, &m);
      if (!r) {
        geometry->release_curves(curves ? l : NULL);
        geometry->release_mesh(curves ? NULL : m);
      } else {
        assert_int_equal(r, SOZAI_ERROR_MEMORY);
        assert_non_null(strstr(geometry->last_error(), "memory"));
        if (curves) assert_null(l);
        if (!curves) assert_null(m);
        fails++;
        injected++;
      }
      assert_int_equal(a.live, live);
      assert_int_equal(a.wrong, 0);
    }
  }
  case_free(&t);
  assert_int_equal(a.live, 0);
  return fails;
}

/* What it would take: the same path, and its own ends. */
static uint32_t fail_memory(const made *c) {
  for (uint32_t k = 1;; k++) {
    assert_true(k < 1000);
    allocator a;
    sozai_host host = failing_host(&a, k, 0);
    sozai_memory m = {.size = sizeof m};
    int32_t r = c->texture
                    ? memory->texture(&host, c->texture, c->preset, c->values, c->count, &m)
                    : memory->geometry(&host, c->generator, c->preset, c->values, c->count, &m);
    assert_int_equal(a.live, 0);
    assert_int_equal(a.wrong, 0);
    if (r == SOZAI_OK) return k - 1;
    must_be_clean(&a, r);
    assert_int_equal(m.held, 0);
  }
}

static uint32_t fail_each(const made *c, int on) {
  for (uint32_t k = 1;; k++) {
    assert_true(k < 1000);
    allocator a;
    sozai_host host = failing_host(&a, k, on);
    thing t;
    int32_t r = case_make(c, &host, &t);
    if (r == SOZAI_OK) {
      case_free(&t);
      assert_int_equal(a.live, 0);
      assert_int_equal(a.wrong, 0);
      return k - 1;
    }
    if (r != SOZAI_ERROR_MEMORY) print_message("%s: %s\n", c->name, textures->last_error());
    must_be_clean(&a, r);
    assert_null(t.texture);
    assert_null(t.geometry);
  }
}

static void each_allocation_fails(void **unused) {
  (void)unused;
  for (const made *c = cases; c->name; c++) {
    uint32_t alone = fail_each(c, 0), all = fail_each(c, 1), planned = fail_memory(c), blocks = 0;
    assert_true(alone >= 3 && alone == all);
    if (c->generator) blocks = fail_blocks(c);
    print_message("%-32s %3u allocations, each failed alone and with all after it; "
                  "%u of its estimate's, %u of its mesh's and curves'\n",
                  c->name, alone, planned, blocks);
  }
  print_message("%u failures injected\n", injected);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(each_allocation_fails)};
  return cmocka_run_group_tests(tests, cases_open, cases_close);
}
