/* SPDX-License-Identifier: Apache-2.0 */
#include "select.h"

#include <regex.h>
#include <stdlib.h>
#include <string.h>

#include "subject.h"

bool select_checks(const char *only, result **out, uint32_t *count, failure *why) {
  regex_t pattern;
  if (only) {
    int code = regcomp(&pattern, only, REG_EXTENDED | REG_NOSUB);
    if (code != 0) {
      char text[200];
      regerror(code, &pattern, text, sizeof text);
      return fail(why, EXIT_BAD_INPUT, "--only: '%s' is no regular expression: %s", only, text);
    }
  }
  uint32_t all = 0, n = 0;
  for (uint32_t g = 0; g < check_group_count; g++) all += *check_groups[g].count;
  result *results = calloc(all, sizeof *results);
  for (uint32_t g = 0; results && g < check_group_count; g++)
    for (uint32_t i = 0; i < *check_groups[g].count; i++) {
      const check *c = &check_groups[g].checks[i];
      if (only && regexec(&pattern, c->name, 0, NULL, 0) != 0) continue;
      results[n++] = (result){.check = c, .group = &check_groups[g]};
    }
  if (only) regfree(&pattern);
  if (!results) return fail(why, EXIT_FAILURE, "out of memory");
  if (n == 0) {
    free(results);
    return fail(why, EXIT_BAD_INPUT, "--only: no check's name matches '%s'; see --list", only);
  }
  *out = results;
  *count = n;
  return true;
}

/* As a check of its own, since asking runs the plugin's code. */
static void has_texture(subject *s) {
  if (!subject_start(s)) return;
  static kind kinds[KINDS_MOST];
  if (subject_kinds(s, kinds) == 0) skipped("none");
  asked();
}

static void ignore(const result *r, void *user) { (void)r, (void)user; }

bool select_texture(const char *path, const char *id, double time_limit, failure *why) {
  if (!id) return true;
  static const check question = {"select.texture", NULL, "it has that texture", has_texture};
  result answer = {.check = &question};
  char *full = realpath(path, NULL);
  const run_options options = {
      .path = full ? full : path, .texture = id, .jobs = 1, .time_limit = time_limit};
  bool ran = run_checks(&options, &answer, 1, ignore, NULL);
  free(full);
  if (!ran) return fail(why, EXIT_FAILURE, "stopped");
  /* A plugin that fails here fails its checks too, which say how. */
  if (answer.outcome != OUTCOME_SKIPPED) return true;
  return fail(why, EXIT_BAD_INPUT, "--texture: the plugin has no '%s'", id);
}
