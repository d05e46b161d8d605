/* SPDX-License-Identifier: Apache-2.0
 *
 * The shapes of needles, clothed shoots and leaves.
 */
#include "mesh.h"
#include "parameters.h"
#include "turn.h"

#define SHAPE_AWL 0    /* three sides and a base, closed */
#define SHAPE_SLIVER 1 /* one triangle */
#define SHAPE_SPRIG 2  /* a core and awls about it */
#define SHAPE_CORE 3   /* its core alone */
#define SHAPE_BLADE 4
#define SHAPE_DIAMOND 5
#define SHAPE_ELLIPSE 6
#define SHAPE_LOBED 7
#define SHAPE_SPARSE 8 /* a sprig with half its awls, twice as wide */
#define SHAPE_GUTTER 9 /* two of an awl's three sides */
#define SHAPE_FLAT 10  /* a blade without its fold */
#define SHAPE_SIX 11   /* an ellipse of six points */
#define SHAPE_THREE 12 /* a hand of three lobes */
#define SHAPE_FIVE 13  /* what five points are of it */
#define SHAPE_TOOTHED 14
#define SHAPE_OBOVATE 15 /* it without teeth and fold */
#define SPRIG_AWLS 12
#define SPARSE_AWLS 6
#define ELLIPSE_POINTS 12
#define HAND_POINTS 14
#define SIX_POINTS 6
#define THREE_POINTS 8
#define FIVE_POINTS 5
#define TEETH_POINTS 5 /* to a side: three teeth */

static const uint8_t sizes[][2] = {[SHAPE_AWL] = {4, 4},
                                   [SHAPE_SLIVER] = {3, 1},
                                   [SHAPE_SPRIG] = {5 + 3 * SPRIG_AWLS, 6 + SPRIG_AWLS},
                                   [SHAPE_CORE] = {5, 6},
                                   [SHAPE_SPARSE] = {5 + 3 * SPARSE_AWLS, 6 + SPARSE_AWLS},
                                   [SHAPE_BLADE] = {8, 8},
                                   [SHAPE_DIAMOND] = {4, 2},
                                   [SHAPE_ELLIPSE] = {ELLIPSE_POINTS, ELLIPSE_POINTS - 2},
                                   [SHAPE_LOBED] = {HAND_POINTS, HAND_POINTS - 2},
                                   [SHAPE_GUTTER] = {4, 2},
                                   [SHAPE_FLAT] = {6, 4},
                                   [SHAPE_SIX] = {SIX_POINTS, SIX_POINTS - 2},
                                   [SHAPE_THREE] = {THREE_POINTS, THREE_POINTS - 2},
                                   [SHAPE_FIVE] = {FIVE_POINTS, FIVE_POINTS - 2},
                                   [SHAPE_TOOTHED] = {4 + 2 * TEETH_POINTS, 14},
                                   [SHAPE_OBOVATE] = {8, 6}};

/* At level 1 about half as many triangles, from 2 on as few as can be. */
static const uint8_t shapes[][3] = {
    [LEAF_NEEDLE] = {SHAPE_AWL, SHAPE_GUTTER, SHAPE_SLIVER},
    [LEAF_BLADE] = {SHAPE_BLADE, SHAPE_FLAT, SHAPE_DIAMOND},
    [LEAF_ELLIPSE] = {SHAPE_ELLIPSE, SHAPE_SIX, SHAPE_DIAMOND},
    [LEAF_LOBED] = {SHAPE_LOBED, SHAPE_THREE, SHAPE_FIVE},
    [LEAF_TOOTHED] = {SHAPE_TOOTHED, SHAPE_OBOVATE, SHAPE_DIAMOND},
};

/* What a diamond is longer and wider than the leaf it stands for: it hides as much. */
static const float diamonds[][2] = {
    [LEAF_NEEDLE] = {1.0f, 1.0f},      [LEAF_BLADE] = {1.063f, 1.202f},
    [LEAF_ELLIPSE] = {1.136f, 1.467f}, [LEAF_LOBED] = {1.0f, 1.0f},
    [LEAF_TOOTHED] = {1.05f, 1.145f},
};

