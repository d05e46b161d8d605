/* SPDX-License-Identifier: Apache-2.0
 *
 * From a choice to what the kernels read: which pieces reach into one cell of
 * the lattice, and the half planes that bound them.
 */
#include <string.h>

#include "../core/scalar.h"
#include "layout.h"

/* Lattice coordinates of a place. */
static void to_lattice(const layout_tile *t, double x, double y, double *i, double *j) {
  double det = t->a[0] * t->b[1] - t->a[1] * t->b[0];
  *i = (x * t->b[1] - y * t->b[0]) / det;
  *j = (t->a[0] * y - t->a[1] * x) / det;
}

/* Whether an edge of the polygon (x, y), anticlockwise if `sign` is 1, has the
 * whole unit square on its outer side. */
static int beside(const double *x, const double *y, int n, double sign) {
  for (int s = 0; s < n; s++) {
    int e = (s + 1) % n;
    double nx = sign * (y[s] - y[e]), ny = sign * (x[e] - x[s]);
    double most = (nx > 0 ? nx : 0) + (ny > 0 ? ny : 0) - (nx * x[s] + ny * y[s]);
    if (most < 1e-9) return 1;
  }
  return 0;
}

/* Greatest distance across the polygon's narrowest direction. */
static double narrowest(const layout_piece *p) {
  double least = 1e30;
  for (int s = 0; s < p->sides; s++) {
    int e = (s + 1) % p->sides;
    double dx = p->x[e] - p->x[s], dy = p->y[e] - p->y[s], most = 0;
    double root = __builtin_sqrt(dx * dx + dy * dy);
    for (int k = 0; k < p->sides; k++) {
      double d = (dx * (p->y[k] - p->y[s]) - dy * (p->x[k] - p->x[s])) / root;
      if (d > most) most = d;
    }
    if (most < least) least = most;
  }
  return least;
}

static double area(const layout_piece *p, double inset) {
  /* of the polygon less a border: exact for what its sides leave */
  double sum = 0, round = 0;
  for (int s = 0; s < p->sides; s++) {
    int e = (s + 1) % p->sides;
    sum += 0.5 * (p->x[s] * p->y[e] - p->x[e] * p->y[s]);
    double dx = p->x[e] - p->x[s], dy = p->y[e] - p->y[s];
    round += __builtin_sqrt(dx * dx + dy * dy);
  }
  /* corners: each takes inset^2 / tan(half its angle) */
  double corners = 0;
  for (int s = 0; s < p->sides; s++) {
    int e = (s + 1) % p->sides, b = (s + p->sides - 1) % p->sides;
    double ux = p->x[e] - p->x[s], uy = p->y[e] - p->y[s];
    double vx = p->x[b] - p->x[s], vy = p->y[b] - p->y[s];
    double dot = ux * vx + uy * vy, cross = ux * vy - uy * vx;
    double size = __builtin_sqrt(dot * dot + cross * cross);
    corners += (size + dot) / cross; /* 1 / tan(half), from the angle's sine and cosine */
  }
  return sum - inset * round + inset * inset * corners;
}

/* The piece, moved by (i, j) tiles, into the table. */
static int add(layout *l, const layout_tile *t, const layout_piece *p, int i, int j) {
  if (l->pieces == LAYOUT_PIECES) return 0;
  int k = l->pieces++;
  double mx = i * t->a[0] + j * t->b[0], my = i * t->a[1] + j * t->b[1];
  for (int s = 0; s < LAYOUT_SIDES; s++) {
    /* a piece of fewer sides has its last one again */
    int from = s < p->sides ? s : p->sides - 1, to = (from + 1) % p->sides;
    double dx = p->x[to] - p->x[from], dy = p->y[to] - p->y[from];
    double inverse = 1.0 / __builtin_sqrt(dx * dx + dy * dy);
    double nx = -dy * inverse, ny = dx * inverse;
    l->nx[s][k] = (float)nx;
    l->ny[s][k] = (float)ny;
    l->d[s][k] = (float)(-(nx * (p->x[from] + mx) + ny * (p->y[from] + my)));
  }
  l->corner_x[k] = (float)(p->corner[0] + mx);
  l->corner_y[k] = (float)(p->corner[1] + my);
  l->along_x[k] = (float)p->along[0];
  l->along_y[k] = (float)p->along[1];
  l->piece_length[k] = (float)p->length;
  l->piece_width[k] = (float)p->width;
  l->cell_i[k] = i;
  l->cell_j[k] = j;
  l->number[k] = p->number;
  return 1;
}

