/* SPDX-License-Identifier: Apache-2.0
 * Collars: where a branch's tube comes out of its parent's, it lies along it, as wide as a collar
 * is, in the parent's colour and under its bark. */
#include <stdio.h>

#include "stem_rings.h"

/* ---- a tube, by its axis --------------------------------------------------------- */

typedef struct {
  double p[3], r;
} node;

typedef struct {
  node *of;
  uint64_t count;
} axis;

typedef struct {
  double off;       /* mm: from its surface, above 0 outside */
  double normal[3]; /* out of the axis, */
  double along[3];  /* and along it */
  double radius;
} place;

static double dot(const double *a, const double *b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void scale(double *v, double by) {
  for (int c = 0; c < 3; c++) v[c] *= by;
}

static place near_axis(const axis *a, const double p[3]) {
  place best = {.off = 1e30};
  for (uint64_t k = 0; k + 1 < a->count; k++) {
    const node *n = &a->of[k];
    place now = {.off = 0};
    double o[3];
    for (int c = 0; c < 3; c++) now.along[c] = n[1].p[c] - n[0].p[c], o[c] = p[c] - n[0].p[c];
    double t = fmin(1, fmax(0, dot(now.along, o) / dot(now.along, now.along)));
    for (int c = 0; c < 3; c++) now.normal[c] = o[c] - t * now.along[c];
    now.radius = n[0].r + t * (n[1].r - n[0].r);
    now.off = sqrt(dot(now.normal, now.normal)) - now.radius;
    if (now.off < best.off) best = now;
  }
  scale(best.normal, 1 / sqrt(dot(best.normal, best.normal)));
  scale(best.along, 1 / sqrt(dot(best.along, best.along)));
  return best;
}

/* To be freed. */
static axis curve_of(const sozai_curves *c, uint64_t owner) {
  uint64_t curve = 0;
  while (c->ids[curve] != owner) curve++;
  axis a = {.count = c->first[curve + 1] - c->first[curve]};
  a.of = malloc(a.count * sizeof *a.of);
  assert_non_null(a.of);
  for (uint64_t k = 0; k < a.count; k++) {
    uint64_t at = c->first[curve] + k;
    for (uint64_t x = 0; x < 3; x++) a.of[k].p[x] = (double)c->points[3 * at + x];
    a.of[k].r = (double)c->radii[at];
  }
  return a;
}

static uint64_t first_of(const sozai_mesh *m, uint64_t owner) {
  uint64_t first = 0;
  while (m->owner[first] != owner) first++;
  return first;
}

/* Of a tube in a mesh, which follows its curve more closely: by its rings that are round, where
 * most are. To be freed. */
static axis tube_of(const sozai_mesh *m, uint64_t owner) {
  rings r = rings_from(m, first_of(m, owner));
  axis a = {.of = malloc(r.count * sizeof *a.of)};
  assert_non_null(a.of);
  for (uint64_t i = 0; i < r.count; i++) {
    node n = {.r = 0};
    double least = 1e9, most = 0;
    for (uint64_t k = 0; k < r.sides; k++)
      for (uint64_t c = 0; c < 3; c++)
        n.p[c] += (double)m->points[3 * index_of(&r, i, k) + c] / (double)r.sides;
    for (uint64_t k = 0; k < r.sides; k++) {
      double d[3];
      for (uint64_t c = 0; c < 3; c++)
        d[c] = (double)m->points[3 * index_of(&r, i, k) + c] - n.p[c];
      least = fmin(least, sqrt(dot(d, d))), most = fmax(most, sqrt(dot(d, d)));
    }
    n.r = most;
    if (most < 1.01 * least) a.of[a.count++] = n;
  }
  if (a.count < r.count / 2) a.count = 0; /* it is furrowed */
  return a;
}

/* Where a branch's triangles come out of the parent: on an edge with one end in and one out. */
typedef struct {
  double p[3], normal[3], colour[3]; /* of the branch's mesh */
  double face[3];                    /* the triangle's normal */
  place at;
} crossing;

typedef struct {
  const sozai_mesh *mesh;
  const sozai_curves *axes;
  sozai_table branches;
  axis parent;
  uint64_t owner, next;            /* next: triangle */
  double radius, base[3], lead[3]; /* of its axis: where it begins, and its direction */
  crossing *of;
  uint64_t count;
} joint;

static void set_face(const sozai_mesh *m, const uint32_t *t, double out[3]) {
  double a[3], b[3];
  for (uint64_t c = 0; c < 3; c++) {
    a[c] = (double)m->points[3 * t[1] + c] - (double)m->points[3 * t[0] + c];
    b[c] = (double)m->points[3 * t[2] + c] - (double)m->points[3 * t[0] + c];
  }
  for (int c = 0; c < 3; c++)
    out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
  double square = dot(out, out);
  if (square > 0) scale(out, 1 / sqrt(square));
}

static void add_crossing(joint *j, const uint32_t *corners, uint32_t a, uint32_t b) {
  const sozai_mesh *m = j->mesh;
  double p[2][3];
  for (uint64_t c = 0; c < 3; c++) {
    p[0][c] = (double)m->points[3 * a + c];
    p[1][c] = (double)m->points[3 * b + c];
  }
  double in = near_axis(&j->parent, p[0]).off;
  double out = near_axis(&j->parent, p[1]).off;
  if (!(in < 0 && out >= 0)) return;
  crossing *x = &j->of[j->count++];
  double t = in / (in - out);
  for (uint64_t c = 0; c < 3; c++) {
    x->p[c] = p[0][c] + t * (p[1][c] - p[0][c]);
    x->normal[c] = (double)m->normals[3 * a + c] * (1 - t) + (double)m->normals[3 * b + c] * t;
    x->colour[c] = (double)m->colours[3 * a + c] * (1 - t) + (double)m->colours[3 * b + c] * t;
  }
  scale(x->normal, 1 / sqrt(dot(x->normal, x->normal)));
  set_face(m, corners, x->face);
  x->at = near_axis(&j->parent, x->p);
}

#define FAR 1500 /* mm from its base: no branch that is looked at is in its parent there */

/* Of each branch thicker than least that stands over the stem's roots; to be freed. */
static void find(joint *j) {
  const sozai_mesh *m = j->mesh;
  axis own = curve_of(j->axes, j->owner);
  for (int c = 0; c < 3; c++) {
    j->base[c] = own.of[0].p[c];
    j->lead[c] = own.of[1].p[c] - own.of[0].p[c];
  }
  free(own.of);
  scale(j->lead, 1 / sqrt(dot(j->lead, j->lead)));
  j->radius = cell(&j->branches, j->owner, "diameter") / 2;
  uint64_t parent = (uint64_t)cell(&j->branches, j->owner, "parent");
  j->parent = tube_of(m, parent);
  if (!j->parent.count) {
    free(j->parent.of);
    j->parent = curve_of(j->axes, parent);
  }
  j->count = 0;
  /* branches' triangles follow one another */
  uint64_t end = m->parts[0].first + m->parts[0].count, last = j->next;
  while (last < end && m->owner[m->indices[3 * last]] <= j->owner) last++;
  j->of = malloc((6 * (last - j->next) + 1) * sizeof *j->of);
  assert_non_null(j->of);
  for (; j->next < last; j->next++) {
    const uint32_t *t = m->indices + 3 * j->next;
    double d[3];
    for (uint64_t c = 0; c < 3; c++) d[c] = (double)m->points[3 * t[0] + c] - j->base[c];
    if (m->owner[t[0]] != j->owner || dot(d, d) > FAR * FAR) continue;
    for (int c = 0; c < 3; c++) {
      add_crossing(j, t, t[c], t[(c + 1) % 3]);
      add_crossing(j, t, t[(c + 1) % 3], t[c]);
    }
  }
}

/* Of whole trees, their branches in turn, as far as they have collars. */
static void each(const char *preset, const char *values, double least,
                 void (*look)(joint *j, void *user), void *user) {
  sozai_geometry *g = grow(preset, values, NULL);
  joint j = {.mesh = mesh_of(g, 0), .axes = curves_of(g, 0), .branches = table_of(g, "branches")};
  for (j.owner = 1; j.owner < j.branches.rows; j.owner++) {
    if (cell(&j.branches, j.owner, "diameter") < 2 * least) continue;
    if (cell(&j.branches, j.owner, "shed") >= 0 && cell(&j.branches, j.owner, "shed") < 1) continue;
    int drawn = 0;
    for (uint64_t k = 0; k < j.axes->curve_count; k++) drawn |= j.axes->ids[k] == j.owner;
    if (!drawn) continue;
    find(&j);
    if (j.count) look(&j, user);
    free(j.of);
    free(j.parent.of);
  }
  geometry()->release_curves(j.axes);
  geometry()->release_mesh(j.mesh);
  geometry()->release(g);
}

static double degrees(const double *a, const double *b) {
  return acos(fmax(-1, fmin(1, dot(a, b)))) * 180 / 3.14159265;
}

/* ---- no edge ------------------------------------------------------------------- */

typedef struct {
  double shaded, sum, most, count, branches;
} angles;

static void add_angles(joint *j, void *user) {
  angles *a = user;
  /* on roots the parent's tube is another */
  if (j->base[1] < ROOTS && cell(&j->branches, j->owner, "parent") < 1) return;
  for (uint64_t i = 0; i < j->count; i++) {
    double off = degrees(j->of[i].face, j->of[i].at.normal);
    a->shaded += degrees(j->of[i].normal, j->of[i].at.normal);
    a->sum += off, a->most = fmax(a->most, off);
    a->count++;
  }
  a->branches++;
}

/* Triangles there, and their shading: a tube without a collar stands off at some 80 degrees. */
static void comes_out_along_it(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"keyaki", "mizunara", "cherry", "sugi", "akamatsu", "momiji"};
  for (int i = 0; i < 6; i++) {
    angles a = {0};
    each(kinds[i], "age=45 orders=1 bark_depth=0 scar_shade=0 lenticel_density=0", 20, add_angles,
         &a);
    print_message("%-10s %3.0f branches: off the parent's surface by %4.1f degrees, %4.1f at most; "
                  "shaded, %.1f\n",
                  kinds[i], a.branches, a.sum / a.count, a.most, a.shaded / a.count);
    assert_true(a.branches > 5);
    assert_true(a.sum / a.count < 20 && a.shaded / a.count < 3);
  }
}

