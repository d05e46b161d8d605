/* SPDX-License-Identifier: Apache-2.0
 * A picture of a grown mesh in the studio: each part in its own colour, its
 * sheets lit from both sides. */
#ifndef SOZAI_CLI_TREE_VIEW_H
#define SOZAI_CLI_TREE_VIEW_H

#include "film.h"
#include "session.h"

typedef struct tree_view {
  uint32_t size[2], spp;
  const char *camera; /* AZ,EL[,ANGLE] */
  const char *target; /* X,Y,Z, or NULL */
  double zoom;
  uint32_t threads; /* 0: the session's */
  bool quiet;       /* no progress bar */
} tree_view;

#define TREE_VIEW_DEFAULT                                                                          \
  { .size = {768, 1024}, .spp = 16, .camera = "25,4,20", .zoom = 1.15 }

bool tree_view_render(const tree_view *v, const sozai_mesh *m, session *s, film *out, failure *why);
/* By the path's ending: .png through the display, .exr. */
bool tree_view_write(const tree_view *v, const sozai_mesh *m, session *s, const char *path,
                     failure *why);

#endif
