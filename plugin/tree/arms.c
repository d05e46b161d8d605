/* SPDX-License-Identifier: Apache-2.0 */
#include "arms.h"

#include "../core/hash1.h"
#include "angle.h"
#include "axis.h"
#include "bark.h"
#include "stem.h"
#include "way.h"

#define FORKS_MOST 6u      /* of one axis */
#define GENERATIONS 4u     /* of arms on arms */
#define LEAST_ARM 0.4      /* of the distance from fork to fork: no arm is shorter */
#define PLACES 0.35        /* of it: how far a fork is off its place, either way */
#define SHORTER 0.7        /* of fork_share: from so much */
#define LONGER 1.1         /* to so much */
#define TURNS_ASIDE 0.125f /* of a turn round the branch: how far off level an arm leaves it */

typedef struct {
  float at, length; /* mm, along the branch that forks; of the arm */
  uint32_t key;
  int left;
} arm;

static double part_of(uint32_t hash) { return (double)tree_unit(hash); }

/* Of one axis, from its base to its tip. length: as the branch has it, so that as many are grown as
 * were counted. */
static uint32_t forks_of(const tree_plan *p, uint32_t key, float length, arm out[FORKS_MOST]) {
  if (!(p->fork_spacing > 0.0)) return 0;
  double whole = (double)length, from = p->fork_from * whole;
  double spacing = (whole - from) / (FORKS_MOST + 1);
  if (spacing < p->fork_spacing) spacing = p->fork_spacing;
  uint32_t count = 0, side = hash1(key ^ 0x68e31da4u) & 1u;
  for (uint32_t i = 0; i < FORKS_MOST; i++) {
    arm a = {.key = hash1(key + 0x632be5abu * (i + 1))};
    uint32_t h = hash1(a.key ^ 0x2f6b1d95u);
    double at = from + spacing * ((double)i + 0.5 + PLACES * (2.0 * part_of(h) - 1.0));
    h = hash1(h);
    a.at = (float)at;
    a.length = (float)(p->fork_share * (whole - at) * (SHORTER + (LONGER - SHORTER) * part_of(h)));
    /* mostly by turns */
    side ^= (hash1(h) >> 30) != 0;
    a.left = (int)side;
    if (!((double)a.length > LEAST_ARM * p->fork_spacing)) break;
    out[count++] = a;
  }
  return count;
}

static uint32_t arm_nodes(const tree_plan *p, float length) {
  return 1u + way_segments(p, (double)length);
}

static void count_below(const tree_plan *p, uint32_t key, float length, uint32_t generation,
                        arms_room *room) {
  arm arms[FORKS_MOST];
  if (generation == GENERATIONS) return;
  uint32_t n = forks_of(p, key, length, arms);
  for (uint32_t i = 0; i < n; i++) {
    room->branches++;
    room->nodes += arm_nodes(p, arms[i].length);
    count_below(p, arms[i].key, arms[i].length, generation + 1, room);
  }
}

void arms_count(const tree_plan *p, uint32_t key, float length, arms_room *room) {
  count_below(p, key, length, 0, room);
}

/* Level, or nearly, to one side of the branch. */
static void direction_of(const tree_plan *p, const axis_walk *w, const arm *a, float out[3]) {
  float aside = (tree_unit(hash1(a->key ^ 0x1b56c4e9u)) - 0.5f) * 2.0f * TURNS_ASIDE;
  uint32_t turn = (uint32_t)((a->left ? 512 : 0) + (int)(1024.0f * aside)) & 1023u;
  turn_side(w->along, w->level, p->fork_cosine, p->fork_sine, p->round[turn][0], p->round[turn][1],
            out);
}

static void grow_below(tree *t, uint32_t branch, uint32_t generation) {
  const tree_plan *p = &t->plan;
  arm arms[FORKS_MOST];
  if (generation == GENERATIONS) return;
  const tree_branch *b = &t->branches[branch];
  uint32_t n = forks_of(p, b->key, b->length, arms);
  if (!n) return;
  axis_walk w;
  bark_growth growth;
  axis_begin(&w, &t->nodes[b->first], b->nodes);
  bark_growth_of(&growth, t, b);
  for (uint32_t i = 0; i < n; i++) {
    float base[3], d[3];
    float thick = axis_to(&w, arms[i].at, base);
    direction_of(p, &w, &arms[i], d);
    double x = (double)d[0], y = (double)d[1], z = (double)d[2];
    double radius = 0.5 * p->slender * (double)arms[i].length, most = p->thickest * (double)thick;
    tree_branch *o = &t->branches[t->branch_count];
    *o = (tree_branch){.first = t->node_count,
                       .nodes = arm_nodes(p, arms[i].length),
                       .parent = branch,
                       .order = b->order,
                       .key = arms[i].key,
                       .at = arms[i].at,
                       .length = arms[i].length,
                       .radius = (float)(radius < most ? radius : most),
                       .azimuth = (float)angle_of(x, -z),
                       .elevation = (float)angle_of(y, scalar_root(x * x + z * z)),
                       .birth = bark_year(&growth, arms[i].at),
                       .death = TREE_ALIVE,
                       .shed = TREE_ALIVE};
    stem_lay(p, o, (double)arms[i].length, base, &t->nodes[o->first]);
    t->node_count += o->nodes;
    grow_below(t, (uint32_t)t->branch_count++, generation + 1);
  }
}

void arms_grow(tree *t, uint32_t branch) { grow_below(t, branch, 0); }
