/* SPDX-License-Identifier: Apache-2.0
 *
 * Buffers handed in: copied whole, and refused where they cannot be right
 * before any of their arrays is read.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "allocator.h"
#include "core/status.h"
#include "every_kind.h"

#include <cmocka.h> /* last: it has a macro named fail */

static const float numbers[24] = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12,
                                  13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24};
static const uint32_t triangles[6] = {0, 1, 2, 2, 1, 3};

static allocator memory;
static sozai_host host;
static settings now;

static int32_t make(const char *id, const sozai_buffer *b) {
  sozai_value v = {.id = id, .kind = SOZAI_KIND_BUFFER, .buffer = b};
  return settings_make(&now, &host, &every_kind, NULL, &v, 1);
}

static void done(void) {
  settings_free(&now, &host);
  assert_int_equal(memory.live, 0);
  assert_int_equal(memory.wrong, 0);
}

static void refused(const char *id, sozai_buffer b, int32_t code, const char *word) {
  int32_t r = make(id, &b);
  if (r != code || !strstr(fail_message(), word) || !strstr(fail_message(), id)) {
    fail_msg("%s: %d, not %d: \"%s\", not \"%s\"", id, r, code, fail_message(), word);
  }
  assert_null(now.list);
  done();
}

static sozai_buffer table(void) {
  return (sozai_buffer){
      .size = sizeof(sozai_buffer), .kind = SOZAI_BUFFER_TABLE, .dims = {6, 2}, .data = numbers};
}

static sozai_buffer image(void) {
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_IMAGE,
                        .dims = {2, 3, 4},
                        .data = numbers,
                        .colour_space = "ACEScg"};
}

static sozai_buffer mesh(void) {
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_MESH,
                        .dims = {4, 2},
                        .points = numbers,
                        .normals = numbers + 12,
                        .indices = triangles};
}

static sozai_buffer cloud(void) {
  return (sozai_buffer){
      .size = sizeof(sozai_buffer), .kind = SOZAI_BUFFER_POINTS, .dims = {8}, .points = numbers};
}

static const sozai_buffer *kept(const char *id) {
  sozai_value v;
  assert_int_equal(settings_value(&now, &every_kind, id, &v), SOZAI_OK);
  return v.buffer;
}

static void copies(void **unused) {
  (void)unused;
  sozai_buffer b = table();
  assert_int_equal(make("table", &b), SOZAI_OK);
  assert_ptr_not_equal(kept("table")->data, numbers);
  assert_memory_equal(kept("table")->data, numbers, 12 * sizeof(float));
  done();
  b = image();
  assert_int_equal(make("image", &b), SOZAI_OK);
  assert_memory_equal(kept("image")->data, numbers, 24 * sizeof(float));
  assert_string_equal(kept("image")->colour_space, "ACEScg");
  assert_ptr_not_equal(kept("image")->colour_space, b.colour_space);
  done();
  b = mesh();
  assert_int_equal(make("mesh", &b), SOZAI_OK);
  assert_memory_equal(kept("mesh")->points, numbers, 12 * sizeof(float));
  assert_memory_equal(kept("mesh")->normals, numbers + 12, 12 * sizeof(float));
  assert_memory_equal(kept("mesh")->indices, triangles, sizeof triangles);
  assert_ptr_not_equal(kept("mesh")->indices, triangles);
  done();
  b = cloud();
  assert_int_equal(make("points", &b), SOZAI_OK);
  assert_memory_equal(kept("points")->points, numbers, 24 * sizeof(float));
  assert_null(kept("points")->normals);
  done();
}

/* None, empty, and a struct from before its last members were added. */
static void less(void **unused) {
  (void)unused;
  assert_int_equal(make("table", NULL), SOZAI_OK);
  assert_null(kept("table"));
  done();
  sozai_buffer b = {.size = sizeof b, .kind = SOZAI_BUFFER_TABLE};
  assert_int_equal(make("table", &b), SOZAI_OK);
  done();
  b = image();
  b.size = offsetof(sozai_buffer, colour_space);
  b.colour_space = (const char *)(uintptr_t)1; /* must not be looked at */
  assert_int_equal(make("image", &b), SOZAI_OK);
  assert_null(kept("image")->colour_space);
  done();
  b = table();
  b.size = sizeof b + 64; /* from after some were added */
  assert_int_equal(make("table", &b), SOZAI_OK);
  assert_int_equal(kept("table")->size, sizeof b);
  done();
}

static void null_arrays(void **unused) {
  (void)unused;
  sozai_buffer b = table();
  b.data = NULL;
  refused("table", b, SOZAI_ERROR_ARGUMENT, "NULL");
  b = image();
  b.data = NULL;
  refused("image", b, SOZAI_ERROR_ARGUMENT, "NULL");
  b = mesh();
  b.points = NULL;
  refused("mesh", b, SOZAI_ERROR_ARGUMENT, "points are NULL");
  b = mesh();
  b.indices = NULL;
  refused("mesh", b, SOZAI_ERROR_ARGUMENT, "indices are NULL");
  b = cloud();
  b.points = NULL;
  refused("points", b, SOZAI_ERROR_ARGUMENT, "points are NULL");
}

