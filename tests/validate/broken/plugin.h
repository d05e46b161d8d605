/* SPDX-License-Identifier: Apache-2.0
 *
 * A small plugin that keeps to api/sozai.h in all: one texture, `plain`, and one
 * generator, `rod`. Built as it is it must pass every check; built with the name of
 * a line of defects.txt it has that one defect, and the checks of that line must
 * fail and no others. Each defect is a few lines within #ifdef.
 */
#ifndef SOZAI_TESTS_BROKEN_PLUGIN_H
#define SOZAI_TESTS_BROKEN_PLUGIN_H

#include <stdbool.h>

#include "sozai.h"

#define TEXT_MOST 256
#define WEIGHTS_MOST 64

/* One parameter's value as it was made. */
typedef struct setting {
  double number[3];
  const char *lent; /* the host's, until it is copied into text */
  char text[TEXT_MOST];
  sozai_buffer buffer;
  float weights[WEIGHTS_MOST];
  bool has_buffer;
} setting;

/* say.c */
int32_t say(int32_t code, const char *format, ...) __attribute__((format(printf, 2, 3)));
const char *said(void);
bool say_open(void);
void say_close(void);
/* A number as in the C locale; false: the text is none. */
bool number_of(const char *text, const char **end, double *out);
sozai_host host_of(const sozai_host *given);
void *take(const sozai_host *h, uint64_t size);
void give_back(const sozai_host *h, void *memory, uint64_t size);
bool host_cancels(const sozai_host *h, float fraction);
/* Run the tasks on the host's threads, or here. */
void run_all(const sozai_host *h, uint32_t count, void (*task)(void *, uint32_t), void *context);

/* values.c */
int32_t settings_read(setting *out, const char *owner, const sozai_parameter *const *parameters,
                      uint32_t parameter_count, const sozai_preset *const *presets,
                      uint32_t preset_count, const char *preset, const sozai_value *values,
                      uint32_t value_count);
int32_t setting_value(const setting *s, const char *owner, const sozai_parameter *const *parameters,
                      uint32_t count, const char *id, sozai_value *out);

/* describe.c */
enum { P_SCALE, P_LEVELS, P_SMOOTH, P_PATTERN, P_OFFSET, P_TINT, P_NOTE, P_WEIGHTS, P_COUNT };
enum { G_LENGTH, G_SIDES, G_COUNT };
enum { C_ALBEDO = 0, C_RADIANCE = 3, C_HEIGHT = 6, C_FACE = 7, COMPONENTS = 8 };
extern char plain_label[];
const sozai_texture_info *plain_info(void);
const sozai_generator_info *rod_info(void);

/* entry.c */
bool ready(void);

extern const sozai_textures_1 textures;   /* texture.c */
extern const sozai_geometry_1 generators; /* rod.c */

#endif
