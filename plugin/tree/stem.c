/* SPDX-License-Identifier: Apache-2.0 */
#include "stem.h"

#include "../core/hash1.h"
#include "../core/meter.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "arms.h"
#include "axis.h"
#include "way.h"

#define STEM_LEAST 8u
#define STEM_MOST 96u

void stem_step(float p[3], double l, double theta, double phi) {
  double level = l * scalar_cos(phi * RADIANS);
  p[0] += (float)(level * scalar_sin(theta * RADIANS));
  p[1] += (float)(l * scalar_sin(phi * RADIANS));
  p[2] -= (float)(level * scalar_cos(theta * RADIANS)); /* z is south */
}

/* A smooth wave between -1 and 1 of the height's share, another for each tree. */
static double wave(uint32_t seed, double x) {
  double a = (double)tree_unit(hash1(seed)), b = (double)tree_unit(hash1(seed + 1u));
  return 0.6 * scalar_sin(6.2831853 * (1.1 * x + a)) + 0.4 * scalar_sin(6.2831853 * (2.7 * x + b));
}

static uint32_t stem_nodes(double height) {
  double n = height / 150.0;
  return n < STEM_LEAST ? STEM_LEAST : n > STEM_MOST ? STEM_MOST : (uint32_t)n;
}

static void grow_stem(tree *t) {
  const tree_plan *p = &t->plan;
  double height = plan_height(p, p->age);
  uint32_t n = stem_nodes(height);
  tree_node *nodes = t->nodes;
  double lean = p->sway * height;
  double x0 = wave(p->seed ^ 0x1234567u, 0.0), z0 = wave(p->seed ^ 0x7654321u, 0.0);
  for (uint32_t i = 0; i < n; i++) {
    /* closer near the ground, where the butt swells */
    double share = (double)i / (n - 1), h = height * share * (0.6 + 0.4 * share);
    nodes[i].p[0] = (float)(lean * (wave(p->seed ^ 0x1234567u, h / height) - x0));
    nodes[i].p[1] = (float)h;
    nodes[i].p[2] = (float)(lean * (wave(p->seed ^ 0x7654321u, h / height) - z0));
    nodes[i].r = (float)plan_radius(p, h, p->age);
    if (nodes[i].r < 0.5f) nodes[i].r = 0.5f;
  }
  t->branches[0] = (tree_branch){.nodes = n,
                                 .parent = TREE_NONE,
                                 .key = hash1(p->seed),
                                 .length = (float)height,
                                 .radius = nodes[0].r,
                                 .elevation = 90.0f,
                                 .death = TREE_ALIVE,
                                 .shed = TREE_ALIVE};
  t->by_years = 1;
  t->branch_count = 1;
  t->node_count = n;
}

/* Nodes of what is left of it. */
static uint32_t branch_nodes(const tree_plan *p, const tree_bud *b) {
  uint32_t all = way_segments(p, life_length(p, b, p->age));
  uint32_t n = (uint32_t)(life_left(p, b) * all + 0.5);
  return 1u + (n < 2 ? 2 : n);
}

void stem_lay(const tree_plan *p, const tree_branch *o, double length, const float base[3],
              tree_node *nodes) {
  float at[3] = {base[0], base[1], base[2]};
  uint32_t segments = way_segments(p, length);
  double radius = (double)o->radius, step = length / segments;
  way w = {{0.0, 0.0}, {0.0, 0.0}};
  for (uint32_t i = 0; i < o->nodes; i++) {
    double share = (double)i / segments;
    for (int c = 0; c < 3; c++) nodes[i].p[c] = at[c];
    /* a cone, a little fuller than straight */
    nodes[i].r = (float)(radius * (1.0 - 0.85 * share) + 0.15 * radius * share * (1.0 - share));
    if (nodes[i].r < 0.3f) nodes[i].r = 0.3f;
    double theta = (double)o->azimuth, phi = (double)o->elevation;
    way_step(&w, p, o->key, length, i, &theta, &phi);
    stem_step(at, step, theta, phi);
  }
}

static void grow_branch(tree *t, const tree_bud *b, const float base[3], double stem_radius) {
  const tree_plan *p = &t->plan;
  tree_branch *o = &t->branches[t->branch_count++];
  double length = life_length(p, b, p->age);
  *o = (tree_branch){.first = t->node_count,
                     .nodes = branch_nodes(p, b),
                     .order = 1,
                     .key = b->key,
                     .at = (float)b->z,
                     .length = (float)length,
                     .azimuth = (float)b->azimuth,
                     .elevation = (float)b->elevation,
                     .birth = (float)b->birth,
                     .death = (float)b->death,
                     .shed = (float)b->shed};
  double radius = life_radius(p, b, p->age), most = p->thickest * stem_radius;
  o->radius = (float)(radius < most ? radius : most);
  if (b->shed >= 0.0) {
    o->nodes = 0;
    return;
  }
  stem_lay(p, o, length, base, &t->nodes[o->first]);
  t->node_count += o->nodes;
}

int32_t stem_grow(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count) {
  const tree_plan *p = &t->plan;
  uint32_t grown = p->orders > 0 ? count : 0;
  uint64_t nodes = stem_nodes(plan_height(p, p->age));
  arms_room arms = {0, 0};
  for (uint32_t i = 0; i < grown; i++) {
    if (buds[i].shed < 0.0) nodes += branch_nodes(p, &buds[i]);
    if (buds[i].death < 0.0)
      arms_count(p, buds[i].key, (float)life_length(p, &buds[i], p->age), &arms);
  }
  t->branch_room = 1u + grown + arms.branches;
  t->node_room = nodes + arms.nodes;
  /* shoots are counted later, and these with them */
  int32_t r = arms.branches ? limit_check(host, LIMIT_SHOOTS, t->branch_room, "fork_spacing") : 0;
  if (r) return r;
  t->branches = host_alloc(host, t->branch_room * sizeof *t->branches, 64);
  t->nodes = t->branches ? host_alloc(host, t->node_room * sizeof *t->nodes, 64) : NULL;
  if (!t->nodes) return SOZAI_ERROR_MEMORY;
  grow_stem(t);
  axis_walk w;
  axis_begin(&w, t->nodes, t->branches[0].nodes);
  for (uint32_t i = 0; i < grown; i++) {
    /* z is a height, and the stem all but upright: its nodes' heights find it */
    float base[3];
    while (w.at + 1 < w.last && (float)buds[i].z > w.nodes[w.at + 1].p[1]) {
      w.begin += w.length;
      w.at++;
      axis_segment(&w);
    }
    const tree_node *a = &w.nodes[w.at], *b = a + 1;
    float share = ((float)buds[i].z - a->p[1]) / (b->p[1] - a->p[1]);
    for (int c = 0; c < 3; c++) base[c] = a->p[c] + share * (b->p[c] - a->p[c]);
    grow_branch(t, &buds[i], base, (double)(a->r + share * (b->r - a->r)));
  }
  t->stems = (uint32_t)t->branch_count;
  for (uint32_t i = 1; i < t->stems; i++) {
    if (t->branches[i].nodes && t->branches[i].death < 0.0f) arms_grow(t, i);
  }
  t->limbs = (uint32_t)t->branch_count;
  return SOZAI_OK;
}
