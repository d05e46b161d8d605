/* SPDX-License-Identifier: Apache-2.0 */
#include "shoots.h"

#include "../core/hash1.h"
#include "axis.h"
#include "bark.h"
#include "parameters.h"

#define LEAST_SHOOT 4.0f  /* mm: what is shorter is not grown */
#define LEAST_RADIUS 0.2f /* mm, at a tip */
#define LEAST_SPRIG 6.0f

/* An axis while it is worked on. */
typedef struct {
  const tree_node *nodes; /* NULL while counting */
  uint32_t count;
  uint32_t branch; /* its index */
  uint32_t key;
  int order;
  float length;
  float birth; /* years of the tree's age */
} stalk;

/* ---- where things stand round an axis --------------------------------- */

/* cos and sin of beta for the i-th. */
static void beta_of(const tree_plan *p, const tree_side *side, uint32_t i, uint32_t hash,
                    float out[2]) {
  uint32_t at = hash >> 22;
  if (side->arrangement == ROUND_FLAT) {
    /* 0 or 180 degrees, give or take */
    int32_t off = (int32_t)(((float)at - 512.0f) * 0.25f * (0.3f + side->jitter));
    at = ((i & 1u) * 512u + (uint32_t)off) & 1023u;
  } else if (side->arrangement == ROUND_SPIRAL) {
    at = (uint32_t)((uint64_t)i * 1640531527u >> 22) & 1023u; /* of 2^32 the golden section */
  } else if (side->arrangement == ROUND_OPPOSITE) {
    int32_t off = (int32_t)(((float)at - 512.0f) * 0.2f * side->jitter);
    at = ((i & 1u) * 512u + ((i >> 1) & 1u) * 256u + (uint32_t)off) & 1023u;
  }
  out[0] = p->round[at][0];
  out[1] = p->round[at][1];
}

/* ---- leaves ----------------------------------------------------------- */

static tree_organ *next_organ(shoot_pen *pen) {
  return &pen->tree->organs[pen->at.organs + pen->used.organs++];
}

static float leaf_taper(const tree_side *side, float s) {
  if (side->taper <= 0.0f) return 1.0f;
  if (side->taper == 0.5f) return __builtin_sqrtf(s > 0.0f ? s : 0.0f);
  return (float)tree_power((double)s, (double)side->taper);
}

/* The paper's cherry: at each site an ellipse square to the branch and two
 * along it, their middles leaf_stalk away to the left or right in turn, in the
 * plane of the branch and the level direction square to it. That direction is
 * the paper's Y = -(x / y) X, which fails at y = 0; turn_level does not. */
static void write_ellipses(shoot_pen *pen, const axis_walk *w, const float p[3], uint32_t i,
                           float size, uint32_t branch) {
  const tree_plan *plan = &pen->tree->plan;
  float out = (i & 1u ? -1.0f : 1.0f) * plan->leaf_stalk;
  float half_width = 0.5f * plan->leaf_width * size, length = plan->side[0].length * size;
  for (int k = 0; k < plan->leaf_site; k++) {
    int along = k % 3 != 0;
    float shift = k % 3 == 1 ? -0.5f * plan->leaf_width : k % 3 == 2 ? 0.5f * plan->leaf_width : 0;
    tree_organ *o = next_organ(pen);
    o->branch = branch;
    for (int c = 0; c < 3; c++) {
      float middle = p[c] + out * w->level[c] + shift * w->along[c];
      float axis = along ? w->along[c] : (i & 1u ? -w->level[c] : w->level[c]);
      o->axis[c] = length * axis;
      o->base[c] = middle - 0.5f * o->axis[c];
      o->side[c] = half_width * (along ? w->level[c] : w->along[c]);
    }
  }
}

