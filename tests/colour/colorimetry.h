/* SPDX-License-Identifier: Apache-2.0
 *
 * Matrices between RGB spaces from their chromaticities, in closed form.
 */
#ifndef SOZAI_TEST_COLOUR_COLORIMETRY_H
#define SOZAI_TEST_COLOUR_COLORIMETRY_H

typedef struct matrix {
  double m[3][3];
} matrix;

typedef struct primaries {
  double red[2], green[2], blue[2], white[2]; /* CIE 1931 x, y */
} primaries;

extern const primaries rec709, rec2020, p3_d65, aces_ap0, aces_ap1;

matrix product(matrix a, matrix b);
matrix inverse(matrix a);
void transform(matrix a, const double in[3], double out[3]);

/* Linear light to CIE XYZ, white at Y = 1. */
matrix rgb_to_xyz(primaries p);
/* From linear light in one space to another, adapted from white to white by Bradford. */
matrix rgb_to_rgb(primaries from, primaries to);

#endif
