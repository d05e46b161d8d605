/* SPDX-License-Identifier: Apache-2.0
 * Bark by its age: each place has the colour that the species' values say for the
 * years since it was laid down, in meshes and curves, at every level. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "tree.h"

static double number_of(const sozai_geometry *g, const char *id) {
  sozai_value v;
  assert_int_equal(geometry()->value(g, id, &v), SOZAI_OK);
  return v.number[0];
}

/* ---- what docs/tree.md says ------------------------------------------------- */

typedef struct {
  double shoot[3], periderm[3], rhytidome[3], periderm_age, from, age;
} bark;

static bark bark_of(const sozai_geometry *g) {
  bark b = {.periderm_age = number_of(g, "periderm_age"),
            .from = number_of(g, "rhytidome_from"),
            .age = number_of(g, "rhytidome_age")};
  static const char *const ids[] = {"shoot_colour", "bark_colour", "rhytidome_colour"};
  double *const to[] = {b.shoot, b.periderm, b.rhytidome};
  for (int i = 0; i < 3; i++) {
    sozai_value v;
    assert_int_equal(geometry()->value(g, ids[i], &v), SOZAI_OK);
    for (int c = 0; c < 3; c++) to[i][c] = v.number[c];
  }
  return b;
}

static double smooth(double x, double from, double to) {
  double s = to > from ? (x - from) / (to - from) : x > from ? 1 : 0;
  s = fmin(1, fmax(0, s));
  return s * s * (3 - 2 * s);
}

/* How far a colour is from that of the bark of that age. */
static double off(const bark *b, double age, const float *colour) {
  double grown = smooth(age, 0, b->periderm_age), old = smooth(age, b->from, b->age), worst = 0;
  for (int c = 0; c < 3; c++) {
    double now = b->shoot[c] * (1 - grown) + b->periderm[c] * grown;
    now = now * (1 - old) + b->rhytidome[c] * old;
    worst = fmax(worst, fabs(now - (double)colour[c]));
  }
  return worst;
}

/* When Richards' curve of the stem's height passes it. */
static double year_of_height(const sozai_geometry *g, double mm) {
  double share = mm / (1000 * number_of(g, "height_max"));
  share = pow(fmax(0, share), 1 / number_of(g, "height_shape"));
  return -log(1 - fmin(share, 1 - 1e-12)) / number_of(g, "height_rate");
}

/* ---- the species' values ------------------------------------------------------ */

static double stem_off(const sozai_geometry *g, const sozai_curves *c) {
  bark b = bark_of(g);
  double age = number_of(g, "age"), worst = 0;
  for (uint64_t i = c->first[0]; i < c->first[1]; i++) {
    double years = fmax(0, age - year_of_height(g, (double)c->points[3 * i + 1]));
    worst = fmax(worst, off(&b, years, c->colours + 3 * i));
  }
  return worst;
}

/* Branches are as old at their base as the stem was since; at the tip of a live one, as of this
 * year. A dead one's bark grows no older. */
static double branches_off(const sozai_geometry *g, const sozai_curves *c) {
  bark b = bark_of(g);
  sozai_table t = table_of(g, "branches");
  double age = number_of(g, "age"), worst = 0;
  for (uint64_t i = 1; i < c->curve_count && c->ids[i] < t.rows; i++) {
    double birth = cell(&t, c->ids[i], "birth"), death = cell(&t, c->ids[i], "death");
    const float *base = c->colours + 3 * c->first[i], *tip = c->colours + 3 * c->first[i + 1] - 3;
    worst = fmax(worst, off(&b, (death < 0 ? age : death) - birth, base));
    if (death < 0) worst = fmax(worst, off(&b, 0, tip));
  }
  return worst;
}

static void as_the_species_says(void **unused) {
  (void)unused;
  static const int ages[] = {6, 40, 120};
  const sozai_generator_info *info = geometry()->find("tree");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    double worst[2] = {0, 0};
    for (int k = 0; k < 3; k++) {
      char values[64];
      snprintf(values, sizeof values, "age=%d orders=1", ages[k]);
      sozai_geometry *g = grow(info->presets[i]->id, values, NULL);
      const sozai_curves *c = curves_of(g, 0);
      assert_non_null(c->colours);
      worst[0] = fmax(worst[0], stem_off(g, c));
      worst[1] = fmax(worst[1], branches_off(g, c));
      geometry()->release_curves(c);
      geometry()->release(g);
    }
    print_message("%-14s colours off by %.4f on stems, %.4f on branches\n", info->presets[i]->id,
                  worst[0], worst[1]);
    assert_true(worst[0] < 0.01 && worst[1] < 1e-4);
  }
}

