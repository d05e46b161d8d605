/* SPDX-License-Identifier: Apache-2.0 */
#include "leaf_shapes.h"

static void write_blade(mesh_pen *pen, const leaf_frame *f) {
  float w = f->half, l = f->length, fold = 0.25f * w;
  float m1 = -0.03f * l, m2 = -0.06f * l, m3 = -0.14f * l; /* it nods */
  uint32_t base = leaf_at(pen, f, 0, 0, 0, 0, 0.1f, 0.995f),
           l1 = leaf_at(pen, f, -0.92f * w, 0.32f * l, m1 + fold, 0.24f, 0, 0.97f),
           l2 = leaf_at(pen, f, -0.8f * w, 0.62f * l, m2 + fold, 0.24f, 0, 0.97f),
           r1 = leaf_at(pen, f, 0.92f * w, 0.32f * l, m1 + fold, -0.24f, 0, 0.97f),
           r2 = leaf_at(pen, f, 0.8f * w, 0.62f * l, m2 + fold, -0.24f, 0, 0.97f),
           c1 = leaf_at(pen, f, 0, 0.32f * l, m1, 0, 0, 1),
           c2 = leaf_at(pen, f, 0, 0.62f * l, m2, 0, 0, 1),
           tip = leaf_at(pen, f, 0, l, m3, 0, 0.1f, 0.995f);
  pen_triangle(pen, base, c1, l1);
  pen_triangle(pen, l1, c1, c2);
  pen_triangle(pen, l1, c2, l2);
  pen_triangle(pen, l2, c2, tip);
  pen_triangle(pen, base, r1, c1);
  pen_triangle(pen, r1, c2, c1);
  pen_triangle(pen, r1, r2, c2);
  pen_triangle(pen, r2, tip, c2);
}

/* Its outline, flat across but nodding. */
static void write_flat(mesh_pen *pen, const leaf_frame *f) {
  float w = f->half, l = f->length, fold = 0.125f * w;
  uint32_t base = leaf_at(pen, f, 0, 0, 0, 0, 0.1f, 0.995f),
           l1 = leaf_at(pen, f, -0.92f * w, 0.32f * l, -0.03f * l + fold, 0, 0, 1),
           l2 = leaf_at(pen, f, -0.8f * w, 0.62f * l, -0.06f * l + fold, 0, 0, 1),
           r1 = leaf_at(pen, f, 0.92f * w, 0.32f * l, -0.03f * l + fold, 0, 0, 1),
           r2 = leaf_at(pen, f, 0.8f * w, 0.62f * l, -0.06f * l + fold, 0, 0, 1),
           tip = leaf_at(pen, f, 0, l, -0.14f * l, 0, 0.1f, 0.995f);
  pen_triangle(pen, base, r1, l1);
  pen_triangle(pen, l1, r1, r2);
  pen_triangle(pen, l1, r2, l2);
  pen_triangle(pen, l2, r2, tip);
}

/* Of an oak's, from the stalk up, of the right side. */
static const float teeth[TEETH_POINTS][2] = {
    {0.52f, 0.22f}, {0.42f, 0.34f}, {0.92f, 0.50f}, {0.72f, 0.60f}, {0.88f, 0.78f}};
#define NODS 0.14f /* of its length, at its tip */

static uint32_t folded(mesh_pen *pen, const leaf_frame *f, float x, float y, float fold) {
  float out = x < 0.0f ? -x : x, lean = x > 0.0f ? -fold : x < 0.0f ? fold : 0.0f;
  float z = fold * out * f->half - NODS * y * y * f->length;
  return leaf_at(pen, f, x * f->half, y * f->length, z, lean, 0,
                 __builtin_sqrtf(1.0f - lean * lean));
}

static void write_toothed(mesh_pen *pen, const leaf_frame *f) {
  const float fold = 0.24f;
  uint32_t base = folded(pen, f, 0, 0, fold), low = folded(pen, f, 0, 0.34f, fold),
           high = folded(pen, f, 0, 0.62f, fold), tip = folded(pen, f, 0, 1, fold);
  for (int left = 0; left < 2; left++) {
    uint32_t last = base;
    for (uint32_t i = 0; i <= TEETH_POINTS; i++) {
      const float *q = teeth[i < TEETH_POINTS ? i : 0];
      uint32_t next = i < TEETH_POINTS ? folded(pen, f, left ? -q[0] : q[0], q[1], fold) : tip;
      uint32_t middle = i < 3 ? low : high;
      pen_triangle(pen, middle, left ? next : last, left ? last : next);
      last = next;
      if (i == 2) pen_triangle(pen, low, left ? high : last, left ? last : high);
    }
  }
}

/* Of as large an area. */
static const float rounded[3][2] = {{0.485f, 0.28f}, {0.873f, 0.52f}, {0.834f, 0.78f}};

