/* SPDX-License-Identifier: Apache-2.0 */
#include "stem.h"

#include "../core/hash1.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "axis.h"

#define STEM_LEAST 8u
#define STEM_MOST 96u
#define TURNS_MOST 13u
#define TURN_PARTS 3u /* segments in which a turn of the way is taken */
#define KEPT 0.8      /* of what the way has turned aside, from turn to turn: light calls it back */

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
  t->branch_count = 1;
  t->node_count = n;
}

/* How often a branch turns aside along its length. */
static uint32_t branch_turns(double length, double wander) {
  double n = 3.0 + length / (wander > 12.0 ? 180.0 : 300.0);
  return n > TURNS_MOST ? TURNS_MOST : (uint32_t)n;
}

/* Segments of the whole branch, and nodes of what is left of it. */
static uint32_t branch_segments(double length, double wander) {
  return branch_turns(length, wander) * TURN_PARTS;
}

static uint32_t branch_nodes(const tree_plan *p, const tree_bud *b) {
  uint32_t all = branch_segments(life_length(p, b, p->age), p->wander);
  uint32_t n = (uint32_t)(life_left(p, b) * all + 0.5);
  return 1u + (n < 2 ? 2 : n);
}

/* How far a branch's way is turned aside, degrees, after its i-th turn. */
typedef struct {
  double azimuth, elevation;
} way;

static way turn_aside(way before, const tree_plan *p, uint32_t key, uint32_t i) {
  uint32_t h = hash1(key + 0x632be59bu * i);
  return (way){KEPT * before.azimuth + 2.0 * p->wander * ((double)tree_unit(h) - 0.5),
               KEPT * before.elevation + 1.4 * p->wander * ((double)tree_unit(hash1(h)) - 0.5)};
}

/* Down along the first half and up again towards the tip, by the sine of the
 * way along; longer branches bend further. */
static double bent(const tree_plan *p, double length, double share) {
  double bend = length / p->droop_length;
  if (bend > 1.5) bend = 1.5;
  return bend * (p->upturn * share * share - p->droop * scalar_sin(3.14159265 * share));
}

static void lay_branch(const tree_plan *p, const tree_branch *o, double length, const float base[3],
                       tree_node *nodes) {
  float at[3] = {base[0], base[1], base[2]};
  uint32_t segments = branch_segments(length, p->wander);
  double radius = (double)o->radius, step = length / segments;
  way from = {0.0, 0.0}, to = {0.0, 0.0}; /* it leaves the stem as its knot does */
  for (uint32_t i = 0; i < o->nodes; i++) {
    double share = (double)i / segments;
    for (int c = 0; c < 3; c++) nodes[i].p[c] = at[c];
    /* a cone, a little fuller than straight */
    nodes[i].r = (float)(radius * (1.0 - 0.85 * share) + 0.15 * radius * share * (1.0 - share));
    if (nodes[i].r < 0.3f) nodes[i].r = 0.3f;
    uint32_t part = i % TURN_PARTS;
    if (i > 0 && part == 0) {
      from = to;
      to = turn_aside(from, p, o->key, i / TURN_PARTS);
    }
    double middle = share + 0.5 / segments, turned = (part + 0.5) / TURN_PARTS;
    double phi = (double)o->elevation + bent(p, length, middle < 1.0 ? middle : 1.0) +
                 from.elevation + turned * (to.elevation - from.elevation);
    if (phi > 86.0) phi = 86.0;
    if (phi < -86.0) phi = -86.0;
    stem_step(at, step, (double)o->azimuth + from.azimuth + turned * (to.azimuth - from.azimuth),
              phi);
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
                     .elevation = (float)life_elevation(p, b),
                     .birth = (float)b->birth,
                     .death = (float)b->death,
                     .shed = (float)b->shed};
  double radius = life_radius(p, b, p->age), most = p->thickest * stem_radius;
  o->radius = (float)(radius < most ? radius : most);
  if (b->shed >= 0.0) {
    o->nodes = 0;
    return;
  }
  lay_branch(p, o, length, base, &t->nodes[o->first]);
  t->node_count += o->nodes;
}

int32_t stem_grow(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count) {
  const tree_plan *p = &t->plan;
  uint32_t grown = p->orders > 0 ? count : 0;
  uint64_t nodes = stem_nodes(plan_height(p, p->age));
  for (uint32_t i = 0; i < grown; i++) {
    if (buds[i].shed < 0.0) nodes += branch_nodes(p, &buds[i]);
  }
  t->branch_room = 1u + grown;
  t->node_room = nodes;
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
  return SOZAI_OK;
}
