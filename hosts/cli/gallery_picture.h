/* SPDX-License-Identifier: Apache-2.0
 * One picture of a gallery, into its file. */
#ifndef SOZAI_CLI_GALLERY_PICTURE_H
#define SOZAI_CLI_GALLERY_PICTURE_H

#include "gallery_list.h"
#include "session.h"
#include "sheet.h"

typedef struct easel {
  session *session;
  const char *folder;
  uint32_t spp;     /* samples per pixel, at most */
  uint32_t threads; /* that one picture may take */
} easel;

/* How many samples of each pixel this one takes. */
uint32_t picture_samples(const easel *e, const picture *p);

typedef enum picture_result {
  PICTURE_FAILED,
  PICTURE_LEFT_OUT, /* the plugin cannot make anything of the values */
  PICTURE_MADE
} picture_result;

/* Writes p's name with .png into the folder; small is what a sheet shows of it, if p is on one.
 * [thread-safe] */
picture_result picture_make(const easel *e, const picture *p, sheet_picture *small, failure *why);

/* Writes a film into the folder under that name. */
bool picture_write(const easel *e, const film *f, const char *name, failure *why);

#define PICTURE_PATH 4096
bool picture_path(char path[PICTURE_PATH], const easel *e, const char *name, failure *why);

#endif
