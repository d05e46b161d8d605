/* SPDX-License-Identifier: Apache-2.0
 * Meshes: tubes closed and turned outward, joints inside their parent, indices
 * in range, nothing that is no number, fewer triangles at each level. */
#include <math.h>

#include "tree.h"

/* ---- closed: every edge once in each direction, points by their place ----- */

typedef struct {
  uint64_t key;
  int64_t balance;
  uint32_t uses;
} edge;

static edge *edges;
static uint64_t room;

static uint64_t place(const sozai_mesh *m, uint32_t p) {
  float v[3];
  for (uint32_t c = 0; c < 3; c++) v[c] = m->points[3 * p + c] + 0.0f;
  /* of tubes that touch, each by itself */
  uint64_t h = fold(0xcbf29ce484222325ull, v, sizeof v);
  return fold(h, &m->owner[p], 4);
}

static void count_edge(uint64_t a, uint64_t b) {
  uint64_t key = a < b ? a * 31 + b : b * 31 + a;
  if (key == 0) key = 1;
  for (uint64_t at = key % room;; at = (at + 1) % room) {
    if (edges[at].key && edges[at].key != key) continue;
    edges[at].key = key;
    edges[at].balance += a < b ? 1 : -1;
    edges[at].uses++;
    return;
  }
}

static void closed(const sozai_mesh *m, const sozai_part *part) {
  room = part->count * 6 + 64;
  edges = calloc(room, sizeof *edges);
  assert_non_null(edges);
  uint64_t open = 0;
  for (uint64_t i = part->first; i < part->first + part->count; i++) {
    uint64_t p[3];
    for (uint64_t c = 0; c < 3; c++) p[c] = place(m, m->indices[3 * i + c]);
    for (int c = 0; c < 3; c++) count_edge(p[c], p[(c + 1) % 3]);
  }
  for (uint64_t i = 0; i < room; i++)
    open += edges[i].key && (edges[i].balance != 0 || edges[i].uses % 2 != 0);
  free(edges);
  if (open) print_error("%s: %llu open edges\n", part->id, (unsigned long long)open);
  assert_int_equal(open, 0);
}

/* The volume that a part encloses: positive when it is turned outward. */
static double volume(const sozai_mesh *m, const sozai_part *part) {
  double sum = 0;
  for (uint64_t i = part->first; i < part->first + part->count; i++) {
    const float *p[3];
    for (uint64_t c = 0; c < 3; c++) p[c] = m->points + 3 * m->indices[3 * i + c];
    double a[3], b[3], d[3];
    for (int c = 0; c < 3; c++)
      a[c] = (double)p[0][c], b[c] = (double)p[1][c], d[c] = (double)p[2][c];
    sum += (a[0] * (b[1] * d[2] - b[2] * d[1]) + a[1] * (b[2] * d[0] - b[0] * d[2]) +
            a[2] * (b[0] * d[1] - b[1] * d[0])) /
           6;
  }
  return sum;
}

static void sound(const sozai_mesh *m) {
  uint64_t at = 0;
  for (uint32_t k = 0; k < m->part_count; k++) {
    assert_int_equal(m->parts[k].first, at);
    assert_true(m->parts[k].count > 0);
    at += m->parts[k].count;
  }
  assert_int_equal(at, m->triangle_count);
  for (uint64_t i = 0; i < 3 * m->triangle_count; i++) assert_true(m->indices[i] < m->point_count);
  for (uint64_t i = 0; i < m->point_count; i++) {
    double length = 0;
    for (uint64_t c = 0; c < 3; c++) {
      assert_true(isfinite(m->points[3 * i + c]));
      length += (double)m->normals[3 * i + c] * (double)m->normals[3 * i + c];
    }
    assert_true(fabs(length - 1) < 0.02);
    assert_true(isfinite(m->uv[2 * i]) && isfinite(m->uv[2 * i + 1]));
  }
}

