/* SPDX-License-Identifier: Apache-2.0
 * A hull of ten million triangles, within the memory that docs/fiber.md states. */
#include "allocator.h"
#include "fiber.h"

#define MOST (1600.0 * 1024 * 1024)

static double most;
static allocator memory;
static sozai_host inner;

static void *counted(void *user, size_t size, size_t align) {
  (void)user;
  void *m = NULL;
  if (posix_memalign(&m, align < sizeof(void *) ? sizeof(void *) : align, size ? size : 1))
    return NULL;
  memory.bytes += size;
  if ((double)memory.bytes > most) most = (double)memory.bytes;
  return m;
}

static void uncounted(void *user, void *m, size_t size, size_t align) {
  (void)user, (void)align;
  memory.bytes -= size;
  free(m);
}

static void ten_million(void **unused) {
  (void)unused;
  mesh m;
  failure why;
  const double size[3] = {30, 20, 30};
  assert_true(hull_make_box(&m, size, 913, &why));
  assert_true(m.triangle_count > 10000000);
  inner = two_threads();
  inner.alloc = counted;
  inner.free = uncounted;
  sozai_geometry *g = NULL;
  int32_t r = grow_code(&inner, &m, "count=500", &g);
  if (r) print_error("%s\n", geometry()->last_error());
  assert_int_equal(r, SOZAI_OK);
  print_message("%u triangles: %.0f MiB at most, the buffer's copy among them; inside %.4f\n",
                m.triangle_count, most / 1048576, statistic(g, "inside"));
  assert_true(most < MOST);
  assert_true(statistic(g, "hull_rule") == 0);
  assert_true(statistic(g, "inside") > 0.999);
  geometry()->release(g);
  assert_true(memory.bytes == 0);
  mesh_free(&m);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(ten_million)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
