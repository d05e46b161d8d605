/* SPDX-License-Identifier: Apache-2.0
 * A strand that would stand as it stood before stops. Around one point whose
 * normal is none, everything is outside and a straight strand that is centred on
 * it is level ground: its quarter turns change nothing. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "fiber/fit.h"
#include "fiber/parameters.h"

int32_t host_progress(const sozai_host *host, double fraction, const char *what);
int32_t host_progress(const sozai_host *host, double fraction, const char *what) {
  (void)host, (void)fraction, (void)what;
  return SOZAI_OK;
}

static void comes_round(void **unused) {
  (void)unused;
  /* the two far ones give the box a size */
  const float points[9] = {0, 0, 0, -64, -64, -64, 64, 64, 64}, normals[9] = {0};
  const sozai_buffer b = {.size = sizeof b,
                          .kind = SOZAI_BUFFER_POINTS,
                          .dims = {3},
                          .points = points,
                          .normals = normals};
  fiber f;
  memset(&f, 0, sizeof f);
  f.plan.mode = MODE_LITERAL;
  f.plan.iterations = 4096;
  f.plan.step = 1;
  f.plan.turn = 1.57079632679489661923;
  f.vertices = 3;
  assert_int_equal(hull_from_points(&f.hull, NULL, &b), SOZAI_OK);
  const double shape[9] = {-1, 0, 0, 0, 0, 0, 1, 0, 0};
  strand_pose pose = {{4, 2, -3}, {1, 0, 0, 0, 1, 0, 0, 0, 1}};
  strand_result r;
  memset(&r, 0, sizeof r);
  fit_strand(&f, shape, &pose, &r);
  print_message("ended as %u after %u moves; C %.3f, before %.3f\n", r.end, r.moves, (double)r.last,
                (double)r.first);
  assert_int_equal(r.end, END_VISITED);
  for (int a = 0; a < 3; a++) assert_true(fabs(pose.middle[a]) < 1e-12); /* it came to the point */
  assert_true(fabs((double)r.last + 2) < 1e-5);
  assert_true(r.moves >= 9 && r.moves < 60); /* nine steps, and turns until one comes round */
  hull_free(&f.hull, NULL);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(comes_round)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
