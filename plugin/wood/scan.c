/* SPDX-License-Identifier: Apache-2.0
 *
 * Nothing here is random, and nothing depends on the machine: a log from a
 * picture is the same log everywhere.
 */
#include "scan.h"

#include <string.h>

#include "../core/scalar.h"

#define STEP 4 /* cells to a vote, and to a cell of the votes' own grid */

static int least(int a, int b) { return a < b ? a : b; }
static int most(int a, int b) { return a > b ? a : b; }

/* The value below which the given share of n numbers in 0..1 lies. */
static double percentile(const float *x, int n, int stride, double share) {
  int count[1024] = {0}, sum = 0, b = 0;
  for (int i = 0; i < n; i++) {
    float v = x[(long)i * stride];
    count[v < 0.0f ? 0 : v >= 1.0f ? 1023 : (int)(v * 1024.0f)]++;
  }
  while (b < 1023 && sum + count[b] < share * n) sum += count[b++];
  return (b + 0.5) / 1024.0;
}

/* ---- wood and background ---------------------------------------------- */

/* Cells of the outermost frame, as indices into the grid. */
static int frame(const scan *s, int32_t *out) {
  int n = 0;
  for (int i = 0; i < s->nx; i++) {
    out[n++] = i;
    out[n++] = (s->nz - 1) * s->nx + i;
  }
  for (int j = 1; j + 1 < s->nz; j++) {
    out[n++] = j * s->nx;
    out[n++] = j * s->nx + s->nx - 1;
  }
  return n;
}

/* Square roots of linear light are near enough to what the eye sees. */
static double difference(const float *rgb, const double colour[3]) {
  double sum = 0.0;
  for (int c = 0; c < 3; c++) {
    double d = scalar_root((double)rgb[c]) - colour[c];
    sum += d * d;
  }
  return scalar_root(sum);
}

/* Marks with `to` what is joined to cell `at` and marked `from`; returns how much. */
static int flood(scan *s, int32_t at, uint8_t from, uint8_t to) {
  int n = 0, depth = 0;
  s->wood[at] = to;
  s->stack[depth++] = at;
  while (depth) {
    int32_t k = s->stack[--depth];
    int i = k % s->nx, j = k / s->nx;
    n++;
    const int32_t next[4] = {i ? k - 1 : -1, i + 1 < s->nx ? k + 1 : -1, j ? k - s->nx : -1,
                             j + 1 < s->nz ? k + s->nx : -1};
    for (int d = 0; d < 4; d++) {
      if (next[d] < 0 || s->wood[next[d]] != from) continue;
      s->wood[next[d]] = to;
      s->stack[depth++] = next[d];
    }
  }
  return n;
}

enum { OTHER, WOOD, SEEN, LARGEST, OUTSIDE };

/* Keeps the largest piece of WOOD and fills its holes; its share of the grid. */
static double keep_largest(scan *s) {
  int cells = s->nx * s->nz, best = 0;
  int32_t where = -1;
  for (int32_t k = 0; k < cells; k++) {
    if (s->wood[k] != WOOD) continue;
    int n = flood(s, k, WOOD, SEEN);
    if (n > best) {
      best = n;
      where = k;
    }
  }
  if (where < 0) return 0.0;
  flood(s, where, SEEN, LARGEST);
  for (int32_t k = 0; k < cells; k++) {
    if (s->wood[k] == SEEN) s->wood[k] = OTHER;
  }
  for (int32_t k = 0; k < cells; k++) {
    int i = k % s->nx, j = k / s->nx;
    int edge = i == 0 || j == 0 || i + 1 == s->nx || j + 1 == s->nz;
    if (edge && s->wood[k] == OTHER) flood(s, k, OTHER, OUTSIDE);
  }
  int n = 0;
  for (int32_t k = 0; k < cells; k++) {
    s->wood[k] = s->wood[k] != OUTSIDE;
    n += s->wood[k];
  }
  return (double)n / cells;
}

