/* SPDX-License-Identifier: Apache-2.0
 *
 * Which shape a needle, clothed shoot or leaf has at a level of detail, and where it lies.
 */
#include "leaf_shapes.h"
#include "parameters.h"

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

static leaf_frame frame_of(const tree_organ *o, const leaf_shape *s) {
  leaf_frame f = {.base = o->base, .owner = o->branch};
  for (int c = 0; c < 3; c++) {
    f.along[c] = o->axis[c];
    f.side[c] = o->side[c];
  }
  f.length = unit(f.along) * s->longer;
  f.half = unit(f.side) * s->wider;
  cross(f.side, f.along, f.up);
  return f;
}

void leaf_write(mesh_pen *pen, const tree_organ *o, const leaf_shape *s) {
  leaf_frame f = frame_of(o, s);
  if (s->shape < NEEDLES) {
    needle_write(pen, &f, s);
  } else {
    blade_write(pen, &f, s->shape);
  }
}
