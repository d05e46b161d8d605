/* SPDX-License-Identifier: Apache-2.0
 *
 * Making and destroying a wood through the ABI while each allocation fails in
 * turn: a clean error and no leak.
 */
#include <dlfcn.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "allocator.h"

static void each_allocation_fails(void **unused) {
  (void)unused;
  void *library = dlopen(SOZAI_TEST_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  assert_non_null(library);
  const sozai_entry_v1 *entry = dlsym(library, SOZAI_ENTRY_SYMBOL);
  /* no colour service lies there */
  assert_int_equal(entry->init("/nonexistent/sozai.so"), SOZAI_OK);
  const sozai_textures_1 *textures = entry->get_factory(SOZAI_TEXTURES_1);
  const sozai_texture_info *info = textures->find("wood");
  static const float widths[5] = {1.0f, 2.0f, 1.5f, 0.5f, 2.5f};
  const sozai_buffer measured = {
      .size = sizeof measured, .kind = SOZAI_BUFFER_TABLE, .dims = {5, 1}, .data = widths};
  const sozai_value values[] = {
      {.id = "ring_widths", .kind = SOZAI_KIND_BUFFER, .buffer = &measured},
      {.id = "object", .kind = SOZAI_KIND_TEXT, .text = "table top"}};
  for (uint32_t p = 0; p <= info->preset_count; p++) {
    const char *preset = p ? info->presets[p - 1]->id : NULL;
    allocator memory;
    uint32_t calls = 0;
    for (;; calls++) {
      assert_true(calls < 1000);
      sozai_host host = allocator_host(&memory);
      memory.fail_at = calls + 1;
      sozai_texture *t = (sozai_texture *)(uintptr_t)1;
      int32_t r = textures->create(&host, "wood", preset, values, 2, &t);
      if (r == SOZAI_OK) {
        assert_non_null(t);
        assert_int_equal(memory.bytes, textures->bytes(t));
        textures->destroy(t);
        assert_int_equal(memory.live, 0);
        assert_int_equal(memory.wrong, 0);
        break;
      }
      assert_int_equal(r, SOZAI_ERROR_MEMORY);
      assert_null(t);
      assert_non_null(strstr(textures->last_error(), "memory"));
      assert_int_equal(memory.live, 0);
      assert_int_equal(memory.wrong, 0);
    }
    assert_true(calls >= 3);
    print_message("%s: %u allocations, each failed in turn\n", preset ? preset : "wood", calls);
  }
  entry->deinit();
  dlclose(library);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(each_allocation_fails)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
