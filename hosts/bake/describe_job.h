/* SPDX-License-Identifier: Apache-2.0
 * What is said of a bake: to its pieces, and in its files. */
#ifndef SOZAI_BAKE_DESCRIBE_JOB_H
#define SOZAI_BAKE_DESCRIBE_JOB_H

#include "bake.h"
#include "plan.h"
#include "writer.h"

/* A line "name: value" for everything that decides the pixels, files by a sum
 * of their bytes. Allocated; NULL: why. */
char *bake_describe_job(const bake_job *job, const bake_plan *plan, failure *why);

typedef struct bake_words {
  bake_word words[8];
  float xy[8]; /* chromaticities */
} bake_words;

/* Fills the spec's colour and words, which point into `words` and the job. */
void bake_describe_file(const bake_job *job, const bake_file *file, writer_spec *spec,
                        bake_words *words);

#endif
