/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai-validate: what `sozai validate` runs. A program of its own that links
 * libc alone, so that a plugin is judged in a process where nothing else is
 * loaded, and its author needs no more than a C compiler to build it.
 */
#include <fcntl.h>
#include <limits.h>
#include <regex.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "options.h"
#include "output_file.h"
#include "report.h"
#include "select.h"

typedef struct settings {
  const char *path;
  const char *json;  /* "": to standard output; NULL: none */
  const char *junit; /* or NULL */
  const char *only;
  bool list, strict;
  uint32_t seed;
  double time_limit;
  uint32_t jobs;
  bool thorough;
  const char *texture;
} settings;

static const char about[] =
    "Judges a plugin by the contract of sozai.h: each check in a process of its own.\n"
    "Exit code: 0 all pass, 1 some failed, 2 wrong usage or an unreadable file.\n\n";

static int parse(int argc, char **argv, settings *s, failure *why) {
  const option options[] = {
      {"list", 0, OPTION_FLAG, &s->list, NULL, "list the checks, and run none", 0, 0},
      {"only", 0, OPTION_TEXT, &s->only, "REGEX", "the checks whose names it matches", 0, 0},
      {"texture", 0, OPTION_TEXT, &s->texture, "ID", "that texture or generator alone", 0, 0},
      {"thorough", 0, OPTION_FLAG, &s->thorough, NULL, "every preset, not some by chance", 0, 0},
      {"strict", 0, OPTION_FLAG, &s->strict, NULL, "a warning is a failure", 0, 0},
      {"seed", 0, OPTION_COUNT, &s->seed, "N", "repeat a run's chances", 0, UINT32_MAX},
      {"jobs", 'j', OPTION_COUNT, &s->jobs, "N", "checks at a time; default: the processors", 1,
       64},
      {"time-limit", 0, OPTION_NUMBER, &s->time_limit, "SECONDS", "of a check; default 60", 0.01,
       86400},
      {"json", 0, OPTION_MAYBE, &s->json, "[=FILE]",
       "a report as JSON, in place of text or to a file", 0, 0},
      {"junit", 0, OPTION_TEXT, &s->junit, "FILE", "a report as JUnit's XML", 0, 0},
  };
  static const char *const names[] = {"plugin"};
  const char *values[1] = {NULL};
  const command_line line = {.usage = "validate <plugin.so> [options]",
                             .about = about,
                             .options = options,
                             .option_count = COUNT_OF(options),
                             .positional = names,
                             .positional_count = 1,
                             .optional_count = 1};
  int parsed = options_parse(&line, argc, argv, values, why);
  s->path = values[0];
  if (parsed == OPTIONS_RUN && s->list && (s->json || s->junit)) {
    fail(why, EXIT_BAD_INPUT, "--list goes with neither --json nor --junit: it is no report");
    return OPTIONS_BAD;
  }
  if (parsed == OPTIONS_RUN && !s->path && !s->list) {
    fail(why, EXIT_BAD_INPUT, "validate: no plugin is given; see sozai validate --help");
    return OPTIONS_BAD;
  }
  return parsed;
}

/* A file that could be a library at all: without opening what would block. */
static bool readable(const char *path, failure *why) {
  struct stat status;
  if (stat(path, &status) != 0)
    return fail(why, EXIT_BAD_INPUT, "cannot read '%s': no such file", path);
  if (!S_ISREG(status.st_mode))
    return fail(why, EXIT_BAD_INPUT, "cannot judge '%s': not a file%s", path,
                S_ISDIR(status.st_mode) ? " but a folder" : "");
  unsigned char head[4] = {0};
  int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ssize_t n = file < 0 ? -1 : read(file, head, sizeof head);
  if (file >= 0) close(file);
  if (n < 0) return fail(why, EXIT_BAD_INPUT, "cannot read '%s'", path);
  if (n < 4 || memcmp(head, "\177ELF", 4) != 0)
    return fail(why, EXIT_BAD_INPUT, "cannot judge '%s': not a shared object (ELF)", path);
  return true;
}

