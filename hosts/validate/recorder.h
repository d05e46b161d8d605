/* SPDX-License-Identifier: Apache-2.0
 * A host whose services note what they are asked, and fail when they are told to. */
#ifndef SOZAI_VALIDATE_RECORDER_H
#define SOZAI_VALIDATE_RECORDER_H

#include <stdatomic.h>

#include "sozai_colour.h"
#include "subject.h"

typedef enum parallel_way {
  PARALLEL_FORWARD,
  PARALLEL_BACKWARD,
  PARALLEL_THREADS,
  PARALLEL_REFUSED,
  PARALLEL_DROPPED, /* every other, and says nothing */
  PARALLEL_WAYS
} parallel_way;

/* What is done with tasks, in words. */
extern const char *const parallel_words[PARALLEL_WAYS];

typedef struct recorder {
  sozai_host abi; /* to be handed over; every service is there */
  /* told */
  uint64_t fail_at;   /* this allocation gives NULL, counted from 1; 0: none */
  uint64_t cancel_at; /* this call of progress cancels, counted from 1; 0: none */
  parallel_way parallel;
  bool colour;           /* offer the colour service below */
  bool images;           /* and that of pictures */
  int32_t colour_result; /* of to_working */
  float colour_scale;    /* by which to_working multiplies */
  int32_t image_result;  /* of open */
  /* noted */
  atomic_uint_fast64_t allocations, frees, progress_calls, log_calls, parallel_calls, service_calls,
      colour_calls, image_opens, image_closes, samples;
  atomic_int_fast64_t bytes; /* had and not given back */
  atomic_uint wrong_user, wrong_free, wrong_align, wrong_fraction, wrong_text, wrong_request;
  sozai_colour_1 colour_service;
  sozai_images_1 image_service;
} recorder;

/* All services, none of which fails. The recorder may not move afterwards. */
void recorder_init(recorder *r);
/* Calls of all services so far. */
uint64_t recorder_calls(const recorder *r);
/* Fail for what was asked wrongly: user, sizes, alignments, fractions, texts. */
void recorder_judge(const recorder *r, const char *name);
/* Fail if memory is not all given back. */
void recorder_empty(const recorder *r, const char *name, const char *what);

#endif
