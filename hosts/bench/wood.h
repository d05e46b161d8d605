/* SPDX-License-Identifier: Apache-2.0
 * The woods, the stones and the fibres that are measured. */
#ifndef SOZAI_BENCH_WOOD_H
#define SOZAI_BENCH_WOOD_H

#include "plugin.h"

typedef struct wood {
  const char *grain;    /* NULL: compound, which is all grains at once */
  const char *porosity; /* NULL: the preset's */
  const char *cpu;      /* an instruction set, or NULL for the best there is */
  const char *cut;      /* NULL: flat */
  bool no_rays;
  bool pigmented;
  const char *reflection; /* NULL: the default */
  const char *layout;     /* NULL: one piece */
  const char *surface;    /* NULL: smooth, and height and normal are not asked for */
  bool plied;             /* plywood, a deep stack of sheets */
  bool edge;              /* seen from the side: the plane x, z */
  bool pictured;          /* its section is the yardstick's picture */
  int knots;              /* how many, */
  int knots_metre;        /* so many to a metre of the stem */
  const char *stone;      /* a preset of stone, in place of all this but cpu */
  const char *fiber;      /* likewise */
} wood;

/* A flat-sawn board of the preset keyaki, or a face of the stone or the fibre. Where the machine
 * lacks the instruction set, true with *out = NULL. picture: the yardstick's, for those that want
 * it. */
bool wood_create(const wood *w, const char *picture, const plugin *p, sozai_texture **out,
                 failure *why);

/* How many components from the first on are a wood's: of one piece those before
 * the layout's, of a layout or a surface all. */
uint32_t wood_components(const wood *w, const plugin *p);

/* The channel of that id, or NULL. */
const sozai_channel *wood_channel(const plugin *p, const char *id);

#endif
