/* SPDX-License-Identifier: Apache-2.0 */
#include "limits.h"

#include <string.h>

#include "meter.h"
#include "status.h"

#define INFO_(name, id_, unit_, value_, most_, doc_)                                               \
  {.size = sizeof(sozai_limit_info),                                                               \
   .id = id_,                                                                                      \
   .unit = unit_,                                                                                  \
   .doc = doc_,                                                                                    \
   .value = value_,                                                                                \
   .most = most_},
const sozai_limit_info limit_infos[LIMITS] = {LIMIT_ROWS(INFO_)};

static uint32_t count(void) { return LIMITS; }

static const sozai_limit_info *info(uint32_t index) {
  return index < LIMITS ? &limit_infos[index] : NULL;
}

static int index_of(const char *id) {
  for (int i = 0; id && i < LIMITS; i++) {
    if (strcmp(limit_infos[i].id, id) == 0) return i;
  }
  return -1;
}

static const sozai_limit_info *find(const char *id) {
  int i = index_of(id);
  return i < 0 ? NULL : &limit_infos[i];
}

const sozai_limits_1 limits_table = {count, info, find};

int32_t limits_read(uint64_t ceilings[LIMITS], const sozai_host *host) {
  for (int i = 0; i < LIMITS; i++) ceilings[i] = limit_infos[i].value;
  if (host->limit_count && !host->limits) {
    return fail(SOZAI_ERROR_ARGUMENT, "host.limits is NULL, and limit_count %u", host->limit_count);
  }
  for (uint32_t k = 0; k < host->limit_count; k++) {
    const sozai_limit *given = &host->limits[k];
    if (!given->id) return fail(SOZAI_ERROR_ARGUMENT, "host.limits: row %u has no id", k);
    int i = index_of(given->id);
    if (i < 0) return fail(SOZAI_ERROR_UNKNOWN, "there is no limit \"%.80s\"", given->id);
    if (given->value > limit_infos[i].most) {
      return fail(SOZAI_ERROR_RANGE, "limit %s: %llu is outside 0 to %llu", given->id,
                  (unsigned long long)given->value, (unsigned long long)limit_infos[i].most);
    }
    ceilings[i] = given->value;
  }
  return SOZAI_OK;
}

uint64_t limit_of(const sozai_host *host, limit which) {
  const meter *m = meter_of(host);
  return m ? m->ceilings[which] : limit_infos[which].value;
}

int32_t limit_check(const sozai_host *host, limit which, uint64_t n, const char *what) {
  uint64_t most = limit_of(host, which);
  if (n <= most) return SOZAI_OK;
  return fail(SOZAI_ERROR_LIMIT, "%s: %llu%s%s is above the ceiling %s, %llu", what,
              (unsigned long long)n, limit_infos[which].unit[0] ? " " : "", limit_infos[which].unit,
              limit_infos[which].id, (unsigned long long)most);
}
