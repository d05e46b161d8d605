/* SPDX-License-Identifier: Apache-2.0 */
#include "colorimetry.h"

#define D65                                                                                        \
  { 0.3127, 0.3290 }
#define ACES_WHITE                                                                                 \
  { 0.32168, 0.33767 }

const primaries rec709 = {{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, D65};
const primaries rec2020 = {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, D65};
const primaries p3_d65 = {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, D65};
const primaries aces_ap0 = {{0.7347, 0.2653}, {0, 1}, {0.0001, -0.077}, ACES_WHITE};
const primaries aces_ap1 = {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, ACES_WHITE};

static const matrix bradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

matrix product(matrix a, matrix b) {
  matrix c;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      c.m[i][j] = a.m[i][0] * b.m[0][j] + a.m[i][1] * b.m[1][j] + a.m[i][2] * b.m[2][j];
  return c;
}

matrix inverse(matrix a) {
  matrix c;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      int p = (j + 1) % 3, q = (j + 2) % 3, r = (i + 1) % 3, s = (i + 2) % 3;
      c.m[i][j] = a.m[p][r] * a.m[q][s] - a.m[p][s] * a.m[q][r];
    }
  double determinant = a.m[0][0] * c.m[0][0] + a.m[0][1] * c.m[1][0] + a.m[0][2] * c.m[2][0];
  for (int i = 0; i < 9; i++) c.m[i / 3][i % 3] /= determinant;
  return c;
}

void transform(matrix a, const double in[3], double out[3]) {
  for (int i = 0; i < 3; i++) out[i] = a.m[i][0] * in[0] + a.m[i][1] * in[1] + a.m[i][2] * in[2];
}

static void xyz_of(const double xy[2], double xyz[3]) {
  xyz[0] = xy[0] / xy[1];
  xyz[1] = 1;
  xyz[2] = (1 - xy[0] - xy[1]) / xy[1];
}

static matrix diagonal(const double d[3]) {
  return (matrix){{{d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]}}};
}

matrix rgb_to_xyz(primaries p) {
  const double *const corners[3] = {p.red, p.green, p.blue};
  matrix columns;
  for (int j = 0; j < 3; j++) {
    columns.m[0][j] = corners[j][0];
    columns.m[1][j] = corners[j][1];
    columns.m[2][j] = 1 - corners[j][0] - corners[j][1];
  }
  double white[3], amounts[3];
  xyz_of(p.white, white);
  transform(inverse(columns), white, amounts);
  return product(columns, diagonal(amounts));
}

static matrix adapt(const double from[2], const double to[2]) {
  double xyz[3], cones_from[3], cones_to[3], gain[3];
  xyz_of(from, xyz);
  transform(bradford, xyz, cones_from);
  xyz_of(to, xyz);
  transform(bradford, xyz, cones_to);
  for (int i = 0; i < 3; i++) gain[i] = cones_to[i] / cones_from[i];
  return product(inverse(bradford), product(diagonal(gain), bradford));
}

matrix rgb_to_rgb(primaries from, primaries to) {
  return product(inverse(rgb_to_xyz(to)), product(adapt(from.white, to.white), rgb_to_xyz(from)));
}
