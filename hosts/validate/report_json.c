/* SPDX-License-Identifier: Apache-2.0 */
#include "json.h"
#include "report.h"
#include "sozai.h"

static void lines(json *j, const char *key, char text[VERDICT_LINES][VERDICT_LINE],
                  atomic_uint *count) {
  json_open(j, key, '[');
  for (uint32_t i = 0; i < reasons_kept(count); i++) json_text(j, NULL, text[i]);
  json_close(j, ']');
}

static void one(json *j, const report_head *head, const result *r) {
  verdict *v = r->verdict;
  outcome o = outcome_of(r, head->strict);
  json_open(j, NULL, '{');
  json_text(j, "name", r->check->name);
  json_text(j, "group", r->group->id);
  json_text(j, "shows", r->check->shows);
  json_text(j, "outcome", outcome_name(o));
  json_number(j, "asked", (double)atomic_load(&v->asked));
  json_number(j, "seconds", r->seconds);
  if (atomic_load(&v->chance))
    json_number(j, "seed", (double)head->seed);
  else
    json_null(j, "seed");
  if (o == OUTCOME_SKIPPED)
    json_text(j, "reason", v->skip);
  else
    json_null(j, "reason");
  json_number(j, "failure_count", (double)atomic_load(&v->failures));
  lines(j, "failures", v->failure, &v->failures);
  json_number(j, "warning_count", (double)atomic_load(&v->warnings));
  lines(j, "warnings", v->warning, &v->warnings);
  json_close(j, '}');
}

void report_json(FILE *to, const report_head *head, const result *results, uint32_t count) {
  totals t = totals_of(results, count, head->strict);
  json j = {.to = to};
  json_open(&j, NULL, '{');
  json_text(&j, "plugin", head->path);
  json_number(&j, "format", 1);
  json_number(&j, "abi_major", SOZAI_ABI_MAJOR);
  json_number(&j, "abi_minor", SOZAI_ABI_MINOR);
  json_number(&j, "seed", (double)head->seed);
  json_bool(&j, "strict", head->strict);
  json_bool(&j, "thorough", head->thorough);
  json_number(&j, "seconds", head->seconds);
  json_number(&j, "checks", (double)t.checks);
  json_number(&j, "passed", (double)t.passed);
  json_number(&j, "failed", (double)t.failed);
  json_number(&j, "skipped", (double)t.skipped);
  json_number(&j, "warned", (double)t.warned);
  json_open(&j, "results", '[');
  for (uint32_t i = 0; i < count; i++) one(&j, head, &results[i]);
  json_close(&j, ']');
  json_close(&j, '}');
}
