/* SPDX-License-Identifier: Apache-2.0
 *
 * From values handed over the ABI to settings: checked against the
 * parameters' table, defaults and preset filled in, text and buffers copied.
 */
#ifndef SOZAI_CORE_PARAMS_H
#define SOZAI_CORE_PARAMS_H

#include "../../api/sozai.h"

/* One parameter's value. */
typedef struct {
  double number[3];           /* CHOICE: the index */
  const char *text;           /* CHOICE: the id. COLOUR: the space. */
  const sozai_buffer *buffer; /* IMAGE: also of a file; NULL: no picture */
} setting;

/* All of a texture's settings, in one block of memory. */
typedef struct {
  setting *list; /* parameter_count of them, in the table's order */
  size_t bytes;
  uint32_t count;
  uint32_t reserved;
} settings;

/* Reads preset and values on top of the defaults. On failure nothing is held. */
int32_t settings_make(settings *out, const sozai_host *host, const sozai_texture_info *info,
                      const char *preset, const sozai_value *values, uint32_t value_count);
void settings_free(settings *s, const sozai_host *host);
/* One of them as a value. */
int32_t settings_value(const settings *s, const sozai_texture_info *info, const char *id,
                       sozai_value *out);

/* The setting at a place in the table: a number, or the index of a choice. */
static inline double number_at(const settings *s, int place) { return s->list[place].number[0]; }
static inline int choice_at(const settings *s, int place) { return (int)number_at(s, place); }

#endif
