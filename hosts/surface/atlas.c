/* SPDX-License-Identifier: Apache-2.0 */
#include "atlas_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_UV 1e6 /* beyond, a float has no room for a tile's texels */
#define SLIVER 1e-7 /* height over length: what is left of a float's digits */
#define BORDER 1e-5 /* UVs that miss a tile's border by this are on it */

/* A triangle's corners in UV. */
typedef struct corners {
  double u[3], v[3];
} corners;

static corners corners_of(const mesh *m, uint32_t triangle) {
  corners c;
  for (size_t k = 0; k < 3; k++) {
    const float *uv = m->uvs + 2 * (size_t)m->indices[3 * (size_t)triangle + k];
    c.u[k] = (double)uv[0];
    c.v[k] = (double)uv[1];
  }
  return c;
}

static bool has_numbers(const corners *c) {
  for (int k = 0; k < 3; k++)
    if (isnan(c->u[k]) || isnan(c->v[k])) return false;
  return true;
}

static bool in_range(const corners *c) {
  for (int k = 0; k < 3; k++)
    if (fabs(c->u[k]) > MOST_UV || fabs(c->v[k]) > MOST_UV) return false;
  return true;
}

static bool has_area(const corners *c) {
  double longest = 0;
  for (int a = 0; a < 3; a++) {
    int b = (a + 1) % 3;
    longest = fmax(longest, (c->u[b] - c->u[a]) * (c->u[b] - c->u[a]) +
                                (c->v[b] - c->v[a]) * (c->v[b] - c->v[a]));
  }
  double area =
      (c->u[1] - c->u[0]) * (c->v[2] - c->v[0]) - (c->u[2] - c->u[0]) * (c->v[1] - c->v[0]);
  return fabs(area) > SLIVER * longest;
}

static double least(const double a[3]) { return fmin(a[0], fmin(a[1], a[2])); }
static double most(const double a[3]) { return fmax(a[0], fmax(a[1], a[2])); }

static bool in_some_tile(const corners *c) {
  return least(c->u) < ATLAS_ACROSS && most(c->u) > 0 && least(c->v) < ATLAS_UP && most(c->v) > 0;
}

/* ---- tiles ------------------------------------------------------------- */

/* Whether all of the box lies beyond one side of the triangle. */
static bool parted(const corners *c, double u0, double v0, double u1, double v1) {
  double area =
      (c->u[1] - c->u[0]) * (c->v[2] - c->v[0]) - (c->u[2] - c->u[0]) * (c->v[1] - c->v[0]);
  double sign = area > 0 ? 1 : -1;
  for (int a = 0; a < 3; a++) {
    int b = (a + 1) % 3;
    double du = sign * (c->u[b] - c->u[a]), dv = sign * (c->v[b] - c->v[a]);
    double u = dv > 0 ? u0 : u1, v = du > 0 ? v1 : v0; /* the box's corner farthest inwards */
    if (du * (v - c->v[a]) - dv * (u - c->u[a]) <= 0) return true;
  }
  return false;
}

static int clamp(double x, int low, int high) { return x < low ? low : x > high ? high : (int)x; }

static void reach(atlas *a, const corners *c) {
  int i0 = clamp(floor(least(c->u) + BORDER), 0, ATLAS_ACROSS);
  int j0 = clamp(floor(least(c->v) + BORDER), 0, ATLAS_UP);
  int i1 = clamp(ceil(most(c->u) - BORDER), 0, ATLAS_ACROSS);
  int j1 = clamp(ceil(most(c->v) - BORDER), 0, ATLAS_UP);
  unsigned row = (1u << i1) - (1u << (i0 < i1 ? i0 : i1)); /* bits i0 to i1 - 1 */
  for (int j = j0; j < j1; j++) {
    if ((a->reached[j] & row) == row) continue;
    for (int i = i0; i < i1; i++)
      if (1001 + i + 10 * j <= ATLAS_LAST &&
          !parted(c, i + BORDER, j + BORDER, i + 1 - BORDER, j + 1 - BORDER))
        a->reached[j] |= (uint16_t)(1u << i);
  }
}

static bool list_tiles(atlas *a, const char *path, failure *why) {
  a->udims = malloc(sizeof *a->udims * ATLAS_ACROSS * ATLAS_UP);
  if (!a->udims) return fail(why, EXIT_FAILURE, "out of memory");
  for (int j = 0; j < ATLAS_UP; j++)
    for (int i = 0; i < ATLAS_ACROSS; i++)
      if (a->reached[j] >> i & 1) a->udims[a->udim_count++] = 1001 + i + 10 * j;
  if (a->udim_count > 0) return true;
  return fail(why, EXIT_BAD_INPUT,
              "mesh '%s': none of its UVs lie in a tile (u 0 to 10, v from 0 up)", path);
}

uint32_t atlas_udim_count(const atlas *a) { return a->udim_count; }
int atlas_udim(const atlas *a, uint32_t k) { return k < a->udim_count ? a->udims[k] : 0; }

