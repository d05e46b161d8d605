/* SPDX-License-Identifier: Apache-2.0
 *
 * Resin canals: as many to an area as asked for, where in the ring, how large.
 * Cells: their sizes and the share of their walls, read off the albedo at 1 um;
 * tyloses only where they are set; and nothing left of any of it in the mean.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
#define ROUND                                                                                      \
  "pith_wander=0; undulation=0; section_wobble=0; slope_noise=0; taper=0; fibre_brightness=0; "    \
  "ring_variation=0; latewood_variation=0; heartwood_years=1000; "
#define GREY "earlywood_colour=0.4 0.4 0.4 @ lin_rec709; latewood_colour=0.4 0.4 0.4 @ lin_rec709; "

/* Canals of a square of end grain at y = 0. */
static void canals(void **state) {
  (void)state;
  static const struct {
    double density, diameter, ring;
  } cases[] = {{0.7, 150, 2.5}, {0.4, 80, 1.6}, {1, 80, 4}};
  for (int k = 0; k < 3; k++) {
    char text[512];
    snprintf(text, sizeof text,
             ROUND "porosity=none; canal_density=%g; canal_diameter=%g; ring_width=%g",
             cases[k].density, cases[k].diameter, cases[k].ring);
    sozai_texture *t = wood_make(NULL, text);
    double step = 1e-3 * cases[k].diameter / 6, side = 30;
    int n = (int)(side / step);
    unsigned char *in = calloc((size_t)(n * n), 1);
    float *phase = malloc(sizeof(float) * (size_t)(n * n));
    int *stack = malloc(sizeof(int) * (size_t)(n * n));
    points p = {0};
    for (int j = 0; j < n; j++) {
      points_clear(&p);
      for (int i = 0; i < n; i++) {
        unsigned q = points_add(&p, 60 + (i + 0.5) * step, 0, (j + 0.5) * step, 0);
        p.normal[1][q] = 1;
        p.normal[2][q] = 0;
      }
      points_ask(&p, t);
      for (int i = 0; i < n; i++) {
        in[j * n + i] = p.out[CANAL][i] > 0.5f;
        phase[j * n + i] = p.out[TIME][i] - floorf(p.out[TIME][i]);
      }
    }
    points_free(&p);
    double found = 0, whole = 0, area = 0, later = 0;
    for (int at = 0; at < n * n; at++) {
      if (!in[at]) continue;
      int depth = 0, cells = 0, cut = 0;
      double middle = 0;
      stack[depth++] = at;
      in[at] = 0;
      while (depth) {
        int q = stack[--depth], i = q % n, j = q / n;
        cells++;
        middle += (double)phase[q];
        cut |= i == 0 || j == 0 || i == n - 1 || j == n - 1;
        for (int d = 0; d < 4; d++) {
          int x = i + (d == 0) - (d == 1), y = j + (d == 2) - (d == 3);
          if (x < 0 || y < 0 || x >= n || y >= n || !in[y * n + x]) continue;
          in[y * n + x] = 0;
          stack[depth++] = y * n + x;
        }
      }
      found += cut ? 0.5 : 1;
      if (cut) continue;
      whole++;
      area += cells * step * step;
      later += middle / cells > 0.5;
    }
    free(in);
    free(phase);
    free(stack);
    textures->destroy(t);
    double want = cases[k].density * side * side, across = 2000 * sqrt(area / whole / PI);
    print_message("%g/mm2 of %g um in rings of %g mm: %.0f canals, %.0f wanted; %.0f um across; "
                  "%.0f %% in the later half of the ring\n",
                  cases[k].density, cases[k].diameter, cases[k].ring, found, want, across,
                  100 * later / whole);
    assert_true(fabs(found - want) < 3 * sqrt(want));
    assert_true(fabs(across - cases[k].diameter) < 0.08 * cases[k].diameter);
    assert_true(later > 0.85 * whole);
  }
}

/* A line of points on the end grain at y = 0, um apart. */
static void line(points *p, double x, double z, double dx, double dz, int count) {
  points_clear(p);
  for (int i = 0; i < count; i++) {
    unsigned q = points_add(p, x + 1e-3 * i * dx, 0, z + 1e-3 * i * dz, 0);
    p->normal[1][q] = 1;
    p->normal[2][q] = 0;
  }
}