static void wrong_kinds(void **unused) {
  (void)unused;
  refused("table", image(), SOZAI_ERROR_KIND, "kind 1");
  refused("points", mesh(), SOZAI_ERROR_KIND, "kind 4");
  sozai_buffer b = table();
  b.size = 0;
  refused("table", b, SOZAI_ERROR_ARGUMENT, "size");
  b.size = sizeof b;
  b.kind = 99;
  refused("table", b, SOZAI_ERROR_KIND, "99");
}

static void indices_out_of_range(void **unused) {
  (void)unused;
  static const uint32_t one_too_many[6] = {0, 1, 2, 2, 1, 4},
                        most[6] = {0, 1, 0xffffffffu, 0, 0, 0};
  sozai_buffer b = mesh();
  b.indices = one_too_many;
  refused("mesh", b, SOZAI_ERROR_RANGE, "index 4 is not below the 4 points");
  b.indices = most;
  refused("mesh", b, SOZAI_ERROR_RANGE, "index 4294967295");
  b.dims[0] = 0;
  b.indices = triangles;
  refused("mesh", b, SOZAI_ERROR_RANGE, "index 0");
}

/* Products that overflow 64 bits, or only memory. Nothing may be read. */
static void absurd_dimensions(void **unused) {
  (void)unused;
  static const uint64_t dims[][3] = {{1ull << 32, 1ull << 32, 0},
                                     {0xffffffffffffffffu, 1, 0},
                                     {1u << 30, 1u << 30, 0},
                                     {1u << 30, 2, 0},
                                     {0x8000000000000001u, 0xffffffffffffffffu, 0}};
  for (size_t i = 0; i < sizeof dims / sizeof *dims; i++) {
    sozai_buffer b = table();
    memcpy(b.dims, dims[i], sizeof b.dims);
    refused("table", b, SOZAI_ERROR_LIMIT, "above the ceiling");
    b = mesh();
    memcpy(b.dims, dims[i], sizeof b.dims);
    refused("mesh", b, SOZAI_ERROR_LIMIT, "above the ceiling");
  }
  static const uint64_t images[][3] = {{1u << 20, 1u << 20, 1u << 24},
                                       {1u << 30, 1u << 30, 16},
                                       {1u << 20, 1u << 20, 0xffffffffu},
                                       {1u << 22, 1u << 22, 1u << 20},
                                       {65536, 65536, 4}};
  for (size_t i = 0; i < sizeof images / sizeof *images; i++) {
    sozai_buffer b = image();
    memcpy(b.dims, images[i], sizeof b.dims);
    refused("image", b, SOZAI_ERROR_LIMIT, "above the ceiling");
  }
}

/* With every value at once: each allocation fails in turn. */
static void no_memory(void **unused) {
  (void)unused;
  sozai_buffer t = table(), i = image(), m = mesh(), p = cloud();
  const sozai_value values[] = {
      {.id = "table", .kind = SOZAI_KIND_BUFFER, .buffer = &t},
      {.id = "image", .kind = SOZAI_KIND_BUFFER, .buffer = &i},
      {.id = "mesh", .kind = SOZAI_KIND_BUFFER, .buffer = &m},
      {.id = "points", .kind = SOZAI_KIND_BUFFER, .buffer = &p},
      {.id = "name", .kind = SOZAI_KIND_TEXT, .text = "somebody"},
      {.id = "tint", .kind = SOZAI_KIND_STRING, .text = "#102030 @ ACEScg"}};
  uint32_t calls = 0;
  for (;; calls++) {
    host = allocator_host(&memory);
    memory.fail_at = calls + 1;
    int32_t r = settings_make(&now, &host, &every_kind, "small", values, 6);
    if (r == SOZAI_OK) break;
    assert_int_equal(r, SOZAI_ERROR_MEMORY);
    assert_non_null(strstr(fail_message(), "memory"));
    assert_null(now.list);
    done();
  }
  print_message("settings: %u allocations, each failed in turn\n", calls);
  assert_true(calls >= 2);
  /* the scratch memory went back, and what is held is what is said */
  assert_int_equal(memory.live, 1);
  assert_int_equal(memory.bytes, now.bytes);
  done();
}

static int start(void **unused) {
  (void)unused;
  host = allocator_host(&memory);
  return status_open() ? 0 : -1;
}

static int stop(void **unused) {
  (void)unused;
  status_close();
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(copies),
                                     cmocka_unit_test(less),
                                     cmocka_unit_test(null_arrays),
                                     cmocka_unit_test(wrong_kinds),
                                     cmocka_unit_test(indices_out_of_range),
                                     cmocka_unit_test(absurd_dimensions),
                                     cmocka_unit_test(no_memory)};
  return cmocka_run_group_tests(tests, start, stop);
}