/* ---- as wide ------------------------------------------------------------------- */

/* Level branches of a straight stem that is no cone, few of them. */
#define FEW                                                                                        \
  "age=60 orders=1 sway=0 butt=0 diameter_max=600 stem_form=0.3 turns_year=0.2 branches_turn=2 "   \
  "elevation_top=0 elevation_base=0 droop=0 upturn=0 wander=0 scar_shade=0 lenticel_density=0 "

typedef struct {
  double below, above, beside, bent, count;
} reach;

/* How far a line of a branch's mesh turns from one ring to the next, at most: degrees. */
static double sharpest(const joint *j) {
  const sozai_mesh *m = j->mesh;
  rings own = rings_from(m, first_of(m, j->owner));
  double most = 0;
  for (uint64_t k = 0; k < own.sides; k++) {
    double before[3], now[3];
    for (uint64_t i = 0; i + 1 < own.count; i++) {
      const float *p = m->points + 3 * index_of(&own, i, k);
      const float *q = m->points + 3 * index_of(&own, i + 1, k);
      for (int c = 0; c < 3; c++) now[c] = (double)q[c] - (double)p[c];
      scale(now, 1 / sqrt(dot(now, now)));
      if (i) most = fmax(most, degrees(before, now));
      for (int c = 0; c < 3; c++) before[c] = now[c];
    }
  }
  return most;
}

