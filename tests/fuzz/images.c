/* SPDX-License-Identifier: Apache-2.0
 * Pictures in the host's memory, of any size, channels and numbers, through the image service
 * beside the plugin; and look-ups of any width. Files are OpenImageIO's to read: see png.cpp for
 * what is ours. */
#include <dlfcn.h>
#include <math.h>
#include <string.h>

#include "sozai_colour.h"
#include "values.h"

#define LOOKS 12

static const sozai_images_1 *images;

static void start(void) {
  void *library = dlopen(SOZAI_TEST_COLOUR, RTLD_NOW | RTLD_LOCAL);
  if (!library) fprintf(stderr, "%s\n", dlerror());
  CHECK(library);
  const sozai_entry_v1 *entry = dlsym(library, SOZAI_COLOUR_ENTRY_SYMBOL);
  CHECK(entry && entry->init(SOZAI_TEST_COLOUR) == SOZAI_OK);
  const sozai_services_1 *factory = entry->get_factory(SOZAI_SERVICES_1);
  const sozai_services_options options = {.size = sizeof options, .image_memory = 64 << 20};
  sozai_services *services = NULL;
  char message[512] = "";
  CHECK(factory && factory->open(&options, &services, message, sizeof message) == SOZAI_OK);
  images = factory->get(services, SOZAI_IMAGES_1);
  CHECK(images);
}

static float look_number(bytes *b) {
  static const float special[] = {0, 1, -1, 1e30f, -1e30f, 1e-40f, 0.5f, 1e6f};
  uint8_t way = take_u8(b);
  return way < 8 ? special[way] : (float)way / 100 - 0.7f;
}

static void look(const sozai_image *image, uint32_t channels, bytes *b) {
  float in[6][LOOKS], out[4][LOOKS];
  float *const to[4] = {out[0], out[1], out[2], out[3]};
  for (int k = 0; k < 6; k++)
    for (int i = 0; i < LOOKS; i++) in[k][i] = b->left ? look_number(b) : 0.1f * (float)i;
  int32_t r =
      images->sample(images->self, image, LOOKS, in[0], in[1], in[2], in[3], in[4], in[5], to);
  CHECK(r == SOZAI_OK);
  for (uint32_t c = 0; c < channels; c++)
    for (int i = 0; i < LOOKS; i++) CHECK(isfinite(out[c][i]));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const spaces[] = {NULL, "data", "sRGB", "ACEScg", "no such space", ""};
  if (!images) start();
  bytes b = {data, size};
  /* one value of an image's parameter is the picture */
  static const sozai_parameter picture = {.size = sizeof picture,
                                          .kind = SOZAI_KIND_BUFFER,
                                          .id = "picture",
                                          .unit = "",
                                          .buffer_kind = SOZAI_BUFFER_IMAGE};
  const sozai_parameter *const list[] = {&picture};
  const sozai_image_request q = {.size = sizeof q,
                                 .wrap_s = take_u8(&b) % 6u,
                                 .wrap_t = take_u8(&b) % 6u,
                                 .first_channel = take_u8(&b) % 5u,
                                 .channels = take_u8(&b) % 6u,
                                 .colour_space = spaces[take_below(&b, 6)]};
  values v;
  values_take(&v, &b, list, 1);
  for (uint32_t i = 0; i < v.count; i++) {
    sozai_image_request one = q;
    one.buffer = v.list[i].buffer;
    sozai_image *image = NULL;
    char message[512] = "";
    if (images->open(images->self, &one, &image, message, sizeof message) != SOZAI_OK) {
      CHECK(!image && *message && !strchr(message, '\n'));
      continue;
    }
    look(image, one.channels, &b);
    images->close(images->self, image);
  }
  values_free(&v);
  return 0;
}
