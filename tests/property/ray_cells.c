/* SPDX-License-Identifier: Apache-2.0
 *
 * Cells on the faces along the fibre: a wall that the face is parallel to is not drawn; fine rays
 * take the share that they are asked for and leave the mean; the cells of a ray lie in rows, and
 * its rows begin and end unevenly.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cmocka_all.h"
#include "truth.h"

#define STRAIGHT                                                                                   \
  "pith_wander=0; undulation=0; section_wobble=0; slope_noise=0; taper=0; fibre_brightness=0; "    \
  "ring_variation=0; latewood_variation=0; heartwood_years=1000; porosity=none; ring_width=4; "    \
  "earlywood_colour=0.4 0.4 0.4 @ lin_rec709; latewood_colour=0.4 0.4 0.4 @ lin_rec709; "
#define CELLS "cell_contrast=1; cell_width=30; cell_depth=30; cell_depth_late=30; cell_length=20; "

static void turned(points *p, unsigned q, int axis) {
  for (int c = 0; c < 3; c++) p->normal[c][q] = c == axis;
}

static double spread(const points *p) {
  double sum = 0, square = 0;
  for (unsigned q = 0; q < p->count; q++) {
    double a = (double)p->out[ALBEDO][q];
    sum += a;
    square += a * a;
  }
  sum /= p->count;
  return sqrt(fmax(square / p->count - sum * sum, 0));
}

/* Lines along the arc, or the radius, on the axis z = 0: there x is the radius and z the arc. */
static void walls_by_face(void **state) {
  (void)state;
  sozai_texture *t = wood_make(NULL, STRAIGHT CELLS "cell_irregularity=0");
  double sd[2][3];
  for (int along = 0; along < 2; along++) {
    for (int face = 0; face < 3; face++) {
      points p = {0};
      uniform_seed(141);
      double sum = 0;
      for (int i = 0; i < 200; i++) {
        double x = 80.3 + 4 * floor(5 * uniform()) + uniform(), y = 100 * uniform();
        points_clear(&p);
        for (int k = 0; k < 60; k++) {
          double d = 0.5e-3 * k;
          turned(&p, points_add(&p, along ? x + d : x, y, along ? 0 : d, 0), face);
        }
        points_ask(&p, t);
        sum += spread(&p);
      }
      sd[along][face] = sum / 200;
      points_free(&p);
    }
  }
  textures->destroy(t);
  print_message(
      "sd of albedo along the arc on faces across the radius, fibre, arc: %.4f %.4f %.4f; "
      "along the radius: %.4f %.4f %.4f\n",
      sd[0][0], sd[0][1], sd[0][2], sd[1][0], sd[1][1], sd[1][2]);
  assert_true(sd[0][0] > 0.025 && sd[0][1] > 0.05 && sd[0][2] < 0.01);
  assert_true(sd[1][2] > 0.015 && sd[1][1] > 0.03 && sd[1][0] < 1e-6);
}

static int by_value(const void *a, const void *b) {
  float x = *(const float *)a, y = *(const float *)b;
  return (x > y) - (x < y);
}

/* Against the same wood without. On a face across the arc no file's wall is drawn, so that what
 * differs is rays, and within CELL_SHARP (0.12 of a file) of one. */
static void fine_rays(void **state) {
  (void)state;
  static const double densities[] = {10, 20, 40};
  double share[3];
  for (int k = 0; k < 3; k++) {
    char text[1024];
    snprintf(text, sizeof text, STRAIGHT CELLS "fine_ray_density=%g", densities[k]);
    sozai_texture *both[] = {wood_make(NULL, text),
                             wood_make(NULL, STRAIGHT CELLS "fine_ray_density=0")};
    points p[2] = {{0}, {0}};
    double mean[2] = {0, 0}, changed = 0;
    enum { POINTS = 200000 };
    for (int f = 0; f < 2; f++) {
      uniform_seed(142);
      for (int i = 0; i < POINTS; i++) {
        double x = 80.4 + uniform(), y = 400 * uniform();
        turned(&p[f], points_add(&p[f], x, y, uniform() - 0.5, 0), 2);
      }
      points_ask(&p[f], both[f]);
      for (int i = 0; i < POINTS; i++) mean[f] += (double)p[f].out[ALBEDO][i] / POINTS;
    }
    /* everything else is darker by as much as rays are brighter: most points by the median */
    static float by[POINTS];
    for (int i = 0; i < POINTS; i++) by[i] = p[0].out[ALBEDO][i] - p[1].out[ALBEDO][i];
    qsort(by, POINTS, sizeof by[0], by_value);
    for (int i = 0; i < POINTS; i++) changed += fabsf(by[i] - by[POINTS / 2]) > 1e-4f;
    for (int f = 0; f < 2; f++) {
      points_free(&p[f]);
      textures->destroy(both[f]);
    }
    share[k] = changed / POINTS;
    print_message("%g/mm2: %.4f of the face, mean albedo %.4f, %.4f without\n", densities[k],
                  share[k], mean[0], mean[1]);
    assert_true(fabs(mean[0] - mean[1]) < 0.001);
    /* 0.22 mm high, and on average as wide as 0.4 of a file of 30 um */
    double want = densities[k] * 0.22 * 0.4 * 0.03;
    assert_true(share[k] > want && share[k] < 1.5 * want);
  }
  assert_true(fabs(share[1] - 2 * share[0]) < 0.1 * share[0]);
  assert_true(fabs(share[2] - 4 * share[0]) < 0.2 * share[0]);
}

