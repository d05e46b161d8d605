/* SPDX-License-Identifier: Apache-2.0 */
#include "library.h"

#include "temp.h"

#include <dlfcn.h>

const char *const library_path = SOZAI_TEST_COLOUR;

static void *handle;
static const sozai_entry_v1 *entry;

const sozai_entry_v1 *library_load(void) {
  handle = dlopen(library_path, RTLD_NOW | RTLD_LOCAL);
  if (!handle) fail_msg("%s", dlerror());
  entry = dlsym(handle, SOZAI_COLOUR_ENTRY_SYMBOL);
  assert_non_null(entry);
  assert_int_equal(entry->init(library_path), SOZAI_OK);
  return entry;
}

void library_unload(void) {
  entry->deinit();
  assert_int_equal(dlclose(handle), 0);
  handle = NULL;
  entry = NULL;
}

int library_setup(void **state) {
  (void)state;
  unsetenv("OCIO");
  unsetenv("OCIO_OPTIMIZATION_FLAGS");
  unsetenv("OCIO_LOGGING_LEVEL");
  unsetenv("OPENIMAGEIO_IMAGECACHE_OPTIONS");
  unsetenv("OPENIMAGEIO_TEXTURE_OPTIONS");
  temp_make();
  library_load();
  return 0;
}

int library_teardown(void **state) {
  (void)state;
  library_unload();
  temp_remove();
  return 0;
}

services services_open(uint64_t image_memory) {
  services s = {0};
  sozai_services_options options = {.size = sizeof options, .image_memory = image_memory};
  char message[512] = "";
  s.factory = entry->get_factory(SOZAI_SERVICES_1);
  int32_t result = s.factory->open(&options, &s.services, message, sizeof message);
  if (result != SOZAI_OK) fail_msg("open: %d, %s", (int)result, message);
  s.images = s.factory->get(s.services, SOZAI_IMAGES_1);
  assert_non_null(s.images);
  return s;
}

void services_close(services *s) { s->factory->close(s->services); }

static services shared;

int services_setup(void **state) {
  library_setup(state);
  shared = services_open(0);
  *state = &shared;
  return 0;
}

int services_teardown(void **state) {
  services_close(&shared);
  return library_teardown(state);
}

sozai_image_request file_request(const char *path, uint32_t channels) {
  return (sozai_image_request){
      .size = sizeof(sozai_image_request), .channels = channels, .path = path};
}

sozai_image *open_image(const services *s, const sozai_image_request *request) {
  sozai_image *image = NULL;
  char message[512] = "";
  int32_t result = s->images->open(s->images->self, request, &image, message, sizeof message);
  if (result != SOZAI_OK) fail_msg("open: %d, %s", (int)result, message);
  assert_non_null(image);
  assert_string_equal(message, "");
  return image;
}

sozai_image *open_file(const services *s, const char *path, uint32_t channels) {
  sozai_image_request request = file_request(path, channels);
  return open_image(s, &request);
}

void close_image(const services *s, sozai_image *image) {
  s->images->close(s->images->self, image);
}

void look(const services *s, const sozai_image *image, float at_s, float at_t, float footprint,
          float out[4]) {
  const float zero = 0;
  float *const to[4] = {&out[0], &out[1], &out[2], &out[3]};
  assert_int_equal(s->images->sample(s->images->self, image, 1, &at_s, &at_t, &footprint, &zero,
                                     &zero, &footprint, to),
                   SOZAI_OK);
}
