/* SPDX-License-Identifier: Apache-2.0 */
#include "material.h"
#include "fiber/texture/material.h"
#include "stone/material.h"
#include "wood/material.h"

const material *const registry[] = {
    &wood_material,
    &stone_material,
    &fibertex_material,
};
const uint32_t registry_count = sizeof registry / sizeof registry[0];
