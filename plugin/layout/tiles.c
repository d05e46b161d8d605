/* SPDX-License-Identifier: Apache-2.0
 *
 * The tiles of the layouts that repeat: one small function each, which names
 * the lattice and the pieces. Nothing here knows of joints.
 */
#include <string.h>

#include "../core/scalar.h"
#include "layout.h"

static void lattice(layout_tile *t, double ax, double ay, double bx, double by) {
  t->a[0] = ax;
  t->a[1] = ay;
  t->b[0] = bx;
  t->b[1] = by;
}

/* The next piece, of the next number within the tile. */
static layout_piece *piece(layout_tile *t) {
  layout_piece *p = &t->piece[t->count];
  memset(p, 0, sizeof *p);
  p->number = t->count++;
  return p;
}

static void corner(layout_piece *p, double x, double y) {
  p->x[p->sides] = x;
  p->y[p->sides++] = y;
}

/* A rectangle whose local u runs along (cx, cy) from its corner. */
static layout_piece *turned(layout_tile *t, double x, double y, double cx, double cy, double length,
                            double width) {
  layout_piece *p = piece(t);
  p->corner[0] = x;
  p->corner[1] = y;
  p->along[0] = cx;
  p->along[1] = cy;
  p->length = length;
  p->width = width;
  corner(p, x, y);
  corner(p, x + cx * length, y + cy * length);
  corner(p, x + cx * length - cy * width, y + cy * length + cx * width);
  corner(p, x - cy * width, y + cx * width);
  return p;
}

/* Along u, and along v (its own v then runs against u). */
static void lying(layout_tile *t, double x, double y, double length, double width) {
  turned(t, x, y, 1, 0, length, width);
}
static void standing(layout_tile *t, double x, double y, double length, double width) {
  turned(t, x + width, y, 0, 1, length, width);
}

/* ---- courses ---------------------------------------------------------- */

static void running(layout_tile *t, double l, double w, double shift) {
  lattice(t, l, 0, shift * l, w);
  lying(t, 0, 0, l, w);
}

static void english(layout_tile *t, double l, double w) {
  lattice(t, l, 0, 0, 2 * w);
  lying(t, 0, 0, l, w);
  lying(t, 0.25 * l, w, 0.5 * l, w);
  lying(t, 0.75 * l, w, 0.5 * l, w);
}

static void flemish(layout_tile *t, double l, double w) {
  lattice(t, 1.5 * l, 0, 0.75 * l, w);
  lying(t, 0, 0, l, w);
  lying(t, l, 0, 0.5 * l, w);
}

/* ---- blocks that turn ------------------------------------------------- */

/* Each block stands on the end of one and against the side of the next:
 * stairs of step w, one stair l down from the other. `by`: a block is so many
 * side by side. */
static void herringbone(layout_tile *t, double l, double w, int by) {
  double step = w * by;
  lattice(t, step, step, l, -l);
  for (int i = 0; i < by; i++) lying(t, 0, i * w, l, w);
  for (int i = 0; i < by; i++) standing(t, l + i * w, step - l, l, w);
}

static void chevron(layout_tile *t, double l, double w, double degrees) {
  double a = degrees * 0.017453292519943295769, c = scalar_cos(a), s = scalar_sin(a);
  double across = l * c, rise = l * s, pitch = w / c;
  lattice(t, 2 * across, 0, 0, pitch);
  for (int side = 0; side < 2; side++) {
    layout_piece *p = piece(t);
    double x = side * across, y0 = side ? rise : 0, y1 = side ? 0 : rise;
    corner(p, x, y0);
    corner(p, x + across, y1);
    corner(p, x + across, y1 + pitch);
    corner(p, x, y0 + pitch);
    /* the box about it, along the grain: the mitre takes d at either end */
    double d = w * s / c;
    p->along[0] = c;
    p->along[1] = side ? -s : s;
    p->corner[0] = side ? x - d * c : x;
    p->corner[1] = side ? y0 + d * s : y0;
    p->length = l + d;
    p->width = w;
  }
}

static void basket(layout_tile *t, double l, double w) {
  int n = (int)(l / w + 0.5);
  n = n < 1 ? 1 : n > 15 ? 15 : n;
  w = l / n;
  lattice(t, l, l, l, -l);
  for (int i = 0; i < n; i++) lying(t, 0, i * w, l, w);
  for (int i = 0; i < n; i++) standing(t, l + i * w, 0, l, w);
}

/* A square of side `inner` within four blocks l x w, l = inner + w. */
static void windmill(layout_tile *t, double l, double w) {
  lattice(t, l + w, 0, 0, l + w);
  lying(t, 0, 0, l, w);
  standing(t, l, 0, l, w);
  lying(t, w, l, l, w);
  standing(t, 0, w, l, w);
  lying(t, w, w, l - w, l - w);
}

static void igeta(layout_tile *t, double l, double w) {
  lattice(t, l + w, 0, 0, l + w);
  lying(t, 0, 0, l, l);
  lying(t, 0, l, l, w);
  standing(t, l, 0, l, w);
  lying(t, l, l, w, w);
}

/* ---- Versailles ------------------------------------------------------- */

/* What of the polygon lies where nx x + ny y <= d. */
static void cut_off(layout_piece *p, double nx, double ny, double d) {
  double x[LAYOUT_SIDES], y[LAYOUT_SIDES];
  int n = 0;
  for (int i = 0; i < p->sides; i++) {
    int j = (i + 1) % p->sides;
    double a = nx * p->x[i] + ny * p->y[i] - d, b = nx * p->x[j] + ny * p->y[j] - d;
    if (a <= 1e-9 && n < LAYOUT_SIDES) {
      x[n] = p->x[i];
      y[n++] = p->y[i];
    }
    if (((a < -1e-9 && b > 1e-9) || (a > 1e-9 && b < -1e-9)) && n < LAYOUT_SIDES) {
      double k = a / (a - b);
      x[n] = p->x[i] + k * (p->x[j] - p->x[i]);
      y[n++] = p->y[i] + k * (p->y[j] - p->y[i]);
    }
  }
  p->sides = n < 3 ? 0 : n;
  memcpy(p->x, x, sizeof x);
  memcpy(p->y, y, sizeof y);
}

