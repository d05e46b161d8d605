/* SPDX-License-Identifier: Apache-2.0
 * Arms into which branches fork: where, how long, to which side and when; that none is lost at a
 * distance; and that wood's tree has the same knots with and without. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "tree.h"

#define DEGREES (180 / 3.14159265358979)
/* Straight branches, far apart, that stand as they leave the stem. */
#define STRAIGHT                                                                                   \
  "age=60 orders=1 sway=0 wander=0 droop=0 upturn=0 elevation_top=20 elevation_base=20 "           \
  "crown_ratio=1 height_max=30 crown_a=0.5 crown_narrowing=0 turns_year=0.3 "

/* What a row's curve is like; a shed branch has none. */
typedef struct {
  const float *points;
  uint64_t count;
} axis;

static axis axis_of(const sozai_curves *c, uint64_t row) {
  for (uint64_t i = 0; i < c->curve_count; i++) {
    if (c->ids[i] != row) continue;
    return (axis){c->points + 3 * c->first[i], c->first[i + 1] - c->first[i]};
  }
  return (axis){NULL, 0};
}

static void direction(const float *a, const float *b, double out[3]) {
  double sum = 0;
  for (int k = 0; k < 3; k++) out[k] = (double)b[k] - (double)a[k], sum += out[k] * out[k];
  for (int k = 0; k < 3; k++) out[k] /= sqrt(sum);
}

/* A straight branch's place so far along it. */
static void place_on(const axis *a, double at, double out[3]) {
  double d[3];
  direction(a->points, a->points + 3 * (a->count - 1), d);
  for (int k = 0; k < 3; k++) out[k] = (double)a->points[k] + at * d[k];
}

/* mm, from the fork below it on the same branch, if it has one and does not stand so near the tip
 * that those beyond are too short to grow; else 0. */
static double gap_before(const sozai_table *b, uint64_t row, double spacing, int *count) {
  double at = cell(b, row, "at"), parent = cell(b, row, "parent"), best = -1;
  if (cell(b, (uint64_t)parent, "length") - at < 1.5 * spacing) return 0;
  for (uint64_t k = 1; k < row; k++) {
    if (cell(b, k, "parent") == parent && cell(b, k, "at") > best) best = cell(b, k, "at");
  }
  if (best < 0) return 0;
  (*count)++;
  return at - best;
}

