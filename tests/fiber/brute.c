/* SPDX-License-Identifier: Apache-2.0
 * Distances and windings by other formulas than the plugin's, over everything. */
#include <math.h>
#include "fiber.h"

typedef struct {
  double x, y, z;
} d3;

static d3 sub(d3 a, d3 b) { return (d3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static d3 along(d3 a, double t, d3 b) { return (d3){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z}; }
static double dot(d3 a, d3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static d3 cross(d3 a, d3 b) {
  return (d3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static double length(d3 a) { return sqrt(dot(a, a)); }
static d3 of(const float *p) { return (d3){(double)p[0], (double)p[1], (double)p[2]}; }

static double to_segment(d3 p, d3 a, d3 b) {
  d3 e = sub(b, a);
  double l = dot(e, e), t = l > 0 ? fmin(1, fmax(0, dot(sub(p, a), e) / l)) : 0;
  return length(sub(p, along(a, t, e)));
}

/* The foot on the plane by barycentric coordinates; outside, the edges. */
static double to_triangle(d3 p, d3 a, d3 b, d3 c) {
  d3 u = sub(b, a), v = sub(c, a), w = sub(p, a);
  double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v);
  double det = uu * vv - uv * uv;
  if (det > 0) {
    double s = (vv * wu - uv * wv) / det, t = (uu * wv - uv * wu) / det;
    if (s >= 0 && t >= 0 && s + t <= 1)
      return length(sub(w, along(along((d3){0, 0, 0}, s, u), t, v)));
  }
  return fmin(to_segment(p, a, b), fmin(to_segment(p, b, c), to_segment(p, c, a)));
}

static void corners(const mesh *m, size_t t, d3 out[3]) {
  for (size_t k = 0; k < 3; k++) out[k] = of(m->points + 3 * (size_t)m->indices[3 * t + k]);
}

double brute_distance(const mesh *m, const float p[3]) {
  double best = INFINITY;
  d3 c[3];
  for (size_t t = 0; t < m->triangle_count; t++) {
    corners(m, t, c);
    best = fmin(best, to_triangle(of(p), c[0], c[1], c[2]));
  }
  return best;
}

double brute_winding(const mesh *m, const float p[3]) {
  double sum = 0;
  d3 c[3];
  for (size_t t = 0; t < m->triangle_count; t++) {
    corners(m, t, c);
    d3 a = sub(c[0], of(p)), b = sub(c[1], of(p)), d = sub(c[2], of(p));
    double x = length(a), y = length(b), z = length(d);
    sum +=
        2 * atan2(dot(a, cross(b, d)), x * y * z + dot(a, b) * z + dot(b, d) * x + dot(d, a) * y);
  }
  return sum / (4 * 3.14159265358979323846);
}

double brute_segments(const float a[6], const float b[6]) {
  d3 p = of(a), e = sub(of(a + 3), p);
  double low = 0, high = 1; /* the distance to a segment is convex along a line */
  for (int i = 0; i < 60; i++) {
    double s = low + (high - low) / 3, t = high - (high - low) / 3;
    if (to_segment(along(p, s, e), of(b), of(b + 3)) < to_segment(along(p, t, e), of(b), of(b + 3)))
      high = t;
    else
      low = s;
  }
  return to_segment(along(p, 0.5 * (low + high), e), of(b), of(b + 3));
}