/* In the branch's radii, from its axis; less what branches as thick as the stem have less. */
static void add_reach(joint *j, void *user) {
  reach *r = user;
  double low = 0, high = 0, beside = 0;
  for (uint64_t i = 0; i < j->count; i++) {
    double up = j->of[i].p[1] - j->base[1];
    /* round the stem */
    double side = fabs(j->of[i].p[0] * j->lead[2] - j->of[i].p[2] * j->lead[0]);
    low = fmin(low, up), high = fmax(high, up), beside = fmax(beside, side);
  }
  double least = 1 - 0.4 * j->radius / j->of[0].at.radius;
  r->below += (-low / j->radius - 1) / least;
  r->above += (high / j->radius - 1) / least;
  r->beside += (beside / j->radius - 1) / least;
  r->bent += sharpest(j);
  r->count++;
}

static void as_wide_as_a_collar(void **unused) {
  (void)unused;
  reach r = {0};
  each("sugi", FEW "bark_depth=0 slenderness=0.02", 8, add_reach, &r);
  print_message("%.0f branches: %.2f radii below, %.2f above, %.2f beside; bent by %.0f degrees\n",
                r.count, r.below / r.count, r.above / r.count, r.beside / r.count,
                r.bent / r.count);
  assert_true(r.count > 5);
  /* 1.3, 0.9 and 0.8, and some of the hem */
  assert_true(fabs(r.below / r.count / 1.3 - 1.1) < 0.15);
  assert_true(fabs(r.above / r.count / 0.9 - 1.1) < 0.15);
  assert_true(r.beside / r.count > 0.6 && r.beside / r.count < 1.0);
  /* 90 degrees in all, and what the hem is askew */
  assert_true(r.bent / r.count < 30);
}

