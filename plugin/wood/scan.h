/* SPDX-License-Identifier: Apache-2.0
 *
 * What can be read off a picture of an end grain: where its wood ends, and
 * where its pith is. Coordinates are cells of a grid, x to the right and z down,
 * cell (i, j) centred at (i + 1/2, j + 1/2).
 */
#ifndef SOZAI_WOOD_SCAN_H
#define SOZAI_WOOD_SCAN_H

#include <stdint.h>

typedef struct {
  int nx, nz;
  const float *rgb; /* nx * nz of r g b, scene-linear, 0 to 1 */
  uint8_t *wood;    /* nx * nz: 1 inside the wood; filled by scan_wood */
  /* room to work in */
  float *grey;    /* nx * nz + 2 (nx + nz): a grid of one line counts its frame twice */
  float *tensor;  /* 3 * nx * nz */
  int32_t *stack; /* as grey */
  float *votes;   /* scan_votes(nx, nz) */
} scan;

/* How many votes there is to be room for. */
int scan_votes(int nx, int nz);

/* The wood is what differs from the colour of the picture's border: the
 * largest piece, its holes filled. 0: there is no such thing, the border being
 * of many colours or the wood reaching it; then all is taken for wood. */
int scan_wood(scan *s);

/* The point that the normals of the rings run through: 0 where too little of the
 * picture is striped. inside: it is within the wood. */
int scan_pith(scan *s, int inside, double out[2]);

/* Distance from a point to the wood's edge in each of count directions, the
 * first along x and on towards z. 0: the point is not within the wood. */
int scan_rim(const scan *s, const double pith[2], int count, float *out);

#endif