/* Lines along the fibre on radial faces, 1 um a step: within rays the albedo steps where rows of
 * 20 um meet, and at the rays' ends the cover jumps from row to row. */
static void rows_of_rays(void **state) {
  (void)state;
  static const char *const rays = "ray_density=2; ray_height=1; ray_width=90; "
                                  "ray_colour=0.4 0.4 0.4 @ lin_rec709; ";
  enum { STEPS = 1200 };
  double sd[2] = {0, 0}, count = 0, jumps = 0, mean = 0;
  double step = 0, square = 0, with[3] = {0, 0, 0}, pairs[3] = {0, 0, 0}, steps = 0;
  for (int cells = 0; cells < 2; cells++) {
    char text[1024];
    snprintf(text, sizeof text, STRAIGHT "%scell_contrast=%d", rays, cells);
    sozai_texture *t = wood_make(NULL, text);
    points p = {0};
    uniform_seed(143);
    count = 0;
    for (int i = 0; i < 400; i++) {
      double x = 70 + 20 * uniform(), y = 300 * uniform(), z = 10 * uniform();
      static double by[STEPS];
      points_clear(&p);
      for (int k = 0; k < STEPS; k++) turned(&p, points_add(&p, x, y + 1e-3 * k, z, 0), 2);
      points_ask(&p, t);
      for (int k = 0; k + 1 < STEPS; k++) {
        double a = (double)p.out[ALBEDO][k];
        if (!cells) jumps += fabsf(p.out[RAY][k + 1] - p.out[RAY][k]) > 0.1f;
        int in = p.out[RAY][k] > 0.6f && p.out[RAY][k + 1] > 0.6f;
        by[k] = in ? fabs((double)p.out[ALBEDO][k + 1] - a) : -1;
        if (!in) continue;
        sd[cells] += (a - 0.4) * (a - 0.4);
        if (cells) mean += a;
        count++;
      }
      if (!cells) continue;
      for (int k = 0; k + 31 < STEPS; k++) {
        if (by[k] < 0) continue;
        step += by[k];
        square += by[k] * by[k];
        steps++;
        for (int l = 0; l < 3; l++) {
          double other = by[k + 10 * (l + 1)];
          if (other < 0) continue;
          with[l] += by[k] * other;
          pairs[l]++;
        }
      }
    }
    sd[cells] = sqrt(sd[cells] / count);
    points_free(&p);
    textures->destroy(t);
  }
  step /= steps;
  square = square / steps - step * step;
  for (int l = 0; l < 3; l++) with[l] = (with[l] / pairs[l] - step * step) / square;
  print_message(
      "in rays: albedo %.4f, sd %.4f, %.6f without cells; its steps go with those 10, 20, "
      "30 um above by %.2f, %.2f, %.2f; %.0f jumps of cover along %d mm\n",
      mean / count, sd[1], sd[0], with[0], with[1], with[2], jumps, 400 * STEPS / 1000);
  assert_true(sd[1] > 0.01 && sd[0] < 1e-5);
  assert_true(fabs(mean / count - 0.4) < 0.003);
  assert_true(with[1] > 0.3 && with[0] < 0.1 && with[2] < 0.1);
  assert_true(jumps > 100);
}

/* Under footprints of parts of a cell to some cells; beyond, property.filter. */
static void filtered(void **state) {
  (void)state;
  static const double sizes[] = {0.003, 0.01, 0.02, 0.03, 0.05, 0.1, 0.2};
  static const char *const cuts[] = {"flat", "quarter", "end"};
  static const char *const presets[] = {"sugi", "akamatsu", "white_oak", "keyaki", "hard_maple"};
  points p = {0};
  uniform_seed(144);
  double worst = 0;
  for (int k = 0; k < 5; k++) {
    for (int f = 0; f < 7; f++) {
      truth_errors errors = {0};
      print_message("%-10s footprint %-5g mm: ", presets[k], sizes[f]);
      for (int c = 0; c < 3; c++) {
        truth_errors part = {0};
        char text[128];
        snprintf(text, sizeof text, "cut=%s; cut_distance=70; cell_contrast=0.9", cuts[c]);
        sozai_texture *t = wood_make(presets[k], text);
        for (int place = 0; place < 200; place++) {
          double x = 80 * (uniform() - 0.5), y = (c == 2 ? 80 : 800) * (uniform() - 0.5);
          truth_ask(&p, t, ONLY3(ALBEDO), x, y, 1.5708 * uniform(), sizes[f]);
          truth_add(&part, &p);
        }
        textures->destroy(t);
        print_message(" %s %.4f", cuts[c], truth_rms(&part));
        errors.square += part.square;
        errors.mean += part.mean;
        errors.n += part.n;
      }
      double rms = truth_rms(&errors), mean = truth_mean(&errors);
      print_message("; rms %.4f, mean %+.4f\n", rms, mean);
      worst = fmax(worst, fmax(rms, 5 * fabs(mean)));
    }
  }
  points_free(&p);
  CHECK(worst <= 0.016, "worst %.4f\n", worst);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(walls_by_face),
      cmocka_unit_test(fine_rays),
      cmocka_unit_test(rows_of_rays),
      cmocka_unit_test(filtered),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
