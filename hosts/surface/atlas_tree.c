/* SPDX-License-Identifier: Apache-2.0
 *
 * All boxes are compared in texels, to which corners and boxes are brought by
 * the same operations: these only round, so a triangle's box never comes out
 * larger than that of the node above it, and no search loses it. */
#include "atlas_tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define DEPTH 40 /* of 2^32 leaves in a balanced tree, with room */

/* ---- building ---------------------------------------------------------- */

typedef struct place {
  uint64_t key; /* along the Z curve */
  uint32_t triangle;
} place;

static uint64_t spread(uint32_t bits) {
  uint64_t x = bits;
  x = (x | x << 16) & 0x0000ffff0000ffffu;
  x = (x | x << 8) & 0x00ff00ff00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0f0f0f0f0fu;
  x = (x | x << 2) & 0x3333333333333333u;
  return (x | x << 1) & 0x5555555555555555u;
}

static const float *corner(const mesh *m, uint32_t triangle, int k) {
  return m->uvs + 2 * (size_t)m->indices[3 * (size_t)triangle + (size_t)k];
}

static void box_of(const mesh *m, uint32_t triangle, float low[2], float high[2]) {
  for (int k = 0; k < 2; k++) {
    float a = corner(m, triangle, 0)[k], b = corner(m, triangle, 1)[k],
          c = corner(m, triangle, 2)[k];
    low[k] = fminf(a, fminf(b, c));
    high[k] = fmaxf(a, fmaxf(b, c));
  }
}

static int by_key(const void *a, const void *b) {
  const place *p = a, *q = b;
  if (p->key != q->key) return p->key < q->key ? -1 : 1;
  return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

static void sort_along_curve(place *places, const mesh *m, const uint32_t *keep, uint32_t count) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (uint32_t i = 0; i < count; i++) {
    float l[2], h[2];
    box_of(m, keep[i], l, h);
    for (int k = 0; k < 2; k++) {
      low[k] = fmin(low[k], (double)l[k]);
      high[k] = fmax(high[k], (double)h[k]);
    }
  }
  double side = fmax(high[0] - low[0], high[1] - low[1]);
  for (uint32_t i = 0; i < count; i++) {
    float l[2], h[2];
    uint32_t cell[2];
    box_of(m, keep[i], l, h);
    for (int k = 0; k < 2; k++)
      cell[k] = (uint32_t)((0.5 * ((double)l[k] + (double)h[k]) - low[k]) / side * 4294967295.0);
    places[i] = (place){spread(cell[0]) | spread(cell[1]) << 1, keep[i]};
  }
  qsort(places, count, sizeof *places, by_key);
}

static void build(atlas_tree *t, const mesh *m, uint32_t node, uint32_t leaf, uint32_t leaves) {
  atlas_node *n = &t->nodes[node];
  if (leaves > 1) {
    uint32_t half = leaves / 2, left = node + 1, right = node + 2 * half;
    build(t, m, left, leaf, half);
    build(t, m, right, leaf + half, leaves - half);
    const atlas_node *a = &t->nodes[left], *b = &t->nodes[right];
    for (int k = 0; k < 2; k++) {
      n->low[k] = fminf(a->low[k], b->low[k]);
      n->high[k] = fmaxf(a->high[k], b->high[k]);
    }
    n->first = a->first < b->first ? a->first : b->first;
    return;
  }
  n->first = UINT32_MAX;
  for (uint32_t i = leaf * ATLAS_LEAF; i < t->count && i < (leaf + 1) * ATLAS_LEAF; i++) {
    float low[2], high[2];
    box_of(m, t->order[i], low, high);
    bool none = n->first == UINT32_MAX;
    for (int k = 0; k < 2; k++) {
      n->low[k] = none ? low[k] : fminf(n->low[k], low[k]);
      n->high[k] = none ? high[k] : fmaxf(n->high[k], high[k]);
    }
    if (t->order[i] < n->first) n->first = t->order[i];
  }
}

bool atlas_tree_build(atlas_tree *t, const mesh *m, const uint32_t *keep, uint32_t count) {
  memset(t, 0, sizeof *t);
  place *places = malloc((size_t)count * sizeof *places);
  t->count = count;
  t->leaves = (count + ATLAS_LEAF - 1) / ATLAS_LEAF;
  t->order = malloc((size_t)count * sizeof *t->order);
  t->nodes = malloc(2 * (size_t)t->leaves * sizeof *t->nodes);
  bool ok = places && t->order && t->nodes && count > 0;
  if (ok) {
    sort_along_curve(places, m, keep, count);
    for (uint32_t i = 0; i < count; i++) t->order[i] = places[i].triangle;
    build(t, m, 0, 0, t->leaves);
  } else
    atlas_tree_free(t);
  free(places);
  return ok;
}