/* What sets the species apart, in words, at 60 years: red, green, blue. */
static void as_dendrology_says(void **unused) {
  (void)unused;
  const float *at[2];
  sozai_geometry *g = grow("akamatsu", "age=60 orders=1", NULL);
  const sozai_curves *c = curves_of(g, 0);
  at[0] = c->colours, at[1] = c->colours + 3 * (c->first[1] - 12);
  /* grey-brown below, orange-red above */
  assert_true(at[0][0] - at[0][2] < 0.12f && at[1][0] - at[1][2] > 0.25f);
  geometry()->release_curves(c);
  geometry()->release(g);
  g = grow("shirakaba", "age=120 orders=3", NULL);
  c = curves_of(g, 0);
  bool white = false;
  for (uint64_t i = 3 * c->first[0]; i < 3 * c->first[1]; i += 3) white |= c->colours[i] > 0.84f;
  /* white above, darker at the foot; brown twigs */
  assert_true(white && c->colours[0] < 0.7f);
  const float *twig = c->colours + 3 * (c->first[c->parts[0].count + 1]) - 3;
  assert_true(twig[0] < 0.4f && twig[0] > twig[2]);
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* ---- ages: red is one, when colours rise evenly ---------------------------------- */

#define RISING                                                                                     \
  " shoot_colour=0,0,0 bark_colour=0.5,0.5,0.5 rhytidome_colour=1,1,1 periderm_age=20"             \
  " rhytidome_from=20 rhytidome_age=150 leaf_colour=0.1,0.2,0.3"

static void older_towards_the_base(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"sugi", "akamatsu", "keyaki", "momiji"};
  for (int k = 0; k < 4; k++) {
    sozai_geometry *g = grow(kinds[k], "age=30 orders=3" RISING, NULL);
    const sozai_curves *c = curves_of(g, 0);
    double deepest = 0;
    for (uint64_t i = 0; i < c->curve_count; i++)
      for (uint64_t n = c->first[i]; n + 1 < c->first[i + 1]; n++) {
        assert_true(c->colours[3 * n + 3] <= c->colours[3 * n]);
        if (i >= c->parts[0].count) deepest = fmax(deepest, (double)c->colours[3 * n]);
      }
    /* shoots of many years, and no age beyond the stem's foot */
    print_message("%-10s the foot %.3f, the oldest shoot %.3f\n", kinds[k], (double)c->colours[0],
                  deepest);
    assert_true(deepest > 0.05 && deepest <= (double)c->colours[0]);
    geometry()->release_curves(c);
    geometry()->release(g);
  }
}

/* A shoot begins with the bark of the place that bore it. */
static void joints_are_of_one_age(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("cherry", "age=20 orders=2" RISING, NULL);
  const sozai_curves *c = curves_of(g, 0);
  double worst = 0;
  uint64_t shoots = 0;
  for (uint64_t i = c->parts[0].count; i < c->curve_count; i++, shoots++) {
    const float *p = c->points + 3 * c->first[i];
    double nearest = 1e9, colour = 0;
    for (uint64_t k = 1; k < c->parts[0].count; k++)
      for (uint64_t n = c->first[k]; n + 1 < c->first[k + 1]; n++) {
        double dot = 0, length = 0, d2 = 0;
        for (uint64_t x = 0; x < 3; x++) {
          double e = (double)c->points[3 * n + 3 + x] - (double)c->points[3 * n + x];
          length += e * e, dot += e * ((double)p[x] - (double)c->points[3 * n + x]);
        }
        double s = fmin(1, fmax(0, dot / length));
        for (uint64_t x = 0; x < 3; x++) {
          double at = (1 - s) * (double)c->points[3 * n + x] + s * (double)c->points[3 * n + 3 + x];
          d2 += (at - (double)p[x]) * (at - (double)p[x]);
        }
        if (d2 >= nearest) continue;
        nearest = d2;
        colour = (1 - s) * (double)c->colours[3 * n] + s * (double)c->colours[3 * n + 3];
      }
    worst = fmax(worst, fabs(colour - (double)c->colours[3 * c->first[i]]));
  }
  print_message("%llu shoots: colours off their place's by %.4f\n", (unsigned long long)shoots,
                worst);
  assert_true(shoots > 500 && worst < 0.01);
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* ---- meshes, and levels of detail --------------------------------------------------- */

static void mesh_as_curves(const sozai_geometry *g, uint32_t level, float foot[3]) {
  const sozai_mesh *m = mesh_of(g, level);
  assert_int_equal(m->size, sizeof *m);
  assert_non_null(m->colours);
  for (uint64_t i = 0; i < 3 * m->point_count; i++)
    assert_true(m->colours[i] >= 0 && m->colours[i] <= 1);
  const sozai_part *leaves = &m->parts[m->part_count - 1];
  bark b = bark_of(g);
  double age = number_of(g, "age"), worst = 0;
  for (uint64_t k = 0; k < 3 * m->parts[0].count; k++) {
    uint32_t i = m->indices[k];
    if (m->owner[i]) continue; /* the stem's alone */
    double years = fmax(0, age - year_of_height(g, (double)m->points[3 * i + 1]));
    worst = fmax(worst, off(&b, years, m->colours + 3 * i));
  }
  for (uint64_t i = 3 * leaves->first; i < 3 * (leaves->first + leaves->count); i++)
    for (int c = 0; c < 3; c++)
      assert_true(m->colours[3 * m->indices[i] + (uint32_t)c] == leaves->colour[c]);
  if (level == 0) memcpy(foot, m->colours, 3 * sizeof *foot);
  assert_memory_equal(foot, m->colours, 3 * sizeof *foot);
  print_message("  level %u: off by %.4f\n", level, worst);
  /* a leaning stem's rings are not level */
  assert_true(worst < 0.02);
  geometry()->release_mesh(m);
}

static void at_every_level(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"akamatsu", "shirakaba"};
  for (int k = 0; k < 2; k++) {
    /* furrows.c, lenticels.c and scars.c look at what those make of it */
    sozai_geometry *g = grow(
        kinds[k],
        "age=40 leaves_most=30000 bark_depth=0 lenticel_density=0 scar_shade=0 leaf_variation=0",
        NULL);
    float foot[3];
    print_message("%s\n", kinds[k]);
    for (uint32_t level = 0; level <= 8; level++) mesh_as_curves(g, level, foot);
    geometry()->release(g);
  }
}