const mesh *atlas_mesh(const atlas *a) { return &a->mesh; }

/* ---- opening ----------------------------------------------------------- */

/* The triangles of use, and a count of the others. */
static uint32_t choose(atlas *a, uint32_t *keep) {
  uint32_t count = 0;
  a->counts.triangles = a->mesh.triangle_count;
  for (uint32_t i = 0; i < a->mesh.triangle_count; i++) {
    corners c = corners_of(&a->mesh, i);
    if (!has_numbers(&c))
      a->counts.without++;
    else if (!in_range(&c))
      a->counts.afar++;
    else if (!has_area(&c))
      a->counts.degenerate++;
    else if (!in_some_tile(&c))
      a->counts.outside++;
    else {
      reach(a, &c);
      keep[count++] = i;
    }
  }
  return count;
}

/* Charts that share texels overlap with their middles more often than not. */
static void count_hidden(atlas *a) {
  for (uint32_t k = 0; k < a->tree.count; k++) {
    uint32_t i = a->tree.order[k];
    corners c = corners_of(&a->mesh, i);
    double u = (c.u[0] + c.u[1] + c.u[2]) / 3, v = (c.v[0] + c.v[1] + c.v[2]) / 3;
    atlas_view view = {floor(u), floor(v) + 1, 1, 1};
    atlas_found found = {.distance2 = 0};
    a->counts.hidden +=
        atlas_tree_nearest(&a->tree, &a->mesh, &view, u - view.left, view.top - v, &found) &&
        found.index < i;
  }
}

static void find_middle(atlas *a) {
  for (size_t k = 0; k < 3; k++) {
    float low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < a->mesh.point_count; i++) {
      low = fminf(low, a->mesh.points[3 * i + k]);
      high = fmaxf(high, a->mesh.points[3 * i + k]);
    }
    a->middle[k] = 0.5f * low + 0.5f * high;
  }
}

static void count_bytes(atlas *a) {
  uint64_t floats = (uint64_t)a->mesh.point_count * 8 + (uint64_t)a->mesh.triangle_count * 3;
  a->counts.bytes = sizeof *a + 4 * floats + 4 * (uint64_t)a->tree.count +
                    2 * (uint64_t)a->tree.leaves * sizeof *a->tree.nodes +
                    sizeof *a->udims * ATLAS_ACROSS * ATLAS_UP;
}

static bool unwrap(atlas *a, const char *path, failure *why) {
  if (!a->mesh.uvs)
    return fail(why, EXIT_BAD_INPUT, "mesh '%s' has no UVs: unwrap it, and export them with it",
                path);
  uint32_t *keep = malloc(sizeof *keep * ((size_t)a->mesh.triangle_count + 1));
  if (!keep) return fail(why, EXIT_FAILURE, "out of memory");
  uint32_t count = choose(a, keep);
  bool ok = true;
  if (count == 0) {
    char text[256];
    atlas_warning(a, text, sizeof text);
    ok = fail(why, EXIT_BAD_INPUT, "mesh '%s': no triangle has UVs of use: %s", path, text);
  }
  ok = ok && (atlas_tree_build(&a->tree, &a->mesh, keep, count) ||
              fail(why, EXIT_FAILURE, "out of memory for the UVs of %u triangles", count));
  free(keep);
  return ok && list_tiles(a, path, why);
}

bool atlas_open(atlas **out, const char *path, double scale, failure *why) {
  *out = NULL;
  atlas *a = calloc(1, sizeof *a);
  if (!a) return fail(why, EXIT_FAILURE, "out of memory");
  if (!mesh_read(&a->mesh, path, scale, why) || !unwrap(a, path, why)) {
    atlas_close(a);
    return false;
  }
  count_hidden(a);
  find_middle(a);
  count_bytes(a);
  *out = a;
  return true;
}

void atlas_close(atlas *a) {
  if (!a) return;
  mesh_free(&a->mesh);
  atlas_tree_free(&a->tree);
  free(a->udims);
  free(a);
}

/* ---- what is amiss ------------------------------------------------------- */

const atlas_counts *atlas_counts_of(const atlas *a) { return &a->counts; }

bool atlas_warning(const atlas *a, char *text, size_t size) {
  const struct {
    uint32_t count;
    const char *what;
  } rows[] = {{a->counts.without, "without UVs"},
              {a->counts.afar, "with UVs past 1000000"},
              {a->counts.degenerate, "without area in UV space"},
              {a->counts.outside, "outside every UDIM tile"},
              {a->counts.hidden, "lying over earlier ones, which are shown instead"}};
  size_t used = 0;
  if (size > 0) text[0] = '\0';
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
    if (rows[i].count == 0 || used >= size) continue;
    int length = used > 0
                     ? snprintf(text + used, size - used, ", %u %s", rows[i].count, rows[i].what)
                     : snprintf(text, size, "of %u triangles %u %s", a->counts.triangles,
                                rows[i].count, rows[i].what);
    used += length > 0 ? (size_t)length : 0;
  }
  return used > 0;
}
