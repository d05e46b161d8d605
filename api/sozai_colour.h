/* SPDX-License-Identifier: Apache-2.0
 *
 * Services for colour and pictures: what sozai.so asks of a host, or of
 * sozai-colour.so beside it, to turn palettes and pictures into the working
 * space, and what a program asks of it to show a result.
 *
 *   SOZAI_COLOUR_1    colours into the working space and back
 *   SOZAI_IMAGES_1    colour-managed, filtered look-ups of pictures
 *   SOZAI_DISPLAY_1   what the config offers, and what a display shows
 *
 * sozai.so looks for each of the first two, in this order, when a texture that
 * needs it is created:
 *   1. sozai_host.get_service(user, id), the host's own;
 *   2. sozai-colour.so in sozai.so's own folder, over OpenColorIO and
 *      OpenImageIO;
 *   3. neither: sRGB is linearised by its formula and linear Rec.709 taken for
 *      the working space, a warning says so once; any other space, and every
 *      picture, is refused.
 *
 * sozai-colour.so exports one data symbol, SOZAI_COLOUR_ENTRY_SYMBOL, of type
 * sozai_entry_v1, and answers get_factory(SOZAI_SERVICES_1).
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
   * scene_linear, or what stands in for it. [thread-safe] */
  const char *(*working_space)(void *self);
  /* Whether to_working and from_working know that space: 1 or 0. [thread-safe] */
  int32_t (*has_space)(void *self, const char *space);
  /* count colours, r g b each, in place, from a space into the working space
   * or back. [thread-safe] */
  int32_t (*to_working)(void *self, const char *space, float *rgb, uint64_t count, char *message,
                        size_t message_size);
  int32_t (*from_working)(void *self, const char *space, float *rgb, uint64_t count, char *message,
                          size_t message_size);
} sozai_colour_1;

/* ---- display ---------------------------------------------------------- */

#define SOZAI_DISPLAY_1 "sozai.display/1"

/* What can be listed. */
#define SOZAI_LIST_SPACES 1u   /* colour spaces that are not hidden; detail: the encoding, or "" */
#define SOZAI_LIST_ROLES 2u    /* detail: the space that the role stands for */
#define SOZAI_LIST_DISPLAYS 3u /* the config's default first; detail: "" */
#define SOZAI_LIST_VIEWS 4u    /* of a display, its default first; detail: the view's look, or "" */
#define SOZAI_LIST_LOOKS 5u    /* detail: the look's process space */

/* Bound to one config, as sozai_colour_1, whose rules for failures hold. */
typedef struct sozai_display_1 {
  uint32_t size; /* sizeof(sozai_display_1) */
  uint32_t reserved;
  void *self;
  /* How many there are of SOZAI_LIST_*; display: for VIEWS, NULL for the
   * default display; else NULL. 0: none, or no such list. [thread-safe] */
  uint32_t (*count)(void *self, uint32_t list, const char *display);
  /* The index-th name and its detail (out pointers may be NULL); they live as
   * long as the service. UNKNOWN: there is none. [thread-safe] */
  int32_t (*item)(void *self, uint32_t list, const char *display, uint32_t index,
                  const char **out_name, const char **out_detail);
  /* From the working space to what a display shows, 0 to 1, in place.
   * display, view: names, or NULL for the config's default display and that
   * display's default view. look: names of looks as in a config, "a, -b", in
   * place of the view's own; NULL: the view's own; "": none. [thread-safe] */
  int32_t (*to_display)(void *self, const char *display, const char *view, const char *look,
                        float *rgb, uint64_t count, char *message, size_t message_size);
  /* CIE 1931 x y of red, green, blue and white of a space that is linear
   * (NULL: the working space). Its white is recognised by its primaries;
   * primaries that no standard has are given as adapted to D65. COLOUR: the
   * config cannot say, having neither of the interchange roles, or the space is
   * not linear. [thread-safe] */
  int32_t (*chromaticities)(void *self, const char *space, float out_xy[8], char *message,
                            size_t message_size);
} sozai_display_1;

/* ---- images ----------------------------------------------------------- */

/* Colour-managed look-ups of pictures. A host may hand over its own texture
 * system: sozai_host.get_service(user, SOZAI_IMAGES_1). */
#define SOZAI_IMAGES_1 "sozai.images/1"

typedef struct sozai_image sozai_image;

