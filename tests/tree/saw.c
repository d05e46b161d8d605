/* SPDX-License-Identifier: Apache-2.0
 * Sawing plans by geometry alone, over radii, thicknesses, kerfs and widths: every board
 * within the log, none nearer to another than the kerf, and what each plan promises. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plan.h"

/* after failure.h, as cmocka has a macro `fail` */
#include <cmocka.h>

#define CASES 160
#define ROUNDING 1e-6 /* mm */

typedef struct {
  double x, z;
} place;

static saw_plan plan;

/* Uniform in low..high for the k-th number of a case. */
static double uniform(uint32_t number, uint32_t k, double low, double high) {
  uint32_t x = number * 2654435761u + k * 40503u + 12345u;
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  x ^= x >> 16;
  return low + (high - low) * (x / 4294967296.0);
}

/* Corners in order round the rectangle, by the header's words alone; drawn in by
 * less than counts, so that boards that touch do not seem to overlap. */
static void corners_of(const saw_board *b, place out[4]) {
  double a = b->rotation * SAW_PI / 180, c = cos(a), s = sin(a);
  static const int sign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int i = 0; i < 4; i++) {
    double w = (0.5 * b->width - 0.1 * ROUNDING) * sign[i][0];
    double t = (0.5 * b->thickness - 0.1 * ROUNDING) * sign[i][1];
    out[i] = (place){b->centre[0] + w * c - t * s, b->centre[1] + w * s + t * c};
  }
}

static double from_segment(place p, place a, place b) {
  double dx = b.x - a.x, dz = b.z - a.z;
  double t = ((p.x - a.x) * dx + (p.z - a.z) * dz) / (dx * dx + dz * dz);
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return hypot(p.x - a.x - t * dx, p.z - a.z - t * dz);
}

static double side_of(place p, place a, place b) {
  return (b.x - a.x) * (p.z - a.z) - (b.z - a.z) * (p.x - a.x);
}

/* Whether c and d lie on either side of the line through a and b. */
static bool parts(place a, place b, place c, place d) {
  const double none = 1e-7; /* mm^2: on the line */
  double left = side_of(c, a, b), right = side_of(d, a, b);
  return fmin(left, right) < -none && fmax(left, right) > none;
}

static bool segments_cross(place a, place b, place c, place d) {
  return parts(a, b, c, d) && parts(c, d, a, b);
}

static bool within(place p, const place r[4]) {
  for (int i = 0; i < 4; i++)
    if (side_of(p, r[i], r[(i + 1) % 4]) <= 0) return false;
  return true;
}

/* The distance of two rectangles; -1: they overlap. */
static double distance(const place a[4], const place b[4]) {
  double least = 1e30;
  for (int i = 0; i < 4; i++) {
    if (within(a[i], b) || within(b[i], a)) return -1;
    for (int k = 0; k < 4; k++) {
      if (segments_cross(a[i], a[(i + 1) % 4], b[k], b[(k + 1) % 4])) return -1;
      least = fmin(least, from_segment(a[i], b[k], b[(k + 1) % 4]));
      least = fmin(least, from_segment(b[i], a[k], a[(k + 1) % 4]));
    }
  }
  return least;
}

static saw_job job_of(int kind, uint32_t number) {
  saw_job j = {.plan = kind,
               .radius = uniform(number, 1, 60, 500),
               .thickness = exp(uniform(number, 2, log(8), log(100))),
               .kerf = number % 5 ? uniform(number, 3, 0.2, 8) : 0,
               .azimuth = uniform(number, 4, -400, 400)};
  if (number % 3 == 0) j.width = uniform(number, 5, 40, 200);
  return j;
}

/* ---- what each plan promises --------------------------------------------- */

/* Degrees between the face and the rings at a place, 0 to 90. */
static double ring_angle(const saw_board *b, place p) {
  double a = b->rotation * SAW_PI / 180;
  double along = p.x * cos(a) + p.z * sin(a), out = -p.x * sin(a) + p.z * cos(a);
  return 90 - atan2(fabs(out), fabs(along)) * 180 / SAW_PI;
}

