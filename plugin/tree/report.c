/* SPDX-License-Identifier: Apache-2.0 */
#include "report.h"

#include "../core/meter.h"
#include "../core/scalar.h"
#include "../core/status.h"
#include "angle.h"

#define RING_HEIGHTS 33

static int32_t room_for(tree_rows *rows, const sozai_host *host, int table, uint64_t most) {
  uint64_t room = most * tree_table_columns(table) + 1;
  if (host_rehearses(host)) return host_claim(host, room * sizeof *rows->data);
  rows->room = room;
  rows->data = host_alloc(host, (size_t)rows->room * sizeof *rows->data, 64);
  return rows->data ? SOZAI_OK : SOZAI_ERROR_MEMORY;
}

static void add_row(tree *t, int table, const double *values) {
  tree_rows *r = &t->tables[table];
  uint32_t columns = tree_table_columns(table);
  float *to = r->data + r->rows * columns;
  for (uint32_t i = 0; i < columns; i++) to[i] = (float)values[i];
  r->rows++;
}

/* ---- the tables -------------------------------------------------------- */

static void fill_branches(tree *t) {
  for (uint32_t i = 0; i < t->limbs; i++) {
    const tree_branch *b = &t->branches[i];
    const double row[] = {b->order,           b->parent == TREE_NONE ? -1.0 : (double)b->parent,
                          (double)b->at,      (double)b->birth,
                          (double)b->death,   (double)b->shed,
                          (double)b->azimuth, (double)b->elevation,
                          (double)b->length,  2.0 * (double)b->radius};
    add_row(t, TABLE_BRANCHES, row);
  }
}

/* The last year's end of which a branch still grew. */
static int last_year(const tree_plan *p, const tree_bud *b) {
  double end = b->death >= 0.0 ? b->death : p->age;
  int year = (int)end;
  return (double)year < end ? year + 1 : year;
}

static int first_year(const tree_bud *b) { return (int)b->birth + 1; }

static uint64_t radii_of(const tree_plan *p, const tree_bud *buds, uint32_t count) {
  uint64_t n = 0;
  for (uint32_t i = 0; i < count; i++) {
    int years = last_year(p, &buds[i]) - first_year(&buds[i]) + 1;
    if (years > 0) n += (uint64_t)years;
  }
  return n;
}

static void fill_knots(tree *t, const tree_bud *buds, uint32_t count) {
  const tree_plan *p = &t->plan;
  for (uint32_t i = 0; i < count; i++) {
    const tree_bud *b = &buds[i];
    double first = (double)t->tables[TABLE_KNOT_RADII].rows, radius = 0.0;
    for (int year = first_year(b); year <= last_year(p, b); year++) {
      radius = life_radius(p, b, year < p->age ? year : p->age);
      const double row[] = {i, year, radius};
      add_row(t, TABLE_KNOT_RADII, row);
    }
    double azimuth = b->azimuth - 90.0;
    if (azimuth < 0.0) azimuth += 360.0;
    const double row[] = {b->shed < 0.0 && p->orders > 0 ? i + 1.0 : -1.0,
                          b->birth,
                          b->death,
                          b->shed,
                          azimuth * RADIANS,
                          b->elevation * RADIANS,
                          b->z,
                          radius,
                          first,
                          (double)t->tables[TABLE_KNOT_RADII].rows - first};
    add_row(t, TABLE_KNOTS, row);
  }
}

static void fill_rings(tree *t) {
  const tree_plan *p = &t->plan;
  double top = plan_height(p, p->age);
  for (int year = 1; year <= p->years; year++) {
    for (int k = 0; k < RING_HEIGHTS; k++) {
      double h = top * k / (RING_HEIGHTS - 1);
      const double row[] = {year, h, plan_radius(p, h, year < p->age ? year : p->age)};
      add_row(t, TABLE_RINGS, row);
    }
  }
}

/* Of a measured tree the branches are known, not their years: births are even over
 * its age, nearest the ground first, and all of them live. */
