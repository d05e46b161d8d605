/* SPDX-License-Identifier: Apache-2.0 */
#include "grown.h"

#include <stdlib.h>
#include <time.h>
#include "cancel.h"
#include "ending.h"
#include "output_file.h"
#include "progress.h"

bool grown_is_picture(const char *output) {
  return ends_in(output, ".png") || ends_in(output, ".exr");
}

bool grown_check_table(const char *output, const char *table, failure *why) {
  if ((table != NULL) == ends_in(output, ".csv")) return true;
  return fail(why, EXIT_BAD_INPUT, "--table: goes with an output in .csv, and .csv with it");
}

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool make_in(const grown_file *f, session *s, failure *why) {
  const sozai_geometry_1 *table = growth_table(s->plugin.entry, why);
  output_file file;
  if (!table || !output_begin(&file, f->output, why)) return false;
  sozai_geometry *g = NULL;
  double begin = now();
  bool ok = f->grow(f->options, table, &s->host.abi, &g, why);
  if (ok && f->verbose) f->report(table, g, now() - begin);
  ok = ok && f->write(f->options, table, g, s, file.writing, why);
  table->release(g);
  if (ok && cancel_requested()) ok = fail(why, EXIT_FAILURE, "cancelled");
  progress_clear();
  if (ok) return output_commit(&file, why);
  return output_failed(&file, why);
}

bool grown_make(const grown_file *f, const session_options *shared, failure *why) {
  session s;
  /* only pictures want colour, whose service takes a while to open */
  bool open = grown_is_picture(f->output) ? session_open(&s, shared, why)
                                          : session_open_without_colour(&s, shared, why);
  if (!open) return false;
  bool ok = make_in(f, &s, why);
  session_close(&s);
  return ok;
}
