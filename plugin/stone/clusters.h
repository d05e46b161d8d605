/* SPDX-License-Identifier: Apache-2.0
 *
 * Where minerals cluster, what a footprint of many cells has of them.
 *
 * Within a block of cells ranks are spread evenly (cells.h), so that a wide footprint varies by
 * little else than by which of its blocks are rich: those are asked, and no cell.
 */
#ifndef SOZAI_STONE_CLUSTERS_H
#define SOZAI_STONE_CLUSTERS_H

#include "cells.h"

#define CLUSTERS_ASKED 8    /* places along a side: a block is four cells wide */
#define CLUSTERS_TOLD 15.0f /* cells: in wider footprints places would be too few, */
#define CLUSTERS_GONE 24.0f /* and from here on the mean is 1 */

/* How rich in its kinds a layer is over a footprint. p: mm, bed space; all: the footprint, cells;
 * most: its longer side; asks: whose lanes; 1 in the others. */
STAGE vf clusters_rich(const stone_cells *c, const vf p[3], const cells_square *all, vf most,
                       vm asks) {
  const vf zero = splat(0.0f), one = splat(1.0f);
  vf q[3], u[3], v[3], sum = zero;
  vf told = one - smooth_step(splat(CLUSTERS_TOLD), splat(CLUSTERS_GONE), most);
  asks = and_(asks, gt(told, zero));
  if (!any(asks)) return one;
  cells_turn(c, p, q);
  const vf step = splat(1.0f / CLUSTERS_ASKED), corner = splat(0.5f / CLUSTERS_ASKED - 0.5f);
  for (int k = 0; k < 3; k++) {
    u[k] = sel(asks, step * all->u[k], zero);
    v[k] = sel(asks, step * all->v[k], zero);
    q[k] = q[k] + sel(asks, corner * (all->u[k] + all->v[k]), zero);
  }
  for (int j = 0; j < CLUSTERS_ASKED; j++) {
    for (int i = 0; i < CLUSTERS_ASKED; i++) {
      vi at[3];
      for (int k = 0; k < 3; k++)
        (void)vfloor(q[k] + splat((float)i) * u[k] + splat((float)j) * v[k], &at[k]);
      sum = sum + cells_rich(c, at, cells_block(c, at[0], at[1], at[2]));
    }
  }
  const float each = c->cluster / (CLUSTERS_ASKED * CLUSTERS_ASKED);
  vf rich = splat(1.0f - c->cluster) + splat(each) * sum;
  return sel(asks, mix(one, rich, told), one);
}

#endif
