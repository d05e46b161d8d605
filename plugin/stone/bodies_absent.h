/* SPDX-License-Identifier: Apache-2.0
 *
 * Where bodies are few, mostly none is near: the cells about all lanes are made once, one to a
 * lane, and where none of them is a body whose ball reaches any lane's look nothing has to be
 * searched for. The lanes then have to the bit what they would have found: nothing.
 */
#ifndef SOZAI_STONE_BODIES_ABSENT_H
#define SOZAI_STONE_BODIES_ABSENT_H

#define ABSENT_MOST 96     /* cells that are worth it */
#define ABSENT_ROUND 2e-3f /* cells: more than rounding does, and than a hole's reach */

/* The cells whose centres may be within `reach` of a box along an axis: where they begin, over a
 * cell that `own` is, and how many. low, high: the box, over that cell. */
typedef struct {
  vi own;
  vf low, high;
  int first, count;
} absent_axis;

INLINE absent_axis absent_about(vf low, vf high, float reach) {
  const float in = 0.5f - 0.5f * CELLS_JITTER; /* from a cell's side to its centre, at least */
  absent_axis a;
  vf base = vfloor(low, &a.own);
  vi from, to;
  a.low = low - base;
  a.high = high - base;
  (void)vfloor(a.low - splat(reach - in), &from);
  (void)vfloor(a.high + splat(reach - in), &to);
  a.first = from[0];
  a.count = to[0] - from[0] + 1;
  return a;
}

/* low, high: the box that the looks' middles are in. wide: cells, at least the looks' sides. */
STAGE int bodies_absent(const stone_cells *c, const vf low[3], const vf high[3], float wide) {
  const float beyond = wide + 0.5f * c->blur + ABSENT_ROUND;
  absent_axis a[3];
  for (int k = 0; k < 3; k++) {
    a[k] = absent_about(low[k], high[k], c->radius + beyond);
    if (a[k].count > ABSENT_MOST) return 0;
  }
  int total = a[0].count * a[1].count;
  if (total > ABSENT_MOST || total * a[2].count > ABSENT_MOST) return 0;
  total *= a[2].count;
  const vf half = splat(0.5f),
           inverse[2] = {splat(1.0f / (float)a[0].count), splat(1.0f / (float)a[1].count)};
  for (int i = 0; i < total; i += LANES) {
    vi number = lane_numbers() + splati(i), row, slice, at[3];
    (void)vfloor((to_float(number) + half) * inverse[0], &row);
    (void)vfloor((to_float(row) + half) * inverse[1], &slice);
    const vi on[3] = {number - row * splati(a[0].count), row - slice * splati(a[1].count), slice};
    vf middle[3], x[3], square = splat(0.0f);
    for (int k = 0; k < 3; k++) {
      vi step = on[k] + splati(a[k].first);
      at[k] = a[k].own + step;
      middle[k] = to_float(step) + half;
    }
    vu h = cells_hash(cells_order(c), (vu)at[0] * splatu(HASH_X) + (vu)at[1] * splatu(HASH_Y) +
                                          (vu)at[2] * splatu(HASH_Z) + splatu(c->seed));
    cells_centre(c, h, middle[0], middle[1], middle[2], x);
    for (int k = 0; k < 3; k++) {
      vf out = vmax(vmax(a[k].low - x[k], x[k] - a[k].high), splat(0.0f));
      square = square + out * out;
    }
    vf reach = cells_radius(c, h) + splat(beyond);
    vm near = and_(lt(square, reach * reach), lti(number, splati(total)));
    if (!any(near)) continue;
    cells_first(c, at);
    if (any(and_(near, cells_has_body(c, at)))) return 0;
  }
  return 1;
}

#endif
