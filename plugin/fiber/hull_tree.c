/* SPDX-License-Identifier: Apache-2.0
 *
 * The tree over a hull's triangles: sorted along Hilbert's curve, in fours, in
 * eights. Built in time linear in the triangles, and nothing in it depends on
 * who builds it.
 */
#include "hull.h"

#include <string.h>

#include "../core/scalar.h"
#include "../core/status.h"

#define FAR 3e38f

/* Place along Hilbert's curve of ten bits an axis, after Skilling 2004: unlike
 * Morton's it never jumps, so that leaves are small. */
static uint32_t hilbert(uint32_t x[3]) {
  for (uint32_t q = 512; q > 1; q >>= 1) {
    for (int a = 0; a < 3; a++) {
      uint32_t low = q - 1, swap = (x[0] ^ x[a]) & low;
      if (x[a] & q) {
        x[0] ^= low;
      } else {
        x[0] ^= swap;
        x[a] ^= swap;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  uint32_t turn = 0, code = 0;
  for (uint32_t q = 512; q > 1; q >>= 1)
    if (x[2] & q) turn ^= q - 1;
  for (int a = 0; a < 3; a++) x[a] ^= turn;
  for (int b = 9; b >= 0; b--)
    for (int a = 0; a < 3; a++) code = code << 1 | (x[a] >> b & 1);
  return code;
}

static uint64_t key_of(const hull *h, const float n[9], int corners, uint32_t i) {
  uint32_t at[3];
  for (int a = 0; a < 3; a++) {
    float sum = 0;
    for (int c = 0; c < corners; c++) sum += n[3 * c + a];
    float t = (sum / (float)corners - h->low[a]) / h->side * 1023.0f;
    at[a] = (uint32_t)(t < 0 ? 0 : t > 1023 ? 1023 : t);
  }
  return (uint64_t)hilbert(at) << 32 | i;
}

/* By the upper half, in three passes of ten bits; the order of equals stays. */
static void sort_keys(uint64_t *keys, uint64_t *spare, uint32_t count) {
  for (int pass = 0; pass < 3; pass++) {
    uint32_t first[1024] = {0}, sum = 0;
    int shift = 32 + 10 * pass;
    for (uint32_t i = 0; i < count; i++) first[keys[i] >> shift & 1023]++;
    for (int b = 0; b < 1024; b++) {
      uint32_t n = first[b];
      first[b] = sum;
      sum += n;
    }
    for (uint32_t i = 0; i < count; i++) spare[first[keys[i] >> shift & 1023]++] = keys[i];
    memcpy(keys, spare, count * sizeof *keys);
  }
}

/* The frame of a patch of leaves: its mean normal first. */
static void patch_frame(const hull *h, uint32_t first, uint32_t last, double axis[3][3]) {
  double n[3] = {0, 0, 0};
  for (uint32_t i = first; i < last && h->rule != HULL_VERTICES; i++) {
    const hull_leaf *l = &h->leaves[i];
    for (uint32_t k = 0; k < HULL_LEAF; k++) {
      double e[2][3], m[3];
      for (int c = 0; c < 2; c++)
        for (int a = 0; a < 3; a++)
          e[c][a] = (double)l->corner[c + 1][a][k] - (double)l->corner[0][a][k];
      for (int a = 0; a < 3; a++)
        m[a] = e[0][(a + 1) % 3] * e[1][(a + 2) % 3] - e[0][(a + 2) % 3] * e[1][(a + 1) % 3];
      /* patches of a soup, turned either way, do not cancel */
      double way = m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0 ? -1 : 1;
      for (int a = 0; a < 3; a++) n[a] += way * m[a];
    }
  }
  double l = scalar_root(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int a = 0; a < 3; a++) axis[0][a] = l > 0 ? n[a] / l : a == 0;
  int least = axis[0][0] * axis[0][0] < axis[0][1] * axis[0][1] ? 0 : 1;
  if (axis[0][2] * axis[0][2] < axis[0][least] * axis[0][least]) least = 2;
  for (int a = 0; a < 3; a++) axis[1][a] = (a == least) - axis[0][least] * axis[0][a];
  l = scalar_root(axis[1][0] * axis[1][0] + axis[1][1] * axis[1][1] + axis[1][2] * axis[1][2]);
  for (int a = 0; a < 3; a++) axis[1][a] /= l;
  for (int a = 0; a < 3; a++)
    axis[2][a] =
        axis[0][(a + 1) % 3] * axis[1][(a + 2) % 3] - axis[0][(a + 2) % 3] * axis[1][(a + 1) % 3];
}

/* Both boxes of a patch, child k of a node; the turned one with room for
 * rounding. */
static void put_patch(const hull *h, hull_node *n, uint32_t k, uint32_t first, uint32_t last) {
  double axis[3][3];
  float frame[3][3], low[3] = {FAR, FAR, FAR}, high[3] = {-FAR, -FAR, -FAR}, from[3], to[3];
  patch_frame(h, first, last, axis);
  for (int r = 0; r < 3; r++) {
    for (int a = 0; a < 3; a++) frame[r][a] = (float)axis[r][a];
    from[r] = FAR, to[r] = -FAR;
  }
  int corners = h->rule == HULL_VERTICES ? 1 : 3;
  for (uint32_t i = first; i < last; i++) {
    for (int c = 0; c < corners; c++) {
      const f4 *p = h->leaves[i].corner[c];
      for (uint32_t q = 0; q < HULL_LEAF; q++) {
        for (int a = 0; a < 3; a++) {
          float u = frame[a][0] * p[0][q] + frame[a][1] * p[1][q] + frame[a][2] * p[2][q];
          low[a] = p[a][q] < low[a] ? p[a][q] : low[a];
          high[a] = p[a][q] > high[a] ? p[a][q] : high[a];
          from[a] = u < from[a] ? u : from[a];
          to[a] = u > to[a] ? u : to[a];
        }
      }
    }
  }
  float room = 1e-6f * h->side;
  for (int r = 0; r < 3; r++) {
    n->low[r][k] = low[r], n->high[r][k] = high[r];
    n->from[r][k] = from[r] - room, n->to[r][k] = to[r] + room;
    for (int a = 0; a < 3; a++) n->axis[r][a][k] = frame[r][a];
  }
}

static void put_nothing(hull_node *n, uint32_t k) {
  for (int r = 0; r < 3; r++) {
    n->low[r][k] = n->from[r][k] = 1e18f;
    n->high[r][k] = n->to[r][k] = -1e18f;
    for (int a = 0; a < 3; a++) n->axis[r][a][k] = r == a;
  }
}

static void set_levels(hull *h) {
  uint32_t below = h->leaf_count, at = 0;
  h->levels = 0;
  do {
    uint32_t n = (below + HULL_WIDE - 1) / HULL_WIDE;
    h->level_first[h->levels] = at;
    h->level_count[h->levels++] = n;
    at += n;
    below = n;
  } while (below > 1);
  h->node_count = at;
}

static void fill_nodes(hull *h) {
  uint64_t leaves = 1; /* of a child */
  for (int level = 0; level < h->levels; level++, leaves *= HULL_WIDE) {
    uint32_t below = level ? h->level_count[level - 1] : h->leaf_count;
    for (uint32_t i = 0; i < h->level_count[level] * HULL_WIDE; i++) {
      hull_node *n = &h->nodes[h->level_first[level] + i / HULL_WIDE];
      uint64_t first = i * leaves, last = first + leaves;
      if (i < below)
        put_patch(h, n, i % HULL_WIDE, (uint32_t)first,
                  last < h->leaf_count ? (uint32_t)last : h->leaf_count);
      else
        put_nothing(n, i % HULL_WIDE);
    }
  }
}

int32_t hull_tree(hull *h, const sozai_host *host,
                  void (*item)(const void *context, uint32_t i, float out[9]),
                  const void *context) {
  uint32_t n = h->items;
  size_t key_bytes = (size_t)n * sizeof(uint64_t);
  uint64_t *keys = host_alloc(host, key_bytes, 64), *spare = host_alloc(host, key_bytes, 64);
  h->leaf_count = (n + HULL_LEAF - 1) / HULL_LEAF;
  set_levels(h);
  h->leaves = host_alloc(host, h->leaf_count * sizeof *h->leaves, 64);
  h->nodes = host_alloc(host, h->node_count * sizeof *h->nodes, 64);
  int32_t r = keys && spare && h->leaves && h->nodes ? SOZAI_OK : SOZAI_ERROR_MEMORY;
  int corners = h->rule == HULL_VERTICES ? 1 : 3;
  float at[9];
  for (uint32_t i = 0; !r && i < n; i++) {
    item(context, i, at);
    keys[i] = key_of(h, at, corners, i);
  }
  if (!r) {
    sort_keys(keys, spare, n);
    for (uint32_t i = 0; i < h->leaf_count * HULL_LEAF; i++) {
      item(context, (uint32_t)keys[i < n ? i : n - 1], at);
      for (int c = 0; c < 9; c++)
        h->leaves[i / HULL_LEAF].corner[c / 3][c % 3][i % HULL_LEAF] = at[c];
    }
    fill_nodes(h);
  }
  host_free(host, keys, key_bytes, 64);
  host_free(host, spare, key_bytes, 64);
  return r;
}

void hull_free(hull *h, const sozai_host *host) {
  host_free(host, h->leaves, h->leaf_count * sizeof *h->leaves, 64);
  host_free(host, h->nodes, h->node_count * sizeof *h->nodes, 64);
  h->leaves = NULL, h->nodes = NULL;
}

uint64_t hull_bytes(const hull *h) {
  return (h->leaves ? h->leaf_count * sizeof *h->leaves : 0) +
         (h->nodes ? h->node_count * sizeof *h->nodes : 0);
}

/* ---- the nearest ------------------------------------------------------- */

static f4 dot4(const f4 a[3], const f4 b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static f4 pick(i4 m, f4 a, f4 b) { return (f4)(((i4)a & m) | ((i4)b & ~m)); }
static f4 least(f4 a, f4 b) { return pick(a < b, a, b); }
static f4 most(f4 a, f4 b) { return pick(a > b, a, b); }

/* Squared distance to the segment from the corner that p is measured from,
 * along e. */
static f4 to_segment(const f4 p[3], const f4 e[3]) {
  const f4 zero = {0, 0, 0, 0}, one = {1, 1, 1, 1}, tiny = {1e-30f, 1e-30f, 1e-30f, 1e-30f};
  f4 square = dot4(e, e), t = dot4(p, e) / pick(square > tiny, square, tiny);
  t = pick(t > zero, t, zero);
  t = pick(t < one, t, one);
  f4 o[3];
  for (int a = 0; a < 3; a++) o[a] = p[a] - t * e[a];
  return dot4(o, o);
}

/* Squared distances to a leaf's four triangles: to the plane where the foot
 * lies in the triangle, else to the nearest edge. Of no area: the edges. */
static f4 to_triangles(const hull_leaf *l, const float q[3]) {
  const f4 zero = {0, 0, 0, 0};
  f4 e[3][3], p[3][3], n[3], best = zero, height = zero, area = zero;
  i4 within = {-1, -1, -1, -1};
  for (int c = 0; c < 3; c++) {
    for (int a = 0; a < 3; a++) {
      f4 at = {q[a], q[a], q[a], q[a]};
      e[c][a] = l->corner[(c + 1) % 3][a] - l->corner[c][a];
      p[c][a] = at - l->corner[c][a];
    }
  }
  for (int a = 0; a < 3; a++)
    n[a] = e[0][(a + 1) % 3] * e[1][(a + 2) % 3] - e[0][(a + 2) % 3] * e[1][(a + 1) % 3];
  area = dot4(n, n);
  height = dot4(n, p[0]);
  for (int c = 0; c < 3; c++) {
    f4 d = to_segment(p[c], e[c]);
    best = c ? least(d, best) : d;
    f4 side[3];
    for (int a = 0; a < 3; a++)
      side[a] = n[(a + 1) % 3] * e[c][(a + 2) % 3] - n[(a + 2) % 3] * e[c][(a + 1) % 3];
    within &= dot4(side, p[c]) >= zero;
  }
  within &= area > zero;
  f4 one = {1, 1, 1, 1};
  f4 plane = height * height / pick(within, area, one);
  return pick(within, least(plane, best), best);
}

static f4 to_vertices(const hull_leaf *l, const float q[3]) {
  f4 d[3];
  for (int a = 0; a < 3; a++) {
    f4 at = {q[a], q[a], q[a], q[a]};
    d[a] = at - l->corner[0][a];
  }
  return dot4(d, d);
}

typedef struct {
  float d;
  uint32_t at; /* level << 28 | node */
} visit;

static f4 four_of(const float *p) {
  f4 r;
  memcpy(&r, p, sizeof r);
  return r;
}

/* Squared distances to the turned boxes of eight children. */
static void to_boxes(const hull_node *n, const float q[3], f4 out[2]) {
  const f4 zero = {0, 0, 0, 0};
  f4 at[3];
  for (int a = 0; a < 3; a++) at[a] = (f4){q[a], q[a], q[a], q[a]};
  for (int half = 0; half < 8; half += 4) {
    f4 sum = zero;
    for (int r = 0; r < 3; r++) {
      f4 u = at[0] * four_of(n->axis[r][0] + half) + at[1] * four_of(n->axis[r][1] + half) +
             at[2] * four_of(n->axis[r][2] + half);
      f4 d = most(most(four_of(n->from[r] + half) - u, u - four_of(n->to[r] + half)), zero);
      sum += d * d;
    }
    out[half / 4] = sum;
  }
}

static float nearest(const hull *h, const float q[3], float best, uint32_t *which) {
  visit stack[HULL_LEVELS * HULL_WIDE];
  int top = 0;
  stack[top++] = (visit){0, (uint32_t)h->levels << 28};
  int points = h->rule == HULL_VERTICES;
  while (top) {
    visit v = stack[--top];
    if (v.d >= best) continue;
    uint32_t level = v.at >> 28, node = v.at & 0x0fffffffu;
    if (level == 0) {
      f4 d = points ? to_vertices(&h->leaves[node], q) : to_triangles(&h->leaves[node], q);
      for (uint32_t k = 0; k < HULL_LEAF; k++) {
        if (d[k] < best) {
          best = d[k];
          *which = node * HULL_LEAF + k;
        }
      }
      continue;
    }
    f4 all[2];
    to_boxes(&h->nodes[h->level_first[level - 1] + node], q, all);
    int from = top;
    for (uint32_t k = 0; k < HULL_WIDE; k++) {
      float d = all[k / 4][k % 4];
      if (d >= best) continue;
      int i = top++;
      for (; i > from && stack[i - 1].d < d; i--) stack[i] = stack[i - 1];
      stack[i] = (visit){d, (level - 1) << 28 | (node * HULL_WIDE + k)};
    }
  }
  return best;
}

static float root(float x) { return __builtin_sqrtf(x); }

float hull_distance(const hull *h, const float p[3], float bound) {
  uint32_t which = 0;
  float best = bound < 1e18f ? bound * bound * 1.000002f : FAR;
  float d = root(nearest(h, p, best, &which));
  return d < bound ? d : bound;
}

float hull_distance_near(const hull *h, const float p[3], uint32_t *hint) {
  f4 d = to_triangles(&h->leaves[*hint / HULL_LEAF], p);
  float best = FAR;
  for (uint32_t k = 0; k < HULL_LEAF; k++) best = d[k] < best ? d[k] : best;
  return root(nearest(h, p, best, hint));
}

float hull_literal(const hull *h, const float p[3]) {
  uint32_t which = 0;
  float d = root(nearest(h, p, FAR, &which));
  const hull_leaf *l = &h->leaves[which / HULL_LEAF];
  uint32_t k = which % HULL_LEAF;
  float side = 0;
  for (int a = 0; a < 3; a++) side += (p[a] - l->corner[0][a][k]) * l->corner[1][a][k];
  return side < 0 ? d : -d;
}

/* ---- inside ------------------------------------------------------------ */

/* On which side of the edge from s to t the point q lies, as seen from either
 * triangle alike: the ends in one order, and q as if moved by (e, e^2) for an e
 * too small to matter, so that it is never on the edge. */
static int edge_side(const double s[2], const double t[2], const double q[2]) {
  int swap = t[1] < s[1] || (t[1] == s[1] && t[0] < s[0]);
  const double *lo = swap ? t : s, *hi = swap ? s : t;
  double o = (hi[0] - lo[0]) * (q[1] - lo[1]) - (hi[1] - lo[1]) * (q[0] - lo[0]);
  int side = o > 0 ? 1 : o < 0 ? -1 : hi[1] > lo[1] ? -1 : 1;
  return swap ? -side : side;
}

int hull_crossing(const float corner[3][3], int axis, const float q[2], double *at) {
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  double c[3][2], p[2] = {(double)q[0], (double)q[1]};
  for (int i = 0; i < 3; i++) c[i][0] = (double)corner[i][u], c[i][1] = (double)corner[i][v];
  int s = edge_side(c[0], c[1], p);
  if (edge_side(c[1], c[2], p) != s || edge_side(c[2], c[0], p) != s) return 0;
  double w[3], sum = 0, x = 0;
  for (int i = 0; i < 3; i++) {
    const double *a = c[(i + 1) % 3], *b = c[(i + 2) % 3];
    w[i] = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    sum += w[i];
  }
  for (int i = 0; i < 3; i++) x += (sum != 0 ? w[i] / sum : 1.0 / 3) * (double)corner[i][axis];
  *at = x;
  return s;
}

typedef struct {
  int above, below;         /* crossings, with their signs */
  int odd_above, odd_below; /* without */
} crossings;

static void count_leaf(const hull *h, uint32_t leaf, int axis, const float p[3], crossings *c) {
  const hull_leaf *l = &h->leaves[leaf];
  float q[2] = {p[(axis + 1) % 3], p[(axis + 2) % 3]};
  for (uint32_t k = 0; k < HULL_LEAF; k++) {
    if (leaf * HULL_LEAF + k >= h->items) return;
    float corner[3][3];
    for (int i = 0; i < 9; i++) corner[i / 3][i % 3] = l->corner[i / 3][i % 3][k];
    double at;
    int s = hull_crossing((const float(*)[3])corner, axis, q, &at);
    if (!s) continue;
    if (at > (double)p[axis])
      c->above += s, c->odd_above ^= 1;
    else
      c->below -= s, c->odd_below ^= 1;
  }
}

/* Of the whole line along an axis, or of what is above p on it alone. */
static crossings cross(const hull *h, int axis, const float p[3], int both) {
  crossings c = {0, 0, 0, 0};
  uint32_t stack[HULL_LEVELS * HULL_WIDE];
  int top = 0, u = (axis + 1) % 3, v = (axis + 2) % 3;
  stack[top++] = (uint32_t)h->levels << 28;
  while (top) {
    uint32_t it = stack[--top], level = it >> 28, node = it & 0x0fffffffu;
    if (level == 0) {
      count_leaf(h, node, axis, p, &c);
      continue;
    }
    const hull_node *n = &h->nodes[h->level_first[level - 1] + node];
    for (uint32_t k = 0; k < HULL_WIDE; k++) {
      int met = n->low[u][k] <= p[u] && p[u] <= n->high[u][k] && n->low[v][k] <= p[v] &&
                p[v] <= n->high[v][k] && (both || n->high[axis][k] >= p[axis]);
      if (met) stack[top++] = (level - 1) << 28 | (node * HULL_WIDE + k);
    }
  }
  return c;
}

int hull_inside(const hull *h, const float p[3]) {
  for (int a = 0; a < 3; a++)
    if (!(p[a] >= h->low[a] && p[a] <= h->high[a])) return 0;
  if (h->rule != HULL_VOTE) {
    crossings c = cross(h, 0, p, 0);
    return h->rule == HULL_WINDING ? c.above != 0 : c.odd_above;
  }
  int votes = 0;
  for (int a = 0; a < 3; a++) {
    crossings c = cross(h, a, p, 1);
    votes += c.odd_above + c.odd_below;
  }
  return votes >= 4;
}