/* A report's file, begun before the run: that it cannot be written is said at once. */
typedef struct report_file {
  output_file file;
  bool begun;
  void (*write)(FILE *, const report_head *, const result *, uint32_t);
} report_file;

static bool report_begin(report_file *f, const char *path, failure *why) {
  if (!path || !*path) return true;
  f->begun = output_begin(&f->file, path, why);
  return f->begun;
}

static bool report_end(report_file *f, const report_head *head, const result *results,
                       uint32_t count, failure *why) {
  if (!f->begun) return true;
  FILE *to = fopen(f->file.writing, "w");
  if (to) f->write(to, head, results, count);
  bool bad = !to || ferror(to) != 0;
  if (to && fclose(to) != 0) bad = true;
  if (!bad) return output_commit(&f->file, why);
  fail(why, EXIT_FAILURE, "cannot write '%s'", f->file.path);
  output_discard(&f->file);
  return false;
}

typedef struct shown {
  const report_head *head;
  const result *before;
} shown;

static void show(const result *r, void *user) {
  shown *s = user;
  text_result(stdout, s->head, r, s->before);
  s->before = r;
}

static void show_nothing(const result *r, void *user) { (void)r, (void)user; }

static double seconds_now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool judge(const settings *s, result *results, uint32_t count, bool *passed, failure *why) {
  report_file json = {.write = report_json}, junit = {.write = report_junit};
  char *path = realpath(s->path, NULL);
  if (!path) return fail(why, EXIT_BAD_INPUT, "cannot read '%s'", s->path);
  const run_options options = {.path = path,
                               .texture = s->texture,
                               .seed = s->seed,
                               .jobs = s->jobs,
                               .time_limit = s->time_limit,
                               .thorough = s->thorough};
  report_head head = {
      .path = s->path, .seed = s->seed, .strict = s->strict, .thorough = s->thorough};
  bool text = !s->json || *s->json;
  shown to_text = {.head = &head};
  bool good = report_begin(&json, s->json, why) && report_begin(&junit, s->junit, why);
  if (good) {
    if (text) text_head(stdout, &head, count);
    double begun = seconds_now();
    good = run_checks(&options, results, count, text ? show : show_nothing, &to_text);
    head.seconds = seconds_now() - begun;
    if (!good) fail(why, EXIT_FAILURE, "stopped");
  }
  free(path);
  if (good) {
    totals t = totals_of(results, count, s->strict);
    *passed = t.failed == 0;
    if (text)
      text_end(stdout, &t);
    else
      report_json(stdout, &head, results, count);
    good = output_printed(why);
  }
  if (good)
    return report_end(&json, &head, results, count, why) &&
           report_end(&junit, &head, results, count, why);
  output_discard(&json.file);
  output_discard(&junit.file);
  return false;
}

int main(int argc, char **argv) {
  failure why = {0};
  settings s = {.time_limit = 60, .jobs = 1, .seed = (uint32_t)time(NULL) ^ (uint32_t)getpid()};
  long processors = sysconf(_SC_NPROCESSORS_ONLN);
  if (processors > 0) s.jobs = processors < 16 ? (uint32_t)processors : 16;
  static char name[] = "validate"; /* what messages call it, whoever started it */
  if (argc > 0) argv[0] = name;
  int parsed = parse(argc, argv, &s, &why);
  if (parsed == OPTIONS_DONE) return 0;
  if (parsed == OPTIONS_BAD) return report(&why);
  if (s.list) {
    text_list(stdout);
    return output_printed(&why) ? 0 : report(&why);
  }
  result *results = NULL;
  uint32_t count = 0;
  bool passed = false;
  bool good = readable(s.path, &why) && select_checks(s.only, &results, &count, &why) &&
              select_texture(s.path, s.texture, s.time_limit, &why) &&
              judge(&s, results, count, &passed, &why);
  free(results);
  return good ? (passed ? 0 : 1) : report(&why);
}
