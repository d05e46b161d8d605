/* SPDX-License-Identifier: Apache-2.0 */
#include "report.h"

#include <math.h>
#include <stdio.h>
#include "json.h"

void report_head(void) {
  printf("%-33s %-6s %10s %10s %10s %8s %7s %8s %8s %6s\n", "", "", "ns/point", "", "look-up", "",
         "ops a", "peak", "limit", "ours/");
  printf("%-33s %-6s %10s %10s %10s %8s %7s %8s %8s %6s\n", "entry", "on", "median", "min",
         "median", "ratio", "point", "Gop/s", "ns", "limit");
}

static void cell(int width, int decimals, double number) {
  if (isnan(number))
    printf(" %*s", width, "-");
  else
    printf(" %*.*f", width, decimals, number);
}

void report_row(const result *r) {
  int decimals = r->ns >= 1e4 ? 0 : 2;
  printf("%-33s %-6s", r->name, *r->instruction_set ? r->instruction_set : "-");
  cell(10, decimals, r->ns);
  cell(10, decimals, r->ns_min);
  cell(10, decimals, r->yardstick_ns);
  cell(8, 2, r->ratio);
  cell(7, 0, r->ops);
  cell(8, 1, r->peak_gops);
  cell(8, 2, r->limit_ns);
  cell(6, 2, r->ns / r->limit_ns);
  if (!isnan(r->speedup)) printf("  %.2f x one thread, at best %.2f", r->speedup, r->speedup_best);
  printf("\n");
  fflush(stdout);
}

static void known(json *j, const char *key, double number) {
  if (!isnan(number)) json_number(j, key, number);
}

static void write_result(json *j, const result *r) {
  json_open(j, NULL, '{');
  json_text(j, "name", r->name);
  json_number(j, "ns_per_point", r->ns);
  json_number(j, "yardstick_ns", r->yardstick_ns);
  json_number(j, "ratio", r->ratio);
  json_number(j, "min_ns_per_point", r->ns_min);
  json_number(j, "yardstick_min_ns", r->yardstick_min);
  if (*r->instruction_set) json_text(j, "instruction_set", r->instruction_set);
  if (r->batch) json_number(j, "batch", r->batch);
  known(j, "speedup", r->speedup);
  known(j, "speedup_best", r->speedup_best);
  known(j, "ops_per_point", r->ops);
  known(j, "float_ops_per_point", r->float_ops);
  known(j, "peak_gops", r->peak_gops);
  known(j, "limit_ns", r->limit_ns);
  known(j, "over_limit", r->ns / r->limit_ns);
  json_close(j, '}');
}

void report_json(const result *results, size_t count) {
  json j = {.to = stdout};
  json_open(&j, NULL, '[');
  for (size_t i = 0; i < count; i++) write_result(&j, &results[i]);
  json_close(&j, ']');
}
