/* SPDX-License-Identifier: Apache-2.0
 *
 * A layer of tubes along the fibre, as tubes.h looks them up: what creation
 * works out.
 */
#ifndef SOZAI_WOOD_TUBE_LAYER_H
#define SOZAI_WOOD_TUBE_LAYER_H

typedef struct {
  float cell, inverse_cell; /* mm; 1/mm: side of a cell of the section, with at most one tube */
  float share;              /* of cells that have one; 0: there are none */
  float radius;             /* mm, of the largest */
  float least;              /* size of the smallest, of the largest */
  float inverse_length;     /* 1/mm */
  float reach;              /* mm: the longest footprint that one look-up answers */
  float mean, slope2;       /* expected depth, and mean square of its gradient over the section */
} wood_tubes;

/* Tubes of radius mm and length mm whose sizes are least to 1 of that, of
 * which a line across meets so many to a mm. */
void tubes_met(wood_tubes *m, double radius, double length, double least, double count);

/* The same by their mean depth over the section. Where there is no room for as
 * many there are fewer. */
void tubes_filling(wood_tubes *m, double radius, double length, double least, double mean);

#endif