static void fill_knots_measured(tree *t) {
  const tree_branch *stem = &t->branches[0];
  for (uint32_t i = 1; i < t->stems; i++) {
    const tree_branch *b = &t->branches[i];
    if (b->order != 1) continue;
    const double row[] = {i,
                          t->plan.age * (double)b->at / (double)stem->length,
                          -1.0,
                          -1.0,
                          ((double)b->azimuth - 90.0) * RADIANS,
                          (double)b->elevation * RADIANS,
                          (double)b->at,
                          (double)b->radius,
                          0.0,
                          0.0};
    add_row(t, TABLE_KNOTS, row);
  }
}

/* Its stem is a cone that rose evenly. */
static void fill_rings_measured(tree *t) {
  const tree_plan *p = &t->plan;
  const tree_branch *stem = &t->branches[0];
  for (int k = 0; k <= p->years; k++) {
    double year = k < p->age ? k : p->age;
    const double foot[] = {year, 0.0, (double)stem->radius * (year / p->age)};
    const double top[] = {year, (double)stem->length, 0.0};
    add_row(t, TABLE_RINGS, foot);
    add_row(t, TABLE_RINGS, top);
  }
}

static double height_of(const tree *t) {
  const tree_branch *stem = &t->branches[0];
  return (double)t->nodes[stem->first + stem->nodes - 1].p[1];
}

/* The stem's diameter at a height. */
static double stem_at(const tree *t, double z) {
  const tree_branch *stem = &t->branches[0];
  const tree_node *a = &t->nodes[stem->first];
  uint32_t i = 0;
  while (i + 2 < stem->nodes && z > (double)a[1].p[1]) a++, i++;
  double low = (double)a[0].p[1], high = (double)a[1].p[1];
  double share = high > low ? (z - low) / (high - low) : 0.0;
  if (share < 0.0) share = 0.0;
  if (share > 1.0) share = 1.0;
  return 2.0 * ((double)a[0].r + share * ((double)a[1].r - (double)a[0].r));
}

/* The straight line between two points as length in cm and two angles. */
static void segment_of(const float *a, const float *b, double out[3]) {
  double x = (double)b[0] - (double)a[0], y = (double)b[1] - (double)a[1],
         z = (double)a[2] - (double)b[2]; /* north */
  double level = scalar_root(x * x + z * z);
  out[0] = scalar_root(level * level + y * y) / 10.0;
  out[1] = angle_of(x, z);
  if (out[1] < 0.0) out[1] += 360.0;
  out[2] = angle_of(y, level);
}

/* The first-order branches that are there; count at most. */
static uint32_t first_order(const tree *t, fit_branch *out) {
  uint32_t count = 0;
  for (uint32_t i = 1; i < t->stems; i++) {
    const tree_branch *b = &t->branches[i];
    if (b->order != 1 || !b->nodes) continue;
    const tree_node *base = &t->nodes[b->first];
    double chord[3], z = (double)base->p[1];
    segment_of(base->p, base[b->nodes - 1].p, chord);
    fit_branch o = {z,        (double)b->azimuth,      (double)b->length,
                    chord[2], 2.0 * (double)b->radius, stem_at(t, z)};
    uint32_t at = count++;
    for (; at > 0 && out[at - 1].z > o.z; at--) out[at] = out[at - 1];
    out[at] = o;
  }
  return count;
}

static void fill_turning(tree *t, const fit_branch *list, uint32_t count, const tree_bud *buds,
                         uint32_t bud_count) {
  double height = height_of(t), turning = 0.0;
  uint32_t at = 0;
  for (uint32_t i = 0; i < count; i++) {
    double d = i ? list[i].azimuth - list[i - 1].azimuth : 0.0;
    if (d < 0.0) d += 360.0;
    turning += d;
    while (buds && at + 1 < bud_count && buds[at].z < list[i].z - 0.01) at++;
    const double row[] = {buds ? buds[at].year : 0.0,
                          turning,
                          d,
                          list[i].azimuth,
                          list[i].z / height,
                          list[i].length / height,
                          buds ? buds[at].elevation : 0.0};
    add_row(t, TABLE_TURNING, row);
  }
}