static void write_obovate(mesh_pen *pen, const leaf_frame *f) {
  const float fold = 0.12f;
  uint32_t left = folded(pen, f, 0, 0, fold), right = left, base = left;
  for (uint32_t i = 0; i < 3; i++) {
    uint32_t l = folded(pen, f, -rounded[i][0], rounded[i][1], fold),
             r = folded(pen, f, rounded[i][0], rounded[i][1], fold);
    if (right != base) pen_triangle(pen, left, right, r);
    pen_triangle(pen, left, r, l);
    left = l, right = r;
  }
  pen_triangle(pen, left, right, folded(pen, f, 0, 1, fold));
}

static void write_diamond(mesh_pen *pen, const leaf_frame *f) {
  float w = f->half * 0.9f, l = f->length;
  uint32_t base = leaf_at(pen, f, 0, 0, 0, 0, 0, 1), a = leaf_at(pen, f, -w, 0.45f * l, 0, 0, 0, 1),
           b = leaf_at(pen, f, w, 0.45f * l, 0, 0, 0, 1), tip = leaf_at(pen, f, 0, l, 0, 0, 0, 1);
  pen_triangle(pen, base, b, a);
  pen_triangle(pen, a, b, tip);
}

static void write_fan(mesh_pen *pen, const leaf_frame *f, const float (*outline)[2],
                      uint32_t count) {
  uint32_t first = 0;
  for (uint32_t i = 0; i < count; i++) {
    uint32_t p = leaf_at(pen, f, outline[i][0] * f->half, outline[i][1] * f->length, 0, 0, 0, 1);
    if (i == 0) first = p;
  }
  for (uint32_t i = 1; i + 1 < count; i++) pen_triangle(pen, first, first + i, first + i + 1);
}

/* Anticlockwise from the stalk's end. */
static const float ellipse[ELLIPSE_POINTS][2] = {
    {0.0f, 0.0f},        {0.5f, 0.066987f}, {0.866025f, 0.25f},  {1.0f, 0.5f},
    {0.866025f, 0.75f},  {0.5f, 0.933013f}, {0.0f, 1.0f},        {-0.5f, 0.933013f},
    {-0.866025f, 0.75f}, {-1.0f, 0.5f},     {-0.866025f, 0.25f}, {-0.5f, 0.066987f}};
static const float hand[HAND_POINTS][2] = {
    {0.0f, 0.08f},   {0.62f, -0.02f}, {0.40f, 0.20f},  {1.0f, 0.42f},   {0.42f, 0.42f},
    {0.60f, 0.80f},  {0.20f, 0.56f},  {0.0f, 1.0f},    {-0.20f, 0.56f}, {-0.60f, 0.80f},
    {-0.42f, 0.42f}, {-1.0f, 0.42f},  {-0.40f, 0.20f}, {-0.62f, -0.02f}};

static const float six[SIX_POINTS][2] = {{0.0f, 0.0f}, {1.07f, 0.3f},  {1.07f, 0.7f},
                                         {0.0f, 1.0f}, {-1.07f, 0.7f}, {-1.07f, 0.3f}};
static const float three[THREE_POINTS][2] = {{0.0f, 0.0f},   {0.95f, 0.2f}, {0.3f, 0.42f},
                                             {0.33f, 0.75f}, {0.0f, 1.0f},  {-0.33f, 0.75f},
                                             {-0.3f, 0.42f}, {-0.95f, 0.2f}};
static const float five[FIVE_POINTS][2] = {
    {0.3f, 0.0f}, {0.62f, 0.45f}, {0.0f, 1.0f}, {-0.62f, 0.45f}, {-0.3f, 0.0f}};

void blade_write(mesh_pen *pen, const leaf_frame *f, int shape) {
  switch (shape) {
  case SHAPE_BLADE:
    write_blade(pen, f);
    break;
  case SHAPE_FLAT:
    write_flat(pen, f);
    break;
  case SHAPE_DIAMOND:
    write_diamond(pen, f);
    break;
  case SHAPE_ELLIPSE:
    write_fan(pen, f, ellipse, ELLIPSE_POINTS);
    break;
  case SHAPE_SIX:
    write_fan(pen, f, six, SIX_POINTS);
    break;
  case SHAPE_LOBED:
    write_fan(pen, f, hand, HAND_POINTS);
    break;
  case SHAPE_THREE:
    write_fan(pen, f, three, THREE_POINTS);
    break;
  case SHAPE_FIVE:
    write_fan(pen, f, five, FIVE_POINTS);
    break;
  case SHAPE_TOOTHED:
    write_toothed(pen, f);
    break;
  default:
    write_obovate(pen, f);
    break;
  }
}
