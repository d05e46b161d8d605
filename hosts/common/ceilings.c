/* SPDX-License-Identifier: Apache-2.0 */
#include "ceilings.h"

#include <errno.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#define FOR_PLUGIN 64 /* the plugin's, as many as may be set */
#define LONGEST_NAME 64

#define INFO_(name, id_, unit_, value_, most_, doc_)                                               \
  {.size = sizeof(sozai_limit_info),                                                               \
   .id = id_,                                                                                      \
   .unit = unit_,                                                                                  \
   .doc = doc_,                                                                                    \
   .value = value_,                                                                                \
   .most = most_},
const sozai_limit_info host_limit_infos[HOST_LIMITS] = {HOST_LIMIT_ROWS(INFO_)};

static pthread_once_t once = PTHREAD_ONCE_INIT;
static uint64_t values[HOST_LIMITS];
static char names[FOR_PLUGIN][LONGEST_NAME];
static sozai_limit for_plugin[FOR_PLUGIN];
static uint32_t for_plugin_count;
static failure bad_environment; /* empty: there is nothing wrong */

static bool read_value(const char *text, uint64_t *out) {
  char *end;
  if (*text < '0' || *text > '9') return false; /* strtoull takes signs and blanks */
  errno = 0;
  unsigned long long n = strtoull(text, &end, 10);
  static const char units[] = "KMGT";
  const char *unit = *end ? strchr(units, *end) : NULL;
  int shift = unit ? 10 * (int)(unit - units + 1) : 0;
  if (errno || end[unit != NULL] || n > UINT64_MAX >> shift) return false;
  *out = n << shift;
  return true;
}

static bool set(const char *pair, const char *from, failure *why) {
  const char *equals = strchr(pair, '=');
  uint64_t n;
  if (!equals || equals == pair || equals - pair >= LONGEST_NAME || !read_value(equals + 1, &n))
    return fail(
        why, EXIT_BAD_INPUT,
        "%s: '%.200s' is not NAME=VALUE, a whole number below 2^64, with K, M, G or T or without",
        from, pair);
  size_t length = (size_t)(equals - pair);
  for (int i = 0; i < HOST_LIMITS; i++) {
    const sozai_limit_info *info = &host_limit_infos[i];
    if (strlen(info->id) != length || strncmp(info->id, pair, length) != 0) continue;
    if (info->value == info->most)
      return fail(why, EXIT_BAD_INPUT, "%s: %s is fixed at %llu", from, info->id,
                  (unsigned long long)info->most);
    if (n > info->most)
      return fail(why, EXIT_BAD_INPUT, "%s: %s: %llu is outside 0 to %llu", from, info->id,
                  (unsigned long long)n, (unsigned long long)info->most);
    values[i] = n;
    return true;
  }
  if (for_plugin_count == FOR_PLUGIN)
    return fail(why, EXIT_BAD_INPUT, "%s: more than %d ceilings", from, FOR_PLUGIN);
  memcpy(names[for_plugin_count], pair, length);
  names[for_plugin_count][length] = '\0';
  for_plugin[for_plugin_count] = (sozai_limit){names[for_plugin_count], n};
  for_plugin_count++;
  return true;
}

static void begin(void) {
  for (int i = 0; i < HOST_LIMITS; i++) values[i] = host_limit_infos[i].value;
  const char *environment = getenv("SOZAI_LIMITS");
  if (!environment || !*environment) return;
  char *copy = strdup(environment), *rest = copy;
  if (!copy) fail(&bad_environment, EXIT_FAILURE, "out of memory");
  for (char *pair; copy && (pair = strsep(&rest, ","));)
    if (!set(pair, "SOZAI_LIMITS", &bad_environment)) break;
  free(copy);
}

bool limits_set(const char *pair, failure *why) {
  pthread_once(&once, begin);
  return set(pair, "--limit", why);
}

uint64_t limits_value(host_limit which) {
  pthread_once(&once, begin);
  return values[which];
}

bool limits_give(const sozai_entry_v1 *entry, sozai_host *host, failure *why) {
  pthread_once(&once, begin);
  if (bad_environment.text[0]) {
    *why = bad_environment;
    return false;
  }
  const sozai_limits_1 *table = entry->get_factory(SOZAI_LIMITS_1); /* or NULL: an older plugin */
  for (uint32_t i = 0; i < for_plugin_count; i++) {
    const sozai_limit_info *info = table ? table->find(for_plugin[i].id) : NULL;
    if (!info)
      return fail(why, EXIT_BAD_INPUT, "there is no limit '%s'; see sozai limits",
                  for_plugin[i].id);
    if (for_plugin[i].value > info->most)
      return fail(why, EXIT_BAD_INPUT, "limit %s: %llu is outside 0 to %llu", info->id,
                  (unsigned long long)for_plugin[i].value, (unsigned long long)info->most);
  }
  host->limits = for_plugin;
  host->limit_count = for_plugin_count;
  return true;
}

bool limits_check(host_limit which, uint64_t n, const char *name, failure *why) {
  uint64_t most = limits_value(which);
  if (n <= most) return true;
  const sozai_limit_info *info = &host_limit_infos[which];
  return fail(why, EXIT_BAD_INPUT, "%s: %llu%s%s is above the ceiling %s, %llu", name,
              (unsigned long long)n, *info->unit ? " " : "", info->unit, info->id,
              (unsigned long long)most);
}