static int cells_along(const points *p, double wall) {
  int n = 0;
  for (unsigned i = 1; i < p->count; i++) {
    n += (double)p->out[ALBEDO][i - 1] < wall && (double)p->out[ALBEDO][i] >= wall;
  }
  return n;
}

static void sizes_and_walls(void **state) {
  (void)state;
  static const struct {
    double width, early, late, density;
  } cases[] = {{34, 42, 14, 420}, {22, 22, 19, 600}, {50, 55, 18, 420}};
  for (int k = 0; k < 3; k++) {
    char text[1024];
    snprintf(text, sizeof text,
             ROUND GREY "porosity=none; ring_width=4; latewood_fraction=0.3; "
                        "latewood_abruptness=1; cell_contrast=1; cell_width=%g; cell_depth=%g; "
                        "cell_depth_late=%g; basic_density=%g; cell_length=20",
             cases[k].width, cases[k].early, cases[k].late, cases[k].density);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(95);
    double bright = 0, dark = 9;
    double walls[2] = {0, 0}, all[2] = {0, 0}, mean = 0, count = 0;
    double across = 0, length = 0, deep[2] = {0, 0};
    for (int i = 0; i < 1500; i++) {
      line(&p, 80 + 40 * uniform(), 2 * uniform(), 1, 0, 4000);
      points_ask(&p, t);
      for (unsigned q = 0; q < p.count; q++) mean += (double)p.out[ALBEDO][q];
      count += p.count;
    }
    for (int i = 0; i < 300; i++) {
      double ring = 4 * floor((80 + 40 * uniform()) / 4);
      for (int late = 0; late < 2; late++) {
        double from = ring + (late ? 3.1 : 0.2), best = 1e9, least = 9, most = 0;
        int n = 0;
        /* lines over the width of two files; the one with the fewest walls runs
         * along the lumina of one */
        enum { LINES = 24 };
        static float seen[LINES][700];
        for (int l = 0; l < LINES; l++) {
          line(&p, from, 2e-3 * cases[k].width * l / LINES, 1, 0, 700);
          points_ask(&p, t);
          double sum = 0;
          for (unsigned q = 0; q < p.count; q++) {
            double a = (double)p.out[ALBEDO][q];
            seen[l][q] = p.out[ALBEDO][q];
            least = fmin(least, a);
            most = fmax(most, a);
            sum += a;
          }
          if (sum < best) best = sum, n = cells_along(&p, 0.5 * (least + most));
        }
        for (int l = 0; l < LINES; l++)
          for (int q = 0; q < 700; q++) walls[late] += (double)seen[l][q] > 0.5 * (least + most);
        all[late] += 700 * LINES;
        deep[late] += n;
        bright = fmax(bright, most);
        dark = fmin(dark, least);
      }
      /* across the files: what is bright along a whole cell is a wall between two */
      points lowest = {0};
      for (int l = 0; l < 12; l++) {
        line(&p, ring + 0.5 + 1.2e-3 * cases[k].early * l / 12, -0.6, 0, 1, 1200);
        points_ask(&p, t);
        if (l == 0) {
          line(&lowest, ring, 0, 0, 0, 1200);
          points_ask(&lowest, t);
          for (unsigned q = 0; q < 1200; q++) lowest.out[ALBEDO][q] = 9;
        }
        for (unsigned q = 0; q < 1200; q++)
          lowest.out[ALBEDO][q] = fminf(lowest.out[ALBEDO][q], p.out[ALBEDO][q]);
      }
      across += cells_along(&lowest, 0.4);
      length += 1.2;
      points_free(&lowest);
    }
    points_free(&p);
    textures->destroy(t);
    double share = cases[k].density / 1500, width = 1e3 * length / across;
    double early = 300 * 700 / deep[0], late = 300 * 700 / deep[1];
    double measured = 0.7 * walls[0] / all[0] + 0.3 * walls[1] / all[1];
    print_message(
        "cells of %g um by %g, late %g, %g kg/m3: %.1f by %.1f, %.1f; walls %.3f and %.3f, "
        "%.3f of the ring (%.3f); albedo %.3f to %.3f, mean %.4f\n",
        cases[k].width, cases[k].early, cases[k].late, cases[k].density, width, early, late,
        walls[0] / all[0], walls[1] / all[1], measured, share, dark, bright, mean / count);
    assert_true(fabs(width - cases[k].width) < 0.06 * cases[k].width);
    assert_true(fabs(early - cases[k].early) < 0.06 * cases[k].early);
    assert_true(fabs(late - cases[k].late) < 0.08 * cases[k].late);
    assert_true(fabs(measured - share) < 0.05);
    assert_true(fabs(mean / count - 0.4) < 0.002);
    assert_true(bright > 0.45 && bright < 1 && dark < 0.39);
  }
}

