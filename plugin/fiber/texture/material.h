/* SPDX-License-Identifier: Apache-2.0 */
#ifndef SOZAI_FIBERTEX_MATERIAL_H
#define SOZAI_FIBERTEX_MATERIAL_H

#include "../../material.h"

extern const material fibertex_material;

#endif