/* All of a piece's copies that reach into the cell (0..1, 0..1) of the lattice. */
static int add_copies(layout *l, const layout_tile *t, const layout_piece *p) {
  double x[LAYOUT_SIDES], y[LAYOUT_SIDES];
  double low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30};
  for (int s = 0; s < p->sides; s++) {
    to_lattice(t, p->x[s], p->y[s], &x[s], &y[s]);
    if (x[s] < low[0]) low[0] = x[s];
    if (y[s] < low[1]) low[1] = y[s];
    if (x[s] > high[0]) high[0] = x[s];
    if (y[s] > high[1]) high[1] = y[s];
  }
  double sign = t->a[0] * t->b[1] - t->a[1] * t->b[0] > 0 ? 1 : -1;
  for (int i = -200; i <= 200; i++) {
    if (i + high[0] < 1e-9 || i + low[0] > 1.0 - 1e-9) continue;
    for (int j = -200; j <= 200; j++) {
      if (j + high[1] < 1e-9 || j + low[1] > 1.0 - 1e-9) continue;
      double mx[LAYOUT_SIDES], my[LAYOUT_SIDES];
      for (int s = 0; s < p->sides; s++) {
        mx[s] = x[s] + i;
        my[s] = y[s] + j;
      }
      if (!beside(mx, my, p->sides, sign) && !add(l, t, p, i, j)) return 0;
    }
  }
  return 1;
}

static int build_table(layout *l, const layout_tile *t) {
  double det = t->a[0] * t->b[1] - t->a[1] * t->b[0], kept = 0, least = 1e30;
  l->quads = 1;
  for (int k = 0; k < t->count; k++) {
    const layout_piece *p = &t->piece[k];
    if (!add_copies(l, t, p)) return 0;
    if (p->sides > l->sides) l->sides = p->sides;
    if (p->sides != 4) l->quads = 0;
    kept += area(p, 0.5 * (double)l->joint);
    double across = narrowest(p);
    if (across < least) least = across;
  }
  l->narrowest = (float)least;
  l->share = (float)(1.0 - kept / (det > 0 ? det : -det));
  l->numbers = 1;
  while (l->numbers < t->count) l->numbers *= 2;
  for (int c = 0; c < 2; c++) {
    l->a[c] = (float)t->a[c];
    l->b[c] = (float)t->b[c];
  }
  l->to_i[0] = (float)(t->b[1] / det);
  l->to_i[1] = (float)(-t->b[0] / det);
  l->to_j[0] = (float)(-t->a[1] / det);
  l->to_j[1] = (float)(t->a[0] / det);
  return 1;
}

/* Longest block, in widths, that the table has room for or that makes sense. */
static double most_slender(int kind) {
  switch (kind) {
  case LAYOUT_HERRINGBONE:
  case LAYOUT_HERRINGBONE_90:
  case LAYOUT_HERRINGBONE_DOUBLE:
  case LAYOUT_CHEVRON:
    return 20;
  case LAYOUT_BASKET:
    return 15;
  default:
    return 1e5;
  }
}

/* Shortest, likewise: blocks that turn want to be longer than wide. */
static double least_slender(int kind) {
  switch (kind) {
  case LAYOUT_HERRINGBONE:
  case LAYOUT_HERRINGBONE_90:
  case LAYOUT_CHEVRON:
  case LAYOUT_BASKET:
    return 1;
  case LAYOUT_WINDMILL:
    return 1.1;
  case LAYOUT_HERRINGBONE_DOUBLE:
    return 2;
  case LAYOUT_VERSAILLES:
    return 7;
  default:
    return 0;
  }
}

