/* SPDX-License-Identifier: Apache-2.0
 * What growing a tree and growing fibre share: from a command's options to a
 * whole file, or none. */
#ifndef SOZAI_CLI_GROWN_H
#define SOZAI_CLI_GROWN_H

#include "growth.h"
#include "session.h"

/* One command's: options is its own, for its functions. */
typedef struct grown_file {
  const char *output;
  const void *options;
  bool verbose; /* report what was grown */
  bool (*grow)(const void *options, const sozai_geometry_1 *table, const sozai_host *host,
               sozai_geometry **out, failure *why);
  /* seconds: that growing took */
  void (*report)(const sozai_geometry_1 *table, const sozai_geometry *g, double seconds);
  /* path: where to write what, once whole, is output's */
  bool (*write)(const void *options, const sozai_geometry_1 *table, const sozai_geometry *g,
                session *s, const char *path, failure *why);
} grown_file;

/* A view, by the output's ending. */
bool grown_is_picture(const char *output);

/* --table goes with .csv, and .csv with it. */
bool grown_check_table(const char *output, const char *table, failure *why);

/* Opens a session for it, grows, writes and closes. */
bool grown_make(const grown_file *f, const session_options *shared, failure *why);

#endif
