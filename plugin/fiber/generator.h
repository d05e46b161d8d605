/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_FIBER_GENERATOR_H
#define SOZAI_FIBER_GENERATOR_H

#include "../generator.h"

extern const generator fiber_generator;

#endif
