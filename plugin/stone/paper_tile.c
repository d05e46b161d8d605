/* SPDX-License-Identifier: Apache-2.0
 *
 * The paper's tile at creation: displaced midpoints, outlines, and the factor
 * that brings the highest texel to 256.
 */
#include <string.h>

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "paper_table.h"
#include "parameters.h"

static double signed_of(uint32_t h) { return (double)(hash1(h) >> 8) / 8388607.5 - 1.0; }
static double unit_of(uint32_t h) { return (double)(hash1(h) >> 8) / 16777215.0; }

/* Midpoints of all edges, level by level: along, across and on the diagonal.
 * Each level's variance is half the last's. */
static void displace(double *h, int grid, uint32_t seed) {
  double size = 1.0;
  memset(h, 0, sizeof(double) * PAPER_GRID * PAPER_GRID);
  for (int step = grid; step > 1; step /= 2) {
    int half = step / 2;
    for (int y = 0; y <= grid; y += half) {
      for (int x = 0; x <= grid; x += half) {
        int odd_x = x / half & 1, odd_y = y / half & 1;
        if (!odd_x && !odd_y) continue;
        /* the ends of the edge that it halves; diagonals run up to the right */
        int dx = odd_x ? half : 0, dy = odd_y ? half : 0;
        double mean = 0.5 * (h[(y - dy) * PAPER_GRID + x - dx] + h[(y + dy) * PAPER_GRID + x + dx]);
        uint32_t at = seed + (uint32_t)y * 977u + (uint32_t)x * 131071u;
        h[y * PAPER_GRID + x] = mean + size * signed_of(at);
      }
    }
    size *= 0.70710678118654752440;
  }
}

static void build_heights(stone_tile *t, int stone, uint32_t seed) {
  double h[PAPER_GRID * PAPER_GRID], low = 1e30, high = -1e30;
  displace(h, t->grid, seed);
  for (int y = 0; y <= t->grid; y++) {
    for (int x = 0; x <= t->grid; x++) {
      double z = h[y * PAPER_GRID + x];
      if (z < low) low = z;
      if (z > high) high = z;
    }
  }
  for (int y = 0; y <= t->grid; y++) {
    for (int x = 0; x <= t->grid; x++) {
      int at = y * PAPER_GRID + x;
      t->height[stone * PAPER_GRID * PAPER_GRID + at] =
          (float)(high > low ? 128.0 * (h[at] - low) / (high - low) : 0.0);
    }
  }
}

int32_t paper_build_tile(stone_constants *w, const settings *s, paper_scan *scan) {
  stone_tile *t = &w->tile;
  int pattern = choice_at(s, P_PAPER_PATTERN);
  if (pattern == PATTERN_NONE || w->mode == MODE_FABRIC) return SOZAI_OK;
  if (choice_at(s, P_LAYOUT) != 0) {
    return fail(SOZAI_ERROR_RANGE,
                "paper_pattern: %s is a layout of its own, and layout = %s "
                "another; one of them none",
                s->list[P_PAPER_PATTERN].text, s->list[P_LAYOUT].text);
  }
  double length = number_at(s, P_PAPER_LENGTH), width = number_at(s, P_PAPER_WIDTH);
  double joint = number_at(s, P_PAPER_JOINT), wander = number_at(s, P_PAPER_WANDER);
  double least = length < width ? length : width;
  if (joint + 2.0 * wander * width > 0.7 * least) {
    return fail(SOZAI_ERROR_RANGE,
                "paper_joint: %.9g texel leave too little of stones of %.9g by %.9g; 0 to %.9g",
                joint, length, width, 0.7 * least - 2.0 * wander * width);
  }
  t->on = 1;
  t->across = pattern == PATTERN_IGETA ? 2 : 1;
  t->down = pattern == PATTERN_CUT ? 1 : 2;
  t->length = (float)length;
  t->width = (float)width;
  t->shift = pattern == PATTERN_CHIDORI ? (float)((int)(0.5 * length)) : 0.0f;
  t->start = pattern == PATTERN_IGETA ? (float)((int)(0.5 * length)) : 0.0f;
  t->tile[0] = (float)(length * t->across);
  t->tile[1] = (float)(width * t->down);
  for (int k = 0; k < 2; k++) t->inverse_tile[k] = 1.0f / t->tile[k];
  t->grid = 1 << (int)number_at(s, P_PAPER_LEVELS);
  t->parts = (int32_t)number_at(s, P_PAPER_PARTS);
  t->dh = (float)number_at(s, P_PAPER_DH);
  t->joint_height = (float)number_at(s, P_PAPER_JOINT_HEIGHT);
  t->repair = (float)number_at(s, P_PAPER_REPAIR);
  t->mm = (float)(number_at(s, P_PAPER_RELIEF) / 256.0);
  for (int k = 0; k < 3; k++) {
    double sum = 0.0;
    for (int c = 0; c < 3; c++) {
      int code = (int)(s->list[P_PAPER_JOINT_COLOUR].number[c] + 0.5);
      sum += (double)w->decode[c][code][k];
    }
    t->joint_colour[k] = (float)sum;
  }
  for (int i = 0; i < PAPER_STONES; i++) {
    uint32_t seed = hash1(w->seed + 301u + (uint32_t)i);
    build_heights(t, i, seed);
    for (int side = 0; side < 4; side++) {
      for (int k = 0; k <= t->parts; k++) {
        double in =
            0.5 * joint + wander * width * unit_of(seed + 7919u * (uint32_t)(side * 64 + k));
        t->inset[(i * 4 + side) * (PAPER_PARTS + 1) + k] = (float)in;
      }
    }
  }
  /* every texel of the tile, with alpha 1 and no joints, for the highest */
  paper_scanned m;
  t->alpha = 1.0f;
  scan(w, &m);
  t->alpha = (float)(256.0 / m.highest);
  t->share = (float)m.joint;
  t->mean =
      (float)(m.joint * (double)t->joint_height + (1.0 - m.joint) * m.mean * (double)t->alpha);
  /* neighbours' numbers are independent: variance dh^2 / 12 each */
  double slope = (double)t->alpha * (double)t->dh * (double)t->mm * (double)w->inverse_texel;
  t->lost = (float)(slope * slope / 12.0 * 2.0 * (2.0 / 3.0));
  return SOZAI_OK;
}
