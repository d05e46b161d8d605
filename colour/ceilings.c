/* SPDX-License-Identifier: Apache-2.0 */
#include "ceilings.h"

#include <string.h>

#define ROW(id_, n, doc_)                                                                          \
  { .size = sizeof(sozai_limit_info), .id = id_, .unit = "", .doc = doc_, .value = n, .most = n }

static const sozai_limit_info rows[] = {
    ROW("image_side", IMAGE_LARGEST_SIDE, "Pixels along a side of a picture that is opened."),
    ROW("image_file_pixels", IMAGE_MOST_PIXELS, "Pixels of a picture that is opened."),
    ROW("image_channels", IMAGE_MOST_CHANNELS, "Channels of a picture that a host hands over."),
    ROW("config_steps", CONFIG_MOST_STEPS,
        "Steps that a colour config's references come to, each by each."),
    ROW("config_depth", CONFIG_DEEPEST, "References of a colour config, one within another.")};
#define ROWS ((uint32_t)(sizeof rows / sizeof *rows))

static uint32_t count(void) { return ROWS; }

static const sozai_limit_info *info(uint32_t index) { return index < ROWS ? &rows[index] : NULL; }

static const sozai_limit_info *find(const char *id) {
  for (uint32_t i = 0; id && i < ROWS; i++)
    if (strcmp(rows[i].id, id) == 0) return &rows[i];
  return NULL;
}

const sozai_limits_1 sozai_colour_limits = {count, info, find};