/* ---- of the parent's colour, and under its bark ----------------------------------- */

typedef struct {
  double worst, other;
} tints;

static void add_tints(joint *j, void *user) {
  tints *t = user;
  double own[3] = {0, 0, 0};
  const sozai_mesh *m = j->mesh;
  /* the stem's, at the nearest of its points */
  for (uint64_t i = 0; i < j->count; i++) {
    double nearest = 1e9, worst = 0;
    const crossing *x = &j->of[i];
    for (uint64_t k = 0; k < m->point_count && m->owner[k] == 0; k++) {
      double off = fabs((double)m->points[3 * k + 1] - x->p[1]);
      if (off > nearest) continue;
      nearest = off;
      for (uint64_t c = 0; c < 3; c++) own[c] = (double)m->colours[3 * k + c];
    }
    for (int c = 0; c < 3; c++) worst = fmax(worst, fabs(own[c] - x->colour[c]));
    t->worst = fmax(t->worst, worst);
  }
  /* and the branch's tip is another */
  for (uint64_t k = 0; k < m->point_count; k++)
    if (m->owner[k] == j->owner)
      t->other = fmax(t->other, fabs((double)m->colours[3 * k] - own[0]));
}

static void in_its_parents_colour(void **unused) {
  (void)unused;
  tints t = {0};
  each("sugi",
       FEW "bark_depth=0 bark_colour=0.2,0.3,0.4 rhytidome_colour=0.6,0.5,0.4 rhytidome_from=5 "
           "rhytidome_age=60 slenderness=0.02",
       8, add_tints, &t);
  print_message("off the stem's colour by %.3f at most; elsewhere by %.3f\n", t.worst, t.other);
  assert_true(t.worst < 0.03 && t.other > 0.2);
}

typedef struct {
  rings stem;
  double sum, squares, relief, squared, count;
} barks;

/* The stem's surface at a height and on a side, mm from its axis. */
static double stem_out(const rings *r, double height, double x, double z) {
  uint64_t i = 0;
  double least[2] = {1e9, 1e9}, out[2] = {0, 0};
  while (i + 2 < r->count && height_of(r, i + 1) < height) i++;
  for (uint64_t n = 0; n < 2; n++)
    for (uint64_t k = 0; k < r->sides; k++) {
      const float *p = r->mesh->points + 3 * index_of(r, i + n, k);
      double off = hypot((double)p[0] - x, (double)p[2] - z);
      if (off < least[n]) least[n] = off, out[n] = out_of(r, i + n, k);
    }
  double from = height_of(r, i), to = height_of(r, i + 1);
  double share = to > from ? (height - from) / (to - from) : 0;
  return out[0] + share * (out[1] - out[0]);
}

/* A collar's first ring: so deep under the stem's surface, furrow by furrow. */
static void add_barks(joint *j, void *user) {
  barks *b = user;
  const sozai_mesh *m = j->mesh;
  rings own = rings_from(m, first_of(m, j->owner));
  if (!b->stem.sides) b->stem = rings_of(m);
  for (uint64_t k = 0; k < own.sides; k++) {
    const float *p = m->points + 3 * index_of(&own, 0, k);
    double x = (double)p[0], z = (double)p[2], out = hypot(x, z);
    double stem = stem_out(&b->stem, (double)p[1], x, z), off = out - stem;
    double bare = near_axis(&j->parent, (double[3]){x, (double)p[1], z}).radius;
    b->sum += off, b->squares += off * off;
    b->relief += stem - bare, b->squared += (stem - bare) * (stem - bare);
    b->count++;
  }
}

static void under_its_bark(void **unused) {
  (void)unused;
  barks b = {.count = 0};
  /* branches of more than 60 mm of radius, whose collars are as fine as bark is */
  each("sugi",
       FEW "rhytidome_from=0 rhytidome_age=0 bark_depth=16 bark_width=50 bark_length=90 "
           "slenderness=0.2 thickest=0.6 bark_reach=60",
       62, add_barks, &b);
  double mean = b.sum / b.count, relief = b.relief / b.count;
  double apart = sqrt(b.squares / b.count - mean * mean);
  double rough = sqrt(b.squared / b.count - relief * relief);
  print_message("%.0f places: %.2f mm under the bark, %.2f mm (sd); of the bark %.2f mm (sd)\n",
                b.count, -mean, apart, rough);
  assert_true(b.count > 100);
  assert_true(mean < 0 && rough > 3 && apart < 0.45 * rough);
}

