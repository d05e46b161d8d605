/* SPDX-License-Identifier: Apache-2.0
 *
 * Chipped edges: uneven by as much as is asked, each stone's its own, what stands for them under a
 * footprint is their mean.
 */
#include <math.h>
#include <stdio.h>

#include "cmocka_all.h"
#include "wood.h"

enum { S_HEIGHT = 9, S_EDGE = 18 };

/* Stones of 200 mm, whose courses begin at y = 0; joints of 10 mm, 4 mm below the edges' foot. */
#define ROUND 16.0
#define DROP 6.0
static sozai_texture *edged(double chipping) {
  char text[256];
  snprintf(text, sizeof text,
           "finish=polished; layout=stack; stone_length=200; stone_width=200; joint_width=10; "
           "joint_depth=4; edge_round=%g; edge_drop=%g; edge_chipping=%g",
           ROUND, DROP, chipping);
  return stone_make(NULL, text);
}

/* Heights along a course's two edges, `in` from each, over its joint's middle. */
enum { ALONG = 4000 };
static void along(const sozai_texture *t, double in, double side, double out[ALONG]) {
  points p = {0};
  for (int i = 0; i < ALONG; i++) points_add(&p, 3.1 * i, side * (5 + in), 0, 0);
  points_ask(&p, t);
  for (int i = 0; i < ALONG; i++) {
    /* not where another joint is nearer */
    int near = fabs((double)p.out[S_EDGE][i] - in) < 1e-3;
    out[i] = near ? (double)p.out[S_HEIGHT][i] : NAN;
  }
  points_free(&p);
}

static double spread(const double x[ALONG], double *mean) {
  double sum = 0, square = 0, count = 0;
  for (int i = 0; i < ALONG; i++) {
    if (isnan(x[i])) continue;
    sum += x[i], square += x[i] * x[i], count++;
  }
  assert_true(count > ALONG / 2);
  *mean = sum / count;
  return sqrt(fmax(square / count - *mean * *mean, 0));
}

static double correlation(const double a[ALONG], const double b[ALONG]) {
  double ma, mb, sa = spread(a, &ma), sb = spread(b, &mb), sum = 0, count = 0;
  for (int i = 0; i < ALONG; i++) {
    if (isnan(a[i]) || isnan(b[i])) continue;
    sum += (a[i] - ma) * (b[i] - mb), count++;
  }
  return sum / count / (sa * sb);
}

static void as_uneven_as_asked(void **state) {
  (void)state;
  static const double asked[4] = {0, 0.3, 0.6, 1};
  static double a[ALONG], b[ALONG];
  double sd[4], mean[4], foot, apart = 0;
  for (int k = 0; k < 4; k++) {
    sozai_texture *t = edged(asked[k]);
    along(t, 0.4 * ROUND, 1, a);
    along(t, 0.4 * ROUND, -1, b);
    sd[k] = spread(a, &mean[k]);
    if (k) apart = fmax(apart, fabs(correlation(a, b)));
    along(t, 0, 1, b);
    double uneven = spread(b, &foot);
    CHECK(uneven < 1e-2 && fabs(foot - (-DROP)) < 1e-2,
          "edge_chipping=%g: at 0.4 of the edge's width %.3f mm, sd %.3f; its foot %.3f, sd %.4f\n",
          asked[k], mean[k], sd[k], foot, uneven);
    textures->destroy(t);
  }
  CHECK(sd[0] < 1e-3 && sd[1] > 0.07 * DROP && sd[2] > 1.4 * sd[1] && sd[3] > 1.1 * sd[2],
        "sd %.3f, %.3f, %.3f, %.3f mm of %g\n", sd[0], sd[1], sd[2], sd[3], DROP);
  CHECK(apart < 0.1, "edges on two sides of a joint correlate by %.3f at most\n", apart);
}

/* Of a footprint's height against the mean of points in its square: RMS. */
static double footprint_error(double chipping, double wide, int places, int parts, double *mean) {
  sozai_texture *t = edged(chipping);
  points p = {0};
  double square = 0;
  int each = parts * parts;
  uniform_seed(31);
  for (int i = 0; i < places; i++) {
    /* small ones near an edge */
    double x = 4000 * uniform(), y = (wide < 10 ? 14 : 4000) * uniform();
    points_add(&p, x, y, 0, wide);
    for (int j = 0; j < each; j++) {
      points_add(&p, x + wide * ((j % parts + uniform()) / parts - 0.5),
                 y + wide * ((j / parts + uniform()) / parts - 0.5), 0, 0);
    }
  }
  points_ask(&p, t);
  *mean = 0;
  for (int i = 0; i < places; i++) {
    const float *h = p.out[S_HEIGHT] + i * (each + 1);
    double off = (double)h[0];
    for (int j = 1; j <= each; j++) off -= (double)h[j] / each;
    square += off * off / places;
    *mean += off / places;
  }
  points_free(&p);
  textures->destroy(t);
  return sqrt(square);
}

static void footprints_see_the_mean(void **state) {
  (void)state;
  static const double wide[4] = {2, 8, 60, 4000};
  for (int k = 0; k < 4; k++) {
    int places = wide[k] > 1000 ? 20 : 200, parts = wide[k] > 1000 ? 192 : 24;
    double even_mean, mean, even = footprint_error(0, wide[k], places, parts, &even_mean);
    double chipped = footprint_error(1, wide[k], places, parts, &mean);
    CHECK(chipped < even + 0.01 * DROP && fabs(mean) < fabs(even_mean) + 0.005 * DROP,
          "%4g mm: height off the mean of %d points by %.3f mm RMS, %+.3f on average; without "
          "chips %.3f, %+.3f\n",
          wide[k], parts * parts, chipped, mean, even, even_mean);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(as_uneven_as_asked),
                                     cmocka_unit_test(footprints_see_the_mean)};
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
