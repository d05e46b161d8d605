/* SPDX-License-Identifier: Apache-2.0
 *
 * The nearest cells of lanes that lie close together, of one look or of some: what cells.h
 * finds of each of them alone, to the bit. The cells that may be nearest to any are made
 * once, one to a lane, and those that a bound leaves are tried on all lanes.
 */
#ifndef SOZAI_STONE_CELLS_SHARED_H
#define SOZAI_STONE_CELLS_SHARED_H

#define CELLS_SHARED 64   /* 4 along each axis */
#define CELLS_NONE 1e15f  /* cells to one that is not among the lane's 27 */
#define CELLS_ROUND 1e-4f /* more than rounding and a number's bits do to a distance */

#define CELLS_GROUP 4      /* looks that one list may serve */
#define CELLS_GROUPED 1.6f /* cells: the sides of a box about their lanes, together, at most */

/* The lanes' places, of one look or of some: their lattice cells are `base` or the next along each
 * axis. To the middle of a box about them all, from the side that the two cells share; and its
 * sides. Lengths in cells. */
typedef struct {
  vi base[3];
  int upper[3]; /* some lane is in the next */
  vf middle[3], reach[3];
} cells_span;

/* The cells that may be nearest, 4 along each axis, of which the inner two are the lanes' own. */
typedef struct {
  float jitter[3][CELLS_SHARED] __attribute__((aligned(64)));
  float weight[CELLS_SHARED] __attribute__((aligned(64)));
  int32_t number[CELLS_SHARED] __attribute__((aligned(64)));
  vf least[4]; /* what each is at least away from any lane; and in every vector's lane */
  vf bound[3]; /* the least of what those that all lanes have are at most, rising */
  int layers;  /* of four by four, three or all; and of each those that are some lane's */
  uint32_t may;
} cells_list;

/* From a look's lanes to the middles of the four cells along each axis. */
typedef struct {
  vf from[3][4];
} cells_reached;

/* Own is the upper of the inner two or the lower. */
INLINE void cells_reach_about(const cells_span *span, const cells_own *own, cells_reached *r) {
  vf none = splat(CELLS_NONE);
  for (int i = 0; i < 3; i++) {
    vf o = own->from[i], below = o - splat(1.0f), above = o + splat(1.0f), *from = r->from[i];
    vm upper = lti(span->base[i], own->whole[i]);
    from[0] = sel(upper, none, below);
    from[1] = sel(upper, below, o);
    from[2] = sel(upper, o, above);
    from[3] = sel(upper, above, none);
  }
}

/* Of `count` looks' lanes. 0: they are too far apart, or several looks' for one list. */
INLINE int cells_span_make(int count, const cells_own *own, cells_span *span) {
  vf half = splat(0.5f), one = splat(1.0f), zero = splat(0.0f), sides = zero;
  vm upper[3][CELLS_GROUP];
  for (int i = 0; i < 3; i++) {
    vi at[CELLS_GROUP];
    for (int l = 0; l < count; l++) at[l] = own[l].whole[i];
    if (!one_apart(at, count, &span->base[i], upper[i])) return 0;
  }
  for (int i = 0; i < 3; i++) {
    vf low = zero, high = zero;
    span->upper[i] = 0;
    for (int l = 0; l < count; l++) {
      vf in = half - own[l].from[i] + sel(upper[i][l], one, zero);
      low = l ? vmin(low, in) : in;
      high = l ? vmax(high, in) : in;
      span->upper[i] |= upper[i][l];
    }
    range_across(low, high, &low, &high);
    span->middle[i] = half * (low + high);
    span->reach[i] = high - low; /* twice half of it */
    sides = sides + span->reach[i];
  }
  return count == 1 || !any(gt(sides, splat(CELLS_GROUPED)));
}

