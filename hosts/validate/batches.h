/* SPDX-License-Identifier: Apache-2.0
 * The checks "batches.larger-struct" and so on, that batches.c lists and other
 * files hold. */
#ifndef SOZAI_VALIDATE_BATCHES_H
#define SOZAI_VALIDATE_BATCHES_H

#include "batch.h"

/* Answers of the first n points in one call, to compare with; to be freed. NULL:
 * failed, and said so. */
float *in_one(subject *s, sozai_texture *t, batch *b, uint32_t n);

/* batches_struct.c */
void batches_larger(subject *s);
void batches_smaller(subject *s);
void batches_out_count(subject *s);
void batches_null(subject *s);
/* batches_machine.c */
void batches_instruction_sets(subject *s);
void batches_flushed(subject *s);
void batches_stack(subject *s);

#endif
