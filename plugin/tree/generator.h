/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_TREE_GENERATOR_H
#define SOZAI_TREE_GENERATOR_H

#include "../generator.h"

extern const generator tree_generator;

#endif