int scan_wood(scan *s) {
  int cells = s->nx * s->nz, n = frame(s, s->stack);
  double colour[3];
  for (int c = 0; c < 3; c++) {
    for (int k = 0; k < n; k++)
      s->grey[k] = (float)scalar_root((double)s->rgb[3 * s->stack[k] + c]);
    colour[c] = percentile(s->grey, n, 1, 0.5);
  }
  for (int k = 0; k < n; k++) s->grey[k] = (float)difference(s->rgb + 3 * s->stack[k], colour);
  double spread = percentile(s->grey, n, 1, 0.9);
  double limit = 2.5 * spread > 0.05 ? 2.5 * spread : 0.05;
  int found = spread < 0.12;
  if (found) {
    for (int k = 0; k < cells; k++) s->wood[k] = difference(s->rgb + 3 * k, colour) > limit;
    double share = keep_largest(s);
    int touching = 0;
    n = frame(s, s->stack);
    for (int k = 0; k < n; k++) touching += s->wood[s->stack[k]];
    found = share > 0.04 && share < 0.98 && touching < n / 20;
  }
  if (!found) memset(s->wood, 1, (size_t)cells);
  return found;
}

/* ---- pith ------------------------------------------------------------- */

/* Mean over 5 x 5 cells, in place, by rows and then by columns. */
static void blur_line(float *x, int n, int stride) {
  float a[5];
  for (int k = 0; k < 3; k++) a[k] = x[0];
  for (int k = 0; k < 2; k++) a[3 + k] = x[(long)least(1 + k, n - 1) * stride];
  for (int i = 0; i < n; i++) {
    float mean = (a[0] + a[1] + a[2] + a[3] + a[4]) * 0.2f;
    for (int k = 0; k < 4; k++) a[k] = a[k + 1];
    a[4] = x[(long)least(i + 3, n - 1) * stride];
    x[(long)i * stride] = mean;
  }
}

static void blur(float *x, int nx, int nz) {
  for (int j = 0; j < nz; j++) blur_line(x + (long)j * nx, nx, 1);
  for (int i = 0; i < nx; i++) blur_line(x + i, nz, nx);
}

/* The structure tensor of brightness: the mean of the gradient's products. */
static void make_tensor(scan *s) {
  int nx = s->nx, nz = s->nz, cells = nx * nz;
  for (int k = 0; k < cells; k++) {
    const float *p = s->rgb + 3 * k;
    s->grey[k] = (float)scalar_root((double)(p[0] + p[1] + p[2]));
  }
  float *xx = s->tensor, *xz = xx + cells, *zz = xz + cells;
  for (int j = 0; j < nz; j++) {
    for (int i = 0; i < nx; i++) {
      int k = j * nx + i, left = i ? k - 1 : k, right = i + 1 < nx ? k + 1 : k;
      int up = j ? k - nx : k, down = j + 1 < nz ? k + nx : k;
      float gx = s->grey[right] - s->grey[left], gz = s->grey[down] - s->grey[up];
      xx[k] = gx * gx;
      xz[k] = gx * gz;
      zz[k] = gz * gz;
    }
  }
  for (int c = 0; c < 3; c++) {
    for (int i = 0; i < 3; i++) blur(s->tensor + (long)c * cells, nx, nz);
  }
}

/* Whether all within `margin` cells along the axes is wood: the rim itself must
 * not vote, its normals meet at the middle and not at the pith. */
static int deep_inside(const scan *s, int i, int j, int margin) {
  if (i < margin || j < margin || i + margin >= s->nx || j + margin >= s->nz) return 0;
  return s->wood[j * s->nx + i] && s->wood[j * s->nx + i - margin] &&
         s->wood[j * s->nx + i + margin] && s->wood[(j - margin) * s->nx + i] &&
         s->wood[(j + margin) * s->nx + i];
}

/* A stripe: its place, its unit normal, and how much of a stripe it is. */
typedef struct {
  double x, z, nx, nz, weight;
} stripe;

static int stripe_at(const scan *s, int i, int j, stripe *out) {
  int cells = s->nx * s->nz, k = j * s->nx + i;
  double xx = (double)s->tensor[k], xz = (double)s->tensor[cells + k];
  double zz = (double)s->tensor[2 * cells + k];
  double half = 0.5 * (xx - zz), gap = scalar_root(half * half + xz * xz), sum = xx + zz;
  if (!(sum > 1e-7) || !(gap > 0.15 * sum)) return 0;
  /* the eigenvector of the larger eigenvalue, in the form that does not cancel */
  double a = half > 0.0 ? half + gap : xz, b = half > 0.0 ? xz : gap - half;
  double l = scalar_root(a * a + b * b);
  if (!(l > 0.0)) return 0;
  double coherence = 2.0 * gap / sum;
  *out = (stripe){i + 0.5, j + 0.5, a / l, b / l,
                  coherence * coherence * coherence * coherence * scalar_root(scalar_root(sum))};
  return 1;
}

