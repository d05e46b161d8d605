/* SPDX-License-Identifier: Apache-2.0
 * What a .sozai file, or a query after its name, says of the picture it is
 * read as. */
#ifndef SOZAI_HOSTS_RECIPE_IMAGE_H
#define SOZAI_HOSTS_RECIPE_IMAGE_H

#include <stddef.h>
#include "failure.h"
#include "ceilings.h"

#define RECIPE_FORMAT_AUTO 0 /* colours half, all else float */
#define RECIPE_FORMAT_HALF 1
#define RECIPE_FORMAT_FLOAT 2

#define RECIPE_WRAP_UNSAID 0
#define RECIPE_WRAP_BLACK 1
#define RECIPE_WRAP_CLAMP 2
#define RECIPE_WRAP_PERIODIC 3 /* and the picture is made to fit itself */
#define RECIPE_WRAP_MIRROR 4

#define RECIPE_SUBIMAGES_SEPARATE 0 /* one for each output */
#define RECIPE_SUBIMAGES_SINGLE 1   /* one, whose channels are all outputs' */

#define RECIPE_NORMALS_OBJECT 0
#define RECIPE_NORMALS_TANGENT 1 /* 0.5 + 0.5 n: right, up, out */

typedef struct recipe_image {
  double resolution[3]; /* pixels, and slices; 0: not said. The second 0 where the first is
                           said: the first is the longer side */
  double size[3];       /* mm; 0: not said */
  int format;           /* RECIPE_FORMAT_* */
  int wrap;             /* RECIPE_WRAP_* */
  int normals;          /* RECIPE_NORMALS_* */
  int subimages;        /* RECIPE_SUBIMAGES_* */
  int samples;          /* each texel is the mean of so many by so many parts; 0: not said, 1 */
  int udim;             /* of a mesh: 1001 and on; 0: its first */
  char *outputs;        /* channels' ids with commas between; NULL: all */
} recipe_image;

/* The keys, with ", " between, cut at size. */
void recipe_image_keys(char *text, size_t size);
/* The number of the key of that name, from 0 up; -1: there is none. */
int recipe_image_key(const char *name);
/* Read the value of a key: of several numbers or names, "," or (numbers) "x" is
 * between them. A later value replaces an earlier. */
bool recipe_image_set(recipe_image *image, int key, const char *text, failure *why);
void recipe_image_free(recipe_image *image);

#endif
