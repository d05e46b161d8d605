/* SPDX-License-Identifier: Apache-2.0 */
#include "mesh.h"

#include "../core/hash1.h"
#include "../core/status.h"
#include "bark.h"
#include "parameters.h"

#define REPORT_EACH 0x40000u /* branches, leaves */

uint32_t pen_point(mesh_pen *pen, const float p[3], const float n[3], float u, float v,
                   uint32_t owner) {
  mesh_block *m = pen->mesh;
  uint64_t i = pen->point++;
  for (int c = 0; c < 3; c++) {
    m->points[3 * i + (uint64_t)c] = p[c];
    m->normals[3 * i + (uint64_t)c] = n[c];
    m->colours[3 * i + (uint64_t)c] = pen->colour[c];
  }
  m->uv[2 * i] = u;
  m->uv[2 * i + 1] = v;
  m->owner[i] = owner;
  return (uint32_t)i;
}

void pen_triangle(mesh_pen *pen, uint32_t a, uint32_t b, uint32_t c) {
  uint32_t *to = pen->mesh->indices + 3 * pen->triangle++;
  to[0] = a, to[1] = b, to[2] = c;
}

static void name_part(sozai_part *part, const tree *t, int which, uint64_t first, uint64_t count,
                      int closed) {
  const char *leaf = t->plan.leaf == LEAF_NEEDLE ? "needle" : "leaf";
  *part = (sozai_part){.id = which == PART_BARK    ? "bark"
                             : which == PART_SHOOT ? "shoot"
                                                   : leaf,
                       .first = first,
                       .count = count,
                       .flags = closed ? SOZAI_PART_CLOSED : 0u};
  for (int c = 0; c < 3; c++) part->colour[c] = t->plan.colours[which][c]; /* COLOUR_ likewise */
}

/* Parts without a triangle, or curve, are left out. */
static uint32_t name_parts(sozai_part *parts, const tree *t, const uint64_t ends[3],
                           int closed_leaves) {
  uint64_t begin = 0;
  uint32_t count = 0;
  for (int k = 0; k < 3; k++) {
    if (ends[k] > begin) {
      name_part(&parts[count++], t, k, begin, ends[k] - begin, k != PART_LEAF || closed_leaves);
    }
    begin = ends[k];
  }
  return count;
}

static uint64_t leaves_of(const tree *t, uint32_t stride) {
  return (t->organ_count + stride - 1) / stride;
}

/* Of every stride leaves one, and one of those that the level before drew; by chance, since a
 * shoot's leaves and a fascicle's needles have an order. */
static const tree_organ *leaf_of(const tree *t, uint64_t i, uint32_t stride) {
  for (uint64_t half = stride >> 1; half; half >>= 1) {
    uint32_t second = hash1((uint32_t)i ^ ((uint32_t)half << 24)) & 1u;
    i = 2 * i + (second && (2 * i + 1) * half < t->organ_count);
  }
  return &t->organs[i];
}

/* Each leaf's own, and more alike of one shoot; the mean is the species'. */
static void leaf_colour(const tree *t, const tree_organ *o, float out[3]) {
  uint32_t shoot = hash1(t->branches[o->branch].key ^ 0x1eafc010u);
  uint32_t leaf = hash1((uint32_t)(o - t->organs) ^ t->plan.seed);
  float light = tree_unit(shoot) + tree_unit(leaf) - 1.0f;
  float yellow = tree_unit(hash1(shoot)) + tree_unit(hash1(leaf)) - 1.0f;
  float varied = t->plan.leaf_variation, warm = 0.5f * varied * yellow;
  const float tone[3] = {1.0f + warm, 1.0f, 1.0f - warm};
  for (int c = 0; c < 3; c++) {
    float now = t->plan.colours[COLOUR_LEAF][c] * (1.0f + varied * light) * tone[c];
    out[c] = now < 1.0f ? now : 1.0f;
  }
}

