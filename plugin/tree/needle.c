/* SPDX-License-Identifier: Apache-2.0 */
#include "leaf_shapes.h"

/* Three round its base, and its tip. */
static void awl_points(mesh_pen *pen, const leaf_frame *f, uint32_t out[4]) {
  float r = f->half;
  out[0] = leaf_at(pen, f, r, 0, 0, 1, 0, 0);
  out[1] = leaf_at(pen, f, -0.5f * r, 0, 0.866f * r, -0.5f, 0, 0.8660254f);
  out[2] = leaf_at(pen, f, -0.5f * r, 0, -0.866f * r, -0.5f, 0, -0.8660254f);
  out[3] = leaf_at(pen, f, 0, f->length, 0, 0, 1, 0);
}

static void write_awl(mesh_pen *pen, const leaf_frame *f) {
  uint32_t p[4];
  awl_points(pen, f, p);
  pen_triangle(pen, p[0], p[1], p[2]);
  pen_triangle(pen, p[0], p[3], p[1]);
  pen_triangle(pen, p[1], p[3], p[2]);
  pen_triangle(pen, p[2], p[3], p[0]);
}

/* Of thin sheets that hang together what is seen from all around is that of the
 * body they would wrap: as much as of the awl. */
static void write_gutter(mesh_pen *pen, const leaf_frame *f) {
  uint32_t p[4];
  awl_points(pen, f, p);
  pen_triangle(pen, p[0], p[3], p[1]);
  pen_triangle(pen, p[1], p[3], p[2]);
}

/* As broad as the awl that it stands for from all around: of a closed body that is in the mean a
 * quarter of its surface, of a sheet half of its area. */
#define SLIVER_WIDER 1.299f /* 3 sqrt(3) / 4, for thin ones */

static void write_sliver(mesh_pen *pen, const leaf_frame *awl, const leaf_shape *s) {
  leaf_frame f = *awl;
  float blunt = 0.5f * (f.half / s->wider) / (f.length / s->longer);
  if (!(f.length > 0.0f)) blunt = 0.0f;
  f.half *= SLIVER_WIDER * (__builtin_sqrtf(1.0f + blunt * blunt) + blunt);
  uint32_t a = leaf_at(pen, &f, -f.half, 0, 0, 0, 0, 1),
           b = leaf_at(pen, &f, f.half, 0, 0, 0, 0, 1),
           c = leaf_at(pen, &f, 0, f.length, 0, 0, 0, 1);
  pen_triangle(pen, a, b, c);
}

#define CORE 0.55f /* of a sprig's half width */

/* A quarter of its surface: twice three sides of a width of sqrt(3) r. */
static float core_hides(float r, float length) {
  float up = __builtin_sqrtf(0.49f * length * length + 0.25f * r * r);
  float down = __builtin_sqrtf(0.09f * length * length + 0.25f * r * r);
  return 0.6495f * r * (up + down);
}

/* What a sprig's awls hide beside its core, in squares of its half width. */
#define AWLS_HIDE 0.5f

/* How wide a core hides as much alone as so many sprigs. */
static float core_alone(const leaf_frame *f, const leaf_shape *s) {
  float half = f->half / s->wider, hides = core_hides(CORE * half, f->length / s->longer);
  hides = (hides + AWLS_HIDE * half * half) * (float)s->stride;
  float r = CORE * f->half;
  for (int i = 0; i < 4 && r > 0.0f; i++) {
    float now = core_hides(r, f->length);
    r *= now > 0.0f ? hides / now : 1.0f;
  }
  return r;
}

static void write_core(mesh_pen *pen, const leaf_frame *f, float r) {
  float m = 0.3f * f->length;
  uint32_t base = leaf_at(pen, f, 0, 0, 0, 0, -1, 0), a = leaf_at(pen, f, r, m, 0, 1, 0, 0),
           b = leaf_at(pen, f, -0.5f * r, m, 0.866f * r, -0.5f, 0, 0.8660254f),
           c = leaf_at(pen, f, -0.5f * r, m, -0.866f * r, -0.5f, 0, -0.8660254f),
           tip = leaf_at(pen, f, 0, f->length, 0, 0, 1, 0);
  pen_triangle(pen, a, b, base);
  pen_triangle(pen, b, c, base);
  pen_triangle(pen, c, a, base);
  pen_triangle(pen, a, tip, b);
  pen_triangle(pen, b, tip, c);
  pen_triangle(pen, c, tip, a);
}

/* cos and sin of i times 137.5 degrees */
static const float golden[SPRIG_AWLS][2] = {{1.0f, 0.0f},
                                            {-0.737277f, 0.675590f},
                                            {0.087426f, -0.996171f},
                                            {0.608439f, 0.793601f},
                                            {-0.984713f, -0.174182f},
                                            {0.843755f, -0.536728f},
                                            {-0.259604f, 0.965715f},
                                            {-0.460970f, -0.887416f},
                                            {0.939321f, 0.343039f},
                                            {-0.924116f, 0.382113f},
                                            {0.423362f, -0.905961f},
                                            {0.299745f, 0.954019f}};

/* Needles stand out from the shoot and bend along it: some of them, larger. */
static void write_sprig(mesh_pen *pen, const leaf_frame *f, int awls, float wide) {
  write_core(pen, f, CORE * f->half);
  for (int i = 0; i < awls; i++) {
    float s = ((float)i + 0.5f) / (float)awls, x = golden[i][0], z = golden[i][1];
    float from = s * 0.86f * f->length, narrow = 1.0f - 0.45f * s, out = f->half * narrow;
    float reach = 1.5f * f->half * narrow, w = wide * f->half * narrow;
    /* out and forward from the core; its width round the shoot */
    uint32_t a = leaf_at(pen, f, -w * z, from, w * x, x, 0, z),
             b = leaf_at(pen, f, w * z, from, -w * x, x, 0, z),
             tip = leaf_at(pen, f, out * x, from + reach, out * z, 0.8f * x, -0.6f, 0.8f * z);
    pen_triangle(pen, a, tip, b);
  }
}

void needle_write(mesh_pen *pen, const leaf_frame *f, const leaf_shape *s) {
  switch (s->shape) {
  case SHAPE_AWL:
    write_awl(pen, f);
    break;
  case SHAPE_GUTTER:
    write_gutter(pen, f);
    break;
  case SHAPE_SLIVER:
    write_sliver(pen, f, s);
    break;
  case SHAPE_SPRIG:
    write_sprig(pen, f, SPRIG_AWLS, 0.3f);
    break;
  case SHAPE_SPARSE:
    write_sprig(pen, f, SPARSE_AWLS, 0.5f); /* they overlap less */
    break;
  default:
    write_core(pen, f, core_alone(f, s));
    break;
  }
}
