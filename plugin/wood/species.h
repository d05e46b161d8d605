/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_SPECIES_H
#define SOZAI_WOOD_SPECIES_H

#include "../../api/sozai.h"

extern const sozai_preset *const wood_species[];
extern const uint32_t wood_species_count;

#endif