void atlas_tree_free(atlas_tree *t) {
  free(t->order);
  free(t->nodes);
  memset(t, 0, sizeof *t);
}

/* ---- one triangle ------------------------------------------------------- */

static double to_x(const atlas_view *v, float u) { return ((double)u - v->left) * v->width; }
static double to_y(const atlas_view *v, float w) { return (v->top - (double)w) * v->height; }

static double smallest(const double a[3]) { return fmin(a[0], fmin(a[1], a[2])); }
static double largest(const double a[3]) { return fmax(a[0], fmax(a[1], a[2])); }

bool atlas_face_of(atlas_face *f, const mesh *m, const atlas_view *v, uint32_t triangle) {
  f->index = triangle;
  for (int k = 0; k < 3; k++) {
    const float *uv = corner(m, triangle, k);
    f->x[k] = to_x(v, uv[0]);
    f->y[k] = to_y(v, uv[1]);
  }
  f->box.low[0] = smallest(f->x), f->box.high[0] = largest(f->x);
  f->box.low[1] = smallest(f->y), f->box.high[1] = largest(f->y);
  f->area = (f->x[1] - f->x[0]) * (f->y[2] - f->y[0]) - (f->x[2] - f->x[0]) * (f->y[1] - f->y[0]);
  return f->area != 0;
}

/* Twice the area between the side from corner a to b and the point. */
static double beside(const atlas_face *f, int a, int b, double x, double y) {
  return (f->x[b] - f->x[a]) * (y - f->y[a]) - (f->y[b] - f->y[a]) * (x - f->x[a]);
}

/* The box first: rounding may put a point of a sliver's side past its end. */
bool atlas_face_contains(const atlas_face *f, double x, double y) {
  if (x < f->box.low[0] || x > f->box.high[0] || y < f->box.low[1] || y > f->box.high[1])
    return false;
  double sign = f->area > 0 ? 1 : -1;
  return sign * beside(f, 0, 1, x, y) >= 0 && sign * beside(f, 1, 2, x, y) >= 0 &&
         sign * beside(f, 2, 0, x, y) >= 0;
}

/* The point of a side nearest to (x, y), and the square of how far it is. */
static double to_side(const atlas_face *f, int a, int b, double x, double y, double at[2]) {
  double ex = f->x[b] - f->x[a], ey = f->y[b] - f->y[a];
  double length2 = ex * ex + ey * ey;
  double t = length2 > 0 ? ((x - f->x[a]) * ex + (y - f->y[a]) * ey) / length2 : 0;
  at[0] = t <= 0 ? f->x[a] : t >= 1 ? f->x[b] : f->x[a] + t * ex;
  at[1] = t <= 0 ? f->y[a] : t >= 1 ? f->y[b] : f->y[a] + t * ey;
  return (x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1]);
}

static double to_face(const atlas_face *f, double x, double y, double at[2]) {
  at[0] = x, at[1] = y;
  if (atlas_face_contains(f, x, y)) return 0;
  double best = INFINITY;
  for (int a = 0; a < 3; a++) {
    double point[2];
    double d = to_side(f, a, (a + 1) % 3, x, y, point);
    if (d < best) best = d, at[0] = point[0], at[1] = point[1];
  }
  /* Rounding alone keeps it out: 0 is for those that contain the point. */
  return fmax(best, 1e-300);
}

/* ---- searching ---------------------------------------------------------- */

static void node_box(const atlas_node *n, const atlas_view *v, atlas_box *b) {
  b->low[0] = to_x(v, n->low[0]), b->high[0] = to_x(v, n->high[0]);
  b->low[1] = to_y(v, n->high[1]), b->high[1] = to_y(v, n->low[1]);
}

static double positive(double a, double b) {
  double most = a > b ? a : b;
  return most > 0 ? most : 0;
}

static double to_box(const atlas_box *b, double x, double y) {
  double dx = positive(b->low[0] - x, x - b->high[0]);
  double dy = positive(b->low[1] - y, y - b->high[1]);
  return dx * dx + dy * dy;
}

