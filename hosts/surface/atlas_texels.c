/* SPDX-License-Identifier: Apache-2.0
 *
 * Block by block: the few triangles that meet a block are gathered once and
 * tried in turn for each of its texels; a block of many is quartered first.
 * What none of them contains is looked up in the tree. */
#include "atlas_parts.h"

#include <math.h>

#define BLOCK 8 /* texels */
#define MOST_GATHERED 32
#define BEYOND 2.0 /* texels that a point goes on past a border */
#define MOST_STRETCH                                                                               \
  4.0 /* of what BEYOND moves a point, over the square root of the texels' area */
#define LARGEST 1048576u
#define FAR_FOOTPRINT 1e4f

typedef struct vec3 {
  double x, y, z;
} vec3;

static vec3 load(const float *array, uint32_t i) {
  const float *p = array + 3 * (size_t)i;
  return (vec3){(double)p[0], (double)p[1], (double)p[2]};
}
static vec3 sub(vec3 a, vec3 b) { return (vec3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static vec3 add(vec3 a, vec3 b) { return (vec3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static vec3 scaled(double s, vec3 a) { return (vec3){s * a.x, s * a.y, s * a.z}; }
static vec3 cross(vec3 a, vec3 b) {
  return (vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static double length(vec3 a) { return sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

/* ---- a place on a triangle ----------------------------------------------- */

/* A face with what it is in space: point = origin + X across + Y down, where
 * (X, Y) counts texels from corner 0. */
typedef struct patch {
  atlas_face face;
  const uint32_t *corner;
  vec3 origin, across, down;
  double footprint;
} patch;

static void patch_of(patch *p, const mesh *m) {
  const atlas_face *f = &p->face;
  p->corner = m->indices + 3 * (size_t)f->index;
  p->origin = load(m->points, p->corner[0]);
  vec3 a = sub(load(m->points, p->corner[1]), p->origin);
  vec3 b = sub(load(m->points, p->corner[2]), p->origin);
  p->across = scaled(1 / f->area, sub(scaled(f->y[2] - f->y[0], a), scaled(f->y[1] - f->y[0], b)));
  p->down = scaled(1 / f->area, sub(scaled(f->x[1] - f->x[0], b), scaled(f->x[2] - f->x[0], a)));
  p->footprint = sqrt(length(cross(p->across, p->down)));
}

static vec3 point_at(const patch *p, double x, double y) {
  vec3 move = add(scaled(x - p->face.x[0], p->across), scaled(y - p->face.y[0], p->down));
  return add(p->origin, move);
}

/* The corners' normals where they have any, else the triangle's own. */
static vec3 normal_at(const patch *p, const mesh *m, double x, double y) {
  const atlas_face *f = &p->face;
  double b = ((x - f->x[0]) * (f->y[2] - f->y[0]) - (f->x[2] - f->x[0]) * (y - f->y[0])) / f->area;
  double c = ((f->x[1] - f->x[0]) * (y - f->y[0]) - (x - f->x[0]) * (f->y[1] - f->y[0])) / f->area;
  vec3 n = add(
      scaled(1 - b - c, load(m->normals, p->corner[0])),
      add(scaled(b, load(m->normals, p->corner[1])), scaled(c, load(m->normals, p->corner[2]))));
  if (!(length(n) > 1e-6))
    n = cross(sub(load(m->points, p->corner[1]), p->origin),
              sub(load(m->points, p->corner[2]), p->origin));
  double l = length(n);
  return l > 0 ? scaled(1 / l, n) : (vec3){0, 0, 1};
}

static void put_vec(float *const to[3], size_t i, vec3 v) {
  if (!to[0]) return;
  to[0][i] = (float)v.x, to[1][i] = (float)v.y, to[2][i] = (float)v.z;
}

/* p: NULL far from all of them. */
static void put(const surface_room *out, size_t i, vec3 point, vec3 normal, const patch *p,
                uint8_t covered) {
  const vec3 none = {0, 0, 0};
  put_vec(out->point, i, point);
  put_vec(out->normal, i, normal);
  put_vec(out->across, i, p ? p->across : none);
  put_vec(out->down, i, p ? p->down : none);
  out->footprint[i] = p ? (float)fmin(p->footprint, (double)FAR_FOOTPRINT) : FAR_FOOTPRINT;
  out->covered[i] = covered;
}

static void put_inside(const atlas *a, const patch *p, double x, double y, const surface_room *out,
                       size_t i) {
  put(out, i, point_at(p, x, y), normal_at(p, &a->mesh, x, y), p, 1);
}

/* Past the border of a triangle: at[] is its nearest point. */
static void put_beside(const atlas *a, const patch *p, double x, double y, const atlas_found *found,
                       const surface_room *out, size_t i) {
  double distance = sqrt(found->distance2);
  double share = distance > BEYOND ? BEYOND / distance : 1;
  vec3 border = point_at(p, found->at[0], found->at[1]);
  vec3 move = add(scaled(share * (x - found->at[0]), p->across),
                  scaled(share * (y - found->at[1]), p->down));
  double limit = MOST_STRETCH * BEYOND * p->footprint, moved = length(move);
  if (moved > limit) move = scaled(limit / moved, move);
  uint8_t covered = distance < 1e-6 ? 1 : 2; /* between two triangles, by rounding */
  put(out, i, add(border, move), normal_at(p, &a->mesh, found->at[0], found->at[1]), p, covered);
}

static void put_far(const atlas *a, const surface_room *out, size_t i) {
  vec3 middle = {(double)a->middle[0], (double)a->middle[1], (double)a->middle[2]};
  put(out, i, middle, (vec3){0, 0, 1}, NULL, 0);
}

/* ---- texels --------------------------------------------------------------- */

static void look_up(const atlas *a, const atlas_view *v, double x, double y,
                    const surface_room *out, size_t i) {
  atlas_found found = {.distance2 = ATLAS_DILATION * ATLAS_DILATION};
  patch p;
  if (!atlas_tree_nearest(&a->tree, &a->mesh, v, x, y, &found)) {
    put_far(a, out, i);
    return;
  }
  atlas_face_of(&p.face, &a->mesh, v, found.index);
  patch_of(&p, &a->mesh);
  if (found.distance2 == 0)
    put_inside(a, &p, x, y, out, i);
  else
    put_beside(a, &p, x, y, &found, out, i);
}

typedef struct rectangle {
  uint32_t x, y, w, h;
} rectangle;

static atlas_box centres_of(rectangle r, double margin) {
  return (atlas_box){{r.x + 0.5 - margin, r.y + 0.5 - margin},
                     {r.x + r.w - 0.5 + margin, r.y + r.h - 0.5 + margin}};
}

/* Where a rectangle's texels stand in the arrays. */
typedef struct target {
  const surface_room *room;
  size_t first, stride;
} target;

static size_t index_of(const target *t, uint32_t column, uint32_t row) {
  return t->first + row * t->stride + column;
}

static void fill_far(const atlas *a, rectangle r, const target *t) {
  for (uint32_t row = 0; row < r.h; row++)
    for (uint32_t column = 0; column < r.w; column++) put_far(a, t->room, index_of(t, column, row));
}

static void fill_from(const atlas *a, const atlas_view *v, rectangle r, const uint32_t *triangles,
                      uint32_t count, const target *t) {
  patch patches[MOST_GATHERED];
  for (uint32_t k = 0; k < count; k++) {
    atlas_face_of(&patches[k].face, &a->mesh, v, triangles[k]);
    patch_of(&patches[k], &a->mesh);
  }
  for (uint32_t row = 0; row < r.h; row++)
    for (uint32_t column = 0; column < r.w; column++) {
      size_t i = index_of(t, column, row);
      double x = r.x + column + 0.5, y = r.y + row + 0.5;
      uint32_t k = 0;
      while (k < count && !atlas_face_contains(&patches[k].face, x, y)) k++;
      if (k < count)
        put_inside(a, &patches[k], x, y, t->room, i);
      else
        look_up(a, v, x, y, t->room, i);
    }
}

static void fill_block(const atlas *a, const atlas_view *v, rectangle r, const target *t) {
  uint32_t found[MOST_GATHERED];
  atlas_box box = centres_of(r, 0), around = centres_of(r, ATLAS_DILATION);
  uint32_t count = atlas_tree_gather(&a->tree, &a->mesh, v, &box, found, MOST_GATHERED);
  if (count == 0 && atlas_tree_gather(&a->tree, &a->mesh, v, &around, found, 0) == 0)
    fill_far(a, r, t);
  else if (count <= MOST_GATHERED)
    fill_from(a, v, r, found, count, t);
  else if (r.w == 1 && r.h == 1)
    look_up(a, v, r.x + 0.5, r.y + 0.5, t->room, t->first);
  else /* quarters, or halves of what is one texel wide */
    for (uint32_t row = 0, h = (r.h + 1) / 2; row < r.h; row += h)
      for (uint32_t column = 0, w = (r.w + 1) / 2; column < r.w; column += w) {
        rectangle part = {r.x + column, r.y + row, r.w - column < w ? r.w - column : w,
                          r.h - row < h ? r.h - row : h};
        target at = {t->room, index_of(t, column, row), t->stride};
        fill_block(a, v, part, &at);
      }
}

static bool has_tile(const atlas *a, int udim) {
  if (udim < 1001 || udim > ATLAS_LAST) return false;
  return a->reached[(udim - 1001) / 10] >> ((udim - 1001) % 10) & 1;
}

bool atlas_texels(const atlas *a, int udim, uint32_t width, uint32_t height, uint32_t x, uint32_t y,
                  uint32_t w, uint32_t h, const surface_room *out) {
  if (!has_tile(a, udim) || width > LARGEST || height > LARGEST || w > width || x > width - w ||
      h > height || y > height - h)
    return false;
  int i = (udim - 1001) % 10, j = (udim - 1001) / 10;
  atlas_view view = {i, j + 1, width, height};
  for (uint32_t row = 0; row < h; row += BLOCK)
    for (uint32_t column = 0; column < w; column += BLOCK) {
      rectangle r = {x + column, y + row, w - column < BLOCK ? w - column : BLOCK,
                     h - row < BLOCK ? h - row : BLOCK};
      target t = {out, (size_t)row * w + column, w};
      fill_block(a, &view, r, &t);
    }
  return true;
}
