/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_STONE_MATERIAL_H
#define SOZAI_STONE_MATERIAL_H

#include "../material.h"

extern const material stone_material;

#endif