static void fill_nodes_grown(tree *t) {
  const tree_branch *stem = &t->branches[0];
  const tree_node *tip = &t->nodes[stem->first + stem->nodes - 1];
  const float *from = t->nodes[stem->first].p;
  double diameter = 0.2 * (double)stem->radius;
  uint32_t node = 0;
  for (uint32_t i = 1; i <= t->stems; i++) {
    const tree_branch *b = i < t->stems ? &t->branches[i] : NULL;
    if (b && !b->nodes) continue;
    const tree_node *to = b ? &t->nodes[b->first] : tip;
    double s[3];
    segment_of(from, to->p, s);
    if (b && s[0] < 0.02) continue; /* on the node before */
    double share = (double)to->p[1] / (double)tip->p[1];
    const double row[] = {0.0, -1.0, node++, s[0], s[1], s[2], diameter};
    add_row(t, TABLE_NODES, row);
    diameter = 0.2 * plan_radius(&t->plan, share * plan_height(&t->plan, t->plan.age), t->plan.age);
    from = to->p;
  }
  node = 0;
  from = t->nodes[stem->first].p;
  double block = 0.0;
  for (uint32_t i = 1; i < t->stems; i++) {
    const tree_branch *b = &t->branches[i];
    if (!b->nodes) continue;
    const float *base = t->nodes[b->first].p;
    double s[3], own[3];
    segment_of(from, base, s);
    if (!(s[0] < 0.02)) {
      node++;
      from = base;
    }
    /* as a tape measures it: along the branch, in its chord's direction */
    segment_of(base, t->nodes[b->first + b->nodes - 1].p, own);
    const double row[] = {
        ++block, 0.0, node, (double)b->length / 10.0, own[1], own[2], 0.2 * (double)b->radius};
    add_row(t, TABLE_NODES, row);
  }
}

static void fill_nodes_measured(tree *t, const tree_field *f) {
  for (uint32_t k = 0; k < f->block_count; k++) {
    const field_block *b = &f->blocks[k];
    for (uint32_t i = 0; i < b->rows; i++) {
      const field_row *r = &f->lines[b->first + i];
      const double row[] = {
          k,          b->order ? (double)b->parent : -1.0, b->node + i, r->length, r->theta, r->phi,
          r->diameter};
      add_row(t, TABLE_NODES, row);
    }
  }
}

static void fill_statistics(tree *t, const field_fit *fit) {
  const tree_plan *p = &t->plan;
  double height = height_of(t), breast = 0.0, lowest = height;
  const tree_branch *stem = &t->branches[0];
  for (uint32_t i = 0; i + 1 < stem->nodes; i++) {
    const tree_node *a = &t->nodes[stem->first + i];
    double low = (double)a[0].p[1], high = (double)a[1].p[1];
    if (low <= 1300.0 && high > 1300.0) {
      double share = (1300.0 - low) / (high - low);
      breast = 2.0 * ((double)a[0].r + share * ((double)a[1].r - (double)a[0].r));
    }
  }
  double shed = 0.0;
  for (uint32_t i = 1; i < t->stems; i++) {
    const tree_branch *b = &t->branches[i];
    if (!b->nodes) shed++;
    if (b->order != 1 || !b->nodes || b->death >= 0.0f) continue;
    double z = (double)t->nodes[b->first].p[1];
    if (z < lowest) lowest = z;
  }
  const double row[] = {p->age,
                        height,
                        2.0 * (double)stem->radius,
                        breast,
                        lowest,
                        fit->turns,
                        fit->branches,
                        fit->mean,
                        fit->sd,
                        fit->count > 1 ? fit->least : 0.0,
                        fit->most,
                        fit->a,
                        fit->a_up,
                        fit->a_down,
                        plan_crown_b(p, p->age),
                        fit->rms,
                        (double)(t->order_counts[1] - (t->limbs - t->stems)),
                        (double)t->order_counts[2],
                        (double)t->order_counts[3],
                        (double)t->order_counts[4],
                        t->sprigs,
                        shed,
                        t->limbs - t->stems};
  add_row(t, TABLE_STATISTICS, row);
}

