/* SPDX-License-Identifier: Apache-2.0
 *
 * What an entry is written in, and the books that several cite.
 *
 * Angles: crimp of wavelength P and height R is a helix of bend k = R / (R^2 +
 * (P / 2 pi)^2) and twist t = (P / 2 pi) / (R^2 + (P / 2 pi)^2), radians per mm;
 * times the segment's length, which is length / (vertices - 1), they are the
 * middles of theta and phi. Their ranges make it irregular: so much that waves are lost after some,
 * and not within one. R is no more than P / 8, a slope of 1, which is as steep as the texture's
 * waves get: nearly as curved as any helix of that P. fiber.catalogue measures what grows.
 */
#ifndef SOZAI_FIBER_MATERIALS_ENTRY_H
#define SOZAI_FIBER_MATERIALS_ENTRY_H

#include "../catalogue.h"

#define MORTON_HEARLE "Morton & Hearle 2008, Physical Properties of Textile Fibres"
#define COOK "Cook 1984, Handbook of Textile Fibres"
#define KOZLOWSKI "Kozlowski 2012, Handbook of Natural Fibres, vol. 1"
#define SIMPSON "Simpson & Crawshaw 2002, Wool: Science and Technology"

#define MATERIAL(name) const fiber_material fiber_##name

#endif
