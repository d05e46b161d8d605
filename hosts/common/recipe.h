/* SPDX-License-Identifier: Apache-2.0
 * What a user asks of a material: its name, a preset and parameters, from a
 * command line, a .sozai file, or both. */
#ifndef SOZAI_HOSTS_RECIPE_H
#define SOZAI_HOSTS_RECIPE_H

#include <stddef.h>
#include "failure.h"
#include "recipe_image.h"
#include "sozai.h"

typedef struct recipe_param {
  char *id;
  char *text;   /* the plugin reads it as the parameter's kind */
  char *file;   /* which file says it, whose folder relative paths start from; or NULL */
  int line;     /* in that file; 0: not from a file's text */
  bool settled; /* text is a path that no longer starts from that folder */
} recipe_param;

#define RECIPE_NO_SHAPE 0
#define RECIPE_PLANE 1
#define RECIPE_BOARD 2
#define RECIPE_MESH 3

/* The surface the material is seen on. */
typedef struct recipe_surface {
  int shape;      /* RECIPE_* */
  double size[3]; /* mm: width, height and thickness; 0: not said */
  char *mesh;     /* path */
  double scale;   /* mm per unit of the mesh's file; 0: not said */
} recipe_surface;

typedef struct recipe {
  char *file; /* the file's path, or NULL */
  char *material;
  char *preset; /* or NULL */
  recipe_param *params;
  size_t param_count;
  recipe_surface surface;
  recipe_image image;
} recipe;

/* Of a name that is a .sozai file's, in capitals or not: the bytes of the path, which may go on
 * in "?"; 0: it is none. */
size_t recipe_file_length(const char *name);
/* name: a material's id, or the path of a .sozai file, which may go on in
 * "?key=value&...": the image's keys ("res" stands for its resolution), "preset",
 * and parameters. */
bool recipe_open(recipe *r, const char *name, failure *why);
void recipe_free(recipe *r);

/* A later value for the same parameter replaces the earlier. line is kept. */
bool recipe_set(recipe *r, const char *id, const char *text, int line, failure *why);
/* "name=value", as in -p. */
bool recipe_set_pair(recipe *r, const char *pair, failure *why);
bool recipe_set_preset(recipe *r, const char *preset, failure *why);

bool recipe_sets(const recipe *r, const char *id);

/* That parameter of a texture, or NULL. */
const sozai_parameter *parameter_of(const sozai_texture_info *info, const char *id);

/* The kind of texture it names. geometry: for a hint where it names what is grown; may be NULL. */
const sozai_texture_info *recipe_info(const recipe *r, const sozai_textures_1 *textures,
                                      const sozai_geometry_1 *geometry, failure *why);
/* Relative paths among the file's parameters start from its folder: make them
 * whole. recipe_create does this first. */
bool recipe_settle(recipe *r, const sozai_textures_1 *textures, failure *why);
/* Whether a .sozai file can hold its values: UTF-8 alone. */
bool recipe_is_text(const recipe *r, failure *why);
/* Make the texture. A refused value of the file's is reported with its line. */
bool recipe_create(recipe *r, const sozai_textures_1 *textures, const sozai_host *host,
                   sozai_texture **out, failure *why);

/* Used by recipe_open: a value that a file says, and fill r from a .sozai file. */
bool recipe_set_from(recipe *r, const char *id, const char *text, const char *file, int line,
                     failure *why);
bool recipe_read_file(recipe *r, const char *path, failure *why);

#endif