static void as_asked(void **unused) {
  (void)unused;
  sozai_geometry *g =
      grow("sugi", STRAIGHT "fork_spacing=1500 fork_from=0.2 fork_share=0.8 fork_angle=35", NULL);
  sozai_table b = table_of(g, "branches");
  const sozai_curves *c = curves_of(g, 0);
  double share = 0, gaps = 0, angle_off = 0, joint = 0, least_from = 1, left = 0, level = 0;
  int arms = 0, gap_count = 0, on_arms = 0;
  for (uint64_t i = 1; i < b.rows; i++) {
    uint64_t parent = (uint64_t)cell(&b, i, "parent");
    if (!parent) continue;
    assert_true(parent < i && cell(&b, i, "order") == 1);
    double whole = cell(&b, parent, "length"), at = cell(&b, i, "at");
    double length = cell(&b, i, "length"), d[3], up[3], q[3];
    axis own = axis_of(c, i), on = axis_of(c, parent);
    assert_true(own.count > 1 && on.count > 1);
    arms++;
    on_arms += cell(&b, parent, "parent") != 0;
    share += length / (whole - at);
    assert_true(length / (whole - at) < 0.8 * 1.1 + 1e-3);
    assert_true(length / (whole - at) > 0.8 * 0.7 - 1e-3);
    least_from = fmin(least_from, at / whole);
    gaps += gap_before(&b, i, 1500, &gap_count);
    /* its angle, its side and its beginning */
    direction(on.points, on.points + 3 * (on.count - 1), d);
    direction(own.points, own.points + 3 * (own.count - 1), up);
    double dot = d[0] * up[0] + d[1] * up[1] + d[2] * up[2];
    angle_off = fmax(angle_off, fabs(acos(dot) * DEGREES - 35));
    double side = d[2] * up[0] - d[0] * up[2]; /* of d x up, what is upright */
    left += side > 0;
    level += fabs(up[1] - d[1] * dot) < 0.75 * sin(35 / DEGREES);
    place_on(&on, at, q);
    for (int k = 0; k < 3; k++) joint = fmax(joint, fabs(q[k] - (double)own.points[k]));
    assert_true(cell(&b, i, "birth") >= cell(&b, parent, "birth"));
    assert_true(cell(&b, i, "birth") < 60 && cell(&b, i, "death") == -1);
    assert_true(cell(&b, i, "diameter") <= cell(&b, parent, "diameter"));
  }
  print_message("%d arms, %d of them on arms: %.3f of what is left (0.72), %.2f m apart, the first "
                "at %.2f; %.0f %% to the left, %.0f %% about level, angles off by %.2g, joints by "
                "%.2g mm\n",
                arms, on_arms, share / arms, 1e-3 * gaps / gap_count, least_from, 100 * left / arms,
                100 * level / arms, angle_off, joint);
  assert_true(arms > 200 && on_arms > 50 && gap_count > 20);
  assert_true(fabs(share / arms - 0.72) < 0.02);
  assert_true(gaps / gap_count > 1350 && gaps / gap_count < 1650);
  assert_true(least_from >= 0.2 && least_from < 0.35);
  assert_true(fabs(left / arms - 0.5) < 0.1 && level == arms);
  assert_true(angle_off < 0.1 && joint < 0.05);
  assert_true(statistic(g, "arms") == arms);
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* Nothing but arms is new. */
static void branches_stay(void **unused) {
  (void)unused;
  sozai_geometry *with = grow("keyaki", "age=40 orders=1", NULL),
                 *without = grow("keyaki", "age=40 orders=1 fork_spacing=0", NULL);
  assert_true(statistic(with, "arms") > 20 && statistic(without, "arms") == 0);
  assert_true(statistic(with, "first_order") == statistic(without, "first_order"));
  static const char *const same[] = {"knots", "knot_radii", "rings", "turning", "nodes"};
  for (size_t k = 0; k < sizeof same / sizeof *same; k++) {
    sozai_table a = table_of(with, same[k]), b = table_of(without, same[k]);
    assert_true(a.rows == b.rows && a.rows > 0);
    assert_memory_equal(a.data, b.data, a.rows * a.info->column_count * sizeof(float));
  }
  geometry()->release(with);
  geometry()->release(without);
}

/* Limbs are seen from afar: a tree without them would fall apart. They are of bark, and their
 * shoots are not. */
static void none_is_lost(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("mizunara", "age=30 orders=2 foliage=none", NULL);
  sozai_table b = table_of(g, "branches");
  for (uint32_t level = 0; level <= 8; level += 4) {
    const sozai_mesh *m = mesh_of(g, level);
    char seen[4096] = {0};
    assert_true(b.rows < sizeof seen && strcmp(m->parts[0].id, "bark") == 0);
    for (uint64_t i = m->parts[0].first; i < m->parts[0].first + m->parts[0].count; i++) {
      uint32_t owner = m->owner[m->indices[3 * i]];
      assert_true(owner < b.rows);
      seen[owner] = 1;
    }
    for (uint64_t i = 0; i < b.rows; i++) assert_true(seen[i] || cell(&b, i, "shed") >= 0);
    geometry()->release_mesh(m);
  }
  geometry()->release(g);
}

/* However near forks are, there are six to a branch. */
static void how_many(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi", STRAIGHT "fork_spacing=1 fork_share=0.05", NULL);
  sozai_table b = table_of(g, "branches");
  uint32_t most = 0;
  for (uint64_t i = 1; i < b.rows; i++) {
    uint32_t n = 0;
    for (uint64_t k = 1; k < b.rows; k++) n += cell(&b, k, "parent") == (double)i;
    if (n > most) most = n;
  }
  assert_int_equal(most, 6);
  geometry()->release(g);
  int32_t r = grow_code(NULL, "sugi",
                        "age=300 turns_year=20 branches_turn=12 crown_ratio=1 fork_spacing=1 "
                        "fork_share=1.2 orders=1",
                        NULL, &g);
  assert_true(r != SOZAI_OK && !g);
  print_message("%s\n", geometry()->last_error());
  assert_non_null(strstr(geometry()->last_error(), "above the ceiling"));
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_asked), cmocka_unit_test(branches_stay),
                                     cmocka_unit_test(none_is_lost), cmocka_unit_test(how_many)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
