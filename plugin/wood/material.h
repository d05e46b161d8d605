/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_WOOD_MATERIAL_H
#define SOZAI_WOOD_MATERIAL_H

#include "../material.h"

extern const material wood_material;
extern const sozai_wood_1 wood_table;

#endif
