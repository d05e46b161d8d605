/* SPDX-License-Identifier: Apache-2.0
 *
 * From a field table to branches: node positions summed from the ground, each
 * segment a cone. A thickness that was not measured comes from the parent at
 * the base, and between measured ones along a straight line.
 */
#include "../core/hash1.h"
#include "../core/status.h"
#include "field.h"
#include "stem.h"

#define TRUNK_SLENDER 0.009 /* radius over length, where not even the trunk was measured */
#define TIP_SHARE 0.08      /* of the base */

void field_radii(const field_row *rows, uint32_t count, double base, tree_node *nodes) {
  double total = 0.0, behind = 0.0;
  for (uint32_t i = 0; i < count; i++) total += rows[i].length;
  double r0 = rows[0].diameter > 0.0 ? rows[0].diameter * 5.0 : base;
  double tip = r0 * TIP_SHARE, at = 0.0, next_at = total, next = tip;
  for (uint32_t i = 0; i <= count; i++) {
    if (i < count && rows[i].diameter > 0.0) r0 = rows[i].diameter * 5.0, at = behind;
    if (i == 0 || (i < count && rows[i].diameter > 0.0)) {
      /* the next that was measured, or the tip */
      double along = behind;
      next_at = total;
      next = tip < r0 ? tip : r0;
      for (uint32_t k = i; k + 1 < count; k++) {
        along += rows[k].length;
        if (rows[k + 1].diameter > 0.0) {
          next = rows[k + 1].diameter * 5.0;
          next_at = along;
          break;
        }
      }
    }
    double share = next_at > at ? (behind - at) / (next_at - at) : 0.0;
    nodes[i].r = (float)(r0 + share * (next - r0));
    if (nodes[i].r < 0.2f) nodes[i].r = 0.2f;
    if (i < count) behind += rows[i].length;
  }
}

static float length_of(const tree_node *nodes, uint32_t from, uint32_t to) {
  float sum = 0.0f;
  for (uint32_t i = from; i < to; i++) {
    float d = 0.0f;
    for (int c = 0; c < 3; c++) {
      float x = nodes[i + 1].p[c] - nodes[i].p[c];
      d += x * x;
    }
    sum += __builtin_sqrtf(d);
  }
  return sum;
}

static void grow_block(tree *t, const tree_field *f, uint32_t index) {
  const field_block *b = &f->blocks[index];
  const field_row *rows = &f->lines[b->first];
  tree_branch *o = &t->branches[index];
  tree_node *nodes = &t->nodes[t->node_count];
  float p[3] = {0.0f, 0.0f, 0.0f};
  double base = 0.0, total = 0.0;
  *o = (tree_branch){.first = t->node_count,
                     .nodes = b->rows + 1,
                     .parent = b->parent,
                     .order = b->order,
                     .key = hash1(t->plan.seed * 0x9e3779b1u + hash1(index + 1u)),
                     .azimuth = (float)rows[0].theta,
                     .elevation = (float)rows[0].phi,
                     .death = TREE_ALIVE,
                     .shed = TREE_ALIVE};
  for (uint32_t i = 0; i < b->rows; i++) total += rows[i].length * 10.0;
  if (b->order) {
    const tree_branch *parent = &t->branches[b->parent];
    const field_block *pb = &f->blocks[b->parent];
    const tree_node *own = &t->nodes[parent->first], *at = &own[b->node - pb->node];
    for (int c = 0; c < 3; c++) p[c] = at->p[c];
    o->at = length_of(own, 0, b->node - pb->node);
    base = t->plan.thickest * (double)at->r;
    /* no years were measured: as if the trunk had risen evenly */
    float top = t->nodes[t->branches[0].nodes - 1].p[1];
    float share = top > 0.0f ? p[1] / top : 0.0f;
    o->birth = (float)t->plan.age * (share < 0.0f ? 0.0f : share > 1.0f ? 1.0f : share);
  } else {
    base = TRUNK_SLENDER * total;
  }
  field_radii(rows, b->rows, base, nodes);
  for (uint32_t i = 0; i <= b->rows; i++) {
    for (int c = 0; c < 3; c++) nodes[i].p[c] = p[c];
    if (i < b->rows) stem_step(p, rows[i].length * 10.0, rows[i].theta, rows[i].phi);
  }
  o->length = (float)total;
  o->radius = nodes[0].r;
  t->node_count += o->nodes;
}

int32_t field_grow(tree *t, const sozai_host *host, const tree_field *f) {
  t->branch_room = f->block_count;
  t->node_room = (uint64_t)f->row_count + f->block_count;
  t->branches = host_alloc(host, t->branch_room * sizeof *t->branches, 64);
  t->nodes = t->branches ? host_alloc(host, t->node_room * sizeof *t->nodes, 64) : NULL;
  if (!t->nodes) return SOZAI_ERROR_MEMORY;
  for (uint32_t i = 0; i < f->block_count; i++) {
    grow_block(t, f, i);
    if ((int)f->blocks[i].order > t->measured) t->measured = (int)f->blocks[i].order;
  }
  t->branch_count = t->stems = t->limbs = f->block_count;
  return SOZAI_OK;
}
