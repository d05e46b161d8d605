/* SPDX-License-Identifier: Apache-2.0
 *
 * Species as presets: a file for each group in species/, an array of each in
 * the list of species.c. A new species is an entry, no code.
 */
#ifndef SOZAI_TREE_SPECIES_H
#define SOZAI_TREE_SPECIES_H

#include "../../api/sozai.h"

extern const sozai_preset *const tree_species[];
extern const uint32_t tree_species_count;

#endif