typedef struct sozai_image_request {
  uint32_t size;   /* sizeof(sozai_image_request) */
  uint32_t wrap_s; /* SOZAI_WRAP_BLACK and the like; SOZAI_WRAP_DEFAULT: clamp */
  uint32_t wrap_t;
  uint32_t first_channel;
  uint32_t channels; /* 1 to 4; colours are converted where there are 3 or 4 */
  uint32_t reserved;
  const char *path;           /* a file, or NULL with a buffer */
  const sozai_buffer *buffer; /* its data, read during open() only */
  const char *colour_space;   /* NULL: by the config's file rules, a buffer's by its own;
                                 "data": raw */
  uint64_t most_pixels;       /* the caller's ceiling image_pixels: what has more, by its head,
                                 is refused before it is read; 0: the service's own alone */
  void *user;                 /* handed back to progress */
  /* While it is read, 0 to 1, on the thread of open(). NULL: none. Not 0: stop. It
   * must not throw or unwind. */
  int32_t (*progress)(void *user, float fraction);
} sozai_image_request;

typedef struct sozai_images_1 {
  uint32_t size; /* sizeof(sozai_images_1) */
  uint32_t reserved;
  void *self;
  /* Open a picture, whole: one that cannot be read to its end is refused here
   * and not later. Numbers that are not finite are read as 0. Of a picture of
   * fewer channels than asked for, grey is repeated, and a missing fourth
   * channel is 1. FILE: missing, unreadable, malformed, or without the first
   * channel; COLOUR: unknown space; LIMIT: above most_pixels; CANCELLED: progress
   * said so; ARGUMENT, MEMORY. Who asks for what another thread is reading waits
   * for it, without progress. [thread-safe] */
  int32_t (*open)(void *self, const sozai_image_request *request, sozai_image **out, char *message,
                  size_t message_size);
  /* NULL is allowed. [exclusive] */
  void (*close)(void *self, sozai_image *image);
  /* Width and height in pixels. [thread-safe] */
  int32_t (*resolution)(void *self, const sozai_image *image, uint32_t *width, uint32_t *height);
  /* count look-ups at (s, t), t down from the top, 0 to 1 over the picture,
   * averaged over the parallelogram of (dsdx, dtdx) and (dsdy, dtdy); working
   * space unless data. out: `channels` arrays. The answer to a look-up does
   * not depend on the others. s and t must be finite; where a file has gone
   * since, FILE, and the numbers are finite. [thread-safe] */
  int32_t (*sample)(void *self, const sozai_image *image, uint32_t count, const float *s,
                    const float *t, const float *dsdx, const float *dtdx, const float *dsdy,
                    const float *dtdy, float *const *out);
  /* Bytes of pictures held for all textures together, and the most that will
   * be. Either may be NULL. [thread-safe] */
  void (*memory)(void *self, uint64_t *out_used, uint64_t *out_limit);
} sozai_images_1;

/* ---- the services beside the plugin ----------------------------------- */

/* Its entry also offers SOZAI_LIMITS_1: the ceilings on pictures and configs. */
#define SOZAI_SERVICES_1 "sozai.services/1"

typedef struct sozai_services sozai_services;

typedef struct sozai_services_options {
  uint32_t size; /* sizeof(sozai_services_options) */
  uint32_t reserved;
  const char *config;    /* an OpenColorIO config: a path, or "ocio://..." where the library
                            has such; NULL: $OCIO, else the shipped one */
  uint64_t image_memory; /* bytes of pictures to hold at most; 0: 1 GiB */
} sozai_services_options;

typedef struct sozai_services_1 {
  /* Open a config. options: NULL for the defaults. The services live until
   * close. On SOZAI_OK message is empty, or a warning: for the role scene_linear,
   * where a config is without it, the first of the roles rendering, reference and
   * default stands in whose space is linear light or data. Where the working
   * space is data, nothing is converted but what has a name of sRGB's that the
   * config does not know, by sRGB's formula. FILE: missing, unreadable or
   * malformed. COLOUR: a config that does not check, or says nothing of a
   * working space. Also ARGUMENT, MEMORY and STATE. [thread-safe] */
  int32_t (*open)(const sozai_services_options *options, sozai_services **out, char *message,
                  size_t message_size);
  /* The table of that id, or NULL. Lives as long as the services. [thread-safe] */
  const void *(*get)(sozai_services *services, const char *service_id);
  /* NULL is allowed. Images must have been closed. [exclusive] */
  void (*close)(sozai_services *services);
} sozai_services_1;

#ifdef __cplusplus
}
#endif

#endif