static double to_node(const atlas_node *n, const atlas_view *v, double x, double y) {
  atlas_box b;
  node_box(n, v, &b);
  return to_box(&b, x, y);
}

static bool better(double distance2, uint32_t index, const atlas_found *than) {
  return distance2 < than->distance2 || (distance2 == than->distance2 && index < than->index);
}

/* A triangle that only touches the tile from beside is none of its own. */
static bool in_tile(const atlas_face *f, const atlas_view *v) {
  return f->box.low[0] < v->width && f->box.high[0] > 0 && f->box.low[1] < v->height &&
         f->box.high[1] > 0;
}

static void look_in_leaf(const atlas_tree *t, const mesh *m, const atlas_view *v, uint32_t leaf,
                         double x, double y, atlas_found *found) {
  for (uint32_t i = leaf * ATLAS_LEAF; i < t->count && i < (leaf + 1) * ATLAS_LEAF; i++) {
    atlas_face f;
    double at[2];
    if (!atlas_face_of(&f, m, v, t->order[i]) || !in_tile(&f, v)) continue;
    if (!better(to_box(&f.box, x, y), f.index, found)) continue;
    double d = to_face(&f, x, y, at);
    if (better(d, f.index, found)) *found = (atlas_found){f.index, d, {at[0], at[1]}};
  }
}

typedef struct waiting {
  uint32_t node, leaf, leaves;
  double distance2;
} waiting;

bool atlas_tree_nearest(const atlas_tree *t, const mesh *m, const atlas_view *v, double x, double y,
                        atlas_found *found) {
  waiting stack[DEPTH];
  int height = 0;
  found->index = UINT32_MAX;
  stack[height++] = (waiting){0, 0, t->leaves, to_node(&t->nodes[0], v, x, y)};
  while (height > 0) {
    waiting w = stack[--height];
    if (!better(w.distance2, t->nodes[w.node].first, found)) continue;
    if (w.leaves == 1) {
      look_in_leaf(t, m, v, w.leaf, x, y, found);
      continue;
    }
    uint32_t half = w.leaves / 2;
    waiting a = {w.node + 1, w.leaf, half, 0},
            b = {w.node + 2 * half, w.leaf + half, w.leaves - half, 0};
    a.distance2 = to_node(&t->nodes[a.node], v, x, y);
    b.distance2 = to_node(&t->nodes[b.node], v, x, y);
    bool a_first = a.distance2 < b.distance2 ||
                   (a.distance2 == b.distance2 && t->nodes[a.node].first < t->nodes[b.node].first);
    stack[height++] = a_first ? b : a;
    stack[height++] = a_first ? a : b;
  }
  return found->index != UINT32_MAX;
}

static bool meet(const atlas_box *a, const atlas_box *b) {
  return a->low[0] <= b->high[0] && a->high[0] >= b->low[0] && a->low[1] <= b->high[1] &&
         a->high[1] >= b->low[1];
}

static void insert(uint32_t *sorted, uint32_t count, uint32_t value) {
  uint32_t i = count;
  for (; i > 0 && sorted[i - 1] > value; i--) sorted[i] = sorted[i - 1];
  sorted[i] = value;
}

uint32_t atlas_tree_gather(const atlas_tree *t, const mesh *m, const atlas_view *v,
                           const atlas_box *box, uint32_t *triangles, uint32_t most) {
  waiting stack[DEPTH];
  int height = 0;
  uint32_t count = 0;
  stack[height++] = (waiting){0, 0, t->leaves, 0};
  while (height > 0) {
    waiting w = stack[--height];
    atlas_box b;
    node_box(&t->nodes[w.node], v, &b);
    if (!meet(&b, box)) continue;
    if (w.leaves > 1) {
      uint32_t half = w.leaves / 2;
      stack[height++] = (waiting){w.node + 2 * half, w.leaf + half, w.leaves - half, 0};
      stack[height++] = (waiting){w.node + 1, w.leaf, half, 0};
      continue;
    }
    for (uint32_t i = w.leaf * ATLAS_LEAF; i < t->count && i < (w.leaf + 1) * ATLAS_LEAF; i++) {
      atlas_face f;
      if (!atlas_face_of(&f, m, v, t->order[i]) || !meet(&f.box, box) || !in_tile(&f, v)) continue;
      if (count == most) return most + 1;
      insert(triangles, count++, f.index);
    }
  }
  return count;
}
