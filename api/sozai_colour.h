/* SPDX-License-Identifier: Apache-2.0
 *
 * The colour service: what sozai.so asks of a host, or of sozai-colour.so
 * beside it, to turn palettes and pictures into the working space.
 *
 * sozai.so looks for a service, in this order, when a texture is created:
 *   1. sozai_host.get_service(user, SOZAI_COLOUR_1), the host's own;
 *   2. sozai-colour.so in sozai.so's own folder, over OpenColorIO;
 *   3. neither: sRGB is linearised by its formula and linear Rec.709 taken for
 *      the working space, a warning says so once, and any other space is
 *      refused.
 *
 * sozai-colour.so exports one data symbol, SOZAI_COLOUR_ENTRY_SYMBOL, of type
 * sozai_entry_v1, and answers get_factory(SOZAI_COLOUR_FACTORY_1).
 * The rules at the head of sozai.h hold here too.
 */
#ifndef SOZAI_COLOUR_H
#define SOZAI_COLOUR_H

#include "sozai.h"

#ifdef __cplusplus
extern "C" {
#endif

#define SOZAI_COLOUR_ENTRY_SYMBOL "sozai_colour_entry"

/* ---- colour ----------------------------------------------------------- */

#define SOZAI_COLOUR_1 "sozai.colour/1"

/* A colour service bound to one config. Functions that fail return
 * SOZAI_ERROR_COLOUR (or ARGUMENT, MEMORY), write one line to message
 * (message_size bytes, always terminated; NULL and 0 are allowed), and leave
 * the numbers untouched. A colour space's name may be a role or an alias. */
typedef struct sozai_colour_1 {
  uint32_t size; /* sizeof(sozai_colour_1) */
  uint32_t reserved;
  void *self; /* handed back in every call */
  /* Where the config came from: a path, or a phrase. [thread-safe] */
  const char *(*config_name)(void *self);
  /* The name of the space that scene-linear numbers are in: the role
   * scene_linear. [thread-safe] */
  const char *(*working_space)(void *self);
  /* Whether the config knows that space: 1 or 0. [thread-safe] */
  int32_t (*has_space)(void *self, const char *space);
  /* count colours, r g b each, in place, from a space into the working space
   * or back. [thread-safe] */
  int32_t (*to_working)(void *self, const char *space, float *rgb, uint64_t count, char *message,
                        size_t message_size);
  int32_t (*from_working)(void *self, const char *space, float *rgb, uint64_t count, char *message,
                          size_t message_size);
  /* From the working space to what a display shows, 0 to 1, in place.
   * display, view: names, or NULL for the config's default display and that
   * display's default view. [thread-safe] */
  int32_t (*to_display)(void *self, const char *display, const char *view, float *rgb,
                        uint64_t count, char *message, size_t message_size);
} sozai_colour_1;

/* Makes services. Answered by sozai-colour.so. */
#define SOZAI_COLOUR_FACTORY_1 "sozai.colour-factory/1"

typedef struct sozai_colour_factory_1 {
  /* Open a config: its path, or NULL for $OCIO, else the shipped one. The
   * service lives until close. FILE: missing, unreadable or malformed. COLOUR:
   * no role scene_linear, or a config that does not check. Also ARGUMENT,
   * MEMORY and STATE. [thread-safe] */
  int32_t (*open)(const char *config, const sozai_colour_1 **out, char *message,
                  size_t message_size);
  /* NULL is allowed. [exclusive] */
  void (*close)(const sozai_colour_1 *service);
} sozai_colour_factory_1;

/* ---- images ----------------------------------------------------------- */

/* Colour-managed image look-ups, so that a host may hand over its own texture
 * system: sozai_host.get_service(user, SOZAI_IMAGES_1). The table is settled
 * here so that hosts can be written to it; sozai-colour.so of ABI 1.0 does not
 * answer this id, and textures of ABI 1.0 have no image parameters. */
#define SOZAI_IMAGES_1 "sozai.images/1"

#define SOZAI_WRAP_BLACK 0u
#define SOZAI_WRAP_CLAMP 1u
#define SOZAI_WRAP_PERIODIC 2u
#define SOZAI_WRAP_MIRROR 3u

typedef struct sozai_image sozai_image;

typedef struct sozai_image_request {
  uint32_t size;   /* sizeof(sozai_image_request) */
  uint32_t wrap_s; /* SOZAI_WRAP_* */
  uint32_t wrap_t;
  uint32_t first_channel;
  uint32_t channels; /* 1 to 4 */
  uint32_t reserved;
  const char *path; /* a file, or NULL with a buffer */
  const sozai_buffer *buffer;
  const char *colour_space; /* NULL: by the config's file rules; "data": raw */
} sozai_image_request;

typedef struct sozai_images_1 {
  uint32_t size; /* sizeof(sozai_images_1) */
  uint32_t reserved;
  void *self;
  /* [thread-safe] */
  int32_t (*open)(void *self, const sozai_image_request *request, sozai_image **out, char *message,
                  size_t message_size);
  /* [exclusive] */
  void (*close)(void *self, sozai_image *image);
  /* Width and height in pixels. [thread-safe] */
  int32_t (*resolution)(void *self, const sozai_image *image, uint32_t *width, uint32_t *height);
  /* count look-ups at (s, t), t down from the top, 0 to 1 over the picture,
   * averaged over the parallelogram of (dsdx, dtdx) and (dsdy, dtdy); working
   * space unless data. out: `channels` arrays. [thread-safe] */
  int32_t (*sample)(void *self, const sozai_image *image, uint32_t count, const float *s,
                    const float *t, const float *dsdx, const float *dtdx, const float *dsdy,
                    const float *dtdy, float *const *out);
} sozai_images_1;

#ifdef __cplusplus
}
#endif

#endif
