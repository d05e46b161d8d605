/* SPDX-License-Identifier: Apache-2.0
 * Every picture of a gallery: the table's, once for each preset where it says so. */
#ifndef SOZAI_CLI_GALLERY_LIST_H
#define SOZAI_CLI_GALLERY_LIST_H

#include "failure.h"
#include "gallery_table.h"
#include "sozai.h"

typedef struct picture {
  shot shot;           /* with what a preset of its own adds */
  const shot *section; /* the heading that it stands under, of the table, which begins with one */
  const char *preset;  /* or NULL */
  char name[128];      /* of the file, without its ending */
  char title[256];
  char seed[32], offset[48]; /* parameters that shot.params may point to */
} picture;

typedef struct picture_list {
  picture *pictures; /* in the table's order; they may not move */
  uint32_t count;
} picture_list;

/* all: those too that are marked `more`. Lists what no texture of the plugin is known for as well,
 * but for presets, of which it then has none. */
bool picture_list_make(picture_list *list, const sozai_textures_1 *textures, bool all,
                       failure *why);
void picture_list_free(picture_list *list);

const char *shot_material(const shot *s);

#endif