int32_t tree_mesh(const tree *t, const sozai_host *host, uint32_t level, mesh_block **out) {
  uint64_t points = 0, triangles = 0;
  tube_shape tube;
  leaf_shape leaf;
  mesh_pen pen = {.bark = bark_surface_of(&t->plan)};
  stem_skin stem;
  int32_t r = host_progress(host, 0.0, "making the mesh");
  if (r) return r;
  if (t->branch_count && bark_surface_on(&pen.bark, t, &t->branches[0])) {
    stem_skin_of(&stem, t, level);
    pen.stem = &stem;
  }
  for (uint32_t i = 0; i < t->branch_count; i++) {
    uint64_t p, n;
    if (!tube_shape_of(t, &pen.bark, i, level, &tube)) continue;
    tube_size(&tube, &p, &n);
    points += p;
    triangles += n;
  }
  leaf_shape_of(t, level, &leaf);
  uint64_t leaves = leaves_of(t, leaf.stride), work = t->branch_count + leaves, done = 0;
  mesh_block *m =
      mesh_block_make(host, points + leaves * leaf.points, triangles + leaves * leaf.triangles, 1);
  if (!m) return points >> 32 ? SOZAI_ERROR_UNSUPPORTED : SOZAI_ERROR_MEMORY;
  pen.mesh = m;
  uint64_t ends[3] = {0, 0, 0};
  for (uint32_t i = 0; !r && i < t->branch_count; i++) {
    int drawn = tube_shape_of(t, &pen.bark, i, level, &tube);
    if (drawn) tube_write(&pen, t, i, &tube);
    if (i + 1 == t->limbs) ends[0] = pen.triangle;
    /* a stem with bark may be a million points */
    if (++done % REPORT_EACH == 0 || (drawn && tube.fine))
      r = host_progress(host, (double)done / (double)work, "making the mesh");
  }
  ends[1] = pen.triangle;
  for (uint64_t i = 0; !r && i < leaves; i++) {
    const tree_organ *o = leaf_of(t, i, leaf.stride);
    leaf_colour(t, o, pen.colour);
    leaf_write(&pen, o, &leaf);
    if (++done % REPORT_EACH == 0)
      r = host_progress(host, (double)done / (double)work, "making the mesh");
  }
  ends[2] = pen.triangle;
  if (!r) r = host_progress(host, 1.0, "making the mesh");
  if (r) {
    host_free(host, m, m->bytes, 64);
    return r;
  }
  m->out.part_count = name_parts(m->parts, t, ends, leaf.closed);
  *out = m;
  return SOZAI_OK;
}

/* ---- curves ------------------------------------------------------------ */

static void write_curve(curves_block *c, uint64_t curve, uint64_t *point, const tree *t,
                        uint32_t stride, uint32_t id) {
  const tree_branch *b = &t->branches[id];
  const tree_node *nodes = &t->nodes[b->first];
  float ages[RINGS_MOST];
  bark_ages(t, b, ages);
  c->first[curve] = *point;
  c->ids[curve] = id;
  for (uint32_t i = 0; i < b->nodes;
       i = i + 1 < b->nodes && i + stride >= b->nodes ? b->nodes - 1 : i + stride) {
    for (int k = 0; k < 3; k++) c->points[3 * *point + (uint64_t)k] = nodes[i].p[k];
    bark_colour(&t->plan, ages[i], &c->colours[3 * *point]);
    c->radii[(*point)++] = nodes[i].r;
  }
}

static uint32_t strided(uint32_t nodes, uint32_t stride) { return (nodes - 2) / stride + 2; }

int32_t tree_curves(const tree *t, const sozai_host *host, uint32_t level, curves_block **out) {
  uint64_t curves = 0, points = 0;
  tube_shape tube;
  leaf_shape leaf;
  int32_t r = host_progress(host, 0.0, "making curves");
  if (r) return r;
  for (uint32_t i = 0; i < t->branch_count; i++) {
    if (!tube_shape_of(t, NULL, i, level, &tube)) continue;
    curves++;
    points += strided(t->branches[i].nodes, tube.stride);
  }
  leaf_shape_of(t, level, &leaf);
  uint64_t leaves = t->plan.leaf == LEAF_NEEDLE ? leaves_of(t, leaf.stride) : 0;
  curves_block *c = curves_block_make(host, curves + leaves, points + 2 * leaves, 1);
  if (!c) return SOZAI_ERROR_MEMORY;
  uint64_t curve = 0, point = 0, ends[3] = {0, 0, 0};
  for (uint32_t i = 0; i < t->branch_count; i++) {
    if (tube_shape_of(t, NULL, i, level, &tube)) {
      write_curve(c, curve++, &point, t, tube.stride, i);
    }
    if (i + 1 == t->limbs) ends[0] = curve;
  }
  ends[1] = curve;
  for (uint64_t i = 0; i < leaves; i++) {
    const tree_organ *o = leaf_of(t, i, leaf.stride);
    float half = __builtin_sqrtf(o->side[0] * o->side[0] + o->side[1] * o->side[1] +
                                 o->side[2] * o->side[2]);
    c->first[curve] = point;
    c->ids[curve++] = o->branch;
    for (int k = 0; k < 3; k++) {
      c->points[3 * point + (uint64_t)k] = o->base[k];
      c->points[3 * point + 3 + (uint64_t)k] = o->base[k] + leaf.longer * o->axis[k];
    }
    leaf_colour(t, o, &c->colours[3 * point]);
    leaf_colour(t, o, &c->colours[3 * point + 3]);
    c->radii[point] = half * leaf.wider;
    c->radii[point + 1] = 0.1f * half * leaf.wider;
    point += 2;
  }
  ends[2] = curve;
  c->first[curve] = point;
  c->out.part_count = name_parts(c->parts, t, ends, 0);
  r = host_progress(host, 1.0, "making curves");
  if (r) {
    host_free(host, c, c->bytes, 64);
    return r;
  }
  *out = c;
  return SOZAI_OK;
}