static void every_species(void **unused) {
  (void)unused;
  const sozai_generator_info *info = geometry()->find("tree");
  for (uint32_t i = 0; i < info->preset_count; i++) {
    sozai_geometry *g = grow(info->presets[i]->id, "age=8 leaves_most=60000", NULL);
    uint64_t before = UINT64_MAX, first = 0, last = 0;
    double shares[9];
    for (uint32_t level = 0; level <= 8; level++) {
      const sozai_mesh *m = mesh_of(g, level);
      sound(m);
      for (uint32_t k = 0; k < m->part_count; k++) {
        if (!(m->parts[k].flags & SOZAI_PART_CLOSED)) continue;
        if (level < 3) closed(m, &m->parts[k]);
        assert_true(volume(m, &m->parts[k]) > 0);
      }
      assert_true(m->triangle_count < before);
      shares[level] = (double)m->triangle_count / (double)before;
      before = m->triangle_count;
      if (level == 0) first = m->triangle_count;
      last = m->triangle_count;
      geometry()->release_mesh(m);
      const sozai_curves *c = curves_of(g, level);
      assert_int_equal(c->first[c->curve_count], c->point_count);
      for (uint64_t k = 0; k < c->curve_count; k++) assert_true(c->first[k + 1] >= c->first[k] + 2);
      for (uint64_t k = 0; k < c->point_count; k++) assert_true(c->radii[k] > 0);
      geometry()->release_curves(c);
    }
    print_message("%-14s %8llu triangles at level 0, %6llu at level 8\n", info->presets[i]->id,
                  (unsigned long long)first, (unsigned long long)last);
    assert_true(last * 4 < first);
    print_message("  of the level before:");
    for (int level = 1; level <= 8; level++) print_message(" %2.0f", 100 * shares[level]);
    print_message(" %%; at 2 of level 0: %.0f %%\n", 100 * shares[1] * shares[2]);
    /* docs/tree.md says so */
    assert_true(shares[1] > 0.23 && shares[1] < 0.6 && shares[2] > 0.23 && shares[2] < 0.5);
    assert_true(shares[1] * shares[2] > 0.08 && shares[1] * shares[2] < 0.2);
    assert_true(shares[3] > 0.45 && shares[3] < 0.6 && shares[4] > 0.45 && shares[4] < 0.6);
    geometry()->release(g);
  }
}

/* Furrows leave no gap, and make the mesh finer at the first three levels alone. */
static void old_bark(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"kuromatsu", "douglas_fir", "keyaki", "shirakaba"};
  for (int s = 0; s < 4; s++) {
    sozai_geometry *g = grow(kinds[s], "age=70 orders=1 rhytidome_from=10 rhytidome_age=70", NULL);
    sozai_geometry *smooth =
        grow(kinds[s], "age=70 orders=1 bark_depth=0 lenticel_density=0 scar_shade=0", NULL);
    uint64_t before = UINT64_MAX;
    for (uint32_t level = 0; level <= 8; level++) {
      const sozai_mesh *m = mesh_of(g, level), *plain = mesh_of(smooth, level);
      sound(m);
      if (level < 3) closed(m, &m->parts[0]);
      assert_true(volume(m, &m->parts[0]) > volume(plain, &plain->parts[0]));
      assert_true(m->triangle_count <= before);
      assert_true((m->triangle_count > plain->triangle_count) == (level < 3));
      if (level < 3)
        print_message("%-12s level %u: %llu triangles, %llu if smooth\n", kinds[s], level,
                      (unsigned long long)m->triangle_count,
                      (unsigned long long)plain->triangle_count);
      before = m->triangle_count;
      geometry()->release_mesh(m);
      geometry()->release_mesh(plain);
    }
    geometry()->release(g);
    geometry()->release(smooth);
  }
}

/* A branch's first ring lies within its parent's tube. */
static void joints_inside(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"sugi", "akamatsu", "cherry", "keyaki"};
  for (int s = 0; s < 4; s++) {
    sozai_geometry *g = grow(kinds[s], "age=20 orders=2 foliage=none", NULL);
    const sozai_curves *c = curves_of(g, 0);
    sozai_table b = table_of(g, "branches");
    double worst = 0;
    uint64_t curve_of[4096] = {0}, arms = 0;
    assert_true(b.rows <= 4096);
    for (uint64_t i = 0; i < c->curve_count && c->ids[i] < b.rows; i++) curve_of[c->ids[i]] = i;
    for (uint64_t i = 1; i < c->curve_count && c->ids[i] < b.rows; i++) {
      const float *p = c->points + 3 * c->first[i];
      uint64_t on = curve_of[(uint64_t)cell(&b, c->ids[i], "parent")];
      double nearest = 1e9, radius = 0;
      arms += on > 0;
      for (uint64_t k = c->first[on]; k + 1 < c->first[on + 1]; k++) {
        double d2 = 0, dot = 0, length = 0;
        for (int x = 0; x < 3; x++) {
          double e =
              (double)c->points[3 * k + 3 + (uint64_t)x] - (double)c->points[3 * k + (uint64_t)x];
          double o = (double)p[x] - (double)c->points[3 * k + (uint64_t)x];
          length += e * e, dot += e * o;
        }
        double t = fmin(1, fmax(0, dot / length));
        for (int x = 0; x < 3; x++) {
          double at = (double)c->points[3 * k + (uint64_t)x] * (1 - t) +
                      (double)c->points[3 * k + 3 + (uint64_t)x] * t;
          d2 += (at - (double)p[x]) * (at - (double)p[x]);
        }
        if (sqrt(d2) < nearest) {
          nearest = sqrt(d2);
          radius = (double)c->radii[k] * (1 - t) + (double)c->radii[k + 1] * t;
        }
      }
      /* three sides at least: a tube is as thin as half its radius at worst, but
       * stems that bear branches this thick have six, 0.86 */
      worst = fmax(worst, (nearest + (double)c->radii[c->first[i]]) / radius);
    }
    print_message("%-10s joints reach %.2f of the parent's radius at most; %llu arms\n", kinds[s],
                  worst, (unsigned long long)arms);
    assert_true((arms > 0) == (s > 0));
    assert_true(worst < 0.86);
    geometry()->release_curves(c);
    geometry()->release(g);
  }
}

