/* SPDX-License-Identifier: Apache-2.0
 *
 * What stone's stages hand on.
 */
#ifndef SOZAI_STONE_BLOCK_H
#define SOZAI_STONE_BLOCK_H

#include "footprint.h"
#include "surface.h"

/* Blocks that go through each stage before the next begins: the more, the less often a stage's code
 * is fetched anew, of which all together do not stay near. */
#define STONE_BLOCKS CELLS_EYES

/* Pairs of layers, one over the other, moss over all; the number of one. */
#define STONE_COVERS (STONE_LAYERS + 1)
#define STONE_PAIRS (STONE_COVERS * (STONE_COVERS - 1) / 2)
INLINE int pair_of(int over, int under) {
  /* from the lowest */
  static const int place[STONE_COVERS] = {[LAYER_GRAINS] = 0,
                                          [LAYER_SPECKS] = 1,
                                          [LAYER_INCLUSIONS] = 2,
                                          [LAYER_HOLES] = 3,
                                          [OVER_MOSS] = 4};
  return place[over] * (place[over] - 1) / 2 + place[under];
}

/* A block of LANES points on its way through the stages. */
typedef struct {
  uint32_t i, n, o;  /* the first, how many; and how far on in the outputs */
  vf at[3], face[3]; /* object space: the point and its normal */
  vf p[3], nrm[3];   /* bed space, likewise */
  vf s;
  vf t1[3], t2[3]; /* the footprint's sides */
  int facing;      /* `face` is that of the block before */
  int alike;       /* of the blocks on their way the first whose footprints lie as these do */
  vf albedo[3], speck, hole, inclusion; /* the last three: shares of the footprint */
  int crystal_known;                    /* the colour has met it */
  vu crystal;                           /* that the point is in */
  int hidden; /* how many of the layers, from below, no lane sees anything of */
  cells_cover cover[STONE_LAYERS];
  vf third;                /* the share of the third kind of inclusions */
  int mixed[STONE_COVERS]; /* a bit to each layer below that it covers unevenly */
  union {
    struct {
      vf with[STONE_PAIRS][CELLS_PARTS]; /* where it does: its covariances with their shares */
      vf with_third[2];                  /* and with the third inclusions': of holes, of moss */
    };
    struct {
      vf light[3], view[3]; /* asked for when all those have been laid */
    };
  };
  int mossed;           /* its shares are known, */
  moss_shares moss;     /* and here; */
  vf moss_hides[3];     /* the covariance of its share with the stone's colour, */
  vf moss_hides_specks; /* and with what shows specks */
  int square;           /* the footprint is square to a normal that was given */
  laid laid;            /* where there is a paving */
  field relief;         /* mm, with its slope; */
  surface surface;
  cells_found holes, inclusions; /* that are asked how high they are */
  cells_bends bends;             /* of layers that share them, at the point */
} block;

#endif
