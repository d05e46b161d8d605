/* SPDX-License-Identifier: Apache-2.0
 *
 * Loading, counting and unloading.
 */
#include "library.h"

#include <stdlib.h>
#include <string.h>

static int load(void **state) {
  (void)state;
  unsetenv("OCIO");
  library_load();
  return 0;
}

static int unload(void **state) {
  (void)state;
  library_unload();
  return 0;
}

static const sozai_entry_v1 *loaded(void) {
  library_unload();
  return library_load();
}

static void nothing_before_init(void **state) {
  (void)state;
  assert_null(loaded()->get_factory(SOZAI_SERVICES_1));
}

static void unknown_ids_give_null(void **state) {
  (void)state;
  const sozai_entry_v1 *entry = loaded();
  assert_int_equal(entry->init(library_path), SOZAI_OK);
  assert_non_null(entry->get_factory(SOZAI_SERVICES_1));
  assert_null(entry->get_factory(SOZAI_IMAGES_1));
  assert_null(entry->get_factory("sozai.services/2"));
  assert_null(entry->get_factory(""));
  assert_null(entry->get_factory(NULL));
  entry->deinit();
}

static void init_is_counted(void **state) {
  (void)state;
  const sozai_entry_v1 *entry = loaded();
  assert_int_equal(entry->init(library_path), SOZAI_OK);
  const sozai_services_1 *factory = entry->get_factory(SOZAI_SERVICES_1);
  assert_int_equal(entry->init(NULL), SOZAI_OK);
  entry->deinit();
  assert_ptr_equal(entry->get_factory(SOZAI_SERVICES_1), factory);
  service_close(service_open(NULL));
  entry->deinit();
  assert_null(entry->get_factory(SOZAI_SERVICES_1));

  sozai_services *services = (void *)(uintptr_t)factory;
  assert_int_equal(factory->open(NULL, &services, NULL, 0), SOZAI_ERROR_STATE);
  assert_null(services);

  entry->deinit(); /* one too many */
  assert_int_equal(entry->init(library_path), SOZAI_OK);
  assert_non_null(entry->get_factory(SOZAI_SERVICES_1));
  entry->deinit();
  assert_null(entry->get_factory(SOZAI_SERVICES_1));
}

/* The shipped config is found with a wrong path, and with none. */
static void config_lies_beside(void **state) {
  (void)state;
  static const char *const told[] = {NULL, "", "sozai-colour.so", "/nowhere/sozai-colour.so"};
  for (size_t i = 0; i < sizeof told / sizeof *told; i++) {
    const sozai_entry_v1 *entry = loaded();
    assert_int_equal(entry->init(told[i]), SOZAI_OK);
    service s = service_open(NULL);
    const char *name = s.colour->config_name(s.colour->self);
    assert_non_null(strrchr(name, '/'));
    assert_string_equal(strrchr(name, '/'), "/sozai.ocio");
    assert_string_equal(s.colour->working_space(s.colour->self), "Linear Rec.709");
    service_close(s);
    entry->deinit();
  }
}

static void loads_again_and_again(void **state) {
  (void)state;
  for (int i = 0; i < 20; i++) {
    const sozai_entry_v1 *entry = loaded();
    assert_int_equal(entry->init(library_path), SOZAI_OK);
    service_close(service_open(NULL));
    entry->deinit();
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(nothing_before_init),   cmocka_unit_test(unknown_ids_give_null),
      cmocka_unit_test(init_is_counted),       cmocka_unit_test(config_lies_beside),
      cmocka_unit_test(loads_again_and_again),
  };
  return cmocka_run_group_tests(tests, load, unload);
}