static void check_live(const saw_job *j, const saw_board *b, const place c[4]) {
  double far = 0;
  for (int i = 0; i < 4; i++) far = fmax(far, hypot(c[i].x, c[i].z));
  if (j->width == 0) assert_true(fabs(far - j->radius) < ROUNDING); /* the chord, no less */
  double a = b->rotation * SAW_PI / 180;
  assert_true(-b->centre[0] * sin(a) + b->centre[1] * cos(a) > -ROUNDING); /* it looks outwards */
  double turned = remainder(b->rotation - j->azimuth, 180);
  assert_true(fabs(turned) < 1e-9);
}

static void check_quarter(const saw_board *b) {
  place middle = {b->centre[0], b->centre[1]};
  assert_true(ring_angle(b, middle) >= 45 - 1e-6);
}

static void check_rift(const saw_board *b, const place c[4]) {
  for (int i = 0; i < 4; i++) {
    double angle = ring_angle(b, c[i]);
    assert_true(angle > 30 - 1e-6 && angle < 60 + 1e-6);
  }
}

static double check_boards(const saw_job *j) {
  static place corners[SAW_MOST_BOARDS][4];
  double nearest = 1e30;
  for (size_t i = 0; i < plan.count; i++) {
    const saw_board *b = &plan.boards[i];
    corners_of(b, corners[i]);
    assert_true(b->thickness == j->thickness && b->width > 0);
    assert_true(j->width == 0 || b->width <= j->width + ROUNDING);
    for (int k = 0; k < 4; k++)
      assert_true(hypot(corners[i][k].x, corners[i][k].z) <= j->radius + ROUNDING);
    if (j->plan == SAW_LIVE) check_live(j, b, corners[i]);
    if (j->plan == SAW_QUARTER && j->width == 0) check_quarter(b);
    if (j->plan == SAW_RIFT) check_rift(b, corners[i]);
    for (size_t k = 0; k < i; k++) {
      double gap = distance(corners[i], corners[k]);
      nearest = fmin(nearest, gap);
      if (gap < j->kerf - ROUNDING)
        print_error("radius %g thickness %g kerf %g: boards %zu and %zu are %g apart\n", j->radius,
                    j->thickness, j->kerf, k + 1, i + 1, gap);
      assert_true(gap >= j->kerf - ROUNDING);
    }
  }
  return nearest;
}

/* ---- tests ----------------------------------------------------------------- */

/* Whether even one board could be sawn: a plan may only then be empty. */
static bool one_fits(const saw_job *j) {
  double q = j->plan == SAW_LIVE ? 0.5 * j->thickness : j->thickness + 0.5 * j->kerf;
  double square = j->radius * j->radius - q * q, least = fmax(25, j->thickness);
  if (square <= 0) return false;
  return j->plan == SAW_LIVE ? 2 * sqrt(square) >= least : sqrt(square) - 0.5 * j->kerf >= least;
}

static void sawn(int kind, int least_made) {
  int made = 0;
  size_t boards = 0;
  double yield = 0;
  for (uint32_t i = 0; i < CASES; i++) {
    saw_job j = job_of(kind, i);
    failure why = {0};
    if (!saw_plan_make(&plan, &j, &why)) {
      bool many = strstr(why.text, "more than") != NULL;
      if (kind != SAW_RIFT && one_fits(&j) && !many) print_error("%s\n", why.text);
      assert_true(kind == SAW_RIFT || many || !one_fits(&j));
      assert_true(why.exit_code == EXIT_BAD_INPUT);
      continue;
    }
    made++;
    boards += plan.count;
    yield += saw_area(&plan) / (SAW_PI * j.radius * j.radius);
    check_boards(&j);
  }
  print_message("%s: %d plans of %d, %zu boards, mean yield %.1f %%\n", saw_plan_names[kind], made,
                CASES, boards, 100 * yield / made);
  assert_true(made >= least_made);
}

