/* SPDX-License-Identifier: Apache-2.0
 * Parts of a render_job that are written as text, the same in options, tables
 * and .sozai files. Messages name the option. */
#ifndef SOZAI_CLI_JOB_OPTIONS_H
#define SOZAI_CLI_JOB_OPTIONS_H

#include "recipe.h"
#include "render.h"

typedef struct job_options {
  const char *shape;  /* board, sphere, plane, or a mesh's path */
  const char *size;   /* WxHxT, WxH or D, by shape */
  const char *camera; /* front, or AZ,EL[,ANGLE] */
  const char *target; /* X,Y,Z */
  const char *light;  /* AZ,EL */
  const char *up;     /* y or z */
} job_options;

/* NULL members leave the job as it is. surface: the default shape and size, or NULL. */
bool job_options_apply(render_job *job, const job_options *o, const recipe_surface *surface,
                       failure *why);

#endif