/* ---- ends of the ranges, and what was measured ----------------------------------------- */

static void at_once(void **unused) {
  (void)unused;
  sozai_geometry *g =
      grow("sugi", "age=10 orders=1 periderm_age=0 rhytidome_from=4 rhytidome_age=0", NULL);
  bark b = bark_of(g);
  const sozai_curves *c = curves_of(g, 0);
  assert_true(off(&b, 10, c->colours) < 1e-6);
  for (uint64_t n = 0; n < 3 * c->first[1]; n += 3) {
    double old = fabs((double)c->colours[n] - b.rhytidome[0]),
           bare = fabs((double)c->colours[n] - b.periderm[0]),
           shoot = fabs((double)c->colours[n] - b.shoot[0]);
    assert_true(fmin(old, fmin(bare, shoot)) < 1e-6); /* none between */
  }
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* Evenly over its age from the ground up. */
static void measured(void **unused) {
  (void)unused;
  sozai_geometry *g =
      grow("akamatsu", "age=40 orders=1", "trunk\n100 0 90 20\n100 0 90 -\nB100\n0\n80 90 0 4\n");
  bark b = bark_of(g);
  const sozai_curves *c = curves_of(g, 0);
  assert_int_equal(c->curve_count, 2);
  const double years[] = {40, 20, 0, 20, 0};
  for (uint64_t i = 0; i < 5; i++) assert_true(off(&b, years[i], c->colours + 3 * i) < 1e-4);
  geometry()->release_curves(c);
  geometry()->release(g);
}

/* ---- leaves ---------------------------------------------------------------------------- */

/* Each of one colour, and all of leaf_colour in the mean. */
static void leaves_vary(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"keyaki", "akamatsu"};
  for (int k = 0; k < 2; k++) {
    sozai_geometry *g = grow(kinds[k], "age=12 foliage=full leaf_variation=0.2", NULL);
    double means[3] = {0};
    for (uint32_t level = 0; level < 3; level++) {
      const sozai_mesh *m = mesh_of(g, level);
      const sozai_part *leaves = &m->parts[m->part_count - 1];
      double sum = 0, count = 0, least = 9, most = 0, reddest = 0;
      for (uint64_t i = leaves->first; i < leaves->first + leaves->count; i++) {
        const uint32_t *at = m->indices + 3 * i;
        const float *c = m->colours + 3 * at[0];
        assert_memory_equal(c, m->colours + 3 * at[1], 12);
        assert_memory_equal(c, m->colours + 3 * at[2], 12);
        double tone = (double)c[1] / (double)leaves->colour[1];
        double red = (double)c[0] / (double)leaves->colour[0] / tone;
        double blue = (double)c[2] / (double)leaves->colour[2] / tone;
        assert_true(fabs(red + blue - 2) < 1e-4);
        reddest = fmax(reddest, red);
        least = fmin(least, tone), most = fmax(most, tone);
        sum += tone, count++;
      }
      means[level] = sum / count;
      print_message("%-10s level %u: %.3f to %.3f, mean %.4f; red to %.3f\n", kinds[k], level,
                    least, most, means[level], reddest);
      assert_true(least > 0.8 && least < 0.84 && most < 1.2 && most > 1.16);
      assert_true(reddest > 1.07 && reddest < 1.1 && fabs(means[level] - 1) < 0.01);
      geometry()->release_mesh(m);
    }
    geometry()->release(g);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_the_species_says),
                                     cmocka_unit_test(as_dendrology_says),
                                     cmocka_unit_test(older_towards_the_base),
                                     cmocka_unit_test(joints_are_of_one_age),
                                     cmocka_unit_test(at_every_level),
                                     cmocka_unit_test(leaves_vary),
                                     cmocka_unit_test(at_once),
                                     cmocka_unit_test(measured)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