static double apart(const float *a, const float *b) {
  double sum = 0;
  for (int c = 0; c < 3; c++) sum += ((double)a[c] - (double)b[c]) * ((double)a[c] - (double)b[c]);
  return sqrt(sum);
}

/* Nothing of the stem below the ground, and a whole ring upon it, however it leans. */
static void feet_are_level(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"akamatsu", "kuromatsu", "momiji"};
  for (int s = 0; s < 3; s++) {
    sozai_geometry *g = grow(kinds[s], "age=60 orders=1", NULL);
    for (uint32_t level = 0; level <= 8; level += 2) {
      const sozai_mesh *m = mesh_of(g, level);
      uint64_t grounded = 0;
      for (uint64_t i = 0; i < m->point_count && !m->owner[i]; i++) {
        assert_true(m->points[3 * i + 1] >= 0);
        grounded += m->points[3 * i + 1] == 0;
      }
      assert_true(grounded >= 5); /* its middle, and three sides and the seam at least */
      geometry()->release_mesh(m);
    }
    geometry()->release(g);
  }
}

/* Between roots a stem's foot is lit as it lies: normals turn with its faces, seen from above. */
static void roots_have_normals(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("buna", "age=80 orders=1 scar_shade=0", NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  double worst = 1, radial = 1;
  for (uint64_t i = 0; i < m->parts[0].count && !m->owner[m->indices[3 * i]]; i++) {
    const float *p[3];
    double a[3], b[3], lowest = 1e9, highest = 0;
    for (uint64_t c = 0; c < 3; c++) {
      p[c] = m->points + 3 * m->indices[3 * i + c];
      lowest = fmin(lowest, (double)p[c][1]), highest = fmax(highest, (double)p[c][1]);
    }
    if (lowest > 0 || highest < 1) continue; /* from the foot to the next ring */
    for (int c = 0; c < 3; c++)
      a[c] = (double)p[1][c] - (double)p[0][c], b[c] = (double)p[2][c] - (double)p[0][c];
    double x = a[1] * b[2] - a[2] * b[1], z = a[0] * b[1] - a[1] * b[0], l = sqrt(x * x + z * z);
    for (uint64_t c = 0; c < 3; c++) {
      const float *n = m->normals + 3 * m->indices[3 * i + c];
      double out = sqrt((double)p[c][0] * (double)p[c][0] + (double)p[c][2] * (double)p[c][2]);
      if (p[c][1] > 0) continue;
      worst = fmin(worst, ((double)n[0] * x + (double)n[2] * z) / l);
      radial = fmin(radial, ((double)p[c][0] * x + (double)p[c][2] * z) / l / out);
    }
  }
  print_message("normals and faces: cosine %.3f at least; of normals from the axis %.3f\n", worst,
                radial);
  assert_true(radial < 0.8 && worst > 0.92);
  geometry()->release_mesh(m);
  geometry()->release(g);
}

/* A dead branch, which has broken off, ends beyond its axis, and a live one on it. */
static void dead_ones_splinter(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("akamatsu", "age=40 orders=1", NULL);
  const sozai_curves *c = curves_of(g, 0);
  const sozai_mesh *m = mesh_of(g, 0);
  sozai_table b = table_of(g, "branches");
  int dead = 0, live = 0;
  for (uint64_t k = 1, at = 0; k < c->curve_count; k++) {
    while (at + 1 < m->point_count && m->owner[at + 1] <= c->ids[k]) at++;
    uint64_t end = c->first[k + 1] - 1;
    double over = apart(m->points + 3 * at, c->points + 3 * end) / (double)c->radii[end];
    if (cell(&b, c->ids[k], "death") < 0) {
      assert_true(over < 1e-3);
      live++;
    } else {
      assert_true(over > 1 && over < 1.5);
      dead++;
    }
  }
  print_message("%d dead branches end in a splinter, %d live ones do not\n", dead, live);
  assert_true(dead > 10 && live > 10);
  geometry()->release_mesh(m);
  geometry()->release_curves(c);
  geometry()->release(g);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_species),      cmocka_unit_test(old_bark),
      cmocka_unit_test(joints_inside),      cmocka_unit_test(feet_are_level),
      cmocka_unit_test(roots_have_normals), cmocka_unit_test(dead_ones_splinter)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
