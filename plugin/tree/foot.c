/* SPDX-License-Identifier: Apache-2.0 */
#include "foot.h"

#include "../core/hash1.h"

#define LOBED_FROM 40.0f                        /* mm of radius */
static const uint32_t lobed_sides[] = {36, 26}; /* by level; from 2 on as any tube */

static int stands_on_roots(const tree_branch *b) { return !b->order && b->radius >= LOBED_FROM; }

uint32_t foot_sides(const tree_branch *b, uint32_t level) {
  return level < 2 && stands_on_roots(b) ? lobed_sides[level] : 0;
}

/* The radius at the foot, as a share. */
static float lobed(const tree *t, const tree_branch *b, float height, const float round[2]) {
  if (!stands_on_roots(b)) return 1.0f;
  float near_ground = 1.0f - height / (3.0f * b->radius);
  if (near_ground <= 0.0f) return 1.0f;
  uint32_t h = hash1(t->plan.seed ^ 0x0badcafeu);
  const float *turn = t->plan.round[h >> 22];
  float c = round[0] * turn[0] - round[1] * turn[1], d = round[1] * turn[0] + round[0] * turn[1];
  /* cos 5x and cos 3x of one angle */
  float c2 = c * c, five = c * (16.0f * c2 * c2 - 20.0f * c2 + 5.0f),
        three = d * (3.0f - 4.0f * d * d);
  return 1.0f + near_ground * near_ground * (0.16f * five + 0.1f * three + 0.1f);
}

float foot_radius(const tree *t, const tree_branch *b, float height, uint32_t k, uint32_t sides,
                  float out[2]) {
  const float *round[3]; /* of the side before, its own, and of the one behind */
  float r[3];
  for (uint32_t i = 0; i < 3; i++)
    round[i] = t->plan.round[(k + sides - 1 + i) % sides * 1024u / sides];
  out[0] = round[1][0], out[1] = round[1][1];
  if (!stands_on_roots(b)) return 1.0f;
  for (int i = 0; i < 3; i++) r[i] = lobed(t, b, height, round[i]);
  if (r[0] == r[2]) return r[1];
  /* square to the line from the side before to the one behind */
  float x = r[2] * round[2][0] - r[0] * round[0][0], y = r[2] * round[2][1] - r[0] * round[0][1];
  float s = 1.0f / __builtin_sqrtf(x * x + y * y);
  out[0] = s * y, out[1] = -s * x;
  return r[1];
}

#define UPRIGHT 0.7f /* a stem that leans further is no foot but a trunk along the ground */

void foot_stand(const tree_branch *b, float height, float along[3]) {
  float share = height / (3.0f * b->radius), sum = 0.0f;
  if (b->order || share >= 1.0f || !(along[1] > UPRIGHT)) return;
  for (int c = 0; c < 3; c++) {
    along[c] = c == 1 ? 1.0f + share * (along[1] - 1.0f) : share * along[c];
    sum += along[c] * along[c];
  }
  sum = 1.0f / __builtin_sqrtf(sum);
  for (int c = 0; c < 3; c++) along[c] *= sum;
}
