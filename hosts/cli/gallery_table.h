/* SPDX-License-Identifier: Apache-2.0
 * The pictures of the gallery, as data. */
#ifndef SOZAI_CLI_GALLERY_TABLE_H
#define SOZAI_CLI_GALLERY_TABLE_H

#include <stdbool.h>
#include <stdint.h>

#define SHOT_PARAMS 6

typedef struct shot {
  const char *name; /* of the file, without its ending; of an each_preset: what it begins with */
  const char *title;
  const char *material;            /* NULL: wood */
  const char *preset;              /* NULL: the parameters' defaults */
  bool each_preset;                /* once for every preset there is; these come first */
  bool on_sheet;                   /* among the small pictures of gallery.png */
  bool on_stones;                  /* or of stones.png */
  bool on_layouts;                 /* or of layouts.png */
  bool on_macro;                   /* or of macro.png */
  bool on_figured;                 /* or of figured.png */
  const char *params[SHOT_PARAMS]; /* name=value, the last ones NULL */
  /* As options of `sozai render` are written; NULL: their defaults. */
  const char *shape, *size, *camera, *light;
  double sky; /* as --sky; 0: its default */
  uint32_t width, height;
} shot;

extern const shot gallery_shots[];
extern const uint32_t gallery_shot_count;

#endif