/* Joints of the layouts that are functions, as a share of the plane. */
static double share_of(const layout *l, double joint) {
  double length = (double)l->length, width = (double)l->width;
  switch (l->kind) {
  case LAYOUT_STRIP:
  case LAYOUT_BUTCHER:
    return 1.0 - (1.0 - joint / length) * (1.0 - joint / width);
  case LAYOUT_ASHLAR: /* blocks are broken upright, and parts across, every other time */
    return 1.0 - (1.0 - 1.5 * joint / length) * (1.0 - 1.5 * joint / width);
  case LAYOUT_FAN: { /* rings and rays, and the border of every fan: straight sides and arcs */
    double r = (double)l->radius, border = r * (1.5707963 + 2.0 * 0.41421356), tile = r * r;
    double inside = 1.0 - (1.0 - joint / length) * (1.0 - joint / width);
    return inside + (1.0 - inside) * joint * (border - 0.5 * 1.5707963 * r) / tile * 0.5;
  }
  case LAYOUT_CRAZY: /* as of squares of the same number, measured */
    return 1.0 - (1.0 - joint / length) * (1.0 - joint / length);
  default:
    return 1.0 - (1.0 - joint / length) * (1.0 - joint / width);
  }
}

#define USUAL_(kind, id, length, width, joint, doc) {length, width, joint},
static const double usual_sizes[LAYOUT_COUNT][3] = {LAYOUT_CATALOGUE(USUAL_)};

const char *layout_build(layout *l, const layout_choice *given, double *least, double *most) {
  layout_choice c = *given;
  const double *usual = usual_sizes[c.kind];
  memset(l, 0, sizeof *l);
  if (c.kind == LAYOUT_NONE) return NULL;
  if (c.length <= 0.0) c.length = usual[0];
  if (c.width <= 0.0) c.width = usual[1];
  if (c.joint < 0.0) c.joint = usual[2];
  l->length = (float)c.length;
  l->width = (float)c.width;
  l->joint = (float)c.joint;
  *least = least_slender(c.kind) * c.width;
  *most = most_slender(c.kind) * c.width;
  if (*most > 1e5) *most = 1e5;
  if (c.length < *least || c.length > *most) return "length";
  l->kind = c.kind;
  double turn = c.turn;
  if (c.kind == LAYOUT_HERRINGBONE || c.kind == LAYOUT_HERRINGBONE_DOUBLE) turn += 45.0;
  turn *= 0.017453292519943295769;
  l->cosine = (float)scalar_cos(turn);
  l->sine = (float)scalar_sin(turn);
  l->inverse_length = (float)(1.0 / c.length);
  l->inverse_width = (float)(1.0 / c.width);
  l->jitter = (float)(0.5 * c.variation);
  l->stagger = (float)c.stagger;
  l->radius = (float)((c.kind == LAYOUT_FAN ? 10.0 : 7.0) * c.width);
  l->numbers = 1;
  l->quads = 1;
  layout_tile t;
  if (layout_tile_of(&c, &t)) {
    if (!build_table(l, &t)) return "length";
  } else {
    double across = c.length * (1.0 - c.variation);
    if (c.kind == LAYOUT_ASHLAR) {
      across *= 0.3;
      if (0.35 * c.width < across) across = 0.35 * c.width;
      l->numbers = 4;
    }
    if (c.kind == LAYOUT_CRAZY) across = 0.3 * c.length;
    if (c.kind == LAYOUT_FAN) {
      across *= 0.6;
      l->numbers = 256; /* ten rings; the fullest has not quite 18 widths */
      while (l->numbers < 180.0 * c.width / c.length && l->numbers < 4096) l->numbers *= 2;
    }
    if (c.kind == LAYOUT_ARCS) {
      double row = (double)LAYOUT_ARC_LONG * c.width, fit = row / c.length;
      l->around = (float)(int)(fit < 1.5 ? 2.0 : fit > 1e6 ? 1e6 : fit + 0.5);
      across = 0.5 * row / (double)l->around;
    }
    if (c.width < across) across = c.width;
    l->narrowest = (float)across;
    l->share = (float)share_of(l, c.joint);
  }
  *least = 0.0;
  *most = 0.45 * (double)l->narrowest;
  return c.joint > *most ? "joint" : NULL;
}
