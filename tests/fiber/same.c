/* SPDX-License-Identifier: Apache-2.0
 * The same bits on every machine: recorded, so that other compilers and
 * processors are held to them; with threads in any order; under any
 * instruction set. And clean ends: allocations that fail, hosts that cancel. */
#include "allocator.h"
#include "fiber.h"

/* A hull of no library's sines: corners that are written down. */
static mesh hull(void) { return box_of(16, 9, 21); }

static const struct {
  const char *values;
  uint64_t bits;
} recorded[] = {
#include "recorded.h"
};
#define RECORDED (sizeof recorded / sizeof *recorded)

static uint64_t bits_of(const sozai_geometry *g) {
  uint64_t h = 0xcbf29ce484222325ull;
  const sozai_curves *c = curves_of(g);
  const sozai_mesh *m = NULL;
  h = fold(h, c->points, (size_t)c->point_count * 12);
  h = fold(h, c->radii, (size_t)c->point_count * 4);
  h = fold(h, c->ids, (size_t)c->curve_count * 4);
  geometry()->release_curves(c);
  assert_int_equal(geometry()->mesh(g, NULL, &m), SOZAI_OK);
  h = fold(h, m->points, (size_t)m->point_count * 12);
  h = fold(h, m->normals, (size_t)m->point_count * 12);
  h = fold(h, m->indices, (size_t)m->triangle_count * 12);
  geometry()->release_mesh(m);
  static const char *const tables[] = {"statistics", "strands"};
  for (int i = 0; i < 2; i++) {
    sozai_table t = table_of(g, tables[i]);
    h = fold(h, t.data, (size_t)t.rows * t.info->column_count * 4);
  }
  return h;
}

static void as_recorded(void **unused) {
  (void)unused;
  int wrong = 0;
  mesh m = hull();
  for (size_t i = 0; i < RECORDED; i++) {
    sozai_geometry *g = NULL;
    assert_int_equal(grow_code(NULL, &m, recorded[i].values, &g), SOZAI_OK);
    uint64_t bits = bits_of(g);
    if (bits != recorded[i].bits) wrong++;
    print_message("    {\"%s\", 0x%016llxull},\n", recorded[i].values, (unsigned long long)bits);
    geometry()->release(g);
  }
  mesh_free(&m);
  assert_int_equal(wrong, 0);
}

static void any_order_any_set(void **unused) {
  (void)unused;
  mesh m = hull();
  static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512", "nonsense"};
  for (size_t k = 0; k < RECORDED; k++) {
    for (int i = 0; i < 8; i++) {
      sozai_host host = two_threads();
      if (i == 0) host.parallel = backwards;
      if (i == 1) host.parallel = refuse;
      if (i >= 3) setenv("SOZAI_CPU", sets[i - 3], 1);
      sozai_geometry *g = NULL;
      assert_int_equal(grow_code(&host, &m, recorded[k].values, &g), SOZAI_OK);
      assert_true(bits_of(g) == recorded[k].bits);
      geometry()->release(g);
    }
    unsetenv("SOZAI_CPU");
  }
  mesh_free(&m);
}

/* A pool that runs some and then refuses: the same, and no more than all of it is told to be done.
 */
static void half_of_a_pool(void **unused) {
  (void)unused;
  mesh m = hull();
  for (size_t k = 0; k < RECORDED; k++) {
    sozai_host host = {.size = sizeof host, .parallel = give_up, .progress = told};
    sozai_geometry *g = NULL;
    furthest = 0;
    assert_int_equal(grow_code(&host, &m, recorded[k].values, &g), SOZAI_OK);
    assert_true(bits_of(g) == recorded[k].bits);
    assert_true(furthest > 0.0f && furthest <= 1.0f);
    geometry()->release(g);
  }
  mesh_free(&m);
}

static void each_allocation_fails(void **unused) {
  (void)unused;
  static const char *const values[] = {"count=40 cells=16 contact=bend rounds=2",
                                       "count=40 mode=literal spacing=2"};
  mesh m = hull();
  for (int k = 0; k < 2; k++) {
    allocator memory;
    uint32_t failed = 0;
    for (uint32_t fail_at = 1;; fail_at++) {
      sozai_host host = allocator_host(&memory);
      memory.fail_at = fail_at;
      sozai_geometry *g = (sozai_geometry *)(uintptr_t)1;
      int32_t r = grow_code(&host, &m, values[k], &g);
      if (r == SOZAI_OK) {
        memory.fail_at = 0;
        const sozai_curves *c = curves_of(g);
        geometry()->release_curves(c);
        geometry()->release(g);
        assert_int_equal(memory.live, 0);
        break;
      }
      failed++;
      assert_int_equal(r, SOZAI_ERROR_MEMORY);
      assert_null(g);
      assert_int_equal(memory.live, 0);
      assert_int_equal(memory.wrong, 0);
      assert_true(fail_at < 200);
    }
    assert_true(failed > 8);
  }
  mesh_free(&m);
}

static int left;
static int32_t stop_after(void *user, float fraction, const char *what) {
  (void)user;
  assert_true(fraction >= 0 && fraction <= 1 && what && *what);
  return --left < 0;
}

static void cancelled(void **unused) {
  (void)unused;
  mesh m = hull();
  int ended = 0;
  for (int after = 0; after < 4000; after = after * 3 / 2 + 1) {
    allocator memory;
    sozai_host host = allocator_host(&memory);
    host.progress = stop_after;
    left = after;
    sozai_geometry *g = NULL;
    int32_t r = grow_code(&host, &m, "count=200 contact=rigid rounds=5", &g);
    if (r == SOZAI_OK) {
      geometry()->release(g);
      ended++;
    } else {
      assert_int_equal(r, SOZAI_ERROR_CANCELLED);
      assert_null(g);
      assert_non_null(strstr(geometry()->last_error(), "cancelled by the host"));
    }
    assert_int_equal(memory.live, 0);
    assert_int_equal(memory.wrong, 0);
  }
  assert_true(ended > 0 && ended < 10);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(as_recorded), cmocka_unit_test(any_order_any_set),
      cmocka_unit_test(half_of_a_pool), cmocka_unit_test(each_allocation_fails),
      cmocka_unit_test(cancelled)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
