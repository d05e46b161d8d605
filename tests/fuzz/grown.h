/* SPDX-License-Identifier: Apache-2.0
 * A generator asked for everything, on the bounded host. */
#ifndef SOZAI_TESTS_FUZZ_GROWN_H
#define SOZAI_TESTS_FUZZ_GROWN_H

#include "generator.h"

/* Grow, and where that is refused see that it says why; else look at mesh, curves and
 * tables, every number of them. */
void grown_try(const generator *kind, const char *preset, const sozai_value *values,
               uint32_t count);

#endif
