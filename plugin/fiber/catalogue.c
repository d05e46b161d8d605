/* SPDX-License-Identifier: Apache-2.0 */
#include "catalogue.h"

#include <string.h>

/* clang-format off */
#define ALL(X) \
  X(cotton) X(cotton_carded) X(kapok) X(flax) X(hemp) X(jute) X(coir) X(wool_merino) X(wool_coarse) X(felt) \
  X(fleece) X(cashmere) X(mohair) X(silk_noil) X(feather_down) X(body_hair) X(head_hair) \
  X(polyester_staple) X(viscose) X(mineral_wool) X(dust) X(lint)
#define DECLARE(name) extern const fiber_material fiber_##name;
ALL(DECLARE)
/* clang-format on */

#define ENTRY(name) &fiber_##name,
const fiber_material *const fiber_materials[] = {ALL(ENTRY)};
const uint32_t fiber_material_count = sizeof fiber_materials / sizeof fiber_materials[0];

const fiber_material *fiber_material_find(const char *id) {
  for (uint32_t i = 0; id && i < fiber_material_count; i++) {
    if (strcmp(fiber_materials[i]->id, id) == 0) return fiber_materials[i];
  }
  return NULL;
}
