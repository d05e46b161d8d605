/* SPDX-License-Identifier: Apache-2.0
 * The plugin that is judged, as the process of one check sees it. */
#ifndef SOZAI_VALIDATE_SUBJECT_H
#define SOZAI_VALIDATE_SUBJECT_H

#include "check.h"
#include "sozai.h"

typedef struct subject {
  const char *path;    /* absolute */
  const char *texture; /* --texture: that kind alone; NULL: all */
  bool thorough;
  uint64_t chance; /* state of the generator of chance */
  void *library;
  const sozai_entry_v1 *entry;
  const sozai_textures_1 *textures; /* NULL where there is no such table */
  const sozai_geometry_1 *geometry;
  const sozai_wood_1 *wood;
} subject;

/* Each says why not, and gives false. load: the library and its entry of our
 * major version; start: the same, init, and its tables. */
bool subject_load(subject *s);
bool subject_start(subject *s);
/* deinit and dlclose, as far as it came. */
void subject_stop(subject *s);
/* Fill in the tables after an init. */
void subject_tables(subject *s);

/* Whether that texture or generator is to be judged. */
bool subject_wants(const subject *s, const char *id);

/* The seed's numbers: the same on every machine. */
uint64_t chance_bits(subject *s);
uint32_t chance_below(subject *s, uint32_t n);
double chance_between(subject *s, double low, double high);

/* What textures and generators have in common. */
typedef struct kind {
  const char *id;
  const char *what; /* "texture" or "generator" */
  uint32_t size, size_known, revision;
  const char *label, *doc;
  const sozai_parameter *const *parameters;
  const sozai_preset *const *presets;
  uint32_t parameter_count, preset_count;
  const sozai_texture_info *texture;
  const sozai_generator_info *generator;
} kind;

#define KINDS_MOST 64

/* All that are to be judged; at most KINDS_MOST. */
uint32_t subject_kinds(const subject *s, kind *out);
/* Started, the same; 0, with the reason said, where it does not start. */
uint32_t subject_all(subject *s, kind *out);
/* Started, the textures among them; 0, with the reason said, where there is none. */
uint32_t subject_textures(subject *s, kind *out);

const char *last_error(const subject *s);
/* "SOZAI_ERROR_RANGE (-4)", for messages. */
const char *result_name(int32_t result);
const char *kind_name(uint32_t kind);

/* ---- textures ---------------------------------------------------------- */

/* Run for every texture that is judged, made as a host without services makes
 * it: of its defaults, and of `presets` of its presets by chance (of all,
 * with --thorough). preset NULL: the defaults. */
typedef void texture_test(subject *s, const sozai_texture_info *info, const char *preset,
                          sozai_texture *t);
void each_texture(subject *s, uint32_t presets, texture_test *test);
/* The same, started first. */
void start_each_texture(subject *s, uint32_t presets, texture_test *test);

/* "wood" or "wood, preset keyaki". The text is this thread's, till the next call. */
const char *texture_name(const sozai_texture_info *info, const char *preset);

#endif
