/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_BENCH_REPORT_H
#define SOZAI_BENCH_REPORT_H

#include <stddef.h>
#include "run.h"

void report_head(void);
void report_row(const result *r);
void report_json(const result *results, size_t count);

#endif