static void write_leaf(shoot_pen *pen, const axis_walk *w, const float p[3], uint32_t i, int k,
                       uint32_t hash, float length, float width, uint32_t branch) {
  const tree_plan *plan = &pen->tree->plan;
  const tree_side *side = &plan->side[0];
  float beta[2], along[3], level[3];
  uint32_t turn = plan->leaf_site > 1 && side->arrangement == ROUND_RANDOM
                      ? hash + (uint32_t)k * (0xffffffffu / (uint32_t)plan->leaf_site)
                      : hash;
  beta_of(plan, side, i * (uint32_t)plan->leaf_site + (uint32_t)k, turn, beta);
  turn_side(w->along, w->level, side->cosine, side->sine, beta[0], beta[1], along);
  turn_level(along, level);
  tree_organ *o = next_organ(pen);
  o->branch = branch;
  float roll[2] = {1.0f, 0.0f};
  if (plan->leaf != LEAF_NEEDLE) {
    /* leaves lie about level, each rolled and nodding its own way */
    uint32_t r = (((hash >> 8) & 255u) - 128u) & 1023u; /* within 45 degrees */
    roll[0] = plan->round[r][0], roll[1] = plan->round[r][1];
    along[1] -= 0.5f * tree_unit(hash1(hash));
    float l =
        1.0f / __builtin_sqrtf(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
    for (int c = 0; c < 3; c++) along[c] *= l;
    turn_level(along, level);
    turn_about(along, roll[0], roll[1], level, level);
  }
  for (int c = 0; c < 3; c++) {
    o->base[c] = p[c] + plan->leaf_stalk * along[c];
    o->axis[c] = length * along[c];
    o->side[c] = 0.5f * width * level[c];
  }
}

static float zone_start(const tree_side *side, float length) {
  float from = side->bare * length;
  if (side->zone > 0.0f && length - side->zone > from) from = length - side->zone;
  return from;
}

/* How many sites a length has: at spacing, 2 spacing ... beyond from, below length. */
static uint32_t sites(float from, float length, float spacing) {
  float n = (length - from) / spacing;
  if (!(n >= 1.0f)) return 0;
  uint32_t whole = (uint32_t)n;
  return (float)whole * spacing >= length - from ? whole - 1 : whole;
}

static void clothe(shoot_pen *pen, const stalk *s, float from) {
  const tree_plan *p = &pen->tree->plan;
  uint32_t segments = s->count - 1, first = (uint32_t)((float)segments * from / s->length);
  if (s->length - from < LEAST_SPRIG) return;
  if (!pen->writing) {
    pen->used.organs += segments - first;
    return;
  }
  float radius = p->side[0].length * p->side[0].sine;
  for (uint32_t i = first; i < segments; i++) {
    tree_organ *o = next_organ(pen);
    const float *a = s->nodes[i].p, *b = s->nodes[i + 1].p;
    float along[3], level[3], sum = 0.0f;
    for (int c = 0; c < 3; c++) along[c] = b[c] - a[c], sum += along[c] * along[c];
    float length = __builtin_sqrtf(sum), inverse = length > 0.0f ? 1.0f / length : 0.0f;
    for (int c = 0; c < 3; c++) along[c] *= inverse;
    turn_level(along, level);
    float over = i + 1 == segments ? 0.6f * p->side[0].length * p->side[0].cosine : 0.15f * length;
    /* short shoots have short needles */
    float own = radius < 0.3f * s->length ? radius : 0.3f * s->length;
    o->branch = s->branch;
    for (int c = 0; c < 3; c++) {
      o->base[c] = a[c];
      o->axis[c] = (length + over) * along[c];
      o->side[c] = own * level[c];
    }
  }
}

static void leaves_on(shoot_pen *pen, const stalk *s, float zone) {
  const tree_plan *p = &pen->tree->plan;
  tree_side side = p->side[0];
  if (p->orders < 4 || p->foliage == FOLIAGE_NONE) return;
  if (zone > 0.0f) side.zone = zone;
  float from = zone_start(&side, s->length);
  if (pen->sprigs) {
    clothe(pen, s, from);
    return;
  }
  float spacing = side.spacing * pen->thin;
  uint32_t n = sites(from, s->length, spacing);
  if (!pen->writing) {
    pen->used.organs += (uint64_t)n * (uint32_t)p->leaf_site;
    return;
  }
  if (!n) return;
  axis_walk w;
  axis_begin(&w, s->nodes, s->count);
  /* fewer and larger, of the same area; needles mostly wider, lest tufts grow */
  float size = __builtin_sqrtf(pen->thin), inverse = 1.0f / s->length;
  float longer = p->leaf == LEAF_NEEDLE ? __builtin_sqrtf(size) : size;
  float wider = p->leaf == LEAF_NEEDLE ? size * longer : size;
  for (uint32_t i = 0; i < n; i++) {
    float at = from + (float)(i + 1) * spacing, point[3];
    axis_to(&w, at, point);
    if (p->leaf == LEAF_ELLIPSE) {
      write_ellipses(pen, &w, point, i, size, s->branch);
      continue;
    }
    uint32_t hash = hash1(s->key + 0x85ebca6bu * (i + 1));
    float length = side.length * longer * leaf_taper(&side, 1.0f - at * inverse);
    float vary = p->leaf == LEAF_NEEDLE ? 1.0f : 0.75f + 0.5f * tree_unit(hash1(~hash));
    for (int k = 0; k < p->leaf_site; k++) {
      write_leaf(pen, &w, point, i, k, hash, length * vary, p->leaf_width * wider * vary,
                 s->branch);
    }
  }
}

/* ---- shoots ----------------------------------------------------------- */

#define SECOND_NODES 4u
#define SECOND_MOST 10u
#define SECOND_EACH 250.0f /* mm: one more node in so many */

static uint32_t nodes_of(const tree_side *side, int order, float length) {
  if (side->bend == 0.0f && side->jitter == 0.0f) return 2;
  if (order > 2) return 3;
  float more = length * (1.0f / SECOND_EACH);
  return more < (float)(SECOND_MOST - SECOND_NODES) ? SECOND_NODES + (uint32_t)more : SECOND_MOST;
}

/* sqrt((SECOND_NODES - 1) / parts) */
static const float root_of_parts[SECOND_MOST] = {
    1.0f, 1.0f, 1.0f, 1.0f, 0.8660254f, 0.7745967f, 0.7071068f, 0.6546537f, 0.6123724f, 0.5773503f};

static void write_shoot(shoot_pen *pen, const tree_side *side, stalk *child, const float base[3],
                        const float direction[3], float radius, float at) {
  tree *t = pen->tree;
  uint64_t node = pen->at.nodes + pen->used.nodes;
  tree_node *nodes = &t->nodes[node];
  float d[3] = {direction[0], direction[1], direction[2]}, p[3] = {base[0], base[1], base[2]};
  uint32_t segments = child->count - 1;
  float step = child->length / (float)segments, bend = side->bend / (float)segments;
  /* as crooked in the whole, however many parts it is in */
  float aside = 0.5f * side->jitter * (child->order == 2 ? root_of_parts[segments] : 1.0f);
  for (uint32_t i = 0; i <= segments; i++) {
    float share = (float)i / (float)segments;
    for (int c = 0; c < 3; c++) nodes[i].p[c] = p[c];
    nodes[i].r = radius + share * (LEAST_RADIUS - radius);
    if (nodes[i].r < 0.75f * LEAST_RADIUS) nodes[i].r = 0.75f * LEAST_RADIUS;
    for (int c = 0; c < 3; c++) p[c] += step * d[c];
    /* lean towards upright, less the nearer to it */
    float up = d[1], length = 0.0f;
    for (int c = 0; c < 3; c++) d[c] += bend * ((c == 1) - up * d[c]);
    if (side->jitter > 0.0f) {
      uint32_t h = hash1(child->key ^ (0x27d4eb2fu * (i + 1)));
      for (int c = 0; c < 3; c++) {
        d[c] += aside * (tree_unit(h) - 0.5f);
        h = hash1(h);
      }
    }
    for (int c = 0; c < 3; c++) length += d[c] * d[c];
    length = 1.0f / __builtin_sqrtf(length);
    for (int c = 0; c < 3; c++) d[c] *= length;
  }
  uint64_t index = pen->at.branches + pen->used.branches;
  child->nodes = nodes;
  tree_branch *b = &t->branches[index];
  *b = (tree_branch){.first = node,
                     .nodes = child->count,
                     .parent = child->branch,
                     .order = (uint32_t)child->order,
                     .key = child->key,
                     .at = at,
                     .length = child->length,
                     .radius = nodes[0].r,
                     .birth = child->birth,
                     .death = TREE_ALIVE,
                     .shed = TREE_ALIVE};
  child->branch = (uint32_t)index;
}

static void shoots_of(shoot_pen *pen, const stalk *parent) {
  const tree_plan *p = &pen->tree->plan;
  int order = parent->order + 1;
  if (order > 3 || order > p->orders || order <= pen->tree->measured) return;
  const tree_side *side = &p->side[order];
  float from = zone_start(side, parent->length), inverse = 1.0f / parent->length;
  uint32_t pair = side->arrangement == ROUND_OPPOSITE ? 2 : 1;
  uint32_t n = sites(from, parent->length, side->spacing) * pair;
  float longest = side->length;
  if (side->share > 0.0f && side->share * parent->length < longest) {
    longest = side->share * parent->length;
  }
  axis_walk w = {0};
  bark_growth growth;
  if (pen->writing && n) {
    axis_begin(&w, parent->nodes, parent->count);
    bark_growth_of(&growth, pen->tree, &pen->tree->branches[parent->branch]);
  }
  for (uint32_t i = 0; i < n; i++) {
    float at = from + (float)(i / pair + 1) * side->spacing;
    uint32_t key = hash1(parent->key + 0x9e3779b9u * (i + 1) + (uint32_t)order);
    float length = longest;
    if (side->taper > 0.0f) {
      length *= (float)tree_power((double)(1.0f - at * inverse), (double)side->taper);
    }
    uint32_t h = hash1(key ^ 0x165667b1u);
    if (side->jitter > 0.0f) {
      length *= 1.0f + side->jitter * (2.0f * tree_unit(h) - 1.0f);
      /* backwards only, and by less than a spacing: places keep their order */
      at -= 0.9f * side->jitter * side->spacing * tree_unit(hash1(h));
    }
    if (!(length >= LEAST_SHOOT)) continue;
    stalk child = {.count = nodes_of(side, order, length),
                   .branch = parent->branch,
                   .key = key,
                   .order = order,
                   .length = length};
    if (pen->writing) {
      float point[3], beta[2], direction[3];
      float thick = axis_to(&w, at, point), radius = 0.5f * (float)p->slender * length;
      float most = (float)p->thickest * thick;
      beta_of(p, side, i, h, beta);
      turn_side(w.along, w.level, side->cosine, side->sine, beta[0], beta[1], direction);
      child.birth = bark_year(&growth, at);
      write_shoot(pen, side, &child, point, direction, radius < most ? radius : most, at);
    }
    pen->used.branches++;
    pen->used.nodes += child.count;
    if (p->leaf_from <= order) leaves_on(pen, &child, 0.0f);
    shoots_of(pen, &child);
  }
}

static stalk stalk_of(const shoot_pen *pen, uint32_t branch) {
  const tree_branch *b = &pen->tree->branches[branch];
  return (stalk){.nodes = &pen->tree->nodes[b->first],
                 .count = b->nodes,
                 .branch = branch,
                 .key = b->key,
                 .order = (int)b->order,
                 .length = b->length};
}

void shoots_on(shoot_pen *pen, uint32_t branch) {
  stalk s = stalk_of(pen, branch);
  if (!(s.length > LEAST_SHOOT) || s.count < 2) return;
  if (pen->tree->plan.leaf_from <= s.order) leaves_on(pen, &s, 0.0f);
  shoots_of(pen, &s);
}

void shoots_leader(shoot_pen *pen, uint32_t branch, float zone) {
  stalk s = stalk_of(pen, branch);
  if (s.length > LEAST_SHOOT && s.count >= 2) leaves_on(pen, &s, zone);
}
