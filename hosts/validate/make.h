/* SPDX-License-Identifier: Apache-2.0
 * Values to give, and things made of them. */
#ifndef SOZAI_VALIDATE_MAKE_H
#define SOZAI_VALIDATE_MAKE_H

#include "subject.h"

/* A value as text, with its room. */
typedef struct given {
  sozai_value value;
  char text[400];
} given;

/* The parameter's default as a value of its kind. False: it has none that can
 * be given (a buffer's is none at all). */
bool make_default(const sozai_parameter *p, sozai_value *out);
/* One by chance, within the soft range; false: only the default is sure to be
 * taken (texts, files, buffers). */
bool make_good(subject *s, const sozai_parameter *p, sozai_value *out);
/* The same value as text, of SOZAI_KIND_STRING. False: it has no such form. */
bool make_text(const sozai_parameter *p, const sozai_value *v, given *out);

bool kind_has_range(uint32_t kind);
/* How many of number[] count. */
uint32_t kind_numbers(uint32_t kind);

/* Equal in what their kind says: numbers to the bit, texts as texts. */
bool value_same(const sozai_value *a, const sozai_value *b);
/* "1.5", "ring", "0.1 0.2 0.3": this thread's till the fourth call after. */
const char *value_shown(const sozai_value *v);

/* A value that must be refused, and why. */
typedef struct bad {
  sozai_value value;
  const char *what;
  int32_t wanted; /* the error; 0: any */
} bad;
#define BAD_MOST 64
/* All that can be told from the description; how many. */
uint32_t make_bad(const sozai_parameter *p, bad *out);

/* create() or grow() as a host without services does. *texture or *geometry is
 * what was made. */
typedef struct made {
  const kind *kind;
  sozai_texture *texture;
  sozai_geometry *geometry;
} made;
int32_t make(subject *s, const kind *k, const sozai_host *host, const char *preset,
             const sozai_value *values, uint32_t count, made *out);
void unmake(subject *s, made *m);
int32_t made_value(const subject *s, const made *m, const char *id, sozai_value *out);

/* Whether two textures give the same bits at some points by chance. what: for
 * messages. */
bool same_bits(subject *s, const sozai_texture_info *info, sozai_texture *a, sozai_texture *b,
               const char *what);

#endif
