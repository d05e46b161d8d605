/* SPDX-License-Identifier: Apache-2.0
 *
 * Pile: dark along its strands and bright where they are grazed; and its nap, which leans
 * otherwise from patch to patch and is under any footprint the mean of its patches.
 */
#include <math.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979
enum { PLACES = 4000 };

static sozai_texture *velvet_of(double drift) {
  const sozai_value values[] = {
      {.id = "nap_drift", .kind = SOZAI_KIND_FLOAT, .number = {drift}},
      {.id = "nap_reach", .kind = SOZAI_KIND_FLOAT, .number = {30}},
  };
  sozai_texture *t = NULL;
  if (textures->create(NULL, "fiber", "velvet", values, 2, &t))
    fail_msg("%s", textures->last_error());
  return t;
}

typedef struct {
  double mean, spread; /* the latter over the mean */
} seen;

/* Of a component at so many places, from an eye at that elevation, turned so far from where the
 * pile leans to, +y. */
static seen look(const sozai_texture *t, int what, double elevation, double turn,
                 double footprint) {
  points p = {0};
  double sum = 0, square = 0, e = elevation * PI / 180, a = (90 + turn) * PI / 180;
  uniform_seed(61);
  for (int i = 0; i < PLACES; i++) {
    unsigned j = points_add(&p, 3000 * uniform(), 3000 * uniform(), 0, footprint);
    p.view[0][j] = (float)(cos(e) * cos(a));
    p.view[1][j] = (float)(cos(e) * sin(a));
    p.view[2][j] = (float)sin(e);
    p.light[0][j] = 0;
    p.light[1][j] = p.light[2][j] = (float)sqrt(0.5);
  }
  points_ask(&p, t);
  for (unsigned i = 0; i < p.count; i++) {
    double x = (double)p.out[what][i];
    sum += x / PLACES, square += x * x / PLACES;
  }
  points_free(&p);
  return (seen){sum, sqrt(fmax(square - sum * sum, 0)) / sum};
}

static void dark_along_itself(void **state) {
  (void)state;
  sozai_texture *t = velvet_of(0);
  for (int far = 0; far < 2; far++) {
    double size = far ? 5 : 0;
    double along = look(t, RADIANCE, 65, 0, size).mean, above = look(t, RADIANCE, 90, 0, size).mean;
    double against = look(t, RADIANCE, 65, 180, size).mean;
    double rim = fmin(look(t, RADIANCE, 15, 0, size).mean, look(t, RADIANCE, 15, 180, size).mean);
    print_message(
        "velvet %s: red %.4f along its pile, %.4f squarely, %.4f against it, %.4f or more "
        "grazed\n",
        far ? "from afar" : "near", along, above, against, rim);
    assert_true(along < 0.85 * above && against > 1.6 * along && rim > 2.2 * along);
  }
  textures->destroy(t);
}

static void leans_in_patches(void **state) {
  (void)state;
  sozai_texture *t = velvet_of(12), *none = velvet_of(0);
  static const double views[][2] = {{90, 0}, {65, 0}, {65, 180}, {30, 90}};
  for (unsigned i = 0; i < sizeof views / sizeof *views; i++) {
    seen small = look(t, RADIANCE, views[i][0], views[i][1], 2);
    seen wide = look(t, RADIANCE, views[i][0], views[i][1], 40);
    seen all = look(t, RADIANCE, views[i][0], views[i][1], 1000);
    seen even = look(none, RADIANCE, views[i][0], views[i][1], 2);
    print_message("eye at %g, turned %g: red %.4f under 2 mm, %.4f under 40, %.4f under 1000; "
                  "spread %.3f, %.3f, %.3f, without a nap %.3f\n",
                  views[i][0], views[i][1], small.mean, wide.mean, all.mean, small.spread,
                  wide.spread, all.spread, even.spread);
    assert_true(fabs(all.mean / small.mean - 1) < 0.02 && fabs(wide.mean / small.mean - 1) < 0.02);
    assert_true(all.spread < 1e-4 && even.spread < 1e-4 && small.spread > 0.02);
    assert_true(wide.spread < 0.8 * small.spread);
  }
  textures->destroy(t);
  textures->destroy(none);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(dark_along_itself),
      cmocka_unit_test(leans_in_patches),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
