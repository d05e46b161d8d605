/* SPDX-License-Identifier: Apache-2.0
 *
 * Pictures as they are named: by text, by a path, by a buffer.
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

static const float numbers[24] = {1};
static allocator memory;
static sozai_host host;
static settings now;

static int32_t make(sozai_value v) {
  v.id = "picture";
  return settings_make(&now, &host, &every_kind, NULL, &v, 1);
}

static int32_t make_text(const char *text) {
  return make((sozai_value){.kind = SOZAI_KIND_STRING, .text = text});
}

static int32_t make_buffer(const sozai_buffer *b) {
  return make((sozai_value){.kind = SOZAI_KIND_IMAGE, .buffer = b});
}

static void done(void) {
  settings_free(&now, &host);
  assert_int_equal(memory.live, 0);
  assert_int_equal(memory.wrong, 0);
}

static void expect(const char *text, const char *path, const char *space, uint32_t wrap,
                   uint32_t channel) {
  assert_int_equal(make_text(text), SOZAI_OK);
  sozai_value v;
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_int_equal(v.kind, SOZAI_KIND_IMAGE);
  assert_non_null(v.buffer);
  assert_string_equal(v.buffer->path, path);
  assert_string_equal(v.text, path);
  if (space) {
    assert_string_equal(v.buffer->colour_space, space);
  } else {
    assert_null(v.buffer->colour_space);
  }
  assert_int_equal(v.buffer->wrap, wrap);
  assert_int_equal(v.buffer->first_channel, channel);
  done();
}

static void by_text(void **unused) {
  (void)unused;
  expect("a.tif", "a.tif", NULL, SOZAI_WRAP_DEFAULT, 0);
  expect("end grain.tif @ Linear Rec.709 (sRGB)", "end grain.tif", "Linear Rec.709 (sRGB)", 0, 0);
  expect("a.tif @ sRGB, wrap=mirror, channel=3", "a.tif", "sRGB", SOZAI_WRAP_MIRROR, 3);
  expect("a.tif @ wrap=black", "a.tif", NULL, SOZAI_WRAP_BLACK, 0);
  expect("a.tif @ , channel=1", "a.tif", NULL, 0, 1);
  expect("/a @ b/c.tif @ ", "/a @ b/c.tif", NULL, 0, 0);
  expect("/a @ b/c.tif @ data", "/a @ b/c.tif", "data", 0, 0);
  expect("a@b.tif", "a@b.tif", NULL, 0, 0);
}

static void none(void **unused) {
  (void)unused;
  sozai_value v;
  assert_int_equal(make_text(""), SOZAI_OK);
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_null(v.buffer);
  done();
  assert_int_equal(settings_make(&now, &host, &every_kind, NULL, NULL, 0), SOZAI_OK);
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_null(v.buffer);
  done();
}

static void by_path(void **unused) {
  (void)unused;
  /* a path is a path: nothing in it is an option */
  assert_int_equal(make((sozai_value){.kind = SOZAI_KIND_IMAGE, .text = "a @ b, wrap=mirror"}),
                   SOZAI_OK);
  sozai_value v;
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_string_equal(v.buffer->path, "a @ b, wrap=mirror");
  assert_int_equal(v.buffer->wrap, SOZAI_WRAP_DEFAULT);
  done();
}

static sozai_buffer pixels(void) {
  return (sozai_buffer){.size = sizeof(sozai_buffer),
                        .kind = SOZAI_BUFFER_IMAGE,
                        .dims = {2, 3, 4},
                        .data = numbers,
                        .colour_space = "ACEScg",
                        .wrap = SOZAI_WRAP_PERIODIC,
                        .first_channel = 1};
}

