/* SPDX-License-Identifier: Apache-2.0 */
#include "species.h"

/* clang-format off */
#define ALL(X) \
  X(sugi) X(sugi_h4) X(sugi_paper) X(hinoki) X(akamatsu) X(kuromatsu) X(karamatsu) X(todomatsu) \
  X(norway_spruce) X(scots_pine) X(douglas_fir) X(cherry) X(cherry_paper) X(keyaki) X(buna) \
  X(mizunara) X(shirakaba) X(momiji)

#define DECLARE(name) extern const sozai_preset tree_##name;
ALL(DECLARE)
/* clang-format on */

#define ENTRY(name) &tree_##name,
const sozai_preset *const tree_species[] = {ALL(ENTRY)};
const uint32_t tree_species_count = sizeof tree_species / sizeof tree_species[0];
