/* SPDX-License-Identifier: Apache-2.0
 *
 * The ring field: rings never cross, R is T's inverse, widths vary by year,
 * and theta = +-pi is no seam.
 */
#include <math.h>
#include <string.h>

#include "cmocka_all.h"
#include "wood.h"

#define PI 3.14159265358979

static const char *const shapes[] = {
    "",
    "section_wobble=0.3; undulation=0.9; undulation_size=10; taper=50; pith_wander=40",
    "ring_width=0.4; undulation=0.45; undulation_size=5; section_wobble=0.2",
    "ring_width=12; ring_variation=0.6; pith_wander=100",
};

static void rings_never_cross(void **state) {
  (void)state;
  uniform_seed(1);
  unsigned rays = 0, steps = 0;
  double least = 1e9;
  for (unsigned s = 0; s < sizeof shapes / sizeof *shapes; s++) {
    sozai_texture *t = wood_make(NULL, shapes[s]);
    points p = {0};
    for (int k = 0; k < 200; k++) {
      double theta = 2 * PI * uniform(), y = 3000 * (uniform() - 0.5);
      float height = (float)y, px, pz;
      assert_int_equal(woods->pith(t, 1, &height, &px, &pz), SOZAI_OK);
      points_clear(&p);
      for (int i = 0; i < 3000; i++) {
        double r = 0.5 + 0.1 * i;
        points_add(&p, (double)px + r * cos(theta), y, (double)pz + r * sin(theta), 0);
      }
      points_ask(&p, t);
      for (unsigned i = 1; i < p.count; i++) {
        double rise = (double)p.out[TIME][i] - (double)p.out[TIME][i - 1];
        if (rise < least) least = rise;
        steps++;
      }
      rays++;
    }
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(least > 0, "time rises on each of %u steps of 0.1 mm on %u rays; least rise %.3g years\n",
        steps, rays, least);
}

static void radius_is_the_inverse_of_time(void **state) {
  (void)state;
  uniform_seed(2);
  double worst = 0;
  unsigned asked = 0;
  for (unsigned s = 0; s < sizeof shapes / sizeof *shapes; s++) {
    sozai_texture *t = wood_make(NULL, shapes[s]);
    points p = {0};
    for (int k = 0; k < 20000; k++) {
      double theta = 2 * PI * (uniform() - 0.5), y = k % 4 ? 2000 * (uniform() - 0.5) : 0;
      double r = 2 + 250 * uniform();
      float height = (float)y, px, pz;
      woods->pith(t, 1, &height, &px, &pz);
      points_add(&p, (double)px + r * cos(theta), y, (double)pz + r * sin(theta), 0);
    }
    points_ask(&p, t);
    for (unsigned i = 0; i < p.count; i++) {
      float px, pz, r, theta;
      woods->pith(t, 1, &p.point[1][i], &px, &pz);
      double x = (double)(p.point[0][i] - px), z = (double)(p.point[2][i] - pz);
      theta = (float)atan2(z, x);
      woods->ring_radius(t, 1, &p.out[TIME][i], &theta, &p.point[1][i], &r);
      double error = fabs((double)r / hypot(x, z) - 1);
      if (error > worst) worst = error;
      asked++;
    }
    points_free(&p);
    textures->destroy(t);
  }
  CHECK(worst < 1e-5, "R(T(r, theta, y), theta, y) = r to %.2g relative at %u points (1e-5)\n",
        worst, asked);
}

/* The radius at which the year j begins, on a round, straight stem. */
static void ring_starts(const sozai_texture *t, unsigned n, double *start) {
  for (unsigned j = 0; j < n; j++) {
    float year = (float)j, zero = 0, r;
    woods->ring_radius(t, 1, &year, &zero, &zero, &r);
    start[j] = (double)r;
  }
}

static void widths_vary_by_year(void **state) {
  (void)state;
  enum { N = 256 };
  for (int k = 0; k < 3; k++) {
    static const double asked[3] = {0.0, 0.2, 0.4};
    char parameters[128];
    snprintf(parameters, sizeof parameters, "section_wobble=0; ring_width=2; ring_variation=%g",
             asked[k]);
    sozai_texture *t = wood_make(NULL, parameters), *again = wood_make(NULL, parameters);
    sozai_texture *other = wood_make(NULL, strcat(parameters, "; seed=2"));
    double start[N + 1], same[N + 1], differs[N + 1], mean = 0, square = 0;
    ring_starts(t, N + 1, start);
    ring_starts(again, N + 1, same);
    ring_starts(other, N + 1, differs);
    for (int j = 0; j < N; j++) {
      double w = start[j + 1] - start[j];
      mean += w / N;
      square += w * w / N;
    }
    double sd = sqrt(fmax(square - mean * mean, 0)) / mean;
    CHECK(fabs(mean - 2) < 0.01 && fabs(sd - asked[k]) < 0.02 + 0.15 * asked[k],
          "ring_variation %.2f: mean width %.4f mm, relative sd %.3f over %d years\n", asked[k],
          mean, sd, N);
    assert_memory_equal(start, same, sizeof start);
    if (k) assert_memory_not_equal(start, differs, sizeof start);
    textures->destroy(t);
    textures->destroy(again);
    textures->destroy(other);
  }
}

static void measured_widths_are_used(void **state) {
  (void)state;
  const float widths[5] = {1.5f, 3.25f, 0.5f, 2.0f, 4.0f};
  sozai_buffer b;
  memset(&b, 0, sizeof b);
  b.size = sizeof b;
  b.kind = SOZAI_BUFFER_TABLE;
  b.dims[0] = 5;
  b.dims[1] = 1;
  b.data = widths;
  sozai_value v[2];
  memset(v, 0, sizeof v);
  v[0].id = "ring_widths";
  v[0].kind = SOZAI_KIND_BUFFER;
  v[0].buffer = &b;
  v[1].id = "section_wobble";
  v[1].kind = SOZAI_KIND_FLOAT;
  sozai_texture *t;
  assert_int_equal(textures->create(NULL, "wood", NULL, v, 2, &t), SOZAI_OK);
  double start[11], at = 0;
  ring_starts(t, 11, start);
  for (int j = 0; j < 10; j++) {
    assert_true(fabs(start[j] - at) < 1e-4);
    at += (double)widths[j % 5];
  }
  textures->destroy(t);
  const float bad[2] = {1.0f, -1.0f};
  b.data = bad;
  b.dims[0] = 2;
  assert_int_equal(textures->create(NULL, "wood", NULL, v, 2, &t), SOZAI_ERROR_RANGE);
  CHECK(strstr(textures->last_error(), "ring_widths") && strstr(textures->last_error(), "-1"),
        "refused: %s\n", textures->last_error());
}

static void no_seam(void **state) {
  (void)state;
  sozai_texture *t = wood_make("keyaki", "section_wobble=0.2; grain=compound");
  points p = {0};
  uniform_seed(3);
  for (int k = 0; k < 2000; k++) {
    double r = 5 + 200 * uniform(), y = 400 * (uniform() - 0.5);
    float height = (float)y, px, pz;
    woods->pith(t, 1, &height, &px, &pz);
    for (int side = -1; side <= 1; side += 2) {
      points_add(&p, (double)px - r, y, (double)pz + side * 1e-4, 0);
    }
  }
  points_ask(&p, t);
  double time = 0, reference = 0, fibre = 0;
  for (unsigned i = 0; i < p.count; i += 2) {
    time = fmax(time, fabs((double)(p.out[TIME][i] - p.out[TIME][i + 1])));
    for (int c = 0; c < 2; c++) {
      reference =
          fmax(reference, fabs((double)(p.out[REFERENCE + c][i] - p.out[REFERENCE + c][i + 1])));
    }
    for (int c = 0; c < 3; c++) {
      fibre = fmax(fibre, fabs((double)(p.out[FIBER + c][i] - p.out[FIBER + c][i + 1])));
    }
  }
  CHECK(time < 1e-3 && reference < 2e-2 && fibre < 1e-3,
        "across theta = +-pi, 0.2 um apart: time %.2g years, reference %.2g mm, fibre %.2g\n", time,
        reference, fibre);
  points_free(&p);
  textures->destroy(t);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(rings_never_cross),
      cmocka_unit_test(radius_is_the_inverse_of_time),
      cmocka_unit_test(widths_vary_by_year),
      cmocka_unit_test(measured_widths_are_used),
      cmocka_unit_test(no_seam),
  };
  return cmocka_run_group_tests(tests, wood_setup, wood_teardown);
}
