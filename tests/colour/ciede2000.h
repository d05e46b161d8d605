/* SPDX-License-Identifier: Apache-2.0
 *
 * How different two colours look.
 */
#ifndef SOZAI_TEST_COLOUR_CIEDE2000_H
#define SOZAI_TEST_COLOUR_CIEDE2000_H

/* CIE XYZ under D65, its white at Y = 1, to CIE L*a*b* of the same white. */
void lab_of(const double xyz[3], double lab[3]);

/* CIE Delta E 2000 with all weights 1. */
double ciede2000(const double lab1[3], const double lab2[3]);

#endif
