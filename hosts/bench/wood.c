/* SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 200809L /* setenv */
#include "wood.h"

#include <stdlib.h>
#include <string.h>

#define PICTURE_MM 256 /* the board's side */

static sozai_value choice(const char *id, const char *text) {
  return (sozai_value){.id = id, .kind = SOZAI_KIND_CHOICE, .text = text};
}

static sozai_value number(const char *id, double x) {
  return (sozai_value){.id = id, .kind = SOZAI_KIND_FLOAT, .number = {x}};
}

enum { KNOTS_MOST = 2000, KNOT_COLUMNS = 10 };

/* Alive, 6 mm thick, one above the other at the golden angle. */
static void fill_knots(float (*rows)[KNOT_COLUMNS], int count, int metre) {
  for (int i = 0; i < count; i++) {
    const double row[KNOT_COLUMNS] = {
        -1, 0, -1, -1, 2.39996 * (i % 40), 0.3, 1000.0 * (i + 0.5) / metre, 6, 0, 0};
    for (int c = 0; c < KNOT_COLUMNS; c++) rows[i][c] = (float)row[c];
  }
}

bool wood_create(const wood *w, const char *picture, const plugin *p, sozai_texture **out,
                 failure *why) {
  sozai_value values[20] = {choice("cut", w->cut ? w->cut : "flat"),
                            choice("grain", w->grain ? w->grain : "compound")};
  uint32_t count = 2;
  if (w->porosity) values[count++] = choice("porosity", w->porosity);
  if (w->layout) values[count++] = choice("layout", w->layout);
  if (w->plied) {
    values[count++] = choice("construction", "plywood");
    values[count++] = (sozai_value){.id = "sheets", .kind = SOZAI_KIND_INT, .number = {1000}};
    values[count++] = number("face_height", w->edge ? 9000 : 0);
  }
  if (w->surface) values[count++] = choice("surface", w->surface);
  if (w->pigmented) values[count++] = number("pigment", 0.5);
  if (w->no_rays) values[count++] = number("ray_density", 0);
  static float rows[KNOTS_MOST][KNOT_COLUMNS];
  sozai_buffer knots = {.size = sizeof knots,
                        .kind = SOZAI_BUFFER_TABLE,
                        .dims = {(uint64_t)w->knots, KNOT_COLUMNS},
                        .data = rows[0]};
  if (w->knots) {
    fill_knots(rows, w->knots, w->knots_metre);
    values[count++] = (sozai_value){.id = "knots", .kind = SOZAI_KIND_BUFFER, .buffer = &knots};
    values[count++] = number("log_height", 500.0 * w->knots / w->knots_metre - 400);
  }
  if (w->reflection) values[count++] = choice("reflection", w->reflection);
  if (w->pictured) {
    values[count++] = (sozai_value){.id = "section", .kind = SOZAI_KIND_IMAGE, .text = picture};
    values[count++] = number("section_width", PICTURE_MM);
    values[count++] = choice("section_pith", "given");
    values[count++] = choice("section_rim", "none");
    /* an end-grain board that is the picture itself, in the yardstick's own order */
    values[count++] = number("cut_distance", w->cut ? 0 : 60);
    values[count++] = number("cut_height", 0);
  }
  /* The kernel is chosen within create(). Unset, it is the best. */
  if (w->cpu)
    setenv("SOZAI_CPU", w->cpu, 1);
  else
    unsetenv("SOZAI_CPU");
  const char *material = w->fiber ? "fiber" : w->stone ? "stone" : "wood";
  const char *preset = w->fiber ? w->fiber : w->stone ? w->stone : "keyaki";
  if (w->fiber || w->stone) count = 0;
  int32_t result = p->textures->create(NULL, material, preset, values, count, out);
  unsetenv("SOZAI_CPU");
  if (result == SOZAI_OK || (result == SOZAI_ERROR_UNSUPPORTED && w->cpu)) return true;
  return fail(why, EXIT_FAILURE, "create: %s", p->textures->last_error());
}

uint32_t wood_components(const wood *w, const plugin *p) {
  const sozai_channel *layouts = wood_channel(p, "board_id");
  return w->layout || w->surface || !layouts ? p->textures->find("wood")->component_count
                                             : layouts->first;
}

const sozai_channel *wood_channel(const plugin *p, const char *id) {
  const sozai_texture_info *info = p->textures->find("wood");
  for (uint32_t i = 0; info && i < info->channel_count; i++)
    if (strcmp(info->channels[i]->id, id) == 0) return info->channels[i];
  return NULL;
}