INLINE void cells_list_make(const stone_cells *c, int graded, int most, const cells_span *span,
                            cells_list *list) {
  static const uint32_t prime[3] = {HASH_X, HASH_Y, HASH_Z};
  const float k = c->jitter;
  const vi *base = span->base;
  const int *upper = span->upper;
  vi own = lane_numbers(), x = own & splati(3), y = own >> 2;
  vf half = splat(0.5f);
  vi from[3] = {base[0] + x - splati(1), base[1] + y - splati(1), base[2] - splati(1)};
  vu hash = splatu(c->seed);
  for (int i = 0; i < 3; i++) hash = hash + (vu)from[i] * splatu(prime[i]);
  vi number = cells_number(from[0], 0) | cells_number(from[1], 1);
  vf at[3] = {to_float(x) - half - span->middle[0], to_float(y) - half - span->middle[1],
              splat(-0.5f) - span->middle[2]};
  /* where no lane is in the upper cell the fourth is nobody's; and what all lanes have
   * among their 27 are three, or the inner two */
  uint32_t may = (upper[0] ? 0xffffu : 0x7777u) & (upper[1] ? 0xffffu : 0x0fffu);
  uint32_t all = (upper[0] ? 0x6666u : 0x7777u) & (upper[1] ? 0x0ff0u : 0x0fffu);
  const vf far = splat(1e30f);
  vf *least = list->least, bound[3] = {far, far, far};
  const int layers = upper[2] ? 4 : 3;
  UNROLL(4)
  for (int v = 0; v < 4; v++) {
    if (v == layers) break;
    vu h = cells_hash(graded, hash + splatu((uint32_t)v * HASH_Z));
    vf f = splat(1e-6f), b = splat(0.0f);
    if (graded) f = cells_weight(c, h);
    store(list->weight + 16 * v, f);
    for (int i = 0; i < 3; i++) {
      vf j = to_float((vi)(h << (uint32_t)(10 * i))) * splat(k);
      store(list->jitter[i] + 16 * v, j);
      vf d = at[i] + j;
      if (i == 2) d = d + splat((float)v);
      f = f + d * d;
      b = b + span->reach[i] * vabs(d);
    }
    vi n = number | cells_number(from[2] + splati(v), 2);
    memcpy(list->number + 16 * v, &n, sizeof n);
    least[v] = f - b;
    uint32_t common = v == 0 ? (upper[2] ? 0 : all) : v == 3 ? 0 : all;
    vf high = sel((vm)common, f + b, far);
    cells_least(high, most, bound);
  }
  memcpy(list->bound, bound, sizeof bound);
  list->layers = layers;
  list->may = may;
}

/* Those that are left, a bit to each. */
INLINE uint64_t cells_list_left(const cells_list *list, int most) {
  const vf *bound = list->bound;
  vf limit = (most > 2 ? third_of(bound) : second_of(bound)) + splat(CELLS_ROUND);
  uint64_t left = 0;
  /* no more than four: sanitized, GCC would look past them */
  for (int v = 0; v < 4 && v < list->layers; v++) {
    uint64_t in = lanes_of(le(list->least[v], limit)) & list->may;
    left |= in << (16 * v);
  }
  return left;
}

/* The least `most` of those that are left, of `count` looks. */
INLINE void cells_list_try(const cells_list *list, uint64_t left, int most, int count,
                           const cells_reached *reached, vf (*key)[3]) {
  for (; left; left &= left - 1) {
    int n = __builtin_ctzll(left), x = n & 3, y = n >> 2 & 3, z = n >> 4;
    vf j[3], weight = splat(list->weight[n]);
    vi number = splati(list->number[n]);
    for (int i = 0; i < 3; i++) j[i] = splat(list->jitter[i][n]);
    UNROLL(4)
    for (int l = 0; l < count; l++) {
      const cells_reached *r = &reached[l];
      const vf at[3] = {j[0] + r->from[0][x], j[1] + r->from[1][y], j[2] + r->from[2][z]};
      cells_keep(dot3(at, at) + weight, number, most, key[l]);
    }
  }
}

/* Whether the lanes are near enough to each other, and then what cells_nearest says. */
INLINE int cells_nearest_shared(const stone_cells *c, int graded, int most, const cells_own *own,
                                vf key[3]) {
  cells_span span;
  cells_reached reached;
  cells_list list;
  if (!cells_span_make(1, own, &span)) return 0;
  cells_reach_about(&span, own, &reached);
  cells_list_make(c, graded, most, &span, &list);
  uint64_t left = cells_list_left(&list, most);
  if (!left) return 0;
  cells_list_try(&list, left, most, 1, &reached, (vf(*)[3])key);
  return 1;
}

#endif
