/* SPDX-License-Identifier: Apache-2.0
 *
 * sozai limits: every ceiling on what comes from outside, as it is in force. */
#include "commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "colour.h"
#include "json.h"
#include "ceilings.h"
#include "options.h"
#include "output_file.h"
#include "plugin.h"

typedef struct row {
  const char *layer; /* who keeps it */
  const sozai_limit_info *info;
  uint64_t value;
  bool settable;
} row;

static void print_text(const row *r) {
  char most[32] = "fixed";
  if (r->settable) snprintf(most, sizeof most, "%llu", (unsigned long long)r->info->most);
  printf("%-10s %-18s %14llu %14s %-2s %s\n", r->layer, r->info->id, (unsigned long long)r->value,
         most, r->info->unit, r->info->doc);
}

static void print_json(json *j, const row *r) {
  json_open(j, NULL, '{');
  json_text(j, "layer", r->layer);
  json_text(j, "id", r->info->id);
  json_text(j, "unit", r->info->unit);
  json_number(j, "value", (double)r->value);
  json_number(j, "usual", (double)r->info->value);
  json_number(j, "most", (double)r->info->most);
  json_bool(j, "settable", r->settable);
  json_text(j, "doc", r->info->doc);
  json_close(j, '}');
}

static void put(json *j, const row *r) {
  if (j)
    print_json(j, r);
  else
    print_text(r);
}

static uint64_t in_force(const sozai_limit_info *info, const sozai_host *host) {
  uint64_t n = info->value;
  for (uint32_t i = 0; i < host->limit_count; i++)
    if (strcmp(host->limits[i].id, info->id) == 0) n = host->limits[i].value;
  return n;
}

/* host: whose ceilings are set; NULL: nobody can. */
static void put_table(json *j, const char *layer, const sozai_limits_1 *table,
                      const sozai_host *host) {
  for (uint32_t i = 0; table && i < table->count(); i++) {
    const sozai_limit_info *info = table->info(i);
    put(j, &(row){layer, info, host ? in_force(info, host) : info->value, host != NULL});
  }
}

/* services: of the pictures; NULL: there are none. */
static bool print_all(const plugin *p, const sozai_entry_v1 *services, bool as_json, failure *why) {
  sozai_host host = {.size = sizeof host};
  if (!limits_give(p->entry, &host, why)) return false;
  json document = {.to = stdout}, *j = as_json ? &document : NULL;
  if (j)
    json_open(j, NULL, '[');
  else
    printf("%-10s %-18s %14s %14s\n", "layer", "ceiling", "in force", "up to");
  put_table(j, "plugin", p->entry->get_factory(SOZAI_LIMITS_1), &host);
  if (services) put_table(j, "pictures", services->get_factory(SOZAI_LIMITS_1), NULL);
  for (int i = 0; i < HOST_LIMITS; i++)
    put(j, &(row){"programs", &host_limit_infos[i], limits_value((host_limit)i),
                  host_limit_infos[i].value != host_limit_infos[i].most});
  if (j) json_close(j, ']');
  return true;
}

int run_limits(int argc, char **argv) {
  bool as_json = false;
  const option options[] = {
      {"json", 0, OPTION_FLAG, &as_json, NULL, "as JSON", 0, 0},
      {"limit", 0, OPTION_LIMIT, NULL, "NAME=VALUE", "as of the other commands", 0, 0}};
  const command_line line = {
      .usage = "limits [--json]",
      .about = "Every ceiling on what comes from outside: in force, and up to where --limit\n"
               "NAME=VALUE of the other commands, or $SOZAI_LIMITS, may set it.\n",
      .options = options,
      .option_count = sizeof options / sizeof options[0]};
  failure why = {0};
  int parsed = options_parse(&line, argc, argv, NULL, &why);
  if (parsed == OPTIONS_DONE) return 0;
  plugin p;
  if (parsed == OPTIONS_BAD || !plugin_open(&p, &why)) return report(&why);
  colour c;
  bool ok = colour_open(&c, p.path, NULL, &why);
  if (ok) {
    ok = print_all(&p, c.entry, as_json, &why);
    colour_close(&c);
  }
  plugin_close(&p);
  if (!ok) return report(&why);
  return output_printed(&why) ? 0 : report(&why);
}