/* A lath or filler of the weave, given along the panel's diagonals p and q
 * from its middle, cut to the frame's inside. */
static void woven(layout_tile *t, double side, double w, double p, double q, double dp, double dq) {
  static const double r = 0.70710678118654752440;
  if (t->count == LAYOUT_TILE_PIECES) return;
  double x = 0.5 * side + (p - q) * r, y = 0.5 * side + (p + q) * r, twice = 0;
  layout_piece *made =
      dq > dp ? turned(t, x + dp * r, y + dp * r, -r, r, dq, dp) : turned(t, x, y, r, r, dp, dq);
  cut_off(made, 1, 0, side - w);
  cut_off(made, -1, 0, -w);
  cut_off(made, 0, 1, side - w);
  cut_off(made, 0, -1, -w);
  for (int s = 0; s < made->sides; s++) {
    int e = (s + 1) % made->sides;
    twice += made->x[s] * made->y[e] - made->x[e] * made->y[s];
  }
  if (twice < 1e-3) t->count--;
}

/* Laths woven over and under on the diagonal, square fillers between them. */
static void versailles(layout_tile *t, double side, double w) {
  lattice(t, side, 0, 0, side);
  lying(t, 0, 0, side - w, w);
  standing(t, side - w, 0, side - w, w);
  lying(t, w, side - w, side - w, w);
  standing(t, 0, w, side - w, w);
  /* from one filler's middle to the next: a quarter of the inside's diagonal */
  double step = 0.25 * 1.41421356237309504880 * (side - 2 * w), f = step - w;
  for (int i = -3; i <= 3; i++) {
    for (int j = -3; j <= 3; j++) {
      double p = i * step - 0.5 * f, q = j * step - 0.5 * f;
      woven(t, side, w, p, q, f, f);
      /* at the crossing beyond its upper corner one lath is on top, which shows
       * as far as the crossings before and after it */
      if ((i + j) & 1) {
        woven(t, side, w, p, q + f, 2 * f + w, w);
      } else {
        woven(t, side, w, p + f, q, w, 2 * f + w);
      }
    }
  }
}

/* ---- polygons --------------------------------------------------------- */

static void about(layout_piece *p, double x, double y, double size) {
  p->corner[0] = x - 0.5 * size;
  p->corner[1] = y - 0.5 * size;
  p->along[0] = 1;
  p->length = p->width = size;
}

static void hexagon(layout_tile *t, double w) {
  const double h = w * 0.57735026918962576451; /* its side, w / sqrt(3) */
  lattice(t, w, 0, 0.5 * w, 1.5 * h);
  layout_piece *p = piece(t);
  about(p, 0.5 * w, h, w);
  corner(p, 0, 0.5 * h);
  corner(p, 0.5 * w, 0);
  corner(p, w, 0.5 * h);
  corner(p, w, 1.5 * h);
  corner(p, 0.5 * w, 2 * h);
  corner(p, 0, 1.5 * h);
}

static void octagon(layout_tile *t, double w) {
  const double k = w * 0.29289321881345247560, r = 0.70710678118654752440; /* 1 - sqrt(1/2) */
  lattice(t, w, 0, 0, w);
  layout_piece *p = piece(t);
  about(p, 0.5 * w, 0.5 * w, w);
  corner(p, k, 0);
  corner(p, w - k, 0);
  corner(p, w, k);
  corner(p, w, w - k);
  corner(p, w - k, w);
  corner(p, k, w);
  corner(p, 0, w - k);
  corner(p, 0, k);
  turned(t, 0, -k, r, r, k / r, k / r);
}

/* ---- which ------------------------------------------------------------ */

int layout_tile_of(const layout_choice *c, layout_tile *t) {
  double l = c->length, w = c->width;
  memset(t, 0, sizeof *t);
  switch (c->kind) {
  case LAYOUT_STACK:
    running(t, l, w, 0);
    break;
  case LAYOUT_RUNNING:
    running(t, l, w, c->stagger);
    break;
  case LAYOUT_CHIDORI:
  case LAYOUT_END_GRAIN:
    running(t, l, w, 0.5);
    break;
  case LAYOUT_ENGLISH:
    english(t, l, w);
    break;
  case LAYOUT_FLEMISH:
    flemish(t, l, w);
    break;
  case LAYOUT_HERRINGBONE:
  case LAYOUT_HERRINGBONE_90:
    herringbone(t, l, w, 1);
    break;
  case LAYOUT_HERRINGBONE_DOUBLE:
    herringbone(t, l, w, 2);
    break;
  case LAYOUT_CHEVRON:
    chevron(t, l, w, c->angle);
    break;
  case LAYOUT_BASKET:
    basket(t, l, w);
    break;
  case LAYOUT_WINDMILL:
    windmill(t, l, w);
    break;
  case LAYOUT_IGETA:
    igeta(t, l, w);
    break;
  case LAYOUT_VERSAILLES:
    versailles(t, l, w);
    break;
  case LAYOUT_HEXAGON:
    hexagon(t, w);
    break;
  case LAYOUT_OCTAGON:
    octagon(t, w);
    break;
  default:
    return 0;
  }
  return 1;
}