static void by_buffer(void **unused) {
  (void)unused;
  sozai_buffer b = pixels();
  assert_int_equal(make_buffer(&b), SOZAI_OK);
  sozai_value v;
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_ptr_not_equal(v.buffer, &b);
  assert_ptr_not_equal(v.buffer->data, numbers);
  assert_memory_equal(v.buffer->data, numbers, sizeof numbers);
  assert_string_equal(v.buffer->colour_space, "ACEScg");
  assert_int_equal(v.buffer->wrap, SOZAI_WRAP_PERIODIC);
  assert_int_equal(v.buffer->first_channel, 1);
  done();
  /* a file in a buffer's clothes */
  b = (sozai_buffer){.size = sizeof b, .kind = SOZAI_BUFFER_IMAGE, .path = "x.exr"};
  assert_int_equal(make_buffer(&b), SOZAI_OK);
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_string_equal(v.buffer->path, "x.exr");
  assert_null(v.buffer->data);
  done();
  /* numbers beside a path of no letters */
  b = pixels();
  b.path = "";
  assert_int_equal(make_buffer(&b), SOZAI_OK);
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_memory_equal(v.buffer->data, numbers, sizeof numbers);
  assert_null(v.buffer->path);
  done();
  /* from before path and wrap were members */
  b = pixels();
  b.size = offsetof(sozai_buffer, path);
  b.path = (const char *)(uintptr_t)1;
  assert_int_equal(make_buffer(&b), SOZAI_OK);
  assert_int_equal(settings_value(&now, &every_kind, "picture", &v), SOZAI_OK);
  assert_null(v.buffer->path);
  assert_int_equal(v.buffer->wrap, SOZAI_WRAP_DEFAULT);
  done();
}

static void refused(int32_t r, int32_t code, const char *word) {
  if (r != code || !strstr(fail_message(), word) || !strstr(fail_message(), "picture")) {
    fail_msg("%d, not %d: \"%s\", not \"%s\"", r, code, fail_message(), word);
  }
  assert_null(now.list);
  done();
}

static void refusals(void **unused) {
  (void)unused;
  refused(make_text("a @ sRGB, wrap=round"), SOZAI_ERROR_RANGE, "round");
  refused(make_text("a @ sRGB, channel=-1"), SOZAI_ERROR_RANGE, "-1");
  refused(make_text("a @ sRGB, channel=1.5"), SOZAI_ERROR_RANGE, "1.5");
  refused(make_text("a @ sRGB, channel="), SOZAI_ERROR_RANGE, "channel");
  refused(make_text("a @ sRGB, blur=2"), SOZAI_ERROR_KIND, "blur=2");
  refused(make((sozai_value){.kind = SOZAI_KIND_IMAGE}), SOZAI_ERROR_ARGUMENT, "NULL");
  refused(make((sozai_value){.kind = SOZAI_KIND_FLOAT}), SOZAI_ERROR_KIND, "an image");
  refused(make((sozai_value){.kind = SOZAI_KIND_IMAGE, .text = "x", .reserved = 7}),
          SOZAI_ERROR_ARGUMENT, "7");
  sozai_buffer b = pixels();
  b.wrap = 5;
  refused(make_buffer(&b), SOZAI_ERROR_RANGE, "5");
  b = pixels();
  b.first_channel = 4;
  refused(make_buffer(&b), SOZAI_ERROR_RANGE, "4");
  b = pixels();
  b.dims[0] = 0;
  refused(make_buffer(&b), SOZAI_ERROR_RANGE, "no pixels");
  b = pixels();
  b.path = "";
  b.first_channel = 4;
  refused(make_buffer(&b), SOZAI_ERROR_RANGE, "4");
  b = pixels();
  b.data = NULL;
  refused(make_buffer(&b), SOZAI_ERROR_ARGUMENT, "NULL");
  b = pixels();
  b.kind = SOZAI_BUFFER_TABLE;
  refused(make_buffer(&b), SOZAI_ERROR_KIND, "kind");
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
  const struct CMUnitTest tests[] = {cmocka_unit_test(by_text), cmocka_unit_test(none),
                                     cmocka_unit_test(by_path), cmocka_unit_test(by_buffer),
                                     cmocka_unit_test(refusals)};
  return cmocka_run_group_tests(tests, start, stop);
}
