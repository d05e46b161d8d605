/* SPDX-License-Identifier: Apache-2.0
 * The same bits on every machine: recorded, so that other compilers and
 * processors are held to them; with threads in any order; under any
 * instruction set. And clean ends: allocations that fail, hosts that cancel. */
#include "allocator.h"
#include "tree.h"

static uint64_t bits_of(const sozai_geometry *g) {
  uint64_t h = 0xcbf29ce484222325ull;
  const sozai_mesh *m = mesh_of(g, 0);
  h = fold(h, m->points, (size_t)m->point_count * 12);
  h = fold(h, m->normals, (size_t)m->point_count * 12);
  h = fold(h, m->indices, (size_t)m->triangle_count * 12);
  geometry()->release_mesh(m);
  const sozai_curves *c = curves_of(g, 0);
  h = fold(h, c->points, (size_t)c->point_count * 12);
  h = fold(h, c->radii, (size_t)c->point_count * 4);
  geometry()->release_curves(c);
  static const char *const tables[] = {"branches", "knots", "knot_radii", "rings",
                                       "turning",  "nodes", "statistics", "fit"};
  for (int i = 0; i < 8; i++) {
    sozai_table t = table_of(g, tables[i]);
    h = fold(h, t.data, (size_t)t.rows * t.info->column_count * 4);
  }
  return h;
}

/* Of all points: apart, so that what is grown and what it is painted with are told apart. */
static uint64_t colours_of(const sozai_geometry *g) {
  const sozai_mesh *m = mesh_of(g, 0);
  uint64_t h = fold(0xcbf29ce484222325ull, m->colours, (size_t)m->point_count * 12);
  geometry()->release_mesh(m);
  const sozai_curves *c = curves_of(g, 0);
  h = fold(h, c->colours, (size_t)c->point_count * 12);
  geometry()->release_curves(c);
  return h;
}

static const struct {
  const char *preset, *values;
  uint64_t bits, colours;
} recorded[] = {
#include "recorded.h"
};
#define RECORDED (sizeof recorded / sizeof *recorded)

static void as_recorded(void **unused) {
  (void)unused;
  int wrong = 0;
  for (size_t i = 0; i < RECORDED; i++) {
    sozai_geometry *g = grow(recorded[i].preset, recorded[i].values, NULL);
    uint64_t bits = bits_of(g);
    uint64_t colours = colours_of(g);
    if (bits != recorded[i].bits || colours != recorded[i].colours) wrong++;
    print_message("    {\"%s\", \"%s\", 0x%016llxull, 0x%016llxull},\n", recorded[i].preset,
                  recorded[i].values, (unsigned long long)bits, (unsigned long long)colours);
    geometry()->release(g);
  }
  assert_int_equal(wrong, 0);
}

static void any_order_any_set(void **unused) {
  (void)unused;
  sozai_host host = {.size = sizeof host};
  static const char *const sets[] = {"scalar", "sse2", "avx2", "avx512", "nonsense"};
  for (int i = 0; i < 7; i++) {
    host.parallel = i == 0 ? backwards : i == 1 ? refuse : NULL;
    if (i >= 2) setenv("SOZAI_CPU", sets[i - 2], 1);
    sozai_geometry *g = NULL;
    assert_int_equal(grow_code(&host, recorded[0].preset, recorded[0].values, NULL, &g), SOZAI_OK);
    assert_true(bits_of(g) == recorded[0].bits && colours_of(g) == recorded[0].colours);
    geometry()->release(g);
  }
  unsetenv("SOZAI_CPU");
}

/* A pool that runs some and then refuses, or does not say so: the same, and no more than all of it
 * is told to be done. */
