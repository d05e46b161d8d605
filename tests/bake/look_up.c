/* SPDX-License-Identifier: Apache-2.0
 *
 * look-up MESH PICTURE COUNT points|seams: COUNT places on the mesh, all over it or
 * along the borders of its charts, as a program sees it that has the picture
 * and the UVs alone. To points.csv where they are in space (as `sozai eval`
 * reads it), to looked-up.csv the picture's R, G and B there, bilinear. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "image.h"
#include "mesh.h"

static uint32_t state = 7;

static double random_number(void) {
  state = state * 1664525u + 1013904223u;
  return (state >> 8) / 16777216.0;
}

static const float *uv_of(const mesh *m, uint32_t t, int k) {
  return m->uvs + 2 * (size_t)m->indices[3 * (size_t)t + (size_t)k];
}

/* A side that no other triangle has, corners being those of UV space. */
static bool is_border(const mesh *m, uint32_t t, int side) {
  const uint32_t *mine = m->indices + 3 * (size_t)t;
  uint32_t a = mine[side], b = mine[(side + 1) % 3];
  for (uint32_t o = 0; o < m->triangle_count; o++)
    for (int k = 0; o != t && k < 3; k++) {
      const uint32_t *other = m->indices + 3 * (size_t)o;
      uint32_t c = other[k], d = other[(k + 1) % 3];
      if ((a == c && b == d) || (a == d && b == c)) return false;
    }
  return true;
}

static void place(const mesh *m, bool seams, uint32_t *t, double w[3]) {
  for (;;) {
    *t = (uint32_t)(random_number() * m->triangle_count);
    double a = random_number(), b = random_number();
    if (!seams) {
      double root = sqrt(a);
      w[0] = 1 - root, w[1] = root * b, w[2] = root * (1 - b);
      return;
    }
    int side = (int)(3 * b);
    if (!is_border(m, *t, side)) continue;
    w[side] = a, w[(side + 1) % 3] = 1 - a, w[(side + 2) % 3] = 0;
    return;
  }
}

/* mm of the mesh to a texel of the picture. */
static double footprint(const mesh *m, uint32_t t, const image *p) {
  const float *a = uv_of(m, t, 0), *b = uv_of(m, t, 1), *c = uv_of(m, t, 2);
  double uv = fabs((double)(b[0] - a[0]) * (double)(c[1] - a[1]) -
                   (double)(c[0] - a[0]) * (double)(b[1] - a[1]));
  const uint32_t *i = m->indices + 3 * (size_t)t;
  double e[2][3], n[3];
  for (size_t k = 0; k < 3; k++)
    for (size_t s = 0; s < 2; s++)
      e[s][k] = (double)(m->points[3 * i[s + 1] + k] - m->points[3 * i[0] + k]);
  for (int k = 0; k < 3; k++)
    n[k] = e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
  double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return sqrt(area / (uv * p->width * p->height));
}

static void write_point(FILE *to, const mesh *m, uint32_t t, const double w[3], const image *p) {
  const uint32_t *i = m->indices + 3 * (size_t)t;
  const float *arrays[2] = {m->points, m->normals};
  for (int a = 0; a < 2; a++)
    for (size_t k = 0; k < 3; k++) {
      double x = 0;
      for (int c = 0; c < 3; c++) x += w[c] * (double)arrays[a][3 * i[c] + k];
      fprintf(to, "%.9g,", x);
    }
  fprintf(to, "%.9g\n", footprint(m, t, p));
}

static void write_look_up(FILE *to, const mesh *m, uint32_t t, const double w[3], const image *p) {
  double u = 0, v = 0, rgb[3] = {0};
  for (int c = 0; c < 3; c++) {
    u += w[c] * (double)uv_of(m, t, c)[0];
    v += w[c] * (double)uv_of(m, t, c)[1];
  }
  double x = fmax(0, u * p->width - 0.5), y = fmax(0, (1 - v) * p->height - 0.5);
  uint32_t x0 = (uint32_t)x, y0 = (uint32_t)y;
  for (uint32_t c = 0; c < 4; c++) {
    uint32_t cx = x0 + c % 2, cy = y0 + c / 2;
    if (cx >= p->width || cy >= p->height) continue;
    double share = (c % 2 ? x - x0 : 1 - (x - x0)) * (c / 2 ? y - y0 : 1 - (y - y0));
    for (size_t k = 0; k < 3; k++)
      rgb[k] += share * (double)p->data[((size_t)cy * p->width + cx) * p->channels + k];
  }
  fprintf(to, "%.9g,%.9g,%.9g\n", rgb[0], rgb[1], rgb[2]);
}

int main(int argc, char **argv) {
  mesh m;
  image p;
  failure why;
  if (argc != 5 || !mesh_read(&m, argv[1], 1, &why) || !image_read(&p, argv[2], &why)) {
    fprintf(stderr, "%s\n", argc != 5 ? "usage: see look_up.c" : why.text);
    return 1;
  }
  FILE *points = fopen("points.csv", "w"), *looked_up = fopen("looked-up.csv", "w");
  if (!points || !looked_up) return 1;
  fputs("px,py,pz,nx,ny,nz,footprint\n", points);
  fputs("albedo_r,albedo_g,albedo_b\n", looked_up);
  for (long i = atol(argv[3]); i > 0; i--) {
    uint32_t t;
    double w[3];
    place(&m, strcmp(argv[4], "seams") == 0, &t, w);
    write_point(points, &m, t, w, &p);
    write_look_up(looked_up, &m, t, w, &p);
  }
  mesh_free(&m);
  image_free(&p);
  return fclose(points) != 0 || fclose(looked_up) != 0;
}