static int shape_of(const tree *t, uint32_t level) {
  if (t->sprigs) return level < 1 ? SHAPE_SPRIG : level < 2 ? SHAPE_SPARSE : SHAPE_CORE;
  return shapes[t->plan.leaf][level < 2 ? level : 2];
}

void leaf_shape_of(const tree *t, uint32_t level, leaf_shape *out) {
  out->shape = shape_of(t, level);
  out->points = sizes[out->shape][0];
  out->triangles = sizes[out->shape][1];
  out->closed = out->shape == SHAPE_AWL || out->shape == SHAPE_CORE;
  /* simpler shapes first, then half as many at each level, of the same area */
  uint32_t halvings = level > 1 ? level - 1 : 0;
  out->stride = 1u << halvings;
  float grow = 1.0f;
  for (uint32_t i = 0; i < halvings; i++) grow *= 1.1892071f; /* the fourth root of 2 */
  out->longer = grow;
  out->wider = grow * grow * grow;
  if (out->shape != SHAPE_DIAMOND) return;
  out->longer *= diamonds[t->plan.leaf][0];
  out->wider *= diamonds[t->plan.leaf][1];
}

static void cross(const float a[3], const float b[3], float out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

static float unit(float v[3]) {
  float sum = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  float length = __builtin_sqrtf(sum), s = length > 0.0f ? 1.0f / length : 0.0f;
  for (int c = 0; c < 3; c++) v[c] *= s;
  return length;
}

/* A leaf's own frame: along it, to its side, out of its upper face. */
typedef struct {
  const float *base;
  float along[3], side[3], up[3];
  float length, half;
  uint32_t owner;
} frame;

static frame frame_of(const tree_organ *o, const leaf_shape *s) {
  frame f = {.base = o->base, .owner = o->branch};
  for (int c = 0; c < 3; c++) {
    f.along[c] = o->axis[c];
    f.side[c] = o->side[c];
  }
  f.length = unit(f.along) * s->longer;
  f.half = unit(f.side) * s->wider;
  cross(f.side, f.along, f.up);
  return f;
}

/* At (x, y, z) of the frame; normal likewise. */
static uint32_t at(mesh_pen *pen, const frame *f, float x, float y, float z, float nx, float ny,
                   float nz) {
  float p[3], n[3];
  for (int c = 0; c < 3; c++) {
    p[c] = f->base[c] + y * f->along[c] + x * f->side[c] + z * f->up[c];
    n[c] = ny * f->along[c] + nx * f->side[c] + nz * f->up[c];
  }
  return pen_point(pen, p, n, 0.5f + 0.5f * x / (f->half > 0.0f ? f->half : 1.0f),
                   y / (f->length > 0.0f ? f->length : 1.0f), f->owner);
}

static void write_awl(mesh_pen *pen, const frame *f) {
  float r = f->half;
  uint32_t a = at(pen, f, r, 0, 0, 1, 0, 0),
           b = at(pen, f, -0.5f * r, 0, 0.866f * r, -0.5f, 0, 0.8660254f),
           c = at(pen, f, -0.5f * r, 0, -0.866f * r, -0.5f, 0, -0.8660254f),
           tip = at(pen, f, 0, f->length, 0, 0, 1, 0);
  pen_triangle(pen, a, b, c);
  pen_triangle(pen, a, tip, b);
  pen_triangle(pen, b, tip, c);
  pen_triangle(pen, c, tip, a);
}

/* Of thin sheets that hang together what is seen from all around is that of the
 * body they would wrap: as much as of the awl. */
static void write_gutter(mesh_pen *pen, const frame *f) {
  float r = f->half;
  uint32_t a = at(pen, f, r, 0, 0, 1, 0, 0),
           b = at(pen, f, -0.5f * r, 0, 0.866f * r, -0.5f, 0, 0.8660254f),
           c = at(pen, f, -0.5f * r, 0, -0.866f * r, -0.5f, 0, -0.8660254f),
           tip = at(pen, f, 0, f->length, 0, 0, 1, 0);
  pen_triangle(pen, a, tip, b);
  pen_triangle(pen, b, tip, c);
}

/* As broad as the awl that it stands for from all around: of a closed body that is in the mean a
 * quarter of its surface, of a sheet half of its area. */
#define SLIVER_WIDER 1.299f /* 3 sqrt(3) / 4, for thin ones */

static void write_sliver(mesh_pen *pen, const frame *awl, const leaf_shape *s) {
  frame f = *awl;
  float blunt = 0.5f * (f.half / s->wider) / (f.length / s->longer);
  if (!(f.length > 0.0f)) blunt = 0.0f;
  f.half *= SLIVER_WIDER * (__builtin_sqrtf(1.0f + blunt * blunt) + blunt);
  uint32_t a = at(pen, &f, -f.half, 0, 0, 0, 0, 1), b = at(pen, &f, f.half, 0, 0, 0, 0, 1),
           c = at(pen, &f, 0, f.length, 0, 0, 0, 1);
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
static float core_alone(const frame *f, const leaf_shape *s) {
  float half = f->half / s->wider, hides = core_hides(CORE * half, f->length / s->longer);
  hides = (hides + AWLS_HIDE * half * half) * (float)s->stride;
  float r = CORE * f->half;
  for (int i = 0; i < 4 && r > 0.0f; i++) {
    float now = core_hides(r, f->length);
    r *= now > 0.0f ? hides / now : 1.0f;
  }
  return r;
}

static void write_core(mesh_pen *pen, const frame *f, float r) {
  float m = 0.3f * f->length;
  uint32_t base = at(pen, f, 0, 0, 0, 0, -1, 0), a = at(pen, f, r, m, 0, 1, 0, 0),
           b = at(pen, f, -0.5f * r, m, 0.866f * r, -0.5f, 0, 0.8660254f),
           c = at(pen, f, -0.5f * r, m, -0.866f * r, -0.5f, 0, -0.8660254f),
           tip = at(pen, f, 0, f->length, 0, 0, 1, 0);
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
static void write_sprig(mesh_pen *pen, const frame *f, int awls, float wide) {
  write_core(pen, f, CORE * f->half);
  for (int i = 0; i < awls; i++) {
    float s = ((float)i + 0.5f) / (float)awls, x = golden[i][0], z = golden[i][1];
    float from = s * 0.86f * f->length, narrow = 1.0f - 0.45f * s, out = f->half * narrow;
    float reach = 1.5f * f->half * narrow, w = wide * f->half * narrow;
    /* out and forward from the core; its width round the shoot */
    uint32_t a = at(pen, f, -w * z, from, w * x, x, 0, z),
             b = at(pen, f, w * z, from, -w * x, x, 0, z),
             tip = at(pen, f, out * x, from + reach, out * z, 0.8f * x, -0.6f, 0.8f * z);
    pen_triangle(pen, a, tip, b);
  }
}

static void write_blade(mesh_pen *pen, const frame *f) {
  float w = f->half, l = f->length, fold = 0.25f * w;
  float m1 = -0.03f * l, m2 = -0.06f * l, m3 = -0.14f * l; /* it nods */
  uint32_t base = at(pen, f, 0, 0, 0, 0, 0.1f, 0.995f),
           l1 = at(pen, f, -0.92f * w, 0.32f * l, m1 + fold, 0.24f, 0, 0.97f),
           l2 = at(pen, f, -0.8f * w, 0.62f * l, m2 + fold, 0.24f, 0, 0.97f),
           r1 = at(pen, f, 0.92f * w, 0.32f * l, m1 + fold, -0.24f, 0, 0.97f),
           r2 = at(pen, f, 0.8f * w, 0.62f * l, m2 + fold, -0.24f, 0, 0.97f),
           c1 = at(pen, f, 0, 0.32f * l, m1, 0, 0, 1), c2 = at(pen, f, 0, 0.62f * l, m2, 0, 0, 1),
           tip = at(pen, f, 0, l, m3, 0, 0.1f, 0.995f);
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
static void write_flat(mesh_pen *pen, const frame *f) {
  float w = f->half, l = f->length, fold = 0.125f * w;
  uint32_t base = at(pen, f, 0, 0, 0, 0, 0.1f, 0.995f),
           l1 = at(pen, f, -0.92f * w, 0.32f * l, -0.03f * l + fold, 0, 0, 1),
           l2 = at(pen, f, -0.8f * w, 0.62f * l, -0.06f * l + fold, 0, 0, 1),
           r1 = at(pen, f, 0.92f * w, 0.32f * l, -0.03f * l + fold, 0, 0, 1),
           r2 = at(pen, f, 0.8f * w, 0.62f * l, -0.06f * l + fold, 0, 0, 1),
           tip = at(pen, f, 0, l, -0.14f * l, 0, 0.1f, 0.995f);
  pen_triangle(pen, base, r1, l1);
  pen_triangle(pen, l1, r1, r2);
  pen_triangle(pen, l1, r2, l2);
  pen_triangle(pen, l2, r2, tip);
}

/* From the stalk up, of the right side. */
static const float teeth[TEETH_POINTS][2] = {
    {0.52f, 0.22f}, {0.42f, 0.34f}, {0.92f, 0.50f}, {0.72f, 0.60f}, {0.88f, 0.78f}};
#define NODS 0.14f /* of its length, at its tip */

static uint32_t folded(mesh_pen *pen, const frame *f, float x, float y, float fold) {
  float out = x < 0.0f ? -x : x, lean = x > 0.0f ? -fold : x < 0.0f ? fold : 0.0f;
  float z = fold * out * f->half - NODS * y * y * f->length;
  return at(pen, f, x * f->half, y * f->length, z, lean, 0, __builtin_sqrtf(1.0f - lean * lean));
}

static void write_toothed(mesh_pen *pen, const frame *f) {
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

static void write_obovate(mesh_pen *pen, const frame *f) {
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

static void write_diamond(mesh_pen *pen, const frame *f) {
  float w = f->half * 0.9f, l = f->length;
  uint32_t base = at(pen, f, 0, 0, 0, 0, 0, 1), a = at(pen, f, -w, 0.45f * l, 0, 0, 0, 1),
           b = at(pen, f, w, 0.45f * l, 0, 0, 0, 1), tip = at(pen, f, 0, l, 0, 0, 0, 1);
  pen_triangle(pen, base, b, a);
  pen_triangle(pen, a, b, tip);
}

static void write_fan(mesh_pen *pen, const frame *f, const float (*outline)[2], uint32_t count) {
  uint32_t first = 0;
  for (uint32_t i = 0; i < count; i++) {
    uint32_t p = at(pen, f, outline[i][0] * f->half, outline[i][1] * f->length, 0, 0, 0, 1);
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

void leaf_write(mesh_pen *pen, const tree_organ *o, const leaf_shape *s) {
  frame f = frame_of(o, s);
  switch (s->shape) {
  case SHAPE_AWL:
    write_awl(pen, &f);
    break;
  case SHAPE_SLIVER:
    write_sliver(pen, &f, s);
    break;
  case SHAPE_SPRIG:
    write_sprig(pen, &f, SPRIG_AWLS, 0.3f);
    break;
  case SHAPE_SPARSE:
    write_sprig(pen, &f, SPARSE_AWLS, 0.5f); /* they overlap less */
    break;
  case SHAPE_CORE:
    write_core(pen, &f, core_alone(&f, s));
    break;
  case SHAPE_BLADE:
    write_blade(pen, &f);
    break;
  case SHAPE_DIAMOND:
    write_diamond(pen, &f);
    break;
  case SHAPE_GUTTER:
    write_gutter(pen, &f);
    break;
  case SHAPE_FLAT:
    write_flat(pen, &f);
    break;
  case SHAPE_TOOTHED:
    write_toothed(pen, &f);
    break;
  case SHAPE_OBOVATE:
    write_obovate(pen, &f);
    break;
  case SHAPE_SIX:
    write_fan(pen, &f, six, SIX_POINTS);
    break;
  case SHAPE_THREE:
    write_fan(pen, &f, three, THREE_POINTS);
    break;
  case SHAPE_FIVE:
    write_fan(pen, &f, five, FIVE_POINTS);
    break;
  case SHAPE_ELLIPSE:
    write_fan(pen, &f, ellipse, ELLIPSE_POINTS);
    break;
  default:
    write_fan(pen, &f, hand, HAND_POINTS);
    break;
  }
}