static void live(void **unused) {
  (void)unused;
  sawn(SAW_LIVE, CASES * 9 / 10);
}

static void quarter(void **unused) {
  (void)unused;
  sawn(SAW_QUARTER, CASES * 8 / 10);
}

static void rift(void **unused) {
  (void)unused;
  sawn(SAW_RIFT, CASES / 2);
}

/* The sheet is as much wood as was peeled; pieces follow one another on one spiral. */
static void rotary(void **unused) {
  (void)unused;
  for (uint32_t i = 0; i < CASES; i++) {
    saw_job j = job_of(SAW_ROTARY, i);
    j.thickness = uniform(i, 6, 0.3, 6);
    j.width = i % 2 ? uniform(i, 7, 600, 3000) : 0;
    failure why = {0};
    if (!saw_plan_make(&plan, &j, &why)) {
      assert_true(j.width > 0 && strstr(why.text, "more than") != NULL);
      continue;
    }
    double area = 0, at = j.radius;
    for (size_t k = 0; k < plan.count; k++) {
      const saw_board *b = &plan.boards[k];
      assert_true(fabs(b->from - at) < ROUNDING && b->to < b->from);
      assert_true(j.width == 0 || b->width <= j.width + ROUNDING);
      at = b->to;
      area += b->width * b->thickness;
      /* its middle is on the spiral, half of the sheet from either end */
      double r = hypot(b->centre[0], b->centre[1]);
      double half = SAW_PI * (b->from * b->from - r * r) / j.thickness;
      assert_true(fabs(half - 0.5 * b->width) < 1e-6 * b->width + 1e-6);
      double turns = (j.radius - r) / j.thickness;
      double angle = (0.25 + j.azimuth / 360 - turns) * 2 * SAW_PI;
      assert_true(hypot(b->centre[0] - r * cos(angle), b->centre[1] - r * sin(angle)) < 1e-6);
    }
    assert_true(at > 0);
    double peeled = SAW_PI * (j.radius * j.radius - at * at);
    assert_true(fabs(area / peeled - 1) < 1e-9);
  }
}

static void refusals(void **unused) {
  (void)unused;
  const saw_job good = {.plan = SAW_LIVE, .radius = 150, .thickness = 27, .kerf = 3};
  const double bad[] = {NAN, INFINITY, -INFINITY, 1e30, -1, 1e-30};
  failure why;
  assert_true(saw_plan_make(&plan, &good, &why));
  for (int kind = 0; kind < SAW_PLANS; kind++)
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
      for (int member = 0; member < 5; member++) {
        saw_job j = good;
        j.plan = kind;
        double *const members[] = {&j.radius, &j.thickness, &j.kerf, &j.width, &j.azimuth};
        *members[member] = bad[i];
        /* tiny kerfs and any direction are fine */
        if (member == 2 && bad[i] == 1e-30) continue;
        if (member == 4 && fabs(bad[i]) <= 36000) continue;
        why = (failure){0};
        assert_false(saw_plan_make(&plan, &j, &why));
        assert_int_equal(why.exit_code, EXIT_BAD_INPUT);
        assert_true(why.text[0] && !strchr(why.text, '\n'));
      }
  saw_job thick = good; /* than the log */
  thick.thickness = 310;
  assert_false(saw_plan_make(&plan, &thick, &why));
  assert_non_null(strstr(why.text, "--thickness"));
  saw_job many = good;
  many.radius = 15000;
  many.thickness = 1;
  assert_false(saw_plan_make(&plan, &many, &why));
  assert_non_null(strstr(why.text, "999"));
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(live), cmocka_unit_test(quarter),
                                     cmocka_unit_test(rift), cmocka_unit_test(rotary),
                                     cmocka_unit_test(refusals)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