/* Bit for bit the same but within the earlywood's vessels. */
static void tyloses_where_set(void **state) {
  (void)state;
  static const char *const presets[] = {"white_oak", "red_oak", "robinia", "ash"};
  static const int has[] = {1, 0, 1, 0};
  for (int k = 0; k < 4; k++) {
    sozai_texture *a = wood_make(presets[k], "cell_contrast=1"),
                  *b = wood_make(presets[k], "cell_contrast=1; tyloses=0");
    points p = {0}, q = {0};
    uniform_seed(96);
    for (int i = 0; i < 60000; i++) {
      double x = 60 + 30 * uniform(), y = 400 * uniform(), z = 30 * (uniform() - 0.5);
      points_add(&p, x, y, z, 0);
      points_add(&q, x, y, z, 0);
    }
    points_ask(&p, a);
    points_ask(&q, b);
    double inside = 0, changed = 0, outside = 0, mean = 0;
    for (unsigned i = 0; i < p.count; i++) {
      double d = (double)p.out[ALBEDO][i] - (double)q.out[ALBEDO][i];
      if (p.out[VESSEL][i] == 0.0f) {
        outside += d != 0.0;
      } else {
        inside++;
        changed += fabs(d) > 0.01;
        mean += d;
      }
    }
    points_free(&p);
    points_free(&q);
    textures->destroy(a);
    textures->destroy(b);
    CHECK(
        outside == 0 && (has[k] ? changed > 0.2 * inside : changed == 0) &&
            fabs(mean / inside) < 0.005,
        "%s: tyloses change %.0f of %.0f points in vessels, by %.4f on average, and %.0f outside\n",
        presets[k], changed, inside, mean / inside, outside);
  }
}

/* From a few cells on nothing is left: bit for bit the wood without cells. */
static void gone_under_wide_footprints(void **state) {
  (void)state;
  static const char *const presets[] = {"sugi", "white_oak", "hard_maple", "akamatsu"};
  for (int k = 0; k < 4; k++) {
    sozai_texture *with = wood_make(presets[k], "cut=quarter; cell_contrast=1; element_length=0.2");
    sozai_texture *without = wood_make(presets[k], "cut=quarter; cell_contrast=0");
    double most = 0, few = 0;
    for (int f = 0; f < 2; f++) {
      points a = {0}, b = {0};
      uniform_seed(97);
      for (int i = 0; i < 20000; i++) {
        double x = 60 * uniform(), y = 300 * uniform(), s = f ? 0.02 : 0.32 + uniform();
        points_add(&a, x, y, 0, s);
        points_add(&b, x, y, 0, s);
      }
      points_ask(&a, with);
      points_ask(&b, without);
      double worst = 0;
      for (unsigned i = 0; i < a.count; i++)
        worst = fmax(worst, fabs((double)(a.out[ALBEDO][i] - b.out[ALBEDO][i])));
      *(f ? &few : &most) = worst;
      points_free(&a);
      points_free(&b);
    }
    CHECK(most == 0 && few > 0.003,
          "%s: cells change albedo by %g under 0.32 mm and more, by up "
          "to %.3f under 0.02\n",
          presets[k], most, few);
    textures->destroy(with);
    textures->destroy(without);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(canals),
      cmocka_unit_test(sizes_and_walls),
      cmocka_unit_test(tyloses_where_set),
      cmocka_unit_test(gone_under_wide_footprints),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
