/* SPDX-License-Identifier: Apache-2.0 */
#include "meshes.h"

#include <math.h>

#define TURN 6.283185307179586

/* A grid's (cells + 1)^2 vertices are the last ones written: join them. */
static void write_grid_faces(FILE *to, unsigned across, unsigned down, bool flip) {
  long row = (long)across + 1, first = -row * ((long)down + 1);
  for (long j = 0; j < (long)down; j++)
    for (long i = 0; i < (long)across; i++) {
      long a = first + j * row + i, b = a + 1, c = b + row, d = a + row;
      if (flip) {
        long swap = b;
        b = d;
        d = swap;
      }
      fprintf(to, "f %ld/%ld %ld/%ld %ld/%ld\nf %ld/%ld %ld/%ld %ld/%ld\n", a, a, b, b, c, c, a, a,
              c, c, d, d);
    }
}

/* A point of the box's face, s and t from -1 to 1: the cube's corner points are
 * drawn in to where the sum over two axes is at most the cut allows. */
static void box_point(int axis, double sign, double s, double t, double p[3]) {
  static const double half[3] = {30, 50, 15};
  const double cut = 4;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  /* Of the side, the last tenth at each end is the cut edge. */
  double q[3];
  double a[2] = {s, t};
  double in = 0;
  for (int k = 0; k < 2; k++) {
    int on = k == 0 ? u : v;
    double flat = half[on] - cut, beyond = fabs(a[k]) > 0.8 ? (fabs(a[k]) - 0.8) / 0.2 : 0;
    double along = beyond > 0 ? flat + beyond * cut / 2 : fabs(a[k]) / 0.8 * flat;
    q[on] = copysign(along, a[k]);
    in = fmax(in, beyond * cut / 2);
  }
  q[axis] = sign * (half[axis] - in);
  for (int k = 0; k < 3; k++) p[k] = q[k];
}

void write_box(FILE *to, unsigned cells, bool udim) {
  static const int tiles[6][2] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 1}};
  for (int f = 0; f < 6; f++) {
    int axis = f / 2;
    double sign = f % 2 ? 1 : -1;
    double u0 = udim ? tiles[f][0] + 0.05 : f % 3 / 3.0 + 0.02;
    double v0 = udim ? tiles[f][1] + 0.05 : (double)(f / 3) / 2 + 0.02;
    double w = udim ? 0.9 : 1 / 3.0 - 0.04, h = udim ? 0.9 : 0.46;
    for (unsigned j = 0; j <= cells; j++)
      for (unsigned i = 0; i <= cells; i++) {
        double p[3], a = (double)i / cells, b = (double)j / cells;
        box_point(axis, sign, 2 * a - 1, 2 * b - 1, p);
        fprintf(to, "v %.9g %.9g %.9g\nvt %.9g %.9g\n", p[0], p[1], p[2], u0 + a * w, v0 + b * h);
      }
    write_grid_faces(to, cells, cells, sign < 0);
  }
}

/* The leg's radius at height y: foot, taper, beads and a square-ish top. */
static double leg_radius(double y) {
  double bead = 5 * exp(-(y - 220) * (y - 220) / 60) + 4 * exp(-(y - 240) * (y - 240) / 90);
  double neck = -5 * exp(-(y - 200) * (y - 200) / 50);
  return 11 + 9 * y / 300 + bead + neck + 3 * exp(-y * y / 200);
}

static void write_disc(FILE *to, unsigned around, double y, double u, double v, bool up) {
  double r = leg_radius(y);
  fprintf(to, "v 0 %.9g 0\nvt %.9g %.9g\n", y, u, v);
  for (unsigned i = 0; i < around; i++) {
    double a = TURN * i / around;
    fprintf(to, "v %.9g %.9g %.9g\nvt %.9g %.9g\n", r * cos(a), y, r * sin(a), u + 0.1 * cos(a),
            v + 0.1 * sin(a));
  }
  long centre = -(long)around - 1;
  for (unsigned i = 0; i < around; i++) {
    long a = centre + 1 + (long)i, b = centre + 1 + (long)((i + 1) % around);
    fprintf(to, "f %ld/%ld %ld/%ld %ld/%ld\n", centre, centre, up ? b : a, up ? b : a, up ? a : b,
            up ? a : b);
  }
}

void write_leg(FILE *to, unsigned around, unsigned along) {
  for (unsigned j = 0; j <= along; j++)
    for (unsigned i = 0; i <= around; i++) {
      double a = TURN * i / around, y = 300.0 * j / along, r = leg_radius(y);
      /* the last column stands where the first does, to the bit */
      double c = i == around ? 1 : cos(a), s = i == around ? 0 : sin(a);
      fprintf(to, "v %.9g %.9g %.9g\nvt %.9g %.9g\n", r * c, y, r * s, 0.03 + 0.55 * i / around,
              0.02 + 0.96 * j / along);
    }
  write_grid_faces(to, around, along, true);
  write_disc(to, around, 0, 0.8, 0.25, false);
  write_disc(to, around, 300, 0.8, 0.75, true);
}

void write_blob(FILE *to, unsigned cells) {
  for (unsigned j = 0; j <= cells; j++)
    for (unsigned i = 0; i <= cells; i++) {
      double a = TURN * i / cells, b = TURN / 2 * (j + 0.5) / (cells + 1);
      double r = 100 + 5 * sin(7 * a) * sin(5 * b);
      fprintf(to, "v %.9g %.9g %.9g\nvt %.9g %.9g\n", r * sin(b) * cos(a), r * cos(b),
              r * sin(b) * sin(a), 0.01 + 0.98 * i / cells, 0.99 - 0.98 * j / cells);
    }
  write_grid_faces(to, cells, cells, false);
}
