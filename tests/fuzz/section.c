/* SPDX-License-Identifier: Apache-2.0
 * Wood from a picture of its end grain, by an image service that answers with any size and any
 * numbers. */
#include <math.h>
#include <string.h>

#include "batch.h"
#include "bounded.h"
#include "sozai_colour.h"
#include "values.h"

/* ---- the service ------------------------------------------------------------ */

static struct {
  uint32_t width, height, opened;
  uint8_t refuse, odd;
  float rings, ground, s, t;
} picture;

static int32_t open_picture(void *self, const sozai_image_request *q, sozai_image **out,
                            char *message, size_t size) {
  (void)self;
  CHECK(q->channels == 3 && (q->path || q->buffer) && message && size);
  if (picture.refuse == 1) {
    snprintf(message, size, "no\npicture");
    return SOZAI_ERROR_FILE;
  }
  picture.opened++;
  *out = (sozai_image *)(uintptr_t)64;
  return SOZAI_OK;
}

static void close_picture(void *self, sozai_image *image) {
  (void)self, (void)image;
  picture.opened--;
}

static int32_t resolution(void *self, const sozai_image *image, uint32_t *width, uint32_t *height) {
  (void)self, (void)image;
  *width = picture.width;
  *height = picture.height;
  return picture.refuse == 2 ? SOZAI_ERROR_FILE : SOZAI_OK;
}

/* Rings upon a ground, and now and then what no picture should hold. */
static int32_t sample(void *self, const sozai_image *image, uint32_t count, const float *s,
                      const float *t, const float *dsdx, const float *dtdx, const float *dsdy,
                      const float *dtdy, float *const *out) {
  (void)self, (void)image;
  const float special[] = {NAN, INFINITY, -INFINITY, -3, 1e30f, 2};
  for (uint32_t i = 0; i < count; i++) {
    CHECK(isfinite(s[i]) && isfinite(t[i]) && isfinite(dsdx[i]) && isfinite(dtdx[i]));
    CHECK(isfinite(dsdy[i]) && isfinite(dtdy[i]));
    float r =
        sqrtf((s[i] - picture.s) * (s[i] - picture.s) + (t[i] - picture.t) * (t[i] - picture.t));
    for (int c = 0; c < 3; c++)
      out[c][i] = r < 0.45f ? 0.4f + 0.2f * sinf(r * picture.rings) : picture.ground;
    if (picture.odd > 200 && i % picture.odd == 7) out[i % 3][i] = special[i % 6];
  }
  return picture.refuse == 3 ? SOZAI_ERROR_FILE : SOZAI_OK;
}

static const sozai_images_1 images = {.size = sizeof images,
                                      .open = open_picture,
                                      .close = close_picture,
                                      .resolution = resolution,
                                      .sample = sample};

static const void *service(void *user, const char *id) {
  (void)user;
  return strcmp(id, SOZAI_IMAGES_1) == 0 ? &images : NULL;
}

static void take_picture(bytes *b) {
  static const uint32_t sides[] = {0, 1, 2, 3, 768, 769, 100000, ~0u, 1u << 31, 64, 40, 33};
  picture.refuse = take_u8(b) % 16;
  picture.odd = take_u8(b);
  picture.width = sides[take_below(b, 12)];
  picture.height = sides[take_below(b, 12)];
  /* a whole grid of the greatest size takes its time */
  if (picture.width > 100 && picture.height > 100 && picture.odd % 32) picture.height = 5;
  picture.rings = (float)take_u8(b);
  picture.ground = (float)take_u8(b) / 255;
  picture.s = (float)take_u8(b) / 200 - 0.1f;
  picture.t = (float)take_u8(b) / 200 - 0.1f;
  picture.opened = 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  const sozai_textures_1 *textures = batch_plugin();
  const sozai_texture_info *info = textures->find("wood");
  bytes b = {data, size};
  sozai_host host = bounded_host;
  host.get_service = service;
  take_picture(&b);
  values v;
  values_take(&v, &b, info->parameters, info->parameter_count);
  sozai_value list[VALUES_MOST + 1];
  memcpy(list, v.list, v.count * sizeof *list);
  list[v.count] = (sozai_value){.id = "section", .kind = SOZAI_KIND_IMAGE, .text = "end.png"};
  bounded_begin(&(bounded_limits){.bytes = 96 << 20, .calls = 60});
  sozai_texture *t = NULL;
  int32_t r = textures->create(&host, "wood", NULL, list, v.count + 1, &t);
  values_free(&v);
  if (r == SOZAI_OK) {
    batch_try(t, &b);
    textures->destroy(t);
  } else
    CHECK(!t && *textures->last_error() && !strchr(textures->last_error(), '\n'));
  CHECK(picture.opened == 0);
  bounded_end();
  return 0;
}