/* ---- and bends ------------------------------------------------------------------- */

typedef struct {
  double nodes, rings, off, count;
} bends;

/* From piece to piece, beyond the collar: degrees, the most. */
static double most_bent(const axis *a, uint64_t from) {
  double most = 0;
  for (uint64_t k = from; k + 2 < a->count; k++) {
    double d[2][3];
    for (int i = 0; i < 2; i++) {
      for (uint64_t c = 0; c < 3; c++)
        d[i][c] = a->of[k + (uint64_t)i + 1].p[c] - a->of[k + (uint64_t)i].p[c];
      scale(d[i], 1 / sqrt(dot(d[i], d[i])));
    }
    most = fmax(most, degrees(d[0], d[1]));
  }
  return most;
}

static void add_bends(joint *j, void *user) {
  bends *b = user;
  axis nodes = curve_of(j->axes, j->owner), tube = tube_of(j->mesh, j->owner);
  b->nodes += most_bent(&nodes, 4);
  b->rings += most_bent(&tube, 4);
  /* through the nodes */
  for (uint64_t k = 6; k < nodes.count; k++) {
    double nearest = 1e9;
    for (uint64_t i = 0; i < tube.count; i++) {
      double d[3];
      for (int c = 0; c < 3; c++) d[c] = tube.of[i].p[c] - nodes.of[k].p[c];
      nearest = fmin(nearest, sqrt(dot(d, d)));
    }
    b->off = fmax(b->off, nearest);
  }
  b->count++;
  free(nodes.of);
  free(tube.of);
}

/* Limbs are curves through their nodes. */
static void bent_gently(void **unused) {
  (void)unused;
  bends b = {.count = 0};
  each("keyaki", "age=60 orders=1 bark_depth=0", 26, add_bends, &b);
  print_message(
      "%.0f limbs: bent by %.1f degrees at a node, by %.1f at a ring; %.4f mm off a node\n",
      b.count, b.nodes / b.count, b.rings / b.count, b.off);
  assert_true(b.count > 50 && b.off < 0.02);
  assert_true(b.rings < 0.65 * b.nodes);
}

/* ---- whatever is asked for ------------------------------------------------------- */

/* In radii, from its axis. */
static void add_furthest(joint *j, void *user) {
  double *worst = user;
  axis line = curve_of(j->axes, j->owner);
  rings own = rings_from(j->mesh, first_of(j->mesh, j->owner));
  uint64_t most = own.count < 12 ? own.count : 12; /* beyond it is a tube */
  for (uint64_t k = index_of(&own, 0, 0); k < index_of(&own, most, 0); k++) {
    double p[3];
    for (uint64_t c = 0; c < 3; c++) {
      p[c] = (double)j->mesh->points[3 * k + c];
      assert_true(isfinite(p[c]));
    }
    place at = near_axis(&line, p);
    *worst = fmax(*worst, (at.off + at.radius) / j->radius);
  }
  free(line.of);
}

/* Branches nearly as thick as their parents, nearly along them, crooked, hanging, on a stem that
 * leans. */
static void no_point_flies_off(void **unused) {
  (void)unused;
  static const char *const how[] = {"thickest=0.9 slenderness=0.2",
                                    "fork_angle=1 elevation_top=88 elevation_base=88",
                                    "fork_angle=120 elevation_top=-80 elevation_base=-80",
                                    "wander=90 sway=0.3 droop=120",
                                    "thickest=0.12 branches_turn=12 turns_year=5",
                                    "stem_form=2 butt=2 thickest=0.95"};
  for (int i = 0; i < 6; i++) {
    char values[160];
    double worst = 0;
    snprintf(values, sizeof values, "age=30 orders=1 bark_depth=0 %s", how[i]);
    each(i % 2 ? "keyaki" : "mizunara", values, 8, add_furthest, &worst);
    print_message("%-52s %.2f radii from a branch's axis\n", how[i], worst);
    /* below: the branch, its collar and the hem of that */
    assert_true(worst > 1 && worst < 1 + 1.5 * 1.3 + 0.02);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(comes_out_along_it),    cmocka_unit_test(as_wide_as_a_collar),
      cmocka_unit_test(in_its_parents_colour), cmocka_unit_test(under_its_bark),
      cmocka_unit_test(bent_gently),           cmocka_unit_test(no_point_flies_off),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