#define FIT_COLUMNS 15
#define FIT_LEAN                                                                                   \
  10 /* and its deviation: angles, whose error is how far tips are off, over the                   \
        branches' length */

static void fit_row(double out[FIT_COLUMNS], double what, const field_fit *f) {
  const double row[FIT_COLUMNS] = {what,        f->a,       f->a_up, f->a_down,  f->turns,
                                   f->branches, f->mean,    f->sd,   f->height,  f->count,
                                   f->lean,     f->lean_sd, f->stem, f->slender, f->ratio};
  for (int i = 0; i < FIT_COLUMNS; i++) out[i] = row[i];
}

static void fill_fit(tree *t, const field_fit *was, const field_fit *is) {
  double a[FIT_COLUMNS], b[FIT_COLUMNS], error[FIT_COLUMNS] = {2.0};
  fit_row(a, 0.0, was);
  fit_row(b, 1.0, is);
  for (int i = 1; i < FIT_COLUMNS; i++) {
    if (i == FIT_LEAN || i == FIT_LEAN + 1) {
      error[i] = (b[i] - a[i]) * RADIANS;
    } else {
      error[i] = a[i] > 0.0 || a[i] < 0.0 ? b[i] / a[i] - 1.0 : 0.0;
    }
  }
  add_row(t, TABLE_FIT, a);
  add_row(t, TABLE_FIT, b);
  add_row(t, TABLE_FIT, error);
}

/* ---- the whole --------------------------------------------------------- */

static int32_t make_rooms(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count,
                          const tree_field *field, const field_fit *was) {
  const tree_plan *p = &t->plan;
  const uint64_t most[TREE_TABLES] = {[TABLE_BRANCHES] = t->limbs,
                                      [TABLE_KNOTS] = buds ? count : t->stems,
                                      [TABLE_KNOT_RADII] = buds ? radii_of(p, buds, count) : 0,
                                      [TABLE_RINGS] = buds ? (uint64_t)p->years * RING_HEIGHTS
                                                           : 2ull * ((uint64_t)p->years + 1),
                                      [TABLE_TURNING] = t->stems,
                                      [TABLE_NODES] = buds ? 2ull * t->stems + 1 : field->row_count,
                                      [TABLE_STATISTICS] = 1,
                                      [TABLE_FIT] = was ? 3 : 0};
  for (int i = 0; i < TREE_TABLES; i++) {
    int32_t r = room_for(&t->tables[i], host, i, most[i]);
    if (r) return r;
  }
  return SOZAI_OK;
}

int32_t report_make(tree *t, const sozai_host *host, const tree_bud *buds, uint32_t count,
                    const tree_field *field, const field_fit *was) {
  const tree_plan *p = &t->plan;
  int32_t r = make_rooms(t, host, buds, count, field, was);
  if (r) return r;
  size_t bytes = (t->stems + 1u) * sizeof(fit_branch);
  if (host_rehearses(host)) {
    r = host_claim(host, bytes);
    host_unclaim(host, bytes);
    return r;
  }
  fit_branch *list = host_alloc(host, bytes, 64);
  if (!list) return SOZAI_ERROR_MEMORY;
  uint32_t there = first_order(t, list);
  field_fit fit;
  fit_branches(&fit, list, there, height_of(t), p->age, p->upslope, plan_crown_b(p, p->age));
  fill_branches(t);
  fill_turning(t, list, there, buds, count);
  host_free(host, list, bytes, 64);
  if (buds) {
    fill_knots(t, buds, count);
    fill_rings(t);
    fill_nodes_grown(t);
  } else {
    fill_knots_measured(t);
    fill_rings_measured(t);
    fill_nodes_measured(t, field);
  }
  fill_statistics(t, &fit);
  if (!was) return SOZAI_OK;
  if (was->stem > 0.0) fit.stem = stem_at(t, was->stem_at);
  fill_fit(t, was, &fit);
  return SOZAI_OK;
}
