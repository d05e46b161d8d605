/* SPDX-License-Identifier: Apache-2.0
 *
 * The species, as data: species/list.h lists them, species/entry.h has the
 * words they are written in, and the entries are by group in species/. */
#include "species.h"

#include "species/entry.h"

#define ADDRESS(key) &species_##key,
const sozai_preset *const wood_species[] = {SPECIES_ALL(ADDRESS)};
const uint32_t wood_species_count = COUNT(wood_species);
