/* SPDX-License-Identifier: Apache-2.0
 * A picture of an aggregate of fibre in the studio: every strand a round curve,
 * light scattered from strand to strand. */
#ifndef SOZAI_CLI_FIBER_VIEW_H
#define SOZAI_CLI_FIBER_VIEW_H

#include "film.h"
#include "session.h"

typedef struct fiber_view {
  uint32_t size[2], spp, bounces;
  uint32_t smooth;    /* pieces a segment is cut into */
  const char *camera; /* AZ,EL[,ANGLE] */
  const char *target; /* X,Y,Z, or NULL */
  const char *light;  /* AZ,EL, or NULL */
  double zoom;
  double sky;    /* 0: the studio's own */
  bool no_floor; /* nothing below, and dark behind */
} fiber_view;

#define FIBER_VIEW_DEFAULT                                                                         \
  { .size = {768, 768}, .spp = 32, .bounces = 12, .smooth = 2, .camera = "35,18,20", .zoom = 1 }

/* g: for the parameters that say how its fibres look. */
bool fiber_view_render(const fiber_view *v, const sozai_geometry_1 *table, const sozai_geometry *g,
                       session *s, film *out, failure *why);
/* By the path's ending: .png through the display, .exr. */
bool fiber_view_write(const fiber_view *v, const sozai_geometry_1 *table, const sozai_geometry *g,
                      session *s, const char *path, failure *why);

#endif
