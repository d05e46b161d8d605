/* SPDX-License-Identifier: Apache-2.0
 * Which of a texture's channels go into which file, and how a number is
 * written there. */
#ifndef SOZAI_BAKE_OUTPUTS_H
#define SOZAI_BAKE_OUTPUTS_H

#include "display.h"
#include "failure.h"
#include "image.h"
#include "sozai.h"

#define BAKE_EXR 0
#define BAKE_TIFF 1
#define BAKE_PNG 2

#define BAKE_NAME 80

/* How a number is written. */
#define BAKE_PLAIN 0     /* as it is */
#define BAKE_COLOUR 1    /* in the file's colour space; its two neighbours with it */
#define BAKE_DIRECTION 2 /* 0.5 + 0.5 n, for formats that begin at 0 */

/* One number of each pixel. */
typedef struct bake_layer {
  char name[BAKE_NAME];
  uint32_t component; /* of the texture */
  int type;           /* IMAGE_* */
  int code;           /* BAKE_* above */
} bake_layer;

typedef struct bake_file {
  const char *output; /* the channel's id that stands for <output>; NULL: all in one */
  bake_layer *layers;
  uint32_t layer_count;
  uint32_t pixel_bytes; /* layers one after another, without gaps */
  bool colours;         /* some layer is a colour */
} bake_file;

typedef struct bake_outputs {
  int format; /* BAKE_EXR and the like */
  bake_file *files;
  uint32_t file_count;
  uint32_t pixel_bytes; /* of all files together */
  char *space;          /* that colours are written in; NULL: the working space */
  const colour *services;
} bake_outputs;

/* What is asked for. */
typedef struct bake_choice {
  const char *path;  /* its ending says the format, <output> in it a file for each */
  const char *names; /* "albedo,roughness"; NULL: the default: see bake_outputs_open */
  const char *space; /* NULL: the working space; "sRGB" where numbers are integers */
  bool tangent;      /* the normal as 0.5 + 0.5 n, of any type: the face lies in x and y */
  uint32_t bits;     /* 8, 16 or 32; 0: EXR 16 for colours and 32 for the rest, TIFF 16, PNG 8.
                        In an EXR of 16 what goes past a half is 32. */
} bake_choice;

/* Without names: all channels that need neither light nor view, of a format
 * that holds them; but albedo alone in a PNG or TIFF without <output>. */
bool bake_outputs_open(bake_outputs *o, const sozai_texture_info *info, const bake_choice *choice,
                       const colour *c, failure *why);
void bake_outputs_close(bake_outputs *o);

uint32_t bake_type_bytes(int type);

/* Numbers of a component, count of them, to where the layer stands in pixels
 * of pixel_bytes each. [thread-safe] */
void bake_encode(const bake_layer *l, const float *numbers, uint32_t count, uint8_t *to,
                 uint32_t pixel_bytes);
/* Colours, r g b one array each, from the working space to the file's, in place;
 * room: 3 * count floats. [thread-safe] */
bool bake_to_space(const bake_outputs *o, float *const rgb[3], uint32_t count, float *room,
                   failure *why);

#endif
