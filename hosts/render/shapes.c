/* SPDX-License-Identifier: Apache-2.0 */
#include "shapes.h"

#include <math.h>
#include <stddef.h>
#include "vec.h"

/* Steps from a face's flat part to the middle of its edge. */
#define STEPS 4
#define SIDE (2 * (STEPS + 1))

/* Where the i-th line of a face's grid runs along one axis: the flat part's end
 * there, and how far beyond it the unrounded surface would be, both in mm. */
static void grid_line(int i, float half, float bevel, float *flat, float *beyond) {
  int step = i < SIDE / 2 ? STEPS - i : i - SIDE / 2;
  float sign = i < SIDE / 2 ? -1 : 1;
  *flat = sign * (half - bevel);
  *beyond = sign * bevel * tanf((float)step / STEPS * 0.78539816f);
}

/* A rounded box is all points within `bevel` of a smaller box. Each of its
 * faces is a grid over the unrounded face; every grid point is drawn in towards
 * the nearest point of the smaller box until it is `bevel` away. */
static void add_face(mesh *m, int axis, float sign, const float *half, float bevel) {
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  uint32_t base = m->point_count;
  for (int i = 0; i < SIDE; i++)
    for (int j = 0; j < SIDE; j++) {
      float flat[3], beyond[3];
      grid_line(i, half[u], bevel, &flat[u], &beyond[u]);
      grid_line(j, half[v], bevel, &flat[v], &beyond[v]);
      flat[axis] = sign * (half[axis] - bevel);
      beyond[axis] = sign * bevel;
      float length = sqrtf(beyond[0] * beyond[0] + beyond[1] * beyond[1] + beyond[2] * beyond[2]);
      float *p = m->points + 3 * (size_t)m->point_count;
      float *n = m->normals + 3 * (size_t)m->point_count++;
      for (int k = 0; k < 3; k++) {
        n[k] = beyond[k] / length;
        p[k] = flat[k] + bevel * n[k];
      }
    }
  for (uint32_t i = 0; i + 1 < SIDE; i++)
    for (uint32_t j = 0; j + 1 < SIDE; j++) {
      uint32_t a = base + i * SIDE + j, b = a + SIDE, c = b + 1, d = a + 1;
      uint32_t *t = m->indices + 3 * (size_t)m->triangle_count;
      uint32_t front[6] = {a, b, c, a, c, d}, back[6] = {a, c, b, a, d, c};
      for (int k = 0; k < 6; k++) t[k] = sign > 0 ? front[k] : back[k];
      m->triangle_count += 2;
    }
}

bool shape_board(mesh *m, const double size[3], double bevel, failure *why) {
  float half[3];
  double least = fmin(size[0], fmin(size[1], size[2]));
  /* Not quite 0 nor half the board, so that no triangle loses its normal. */
  float radius = (float)fmin(fmax(bevel, 1e-4 * least), 0.499 * least);
  for (int k = 0; k < 3; k++) half[k] = (float)(size[k] / 2);
  uint32_t cells = (SIDE - 1) * (SIDE - 1);
  if (!mesh_allocate(m, 6 * SIDE * SIDE, 6 * 2 * cells, why)) return false;
  m->point_count = m->triangle_count = 0;
  for (int axis = 0; axis < 3; axis++) {
    add_face(m, axis, -1, half, radius);
    add_face(m, axis, 1, half, radius);
  }
  return true;
}

bool shape_plane(mesh *m, const double size[2], failure *why) {
  if (!mesh_allocate(m, 4, 2, why)) return false;
  static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  for (int i = 0; i < 4; i++) {
    m->points[3 * i] = (float)(i == 1 || i == 2 ? size[0] / 2 : -size[0] / 2);
    m->points[3 * i + 1] = (float)(i >= 2 ? size[1] / 2 : -size[1] / 2);
    m->normals[3 * i + 2] = 1;
  }
  for (int i = 0; i < 6; i++) m->indices[i] = indices[i];
  return true;
}