/* The votes' grid reaches half a picture beyond it on each side. */
static int votes_x(const scan *s) { return 2 * (s->nx / STEP + 1); }
static int votes_z(const scan *s) { return 2 * (s->nz / STEP + 1); }

int scan_votes(int nx, int nz) { return 4 * (nx / STEP + 1) * (nz / STEP + 1); }

/* Votes for all points along a line through the stripe. */
static void vote_along(scan *s, const stripe *q, double nx, double nz) {
  int wide = votes_x(s), high = votes_z(s);
  double x0 = q->x / STEP + wide / 4, z0 = q->z / STEP + high / 4;
  for (int side = -1; side <= 1; side += 2) {
    double x = x0, z = z0;
    for (;;) {
      x += side * nx;
      z += side * nz;
      if (x < 0.0 || z < 0.0 || x >= wide || z >= high) break;
      s->votes[(int)z * wide + (int)x] += (float)q->weight;
    }
  }
}

/* A ring's stripe points at the pith by its normal, a ray's or a flame's by its course, and which
 * it is nobody knows yet: the other line of each misses all the others'. */
static void vote(scan *s, const stripe *q) {
  vote_along(s, q, q->nx, q->nz);
  vote_along(s, q, -q->nz, q->nx);
}

static void strongest(scan *s, int inside, double out[2]) {
  int wide = votes_x(s), high = votes_z(s);
  blur(s->votes, wide, high);
  blur(s->votes, wide, high);
  float best = -1.0f;
  for (int j = 0; j < high; j++) {
    for (int i = 0; i < wide; i++) {
      double x = (i + 0.5 - wide / 4) * STEP, z = (j + 0.5 - high / 4) * STEP;
      if (inside &&
          (x < 0 || z < 0 || x >= s->nx || z >= s->nz || !s->wood[(int)z * s->nx + (int)x])) {
        continue;
      }
      if (s->votes[j * wide + i] > best) {
        best = s->votes[j * wide + i];
        out[0] = x;
        out[1] = z;
      }
    }
  }
}

#define HARMONICS 3
#define UNKNOWNS (2 + 2 * HARMONICS)

/* Gauss's elimination with the largest pivot; 0: the system says nothing. */
static int solve(double m[UNKNOWNS][UNKNOWNS + 1], int n) {
  for (int c = 0; c < n; c++) {
    int p = c;
    for (int r = c + 1; r < n; r++) {
      if (m[r][c] * m[r][c] > m[p][c] * m[p][c]) p = r;
    }
    if (!(m[p][c] * m[p][c] > 1e-20)) return 0;
    for (int k = 0; k <= n; k++) {
      double t = m[p][k];
      m[p][k] = m[c][k];
      m[c][k] = t;
    }
    for (int r = 0; r < n; r++) {
      if (r == c) continue;
      double f = m[r][c] / m[c][c];
      for (int k = c; k <= n; k++) m[r][k] -= f * m[c][k];
    }
  }
  return 1;
}

/* One step of weighted least squares on the sines of the angles by which the
 * normals miss p; what misses by far more than `angle` counts for little. A
 * pith that is off makes them miss by less the farther they are, and rings that
 * are not round, r = R (1 + w(theta)), by w' at any distance: both are fitted
 * at once, w' by its harmonics, of which there are `harmonics`. */
