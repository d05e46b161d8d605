/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_STONE_CATALOGUE_H
#define SOZAI_STONE_CATALOGUE_H

#include "../../api/sozai.h"

extern const sozai_preset *const stone_catalogue[];
extern const uint32_t stone_catalogue_count;

#endif
