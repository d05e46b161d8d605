/* SPDX-License-Identifier: Apache-2.0 */
#include "library.h"

#include <dlfcn.h>
#include <stdlib.h>

const char *const library_path = SOZAI_TEST_COLOUR;

static void *handle;
static const sozai_entry_v1 *entry;

const sozai_entry_v1 *library_load(void) {
  handle = dlopen(library_path, RTLD_NOW | RTLD_LOCAL);
  if (!handle) fail_msg("%s", dlerror());
  entry = dlsym(handle, SOZAI_COLOUR_ENTRY_SYMBOL);
  assert_non_null(entry);
  assert_int_equal(entry->abi_major, SOZAI_ABI_MAJOR);
  return entry;
}

void library_unload(void) {
  assert_int_equal(dlclose(handle), 0);
  handle = NULL;
  entry = NULL;
}

int library_setup(void **state) {
  (void)state;
  unsetenv("OCIO");
  unsetenv("OCIO_OPTIMIZATION_FLAGS");
  unsetenv("OCIO_LOGGING_LEVEL");
  library_load();
  return entry->init(library_path);
}

int library_teardown(void **state) {
  (void)state;
  entry->deinit();
  library_unload();
  return 0;
}

const sozai_services_1 *library_factory(void) { return entry->get_factory(SOZAI_SERVICES_1); }

int32_t library_open(const char *config, sozai_services **out, char *message, size_t size) {
  const sozai_services_options options = {.size = sizeof options, .config = config};
  return library_factory()->open(&options, out, message, size);
}

service service_open(const char *config) {
  service s = {0};
  char message[512] = "";
  int32_t result = library_open(config, &s.handle, message, sizeof message);
  if (result != SOZAI_OK) fail_msg("open: %d, %s", (int)result, message);
  assert_non_null(s.handle);
  s.colour = library_factory()->get(s.handle, SOZAI_COLOUR_1);
  s.display = library_factory()->get(s.handle, SOZAI_DISPLAY_1);
  assert_non_null(s.colour);
  assert_non_null(s.display);
  return s;
}

void service_close(service s) { library_factory()->close(s.handle); }

static service shipped;

int shipped_setup(void **state) {
  if (library_setup(state) != 0) return -1;
  shipped = service_open(NULL);
  *state = &shipped;
  return 0;
}

int shipped_teardown(void **state) {
  service_close(shipped);
  return library_teardown(state);
}

const char *blender_config(void) {
  const char *path = getenv("SOZAI_TEST_BLENDER_CONFIG");
  return path ? path : "/usr/share/blender/datafiles/colormanagement/config.ocio";
}
