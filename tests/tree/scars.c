/* SPDX-License-Identifier: Apache-2.0
 * Scars of branches: one over each branch there ever was, as wide as asked for, drawn apart by what
 * the stem has grown since, as bright in the mean as bark without, and none where periderm is gone.
 */
#include <stdio.h>

#include "stem_rings.h"

#define PI 3.14159265358979

/* A straight stem with few branches, all level, all of it periderm. */
#define FEW                                                                                        \
  "age=60 orders=1 sway=0 butt=0 diameter_max=600 bark_depth=0 periderm_age=0 rhytidome_from=900 " \
  "bark_colour=0.5,0.6,0.7 turns_year=0.2 branches_turn=2 elevation_top=0 elevation_base=0 "       \
  "bark_reach=40 slenderness=0.012 scar_shade=0.5 "
/* A place's way from the axis: of the knots' azimuths. */
static double way_of(const rings *r, uint64_t i, uint64_t k) {
  const float *p = r->mesh->points + 3 * index_of(r, i, k);
  return atan2((double)p[2], (double)p[0]);
}

static double turn_to(double to, double from) { return remainder(to - from, 2 * PI); }

/* What there is about a knot: of the marks' places near its height, how far they reach to either
 * side and down, mm, and the darkest at the knot itself. */
typedef struct {
  double left, right, low, high, wound;
} seen_scar;

static seen_scar look(const rings *r, double height, double way, double size) {
  seen_scar s = {.low = 1e9, .high = -1e9};
  for (uint64_t i = 0; i < r->count; i++) {
    double up = height_of(r, i) - height;
    if (fabs(up) > 25 * size) continue;
    for (uint64_t k = 0; k < r->sides; k++) {
      double m = mark(r, i, k), off = turn_to(way_of(r, i, k), way) * out_of(r, i, k);
      if (hypot(off, up) < 0.5 * size) s.wound = fmax(s.wound, m);
      if (m < 0.3) continue;
      s.left = fmax(s.left, -off), s.right = fmax(s.right, off);
      s.low = fmin(s.low, up), s.high = fmax(s.high, up);
    }
  }
  return s;
}

/* Whether nobody's scar is near another's. */
static int alone(const sozai_table *knots, uint64_t which) {
  for (uint64_t i = 0; i < knots->rows; i++) {
    double apart = fabs(cell(knots, i, "height") - cell(knots, which, "height"));
    if (i != which && apart < 30 * (cell(knots, i, "radius") + cell(knots, which, "radius")) / 2)
      return 0;
  }
  return 1;
}

/* The stem's radius at a height in a year. */
static double radius_at(const sozai_table *t, double year, double height) {
  double best = 1e9, found = 0;
  for (uint64_t i = 0; i < t->rows; i++) {
    double off = 1000 * fabs(cell(t, i, "year") - year) + fabs(cell(t, i, "height") - height);
    if (off < best) best = off, found = cell(t, i, "radius");
  }
  return found;
}

typedef struct {
  int scars;
  double width, drawn, droop, wound;
} measured;

/* Of the lone scars of living branches, or of those that died 20 years ago and more; on a few
 * trees.
 */
