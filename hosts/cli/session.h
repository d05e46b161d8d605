/* SPDX-License-Identifier: Apache-2.0
 * What eval, render and the pictures share: the plugin, the colour service and
 * the host's services, opened in that order and closed in the other. */
#ifndef SOZAI_CLI_SESSION_H
#define SOZAI_CLI_SESSION_H

#include "colour.h"
#include "display.h"
#include "host.h"
#include "options.h"
#include "plugin.h"
#include "recipe.h"
#include "ceilings.h"

typedef struct session {
  plugin plugin;
  colour colour;
  display_choice shown; /* checked */
  host host;            /* the session may not move once open: textures point here */
} session;

/* The options that name a texture and how to run. */
typedef struct session_options {
  const char *preset;
  option_texts params;
  display_choice shown; /* of the commands that write PNG */
  const char *config;
  uint32_t threads; /* 0: as many as there are */
  bool verbose;
} session_options;

/* Their rows of an option table. */
/* clang-format off */
#define SESSION_TEXTURE_OPTIONS(s) \
  {.name = "preset", .kind = OPTION_TEXT, .target = &(s).preset, .argument = "NAME", \
   .help = "start from a preset's values"}, \
  {.name = "param", .letter = 'p', .kind = OPTION_PAIRS, .target = &(s).params, \
   .argument = "NAME=VALUE", .help = "set a parameter; any number of these"}
#define SESSION_RUN_OPTIONS(s) \
  {.name = "config", .kind = OPTION_TEXT, .target = &(s).config, .argument = "FILE", \
   .help = "OpenColorIO config (default: $OCIO, else the shipped one)"}, \
  {.name = "threads", .kind = OPTION_COUNT, .target = &(s).threads, .argument = "N", \
   .help = "threads (default: all)", .low = 1, .high = MOST_THREADS}, \
  {.name = "limit", .kind = OPTION_LIMIT, .argument = "NAME=VALUE", \
   .help = "set a ceiling: see sozai limits; any number of these"}, \
  {.name = "verbose", .kind = OPTION_FLAG, .target = &(s).verbose, \
   .help = "log what the plugin says"}
#define SESSION_DISPLAY_OPTIONS(s) \
  {.name = "display", .kind = OPTION_TEXT, .target = &(s).shown.display, .argument = "NAME", \
   .help = "the display a PNG is for (default: the config's)"}, \
  {.name = "view", .kind = OPTION_TEXT, .target = &(s).shown.view, .argument = "NAME", \
   .help = "the display's view (default: the display's first)"}, \
  {.name = "look", .kind = OPTION_TEXT, .target = &(s).shown.look, .argument = "NAME", \
   .help = "look in place of the view's own; '' for none; several: 'a, -b'"}
/* clang-format on */

/* argc: how many -p there can be at most. */
bool session_options_init(session_options *o, int argc, failure *why);
void session_options_free(session_options *o);

/* Names of displays, views and looks are checked here, before any work. */
bool session_open(session *s, const session_options *o, failure *why);
/* The plugin and the host's services alone. */
bool session_open_without_colour(session *s, const session_options *o, failure *why);
void session_close(session *s);

/* The recipe of a material or file, with the options' preset and parameters on top. */
bool session_recipe(recipe *r, const char *name, const session_options *o, failure *why);

/* Where arches fill the face of a board: nearer to the pith they are one narrow tongue. */
#define BOARD_FROM_PITH "100" /* mm */

/* A texture is a whole log unless something else is said, and a board, or a plane, with the pith in
 * its middle is one that no mill sells: where no file describes it and nobody says how it lies, it
 * is sawn flat. info: the recipe's; shape: board, plane, or another. */
bool session_saw(recipe *r, const sozai_texture_info *info, const char *shape, failure *why);

/* The same parameters for a recipe that is written to a file: paths in it start from
 * the file's folder, those of -p from this one. recipe_settle makes them whole. */
bool session_params_here(recipe *r, const option_texts *params, failure *why);

/* "a,b" into indices of the texture's channels, in that order. most: the room
 * in indices. false: an unknown name, or one that stands twice. */
bool session_channels(const sozai_texture_info *info, const char *names, uint32_t *indices,
                      uint32_t most, uint32_t *count, failure *why);

#endif