static void half_of_a_pool(void **unused) {
  (void)unused;
  for (int silent = 0; silent < 2; silent++) {
    sozai_host host = {.size = sizeof host, .parallel = silent ? drop : give_up, .progress = told};
    sozai_geometry *g = NULL;
    furthest = 0;
    assert_int_equal(grow_code(&host, recorded[0].preset, recorded[0].values, NULL, &g), SOZAI_OK);
    assert_true(bits_of(g) == recorded[0].bits);
    assert_true(furthest > 0.0f && furthest <= 1.0f);
    geometry()->release(g);
  }
}

static void each_allocation_fails(void **unused) {
  (void)unused;
  static const char *const fields[] = {NULL, "trunk\n50 0 90\n50 0 90\nB1\n0\n30 0 0\n"};
  for (int k = 0; k < 2; k++) {
    allocator memory;
    uint32_t failed = 0;
    for (uint32_t fail_at = 1;; fail_at++) {
      sozai_host host = allocator_host(&memory);
      memory.fail_at = fail_at;
      sozai_geometry *g = (sozai_geometry *)(uintptr_t)1;
      int32_t r = grow_code(&host, "sugi", "age=4", fields[k], &g);
      const sozai_mesh *m = NULL;
      const sozai_curves *c = NULL;
      if (r == SOZAI_OK) {
        assert_int_equal(memory.bytes, geometry()->bytes(g));
        r = geometry()->mesh(g, NULL, &m);
      } else {
        assert_null(g);
      }
      if (r == SOZAI_OK) r = geometry()->curves(g, NULL, &c);
      geometry()->release(g);
      geometry()->release_mesh(m);
      geometry()->release_curves(c);
      assert_int_equal(memory.live, 0);
      assert_int_equal(memory.wrong, 0);
      if (r == SOZAI_OK) break;
      assert_int_equal(r, SOZAI_ERROR_MEMORY);
      assert_non_null(strstr(geometry()->last_error(), "memory"));
      failed++;
      assert_true(failed < 1000);
    }
    print_message("%u allocations, each failed in turn\n", failed);
    assert_true(failed > 10);
  }
}

typedef struct {
  uint32_t calls, stop_at;
} watcher;

static void *watched_alloc(void *user, size_t size, size_t align) {
  (void)user;
  return aligned_alloc(align, (size + align - 1) / align * align);
}

static void watched_free(void *user, void *memory, size_t size, size_t align) {
  (void)user, (void)size, (void)align;
  free(memory);
}

static int32_t watch(void *user, float fraction, const char *what) {
  watcher *w = user;
  assert_non_null(what);
  assert_true(fraction >= 0.0f && fraction <= 1.0f);
  w->calls++;
  return w->calls == w->stop_at;
}

static void cancel_at_each_call(void **unused) {
  (void)unused;
  for (uint32_t stop = 1;; stop++) {
    watcher w = {.stop_at = stop};
    sozai_host host = {.size = sizeof host,
                       .user = &w,
                       .alloc = watched_alloc,
                       .free = watched_free,
                       .progress = watch};
    sozai_geometry *g = (sozai_geometry *)(uintptr_t)1;
    int32_t r = grow_code(&host, "akamatsu", "age=5", NULL, &g);
    const sozai_mesh *m = NULL;
    const sozai_curves *c = NULL;
    if (r) assert_null(g);
    if (r == SOZAI_OK) r = geometry()->mesh(g, NULL, &m);
    if (r == SOZAI_OK) r = geometry()->curves(g, NULL, &c);
    geometry()->release(g);
    geometry()->release_mesh(m);
    geometry()->release_curves(c);
    if (r == SOZAI_OK) {
      print_message("cancelled at each of %u calls\n", stop - 1);
      assert_true(stop > 40);
      break;
    }
    assert_int_equal(r, SOZAI_ERROR_CANCELLED);
    assert_non_null(strstr(geometry()->last_error(), "cancelled"));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(as_recorded), cmocka_unit_test(any_order_any_set),
      cmocka_unit_test(half_of_a_pool), cmocka_unit_test(each_allocation_fails),
      cmocka_unit_test(cancel_at_each_call)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