static measured measure(const char *values, int dead) {
  measured out = {.wound = 9};
  for (int seed = 1; seed <= 6; seed++) {
    char own[700];
    snprintf(own, sizeof own, "%s seed=%d", values, seed);
    sozai_geometry *g = grow("sugi", own, NULL);
    sozai_table knots = table_of(g, "knots"), grown = table_of(g, "rings");
    const sozai_mesh *m = mesh_of(g, 0);
    rings r = rings_of(m);
    for (uint64_t i = 0; i < knots.rows; i++) {
      double death = cell(&knots, i, "death"), height = cell(&knots, i, "height");
      double size = cell(&knots, i, "radius"), now = radius_at(&grown, 60, height);
      if ((death >= 0) != dead || (dead && death > 40) || size < 6 || now < 60) continue;
      if (height < ROOTS || !alone(&knots, i)) continue;
      seen_scar s = look(&r, height, cell(&knots, i, "azimuth"), size);
      double then = dead ? radius_at(&grown, floor(death), height) : now;
      if (!(then > 0)) continue;
      out.scars++;
      out.width += (s.left + s.right) / (2 * size);
      out.drawn += now / then;
      out.droop += (s.high - s.low) / size;
      out.wound = fmin(out.wound, s.wound);
    }
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
  out.width /= out.scars, out.drawn /= out.scars, out.droop /= out.scars;
  print_message("%s branches: %d scars, %.2f diameters wide where the stem has grown by %.2f, "
                "%.2f radii high, at the branch at least %.2f\n",
                dead ? "dead" : "living", out.scars, out.width, out.drawn, out.droop, out.wound);
  assert_true(out.scars >= 12);
  return out;
}

static void as_wide_as_asked(void **unused) {
  (void)unused;
  /* pointed ends are paler than what is looked for */
  for (int wide = 3; wide <= 6; wide += 3) {
    char values[600];
    snprintf(values, sizeof values, FEW "scar_width=%d scar_droop=0.5 crown_ratio=1", wide);
    measured m = measure(values, 0);
    assert_true(fabs(m.width / wide - 0.95) < 0.15);
    /* half the width is `wide` radii: so much of it, and the brow's own height */
    assert_true(fabs(m.droop - (0.5 * wide + 0.5)) < 0.2 * m.droop);
    assert_true(m.wound > 0.6 && fabs(m.drawn - 1) < 0.01);
  }
}

static void drawn_apart(void **unused) {
  (void)unused;
  const char *values = FEW "scar_width=4 scar_droop=0.5 crown_ratio=0.3 crown_age=20 shedding=2";
  measured m = measure(values, 1);
  assert_true(m.drawn > 1.3 && fabs(m.width / (4 * m.drawn) - 0.95) < 0.15);
  /* and no higher */
  assert_true(fabs(m.droop - (0.5 * 4 + 0.5)) < 0.2 * m.droop);
  assert_true(m.wound > 0.6);
}

static void where_they_are(void **unused) {
  (void)unused;
  static const struct {
    const char *more;
    uint32_t level;
    double from, to, least, most;
  } cases[] = {
      {"", 0, 1000, 9000, 0.95, 1.1},            /* all there is */
      {"", 1, 1000, 9000, 0.8, 1.1},             /* coarser */
      {"", 2, 0, 9000, 0, 1e-5},                 /* none from afar */
      {"bark_reach=4", 0, 1000, 3000, 0.7, 1.1}, /* up to there */
      {"bark_reach=4", 0, 4200, 9000, 0, 1e-5},
      {"rhytidome_from=0 rhytidome_age=0 rhytidome_colour=0.5,0.6,0.7", 0, 0, 9000, 0, 1e-5},
      {"scar_shade=0", 0, 0, 9000, 0, 1e-5},
      {"scar_width=0", 0, 0, 9000, 0, 1e-5},
  };
  for (unsigned c = 0; c < sizeof cases / sizeof *cases; c++) {
    char values[700];
    snprintf(
        values, sizeof values,
        FEW
        "turns_year=3 scar_width=6 slenderness=0.016 crown_ratio=0.4 crown_age=20 shedding=3 %s",
        cases[c].more);
    sozai_geometry *g = grow("sugi", values, NULL);
    const sozai_mesh *m = mesh_of(g, cases[c].level);
    rings r = rings_of(m);
    double mean, range = range_of(&r, cases[c].from, cases[c].to, &mean);
    print_message("level %u, %llu points, %g to %g mm, %s: range %.3f, mean %.4f\n", cases[c].level,
                  (unsigned long long)m->point_count, cases[c].from, cases[c].to, cases[c].more,
                  range, mean);
    assert_true(range >= cases[c].least && range <= cases[c].most);
    assert_true(fabs(mean) < 0.01);
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
}

/* A quad is parted from the one to the other of its corners that are more alike: of arms that droop
 * to the left and to the right, one would have teeth else. */
static void arms_without_teeth(void **unused) {
  (void)unused;
  sozai_geometry *g =
      grow("sugi", FEW "turns_year=1 scar_width=6 scar_droop=1 crown_ratio=1", NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  rings r = rings_of(m);
  uint64_t wrong = 0, parted[2] = {0, 0};
  for (uint64_t k = 0; k < r.sides; k++)
    for (uint64_t i = 0; i + 1 < r.count; i++) {
      const uint64_t corner[4] = {index_of(&r, i, k), index_of(&r, i, k + 1),
                                  index_of(&r, i + 1, k + 1), index_of(&r, i + 1, k)};
      /* a side's triangles: one at the ground, two for each ring, one at the tip */
      const uint32_t *t = m->indices + 3 * (k * 2 * r.count + 1 + 2 * i);
      double tone[4];
      for (int c = 0; c < 4; c++) tone[c] = (double)m->colours[3 * corner[c] + 1];
      double rising = fabs(tone[0] - tone[2]), falling = fabs(tone[1] - tone[3]);
      if (fabs(rising - falling) < 0.05) continue;
      int rises = t[0] == corner[0] && t[1] == corner[1] && t[2] == corner[2];
      assert_true(rises || (t[0] == corner[0] && t[1] == corner[1] && t[2] == corner[3]));
      parted[rises]++;
      wrong += rises != (rising < falling);
    }
  print_message("%llu quads of brows parted one way, %llu the other, %llu athwart a brow\n",
                (unsigned long long)parted[0], (unsigned long long)parted[1],
                (unsigned long long)wrong);
  assert_true(parted[0] > 100 && parted[1] > 100);
  assert_int_equal(wrong, 0);
  geometry()->release_mesh(m);
  geometry()->release(g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(as_wide_as_asked), cmocka_unit_test(drawn_apart),
      cmocka_unit_test(where_they_are), cmocka_unit_test(arms_without_teeth)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
