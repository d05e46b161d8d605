/* SPDX-License-Identifier: Apache-2.0
 * Relief of old bark: plates as wide, as long and as high as asked for, as dark in the mean as
 * even bark, no further up than it reaches, and lit as it lies. */
#include <stdio.h>

#include "stem_rings.h"

/* Plates that are cells, all of a kind. */
#define ALIKE "bark_joined=0 bark_ridges=0 bark_scales=0 bark_variation=0 "
/* A straight stem, all of it rhytidome. */
#define EVEN                                                                                       \
  "age=60 orders=1 sway=0 butt=0 diameter_max=700 rhytidome_from=0 rhytidome_age=0 "               \
  "rhytidome_colour=0.4,0.5,0.3 " ALIKE

static double narrowest(const rings *r, uint64_t i) {
  double least = 1e9;
  for (uint64_t k = 0; k < r->sides; k++) least = fmin(least, out_of(r, i, k));
  return least;
}

static double mean_of(const rings *r, uint64_t i) {
  double sum = 0;
  for (uint64_t k = 0; k < r->sides; k++) sum += out_of(r, i, k);
  return sum / (double)r->sides;
}

/* ---- sizes --------------------------------------------------------------------- */

/* mm, of plates round the stem and along it, from furrow to furrow: lower than half the mean. */
static void sizes_of(const char *values, double size[2]) {
  sozai_geometry *g = grow("sugi", values, NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  rings r = rings_of(m);
  double round = 0, up = 0, wide = 0, tall = 0;
  for (uint64_t i = 0; i + 1 < r.count && height_of(&r, i + 1) < 5500; i++) {
    double low = narrowest(&r, i), next = narrowest(&r, i + 1);
    low += 0.5 * (mean_of(&r, i) - low), next += 0.5 * (mean_of(&r, i + 1) - next);
    if (height_of(&r, i) < ROOTS) continue;
    for (uint64_t k = 0; k < r.sides; k++) {
      int here = out_of(&r, i, k) > low;
      round += here && out_of(&r, i, k + 1) <= low;
      up += here && out_of(&r, i + 1, k) <= next;
      wide += 2 * 3.14159265 * low / (double)r.sides;
      tall += height_of(&r, i + 1) - height_of(&r, i);
    }
  }
  size[0] = wide / round, size[1] = tall / up;
  geometry()->release_mesh(m);
  geometry()->release(g);
}

static void plates_as_wide_and_long_as_asked(void **unused) {
  (void)unused;
  static const struct {
    double width, length, flat;
  } cases[] = {{30, 30, 0.5}, {25, 100, 0.5}, {60, 90, 0}, {40, 40, 1}};
  for (int c = 0; c < 4; c++) {
    char values[320];
    double size[2];
    snprintf(values, sizeof values,
             EVEN "bark_depth=20 bark_plates=%g bark_width=%g bark_length=%g", cases[c].flat,
             cases[c].width, cases[c].length);
    sizes_of(values, size);
    print_message("plates of %g x %g mm: %.1f x %.1f mm\n", cases[c].width, cases[c].length,
                  size[0], size[1]);
    assert_true(fabs(size[0] / cases[c].width - 1) < 0.15);
    assert_true(fabs(size[1] / cases[c].length - 1) < 0.15);
  }
}

#define PLATES EVEN "bark_depth=20 bark_plates=0.5 bark_width=30 bark_length=60 "

/* Ridges are as wide as strips and run on; plates that are joined are larger both ways. */
static void ridges_and_joined_plates(void **unused) {
  (void)unused;
  double apart[2], ridges[2], joined[2];
  sizes_of(PLATES, apart);
  sizes_of(PLATES "bark_ridges=1", ridges);
  sizes_of(PLATES "bark_joined=0.5", joined);
  print_message("plates %.1f x %.1f, ridges %.1f x %.1f, joined %.1f x %.1f mm\n", apart[0],
                apart[1], ridges[0], ridges[1], joined[0], joined[1]);
  assert_true(ridges[1] > 1.6 * apart[1] && ridges[0] < 1.25 * apart[0]);
  assert_true(joined[0] > 1.1 * apart[0] && joined[1] > 1.1 * apart[1]);
}

/* Plates' tones: as bright in the mean, off it by as much as asked; and scales' heights. */
static void plates_differ(void **unused) {
  (void)unused;
  static const char *const cases[] = {"bark_variation=0", "bark_variation=0.2",
                                      "bark_variation=0.4", "bark_scales=1"};
  double spread[4], rough[4];
  for (int c = 0; c < 4; c++) {
    char values[320];
    snprintf(values, sizeof values, PLATES "bark_shade=0 %s", cases[c]);
    sozai_geometry *g = grow("sugi", values, NULL);
    const sozai_mesh *m = mesh_of(g, 0);
    rings r = rings_of(m);
    double sum = 0, squares = 0, most = 0, count = 0, steps = 0, high = 0;
    for (uint64_t i = 0; i < r.count && height_of(&r, i) < 5500; i++) {
      double low = narrowest(&r, i), mean = mean_of(&r, i);
      if (height_of(&r, i) < ROOTS) continue;
      for (uint64_t k = 0; k < r.sides; k++) {
        double off = (double)m->colours[3 * index_of(&r, i, k)] / 0.4 - 1;
        sum += off, squares += off * off, count++;
        most = fmax(most, fabs(off));
        /* on plates, from point to point */
        if (!(out_of(&r, i, k) > low + 1.2 * (mean - low))) continue;
        steps += fabs(out_of(&r, i, k + 1) - out_of(&r, i, k));
        high += out_of(&r, i, k) - low;
      }
    }
    spread[c] = sqrt(squares / count), rough[c] = steps / high;
    print_message("%s: tones %.4f in the mean, %.3f (sd), %.3f at most; rough by %.3f\n", cases[c],
                  sum / count, spread[c], most, rough[c]);
    assert_true(fabs(sum / count) < 0.004);
    assert_true(c == 0 || c == 3 ? most < 1e-5 : most < 0.2 * c && most > 0.17 * c);
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
  assert_true(fabs(spread[2] / spread[1] - 2) < 0.01 && spread[1] > 0.06);
  assert_true(rough[3] > 1.08 * rough[0]);
}

/* Over the stem's radius, which is that under bark. */
static void as_deep_as_asked(void **unused) {
  (void)unused;
  static const struct {
    const char *values;
    double depth;
  } cases[] = {{EVEN "bark_length=60 bark_depth=12", 12},
               {EVEN "bark_length=60 bark_depth=25 bark_plates=1 bark_width=60", 25},
               {EVEN "bark_length=60 bark_depth=150", 1e9}};
  for (int c = 0; c < 3; c++) {
    sozai_geometry *g = grow("sugi", cases[c].values, NULL);
    const sozai_curves *axis = curves_of(g, 0);
    double mean[9] = {0}, most = 0, least = 1e9, bare = 0;
    for (uint32_t level = 0; level <= 6; level += 3) {
      const sozai_mesh *m = mesh_of(g, level);
      rings r = rings_of(m);
      double sum = 0, count = 0;
      for (uint64_t i = 0; i < r.count; i++) {
        double y = height_of(&r, i);
        if (y < ROOTS || y > 5500) continue;
        uint64_t n = axis->first[0];
        while ((double)axis->points[3 * n + 4] < y) n++;
        double y0 = (double)axis->points[3 * n + 1], y1 = (double)axis->points[3 * n + 4];
        bare = (double)axis->radii[n] +
               ((double)axis->radii[n + 1] - (double)axis->radii[n]) * (y - y0) / (y1 - y0);
        /* shares of what there may be at most */
        double depth = fmin(cases[c].depth, 0.16 * bare);
        for (uint64_t k = 0; k < r.sides; k++) {
          double thick = (out_of(&r, i, k) - bare) / depth;
          sum += thick, count++;
          if (level == 0) most = fmax(most, thick), least = fmin(least, thick);
        }
      }
      mean[level] = sum / count;
      geometry()->release_mesh(m);
    }
    print_message("%s: %.3f to %.3f of it, mean %.3f; from afar %.3f\n",
                  cases[c].values + sizeof EVEN - 1, least, most, mean[0], mean[3]);
    assert_true(least > -0.01 && least < 0.05 && most > 0.9 && most < 1.01);
    assert_true(fabs(mean[6] - mean[3]) < 0.01);
    assert_true(fabs(mean[3] - mean[0]) < 0.02);
    geometry()->release_curves(axis);
    geometry()->release(g);
  }
}

/* ---- colour -------------------------------------------------------------------- */

static void dark_in_furrows(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi", EVEN "bark_depth=15 bark_shade=0.4", NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  rings r = rings_of(m);
  double sum = 0, count = 0, least = 1, most = 0, thin = 0, dark = 0, both = 0;
  for (uint64_t i = 0; i < r.count && height_of(&r, i) < 5500; i++) {
    double low = narrowest(&r, i);
    for (uint64_t k = 0; k < r.sides; k++) {
      const float *c = m->colours + 3 * index_of(&r, i, k);
      double tone = (double)c[1] / 0.5;
      assert_true(fabs((double)c[0] - 0.4 * tone) < 1e-5 && fabs((double)c[2] - 0.3 * tone) < 1e-5);
      least = fmin(least, tone), most = fmax(most, tone);
      sum += tone, count++;
      int t = out_of(&r, i, k) - low < 4, d = tone < 0.92;
      thin += t, dark += d, both += t && d;
    }
  }
  print_message("bark of %.4f of its colour, %.3f to %.3f; %.3f of dark is low\n", sum / count,
                least, most, both / dark);
  assert_true(fabs(sum / count - 1) < 0.015);
  assert_true(most - least > 0.36 && most - least < 0.401 && most < 1.4);
  assert_true(both > 0.9 * dark && both > 0.5 * thin);
  geometry()->release_mesh(m);
  geometry()->release(g);
}

/* Half turned: black and white, so that red is how much is rhytidome. */
static double turned_at(const char *turning, double *low, double *high) {
  char values[400];
  snprintf(values, sizeof values,
           "age=60 orders=1 sway=0 butt=0 diameter_max=700 periderm_age=0 rhytidome_from=20 "
           "rhytidome_age=100 bark_colour=0,0,0 rhytidome_colour=1,1,1 bark_depth=15 bark_shade=0 "
           "bark_plates=0.5 " ALIKE "bark_turning=%s",
           turning);
  sozai_geometry *g = grow("sugi", values, NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  rings r = rings_of(m);
  double sum = 0, count = 0, lows = 0, highs = 0;
  *low = *high = 0;
  for (uint64_t i = 0; i < r.count && height_of(&r, i) < 3000; i++) {
    double least = narrowest(&r, i), mean = mean_of(&r, i);
    if (height_of(&r, i) < ROOTS) continue;
    for (uint64_t k = 0; k < r.sides; k++) {
      double red = (double)m->colours[3 * index_of(&r, i, k)];
      sum += red, count++;
      if (out_of(&r, i, k) < least + 0.3 * (mean - least)) *low += red, lows++;
      if (out_of(&r, i, k) > mean + 0.3 * (mean - least)) *high += red, highs++;
    }
  }
  *low /= lows, *high /= highs;
  print_message("turning %s: %.3f of it, %.3f in furrows, %.3f on plates\n", turning, sum / count,
                *low, *high);
  geometry()->release_mesh(m);
  geometry()->release(g);
  return sum / count;
}

static void turns_in_furrows_or_on_plates(void **unused) {
  (void)unused;
  double low, high, even = turned_at("0", &low, &high);
  assert_true(fabs(low - high) < 0.01);
  assert_true(fabs(turned_at("1", &low, &high) - even) < 0.06);
  assert_true(low > even + 0.2 && high < even - 0.1);
  assert_true(fabs(turned_at("-1", &low, &high) - even) < 0.06);
  assert_true(low < even - 0.2 && high > even + 0.1);
}

/* mm, of a point from its ring's middle. */
static double out_of_limb(const rings *r, uint64_t i, uint64_t k) {
  double middle[3] = {0}, sum = 0;
  const float *p = r->mesh->points;
  for (uint64_t s = 0; s < r->sides; s++)
    for (uint64_t c = 0; c < 3; c++)
      middle[c] += (double)p[3 * index_of(r, i, s) + c] / (double)r->sides;
  for (uint64_t c = 0; c < 3; c++)
    sum += (middle[c] - (double)p[3 * index_of(r, i, k) + c]) *
           (middle[c] - (double)p[3 * index_of(r, i, k) + c]);
  return sqrt(sum);
}

/* Strips of level limbs run along them, as those of stems do. */
static void along_limbs(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("mizunara",
                           "age=110 orders=1 elevation_top=5 elevation_base=5 droop=0 upturn=0 "
                           "wander=0 bark_width=40 bark_length=400 bark_reach=100 rhytidome_age=20",
                           NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  double round = 0, up = 0;
  unsigned limbs = 0;
  for (uint64_t i = 1; i < m->point_count && limbs < 6; i++) {
    if (m->owner[i] == m->owner[i - 1] || m->owner[i] == 0) continue;
    rings r = rings_from(m, i);
    if (r.sides < 30 || r.count < 40) continue;
    limbs++;
    double last[400], at[400];
    for (uint64_t n = 10; n < 40; n++) {
      double mean = 0;
      for (uint64_t k = 0; k < r.sides; k++) mean += out_of_limb(&r, n, k) / (double)r.sides;
      for (uint64_t k = 0; k < r.sides; k++) at[k] = out_of_limb(&r, n, k) - mean;
      for (uint64_t k = 0; k < r.sides; k++) {
        round += (at[k] > 0) != (at[(k + 1) % r.sides] > 0);
        up += n > 10 && (at[k] > 0) != (last[k] > 0);
      }
      memcpy(last, at, sizeof last);
    }
  }
  print_message("%u limbs: %.0f edges met round them, %.0f along\n", limbs, round, up);
  assert_true(limbs > 2 && round > 1.8 * up);
  geometry()->release_mesh(m);
  geometry()->release(g);
}

/* ---- where it is ----------------------------------------------------------------- */

/* How far a ring is from round. */
static double rough(const rings *r, uint64_t i) {
  double most = 0;
  for (uint64_t k = 0; k < r->sides; k++) most = fmax(most, out_of(r, i, k));
  return most - narrowest(r, i);
}

static void no_higher_than_it_reaches(void **unused) {
  (void)unused;
  sozai_geometry *g = grow("sugi", EVEN "bark_depth=15 bark_reach=3", NULL);
  const sozai_mesh *m = mesh_of(g, 0);
  rings r = rings_of(m);
  double low = 0, middle = 0, above = 0;
  for (uint64_t i = 0; i < r.count; i++) {
    double y = height_of(&r, i), d = rough(&r, i);
    if (y > ROOTS && y < 1500)
      low = fmax(low, d);
    else if (y > 2200 && y < 2300)
      middle = fmax(middle, d);
    else if (y > 3000)
      above = fmax(above, d);
  }
  print_message("rings off round by %.1f mm, %.1f half way, %.3f above\n", low, middle, above);
  assert_true(low > 12 && middle > 4 && middle < 11 && above < 0.01);
  geometry()->release_mesh(m);
  geometry()->release(g);
  static const char *const smooth[] = {EVEN "bark_depth=0", EVEN "bark_reach=0",
                                       "age=60 orders=1 sway=0 butt=0 rhytidome_from=90"};
  for (int c = 0; c < 3; c++) {
    g = grow("sugi", smooth[c], NULL);
    m = mesh_of(g, 0);
    r = rings_of(m);
    for (uint64_t i = 0; i < r.count; i++)
      assert_true(height_of(&r, i) < ROOTS || rough(&r, i) < 0.01);
    assert_true(r.sides < 40);
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
}

/* ---- normals ----------------------------------------------------------------------- */

static void lit_as_it_lies(void **unused) {
  (void)unused;
  static const char *const kinds[] = {"akamatsu", "mizunara", "keyaki", "sugi"};
  for (int s = 0; s < 4; s++) {
    sozai_geometry *g = grow(kinds[s], "age=70 orders=1", NULL);
    const sozai_mesh *m = mesh_of(g, 0);
    rings r = rings_of(m);
    double sum = 0, areas = 0, astray = 0;
    for (uint64_t t = 0; t < m->parts[0].count; t++) {
      const uint32_t *at = m->indices + 3 * t;
      double a[3], b[3], n[3], area = 0;
      if (m->owner[at[0]]) break;
      /* the ends have none of their own */
      if (at[0] <= r.sides + 1 || at[2] >= r.first + (r.count - 1) * (r.sides + 1)) continue;
      for (uint64_t c = 0; c < 3; c++) {
        a[c] = (double)m->points[3 * at[1] + c] - (double)m->points[3 * at[0] + c];
        b[c] = (double)m->points[3 * at[2] + c] - (double)m->points[3 * at[0] + c];
      }
      for (int c = 0; c < 3; c++) {
        n[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
        area += n[c] * n[c];
      }
      area = sqrt(area);
      if (!(area > 0)) continue;
      for (int k = 0; k < 3; k++) {
        double dot = 0;
        for (uint64_t c = 0; c < 3; c++) dot += n[c] / area * (double)m->normals[3 * at[k] + c];
        sum += area * dot, areas += area;
        if (dot < 0.5) astray += area;
      }
    }
    print_message("%-10s normals along faces' by %.3f in the mean, %.4f of them half or less\n",
                  kinds[s], sum / areas, astray / areas);
    assert_true(sum / areas > 0.9 && astray / areas < 0.05);
    geometry()->release_mesh(m);
    geometry()->release(g);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(plates_as_wide_and_long_as_asked),
                                     cmocka_unit_test(ridges_and_joined_plates),
                                     cmocka_unit_test(plates_differ),
                                     cmocka_unit_test(as_deep_as_asked),
                                     cmocka_unit_test(dark_in_furrows),
                                     cmocka_unit_test(turns_in_furrows_or_on_plates),
                                     cmocka_unit_test(along_limbs),
                                     cmocka_unit_test(no_higher_than_it_reaches),
                                     cmocka_unit_test(lit_as_it_lies)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
