/* SPDX-License-Identifier: Apache-2.0
 *
 * The contract has no question for this, and a look-up of the image service is
 * filtered, which takes from a covariance. But a space whose look-ups are the
 * file rules' own to the bit is the rules' space, or converts as it does. */
#include "photo_rule.h"

#include <string.h>

#define SIDE 24 /* look-ups along each side */
#define PROBES (SIDE * SIDE)

typedef struct probe {
  float rgb[3][PROBES];
} probe;

static bool look_up(const sozai_images_1 *images, const char *path, const char *space, probe *out) {
  const sozai_image_request request = {.size = sizeof request,
                                       .wrap_s = SOZAI_WRAP_CLAMP,
                                       .wrap_t = SOZAI_WRAP_CLAMP,
                                       .channels = 3,
                                       .path = path,
                                       .colour_space = space};
  sozai_image *picture = NULL;
  if (images->open(images->self, &request, &picture, NULL, 0) != SOZAI_OK) return false;
  float s[PROBES], t[PROBES], zero[PROBES] = {0};
  for (int i = 0; i < PROBES; i++) {
    s[i] = ((float)(i % SIDE) + 0.5f) / SIDE;
    t[i] = ((float)(i / SIDE) + 0.5f) / SIDE;
  }
  float *rgb[3] = {out->rgb[0], out->rgb[1], out->rgb[2]};
  bool ok =
      images->sample(images->self, picture, PROBES, s, t, zero, zero, zero, zero, rgb) == SOZAI_OK;
  images->close(images->self, picture);
  return ok;
}

const char *photo_rule(const char *path, bool integers, const colour *c) {
  if (!c->service) return integers ? "sRGB" : "Linear Rec.709";
  const char *working = c->service->working_space(c->service->self);
  const char *usual = integers ? "sRGB" : working;
  probe wanted, got;
  if (!c->images || !c->display || !look_up(c->images, path, NULL, &wanted)) return usual;
  if (look_up(c->images, path, usual, &got) && memcmp(&wanted, &got, sizeof got) == 0) return usual;
  const sozai_display_1 *d = c->display;
  for (uint32_t i = 0; i < d->count(d->self, SOZAI_LIST_SPACES, NULL); i++) {
    const char *name = NULL;
    if (d->item(d->self, SOZAI_LIST_SPACES, NULL, i, &name, NULL) == SOZAI_OK &&
        look_up(c->images, path, name, &got) && memcmp(&wanted, &got, sizeof got) == 0)
      return name;
  }
  return usual;
}
