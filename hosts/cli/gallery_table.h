/* SPDX-License-Identifier: Apache-2.0
 * The pictures of the gallery, as data. */
#ifndef SOZAI_CLI_GALLERY_TABLE_H
#define SOZAI_CLI_GALLERY_TABLE_H

#include <stdbool.h>
#include <stdint.h>

#define SHOT_PARAMS 6

typedef struct shot {
  const char *heading; /* no picture but the beginning of a section; its sheet shows it whole */
  const char *name;    /* of the file, without its ending; of an each_preset: what it begins with */
  const char *title;
  const char *material;            /* NULL: wood; or tree, which is grown */
  const char *preset;              /* NULL: the parameters' defaults */
  bool each_preset;                /* once for every preset there is, */
  const char *with, *without;      /* or that gives this parameter, or does not; NULL: all */
  bool own_log;                    /* each preset's from a log of its own: a seed of its own */
  double aside;                    /* mm: off the pith's line, of each preset up to so much */
  bool more;                       /* only with --all: the others take a minute */
  const char *sheet;               /* id of the sheet that shows it small, or NULL */
  const char *params[SHOT_PARAMS]; /* name=value, the last ones NULL */
  /* As options of `sozai render` are written; NULL: their defaults. */
  const char *shape, *size, *camera, *light;
  double sky;         /* as --sky; 0: its default */
  double zoom, ahead; /* as --zoom, 0: 1; and the y of --target 0,Y,0, if it is not 0 */
  uint32_t width, height;
} shot;

/* Small pictures of one size with their names, on one sheet. */
typedef struct shot_sheet {
  const char *id; /* and of the file, without its ending */
  uint32_t columns;
} shot_sheet;

#define GALLERY_SHEETS 11
extern const shot_sheet gallery_sheets[GALLERY_SHEETS];
extern const shot gallery_shots[];
extern const uint32_t gallery_shot_count;

#endif
