/* SPDX-License-Identifier: Apache-2.0 */
#define _POSIX_C_SOURCE 200809L
#include <regex.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include "bake.h"
#include "cancel.h"
#include "options.h"
#include "output_file.h"
#include "pin.h"
#include "progress.h"
#include "report.h"
#include "scratch.h"

/* ---- choosing --------------------------------------------------------- */

typedef struct choice {
  const entry **items;
  size_t count;
} choice;

static bool choose(choice *c, const char *filter, failure *why) {
  regex_t expression;
  int error = filter ? regcomp(&expression, filter, REG_EXTENDED | REG_NOSUB) : 0;
  if (error) {
    char text[256];
    regerror(error, &expression, text, sizeof text);
    return fail(why, EXIT_BAD_INPUT, "--filter: '%s': %s", filter, text);
  }
  c->count = 0;
  for (size_t i = 0; i < entry_count; i++)
    if (!filter || regexec(&expression, entries[i].name, 0, NULL, 0) == 0)
      c->items[c->count++] = &entries[i];
  if (filter) regfree(&expression);
  return c->count ||
         fail(why, EXIT_BAD_INPUT, "--filter: '%s' matches no entry; see --list", filter);
}

static bool any_needs_yardstick(const choice *c) {
  for (size_t i = 0; i < c->count; i++)
    if (entry_needs_yardstick(c->items[i])) return true;
  return false;
}

/* ---- making ready ----------------------------------------------------- */

static bool make_picture(const bench *b, const char *path, failure *why) {
  progress_show(0, "baking the board");
  float *rgb = bake_board(&b->plugin, &b->board, why);
  if (!rgb) return false;
  progress_show(0, "making its mipmaps");
  bool ok = yardstick_write(path, b->board.side, rgb, why);
  free(rgb);
  return ok;
}

static bool make_yardstick(bench *b, const char *path, failure *why) {
  if (!make_picture(b, path, why)) return false;
  b->picture = path;
  b->yardstick = yardstick_open(path, why);
  return b->yardstick != NULL;
}

/* ---- measuring -------------------------------------------------------- */

static bool run_all(const bench *b, const choice *c, bool json, result *results, size_t *done,
                    failure *why) {
  if (!json) report_head();
  for (size_t i = 0; i < c->count; i++) {
    const entry *e = c->items[i];
    progress_show((float)i / (float)c->count, e->name);
    bool skipped;
    if (!entry_run(b, e, &results[*done], &skipped, why)) return false;
    progress_clear();
    if (skipped)
      fprintf(stderr, "sozai-bench: %s: not on this machine\n", e->name);
    else if (!json)
      report_row(&results[(*done)++]);
    else
      (*done)++;
  }
  return true;
}

static bool run(const bench_options *o, const choice *c, result *results, size_t *done,
                failure *why) {
  bench b = {.board = board_make(o->quick),
             .repetitions = o->quick ? 3 : 15,
             .counted_batches = o->quick ? 1 : 4};
  if (!plugin_open(&b.plugin, why)) return false;
  scratch s = {0};
  /* On every CPU until here, on one from here on. */
  bool ok = !any_needs_yardstick(c) ||
            (scratch_open(&s, "board.exr", why) && make_yardstick(&b, s.file, why));
  if (ok && !pin_to(0)) ok = fail(why, EXIT_FAILURE, "cannot stay on one CPU");
  ok = ok && run_all(&b, c, o->json, results, done, why);
  progress_clear();
  yardstick_close(b.yardstick);
  scratch_close(&s);
  if (ok && o->json) report_json(results, *done);
  plugin_close(&b.plugin); /* last: results point at its texts */
  return ok;
}

static bool work(const bench_options *o, choice *c, failure *why) {
  if (!choose(c, o->filter, why)) return false;
  if (o->list) {
    for (size_t i = 0; i < c->count; i++) puts(c->items[i]->name);
    return true;
  }
  result *results = calloc(c->count, sizeof *results);
  if (!results) return fail(why, EXIT_FAILURE, "out of memory");
  size_t done = 0;
  bool ok = run(o, c, results, &done, why);
  free(results);
  return ok;
}

int main(int argc, char **argv) {
  signal(SIGPIPE, SIG_IGN); /* a closed pipe is a failed write: what is half made is taken away */
  cancel_install();
  bench_options o;
  failure why = {.exit_code = EXIT_FAILURE};
  bool ok = bench_options_read(&o, argc, argv, &why);
  if (ok && o.help)
    bench_options_help();
  else if (ok) {
    choice c = {.items = calloc(entry_count, sizeof *c.items)};
    ok = c.items ? work(&o, &c, &why) : fail(&why, EXIT_FAILURE, "out of memory");
    free(c.items);
  }
  ok = ok && output_printed(&why);
  progress_clear();
  if (!ok && why.exit_code != EXIT_CLOSED_PIPE) fprintf(stderr, "sozai-bench: %s\n", why.text);
  cancel_end();
  return ok ? 0 : why.exit_code;
}
