/* SPDX-License-Identifier: Apache-2.0 */
#include "report.h"

#include <string.h>

outcome outcome_of(const result *r, bool strict) {
  bool warned = r->outcome == OUTCOME_PASSED && atomic_load(&r->verdict->warnings);
  return strict && warned ? OUTCOME_FAILED : r->outcome;
}

const char *outcome_name(outcome o) {
  return o == OUTCOME_PASSED ? "passed" : o == OUTCOME_FAILED ? "failed" : "skipped";
}

uint32_t reasons_kept(atomic_uint *count) {
  uint32_t n = atomic_load(count);
  return n < VERDICT_LINES ? n : VERDICT_LINES;
}

totals totals_of(const result *results, uint32_t count, bool strict) {
  totals t = {.checks = count};
  for (uint32_t i = 0; i < count; i++) {
    outcome o = outcome_of(&results[i], strict);
    t.passed += o == OUTCOME_PASSED;
    t.failed += o == OUTCOME_FAILED;
    t.skipped += o == OUTCOME_SKIPPED;
    t.warned += atomic_load(&results[i].verdict->warnings) != 0;
  }
  return t;
}

/* A plugin's words, and a file's name, may hold anything: on one line, and
 * nothing that a terminal obeys. */
static void plain(FILE *to, const char *text) {
  for (const unsigned char *s = (const unsigned char *)text; *s; s++) {
    if (*s == '\n')
      fputs("\\n", to);
    else if (*s < 0x20 || *s == 0x7f)
      fprintf(to, "\\x%02x", *s);
    else if (*s == 0xc2 && s[1] >= 0x80 && s[1] < 0xa0) /* the C1 controls */
      fprintf(to, "\\x%02x", *++s);
    else
      fputc(*s, to);
  }
}

void text_head(FILE *to, const report_head *head, uint32_t checks) {
  plain(to, head->path);
  fprintf(to, "\n%u checks, seed %u%s%s\n", checks, head->seed, head->strict ? ", strict" : "",
          head->thorough ? ", thorough" : "");
}

static void reasons(FILE *to, const char *what, char lines[VERDICT_LINES][VERDICT_LINE],
                    atomic_uint *count) {
  uint32_t kept = reasons_kept(count);
  for (uint32_t i = 0; i < kept; i++) {
    fprintf(to, "      %s", what);
    plain(to, lines[i]);
    fputc('\n', to);
  }
  if (atomic_load(count) > kept) fprintf(to, "      and %u more\n", atomic_load(count) - kept);
}

void text_result(FILE *to, const report_head *head, const result *r, const result *before) {
  if (!before || before->group != r->group)
    fprintf(to, "\n%s: %s\n", r->group->id, r->group->title);
  outcome o = outcome_of(r, head->strict);
  verdict *v = r->verdict;
  fprintf(to, "  %-7s %s", o == OUTCOME_FAILED ? "FAILED" : outcome_name(o), r->check->name);
  if (o == OUTCOME_SKIPPED) {
    fputs(": ", to);
    plain(to, v->skip);
  }
  if (atomic_load(&v->chance)) fprintf(to, " (seed %u)", head->seed);
  fputc('\n', to);
  if (o == OUTCOME_FAILED) fprintf(to, "      wanted: %s\n", r->check->shows);
  reasons(to, "", v->failure, &v->failures);
  reasons(to, "warning: ", v->warning, &v->warnings);
  fflush(to);
}

void text_end(FILE *to, const totals *t) {
  fprintf(to, "\n%u checks: %u passed, %u failed, %u skipped", t->checks, t->passed, t->failed,
          t->skipped);
  if (t->warned) fprintf(to, ", %u with warnings", t->warned);
  fputc('\n', to);
}

void text_list(FILE *to) {
  for (uint32_t g = 0; g < check_group_count; g++) {
    fprintf(to, "%s: %s\n", check_groups[g].id, check_groups[g].title);
    for (uint32_t i = 0; i < *check_groups[g].count; i++)
      fprintf(to, "  %-30s %s\n", check_groups[g].checks[i].name, check_groups[g].checks[i].shows);
  }
}