static int refine(const scan *s, int margin, double angle, int harmonics, double fit[UNKNOWNS],
                  double p[2]) {
  int n = 2 + 2 * harmonics;
  double m[UNKNOWNS][UNKNOWNS + 1];
  memset(m, 0, sizeof m);
  for (int j = STEP / 2; j < s->nz; j += STEP) {
    for (int i = STEP / 2; i < s->nx; i += STEP) {
      stripe q;
      if (!deep_inside(s, i, j, margin) || !stripe_at(s, i, j, &q)) continue;
      double dx = q.x - p[0], dz = q.z - p[1], r = scalar_root(dx * dx + dz * dz);
      if (r < 3.0) continue;
      double c = dx / r, d = dz / r, along = q.nx * c + q.nz * d;
      if (along * along < 0.5) q = (stripe){q.x, q.z, -q.nz, q.nx, q.weight}; /* a ray's */
      double side = q.nx * c + q.nz * d < 0.0 ? -1.0 : 1.0;
      double nx = side * q.nx, nz = side * q.nz;
      double row[UNKNOWNS + 1] = {-nz / r, nx / r};
      double ck = c, sk = d, miss = c * nz - d * nx, expected = 0.0;
      for (int k = 0; k < harmonics; k++) {
        row[2 + 2 * k] = ck;
        row[3 + 2 * k] = sk;
        expected += ck * fit[2 + 2 * k] + sk * fit[3 + 2 * k];
        double next = ck * c - sk * d;
        sk = sk * c + ck * d;
        ck = next;
      }
      row[n] = -miss;
      double off = (miss + expected) / angle, weight = q.weight / (1.0 + off * off);
      for (int a = 0; a < n; a++) {
        for (int b = 0; b <= n; b++) m[a][b] += weight * row[a] * row[b];
      }
    }
  }
  if (!solve(m, n)) return 0;
  for (int a = 0; a < n; a++) fit[a] = m[a][n] / m[a][a];
  p[0] += fit[0];
  p[1] += fit[1];
  return 1;
}

static int inside_picture(const scan *s, const double p[2]) {
  return p[0] > 0.0 && p[1] > 0.0 && p[0] < s->nx && p[1] < s->nz;
}

int scan_pith(scan *s, int inside, double out[2]) {
  make_tensor(s);
  int margin = inside ? most(least(s->nx, s->nz) / 25, 2) : 2, count = 0;
  memset(s->votes, 0, (size_t)scan_votes(s->nx, s->nz) * sizeof *s->votes);
  for (int j = STEP / 2; j < s->nz; j += STEP) {
    for (int i = STEP / 2; i < s->nx; i += STEP) {
      stripe q;
      if (!deep_inside(s, i, j, margin) || !stripe_at(s, i, j, &q)) continue;
      vote(s, &q);
      count++;
    }
  }
  if (count < 24) return 0;
  strongest(s, inside, out);
  double fit[UNKNOWNS] = {0};
  for (int i = 0; i < 12; i++) {
    /* with the pith outside, all is seen from one side: the harmonics would say
     * whatever the pith does */
    int harmonics = i >= 4 && inside_picture(s, out) ? HARMONICS : 0;
    if (!refine(s, margin, i < 4 ? 0.3 : 0.12, harmonics, fit, out)) break;
  }
  double limit = 4.0 * (s->nx + s->nz);
  return out[0] > -limit && out[0] < limit && out[1] > -limit && out[1] < limit;
}

/* ---- rim -------------------------------------------------------------- */

static int is_wood(const scan *s, double x, double z) {
  return x >= 0.0 && z >= 0.0 && x < s->nx && z < s->nz && s->wood[(int)z * s->nx + (int)x];
}

static float middle_of_five(const float *x, int i, int n) {
  float a[5];
  for (int k = 0; k < 5; k++) {
    float v = x[(i + k - 2 + n) % n];
    int j = k;
    for (; j > 0 && a[j - 1] > v; j--) a[j] = a[j - 1];
    a[j] = v;
  }
  return a[2];
}

int scan_rim(const scan *s, const double pith[2], int count, float *out) {
  if (count > 512 || !is_wood(s, pith[0], pith[1])) return 0;
  float raw[512];
  double farthest = s->nx + s->nz;
  for (int k = 0; k < count; k++) {
    double angle = 6.28318530717958647692 * k / count;
    double c = scalar_cos(angle), n = scalar_sin(angle), r = farthest;
    while (r > 0.0 && !is_wood(s, pith[0] + r * c, pith[1] + r * n)) r -= 0.5;
    raw[k] = (float)r;
  }
  /* a crack at the edge or a speck on the background is no rim */
  for (int k = 0; k < count; k++) out[k] = middle_of_five(raw, k, count);
  return 1;
}
